#include "commands.hpp"
#include "linkwright/analyses/tolerance_study.hpp"
#include "linkwright/files/result_file.hpp"
#include "report.hpp"

namespace linkwright::cli {

int tolerance(const ToleranceArguments& arguments) {
  const Interruption interruption(Interruption::Answer::at_once);
  const auto refuse = [&](const std::vector<Error>& mistakes) {
    print_mistakes(arguments.result == "-" ? "standard input" : arguments.result, mistakes);
    return mistake;
  };
  const auto text = read_text_file(arguments.result, max_result_bytes);
  if (!text) return refuse(text.errors());
  auto listed = listed_study(*text, arguments.linkage, {arguments.length, arguments.samples, arguments.seed});
  if (!listed) return refuse(listed.errors());
  ToleranceStudy& study = listed->study;
  if (!arguments.report.empty() &&
      !write_output(arguments.report, [&](const TextSink& sink) { sink(write_tolerance_study(study)); }))
    return failure;
  if (!arguments.picture.empty() &&
      !write_output(arguments.picture, [&](const TextSink& sink) { sink(draw_tolerances(study)); }))
    return failure;
  if (arguments.report == "-" || arguments.picture == "-") return 0;
  const std::string words = tolerance_words(listed->problem, findings(listed->answer), listed->place);
  return print_answer(study.title + "\n" + words) ? 0 : failure;
}

}  // namespace linkwright::cli
