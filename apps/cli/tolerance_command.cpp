#include <fmt/format.h>

#include "commands.hpp"
#include "linkwright/drawing/tolerance_drawing.hpp"
#include "linkwright/files/listed_problem.hpp"
#include "linkwright/files/result_file.hpp"
#include "linkwright/files/tolerance_file.hpp"
#include "linkwright/synthesis/solve.hpp"
#include "tolerance_report.hpp"

namespace linkwright::cli {
namespace {

Error no_tolerances() {
  return {"no_tolerances", "problem.tolerances",
          "the problem of this result has no tolerances; add \"tolerances\": {\"length\": 0.1} beside its \"task\" and "
          "solve it again, or say --length"};
}

/// The tolerances of the file, and over them what flags say.
Result<Tolerances> tolerances_of(const Problem& problem, const ToleranceArguments& arguments) {
  if (!problem.options.tolerances && !arguments.length) return no_tolerances();
  Tolerances tolerances = problem.options.tolerances.value_or(Tolerances{});
  if (arguments.length) tolerances.length = LengthTolerances::all(*arguments.length);
  if (arguments.samples) tolerances.samples = *arguments.samples;
  if (arguments.seed) tolerances.seed = static_cast<std::uint64_t>(*arguments.seed);
  const auto mistakes = mistakes_in(tolerances);
  return mistakes.empty() ? Result<Tolerances>(tolerances) : Result<Tolerances>(mistakes);
}

/// Which of the linkages at the place.
std::size_t listed_place(const Answer& answer, int layer) {
  const auto* lines = std::get_if<StraightLineAnswer>(&answer);
  if (lines == nullptr) return 0;
  for (std::size_t i = 0; i < lines->linkages.size(); ++i)
    if (lines->linkages[i].place.layer == layer) return i;
  return 0;
}

Result<ListedProblem> asked(const ToleranceArguments& arguments) {
  const auto text = read_text_file(arguments.result, max_result_bytes);
  if (!text) return text.errors();
  auto listed = read_listed_problem(*text, arguments.linkage);
  if (!listed) return listed;
  const auto tolerances = tolerances_of(listed->problem, arguments);
  if (!tolerances) return tolerances.errors();
  SynthesisOptions& options = listed->problem.options;
  options.tolerances = *tolerances;
  options.region_samples = SynthesisOptions::min_samples;  // of the map only one place is looked at
  return listed;
}

}  // namespace

int tolerance(const ToleranceArguments& arguments) {
  const Interruption interruption(Interruption::Answer::at_once);
  const auto refuse = [&](const std::vector<Error>& mistakes) {
    print_mistakes(arguments.result == "-" ? "standard input" : arguments.result, mistakes);
    return mistake;
  };
  const auto listed = asked(arguments);
  if (!listed) return refuse(listed.errors());
  const Problem& problem = listed->problem;
  const auto solved = solve(problem.task, problem.requirements, problem.options);
  if (!solved) return refuse(solved.errors());
  const Findings& found = findings(*solved);
  const std::size_t place = listed_place(*solved, listed->layer);
  if (place >= found.tolerance.size())
    return refuse({{"no_place", "linkages",
                    "at the place of this linkage its problem has none any more; solve the problem anew"}});
  if (!found.tolerance[place])
    return refuse({{"no_sensitivity", "linkages",
                    "this linkage stands at a dead point in one of its positions, where errors have no bound"}});
  ToleranceStudy study = tolerance_study(problem, *solved, place);
  study.title += fmt::format("{}linkage {}", study.title.empty() ? "" : ", ", arguments.linkage);
  if (!arguments.report.empty() &&
      !write_output(arguments.report, [&](const TextSink& sink) { sink(write_tolerance_study(study)); }))
    return failure;
  if (!arguments.picture.empty() &&
      !write_output(arguments.picture, [&](const TextSink& sink) { sink(draw_tolerances(study)); }))
    return failure;
  if (arguments.report == "-" || arguments.picture == "-") return 0;
  return print_answer(study.title + "\n" + tolerance_words(problem, found, place)) ? 0 : failure;
}

}  // namespace linkwright::cli
