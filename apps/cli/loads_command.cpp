#include <fmt/format.h>
#include <string>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "linkwright/analyses/load_study.hpp"
#include "linkwright/analyses/spring_places.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/files/result_file.hpp"
#include "report.hpp"

namespace linkwright::cli {
namespace {

/// What is written, by the ending of the file's name; nothing of another.
std::string written(const LoadStudy& study, std::string_view path) {
  if (path.ends_with(".csv")) return load_table(study);
  return path.ends_with(".svg") ? draw_loads(study) : write_load_study(study);
}

bool is_known(std::string_view path) {
  return path.empty() || path == "-" || path.ends_with(".csv") || path.ends_with(".svg") || path.ends_with(".json");
}

std::string spoken_path(const std::string& path) { return path == "-" ? "standard input" : path; }

Result<std::vector<CatalogueSpring>> read_parts(const std::string& path, const std::string& unit) {
  const auto text = read_text_file(path, max_file_bytes);
  if (!text) return text.errors();
  const auto catalogue = read_spring_catalogue(*text);
  return catalogue ? parts_in(*catalogue, unit) : Result<std::vector<CatalogueSpring>>(catalogue.errors());
}

/// With --place-springs.
int place_springs(const LoadsArguments& arguments) {
  const Interruption interruption(Interruption::Answer::when_asked);
  const auto refuse = [](const std::string& path, const std::vector<Error>& mistakes) {
    print_mistakes(spoken_path(path), mistakes);
    return mistake;
  };
  if (!arguments.output.empty() && arguments.output != "-" && !arguments.output.ends_with(".json"))
    return refuse(arguments.output, {{"unknown_ending", "-o", "springs that were placed are written as .json", {}}});
  if (arguments.balance)
    return refuse(arguments.boxes,
                  {{"not_together", "--balance", "a balance is told without springs to be placed", {}}});
  if (!arguments.of_case.empty())
    return refuse(arguments.result, {{"not_together", "--case", "springs are placed by all cases of the loads", {}}});
  const auto text = read_text_file(arguments.result, max_result_bytes);
  if (!text) return refuse(arguments.result, text.errors());
  const auto boxes = read_text_file(arguments.boxes, max_file_bytes);
  const auto wanted = boxes ? read_spring_boxes(*boxes) : Result<SpringWanted>(boxes.errors());
  if (!wanted) return refuse(arguments.boxes, wanted.errors());
  const auto on = loaded_linkage(*text, arguments.linkage);
  if (!on) return refuse(arguments.result, on.errors());
  std::optional<std::vector<CatalogueSpring>> parts;
  if (!arguments.catalogue.empty()) {
    auto read = read_parts(arguments.catalogue, on->length_unit);
    if (!read) return refuse(arguments.catalogue, read.errors());
    parts = *std::move(read);
  }
  std::optional<PlacedSpring> placed;
  {
    ProgressLine line;
    const Progress progress{[&](double done) { line.show(done); }, Interruption::flag()};
    auto found = place_spring_on(*on, *wanted, std::move(parts), {}, progress);
    if (!found) return refuse(arguments.boxes, found.errors());
    placed = *std::move(found);
  }
  // Stopped by hand it tells what it has.
  if (Interruption::happened() && placed->place.found) Interruption::settle();
  if (!arguments.output.empty() &&
      !write_output(arguments.output, [&](const TextSink& sink) { sink(write_placed_spring(*placed)); }))
    return failure;
  if (arguments.output == "-") return 0;
  return print_answer(placed->title + "\n" + spring_words(*placed)) ? 0 : failure;
}

}  // namespace

int loads(const LoadsArguments& arguments) {
  if (!arguments.boxes.empty()) return place_springs(arguments);
  const Interruption interruption(Interruption::Answer::at_once);
  const auto refuse = [&](const std::vector<Error>& mistakes) {
    print_mistakes(arguments.result == "-" ? "standard input" : arguments.result, mistakes);
    return mistake;
  };
  if (!is_known(arguments.output))
    return refuse({{"unknown_ending", "-o",
                    fmt::format("{}: a table ends in .csv, a picture in .svg, a report in .json", arguments.output)}});
  const auto text = read_text_file(arguments.result, max_result_bytes);
  if (!text) return refuse(text.errors());
  LoadChanges changes;
  if (!arguments.of_case.empty()) changes.only_case = arguments.of_case;
  if (arguments.free_share) changes.real_springs.free_share = *arguments.free_share;
  if (auto mistakes = mistakes_in(changes.real_springs); !mistakes.empty()) {
    mistakes.front().place = "--free-share";
    return refuse(mistakes);
  }
  const auto study = listed_loads(*text, arguments.linkage, changes);
  if (!study) return refuse(study.errors());
  if (!arguments.output.empty() &&
      !write_output(arguments.output, [&](const TextSink& sink) { sink(written(*study, arguments.output)); }))
    return failure;
  if (arguments.output == "-") return 0;
  return print_answer(study->title + "\n" + load_words(*study) + (arguments.balance ? balance_words(*study) : ""))
             ? 0
             : failure;
}

}  // namespace linkwright::cli
