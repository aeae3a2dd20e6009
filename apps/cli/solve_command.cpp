#include <fmt/format.h>

#include "commands.hpp"
#include "linkwright/drawing/svg_drawing.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/files/result_file.hpp"
#include "linkwright/synthesis/solve.hpp"
#include "report.hpp"

namespace linkwright::cli {
namespace {

int stopped() {
  print_failure(Interruption::words());
  return Interruption::exit_status();
}

Result<Answer> solve_with_progress(const Problem& problem) {
  ProgressLine line;
  Progress progress;
  progress.report = [&line](double done) { line.show(done); };
  progress.cancelled = Interruption::flag();
  return solve(problem, progress);
}

/// The files that were asked for; false where one cannot be written.
bool write_files(const SolveArguments& arguments, const Problem& problem, const Answer& answer) {
  const bool drawn = arguments.picture.empty() ||
                     write_output(arguments.picture, [&](const TextSink& sink) { sink(draw_answer(problem, answer)); });
  return drawn && (arguments.result.empty() || write_output(arguments.result, [&](const TextSink& sink) {
                     write_result(sink, problem, answer, arguments.with_region);
                   }));
}

}  // namespace

int solve(const SolveArguments& arguments) {
  const Interruption interruption(Interruption::Answer::when_asked);
  const std::string file = arguments.problem == "-" ? "standard input" : arguments.problem;
  auto problem = read_problem_file(arguments.problem);
  if (!problem) {
    print_mistakes(file, problem.errors());
    return mistake;
  }
  if (arguments.samples) problem->options.region_samples = *arguments.samples;
  const auto option_mistakes = mistakes_in(problem->options);
  if (!option_mistakes.empty()) {
    print_mistakes("--samples", option_mistakes);
    return mistake;
  }
  const auto solved = solve_with_progress(*problem);
  if (solved && looked_at_by_search(*solved)) Interruption::settle();  // a search hands over the best so far
  if (Interruption::happened()) return stopped();
  if (!solved) {
    print_mistakes(file, solved.errors());
    return mistake;
  }
  const bool written = write_files(arguments, *problem, *solved);
  if (Interruption::happened()) return stopped();
  if (!written) return failure;
  const bool text_goes_elsewhere = arguments.result == "-" || arguments.picture == "-";
  const bool told = text_goes_elsewhere || print_answer(report(*problem, *solved));
  return told ? Interruption::exit_status() : failure;
}

}  // namespace linkwright::cli
