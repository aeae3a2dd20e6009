#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <variant>

#include "commands.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/count_text.hpp"
#include "linkwright/drawing/svg_drawing.hpp"
#include "linkwright/files/analysis_file.hpp"
#include "linkwright/files/csv_table.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/files/result_file.hpp"
#include "linkwright/files/six_bar_file.hpp"
#include "linkwright/files/text_file.hpp"
#include "report.hpp"

namespace linkwright::cli {
namespace {

bool ends_with(std::string_view text, std::string_view end) {
  return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

Result<AnyStoredLinkage> read_linkage_file(const std::string& path) {
  const auto text = read_text_file(path, max_result_bytes);
  return text ? read_any_linkage(*text) : Result<AnyStoredLinkage>(text.errors());
}

std::string table_of(const LinkageAnalysis& analysis) { return motion_table(analysis.linkage); }
std::string table_of(const StoredSixBarAnalysis& analysis) { return motion_table(analysis.motion); }
std::string table_of(const StoredSphericalAnalysis& analysis) { return motion_table(analysis); }

template <class Analysis>
bool write_report(const std::string& path, const Analysis& analysis) {
  return write_output(path, [&](const TextSink& sink) {
    sink(ends_with(path, ".csv") ? table_of(analysis) : write_analysis(analysis));
  });
}

std::string words(const LinkageAnalysis& analysis, std::string_view drive) { return linkage_words(analysis, drive); }
std::string words(const StoredSixBarAnalysis& analysis, std::string_view /*drive*/) { return six_bar_words(analysis); }
std::string words(const StoredSphericalAnalysis& analysis, std::string_view drive) {
  return spherical_words(analysis, drive);
}

template <class Stored>
int report_on(const Stored& linkage, const AnalyzeArguments& arguments) {
  const auto analysis = linkwright::analyze(linkage);
  if (!arguments.report.empty() && !write_report(arguments.report, analysis)) return failure;
  return arguments.report == "-" || print_answer(words(analysis, arguments.drive)) ? 0 : failure;
}

std::optional<Point> point_of(const AnalyzeArguments& arguments) {
  if (arguments.point.empty()) return std::nullopt;
  return Point{arguments.point[0], arguments.point[1]};
}

// ---- one instant

constexpr double largest_angle_deg = 1e6, largest_number = 1e12;  // of flags; the latter as in files

std::optional<Error> mistake_in(const AnalyzeArguments& arguments) {
  const auto is_beyond = [](double value, double most) { return !(std::abs(value) <= most); };
  const auto beyond = [](std::string_view flag, double most) {
    return Error{"flag_range", std::string(flag), fmt::format("a number between ±{} belongs here", limit_text(most))};
  };
  if (std::any_of(arguments.point.begin(), arguments.point.end(),
                  [&](double x) { return is_beyond(x, largest_number); }))
    return beyond("--point", largest_number);
  if (std::any_of(arguments.body.begin(), arguments.body.end(), [&](double x) { return is_beyond(x, largest_number); }))
    return beyond("--body", largest_number);
  if (arguments.input_deg && is_beyond(*arguments.input_deg, largest_angle_deg))
    return beyond("--input-deg", largest_angle_deg);
  if (arguments.input_acceleration && is_beyond(*arguments.input_acceleration, largest_number))
    return beyond("--input-acceleration", largest_number);
  if (arguments.instant && !arguments.compared.empty())
    return Error{"instant_or_comparison", "--compare", "an instant and a path are told one at a time; leave one out"};
  if (!arguments.instant && arguments.compared.empty() && !(arguments.point.empty() && arguments.picture.empty()))
    return Error{"flag_without_question", arguments.point.empty() ? "--svg" : "--point",
                 "this goes with --instant or --compare; give one of them, or leave it out"};
  if (arguments.instant && ends_with(arguments.report, ".csv"))
    return Error{"instant_table", "--output", "an instant has no table; give the file a name that ends in .json"};
  return std::nullopt;
}

Result<LinkageInstant> instant_of(const StoredLinkage& linkage, const AnalyzeArguments& arguments) {
  InstantAsked asked{point_of(arguments), {}, arguments.input_acceleration.value_or(0)};
  if (arguments.input_deg) asked.input_angle = radians(*arguments.input_deg);
  auto instant = linkwright::instant_of(linkage, asked);
  if (instant) return instant;
  std::vector<Error> errors = instant.errors();
  for (Error& error : errors) error.place = "--input-deg";
  return errors;
}

template <class Drawable>
bool draw(const AnalyzeArguments& arguments, const Drawable& drawable) {
  return arguments.picture.empty() ||
         write_output(arguments.picture, [&](const TextSink& sink) { sink(draw_instant(drawable)); });
}

int report_instant_of(const StoredLinkage& linkage, const AnalyzeArguments& arguments) {
  auto instant = instant_of(linkage, arguments);
  if (!instant) {
    print_mistakes(arguments.linkage, instant.errors());
    return mistake;
  }
  LinkageAnalysis analysis = linkwright::analyze(linkage);
  analysis.instant = *std::move(instant);
  if (!arguments.report.empty() && !write_report(arguments.report, analysis)) return failure;
  if (!draw(arguments, analysis)) return failure;
  return arguments.report == "-" || print_answer(words(analysis, arguments.drive) + instant_words(analysis)) ? 0
                                                                                                             : failure;
}

int report_instant_of(const Problem& problem, const AnalyzeArguments& arguments) {
  for (const auto& [is_given, flag] : {std::pair(arguments.input_deg.has_value(), "--input-deg"),
                                       std::pair(arguments.input_acceleration.has_value(), "--input-acceleration")}) {
    if (!is_given) continue;
    print_mistakes(arguments.linkage,
                   {{"no_input", flag, "a prescribed motion has no input link; leave this flag out"}});
    return mistake;
  }
  const auto instant = prescribed_instant(problem, point_of(arguments));
  if (!instant) {
    print_mistakes(arguments.linkage, instant.errors());
    return mistake;
  }
  const auto write = [&](const TextSink& sink) { sink(write_instant(*instant)); };
  if (!arguments.report.empty() && !write_output(arguments.report, write)) return failure;
  if (!draw(arguments, *instant)) return failure;
  return arguments.report == "-" || print_answer(instant_words(*instant)) ? 0 : failure;
}

/// Of a file that was read as a linkage and is none, the problem.
int report_instant_of_problem(const AnalyzeArguments& arguments) {
  const auto problem = read_problem_file(arguments.linkage);
  if (problem) return report_instant_of(*problem, arguments);
  print_mistakes(arguments.linkage, problem.errors());
  return mistake;
}

int refuse_comparison(const AnalyzeArguments& arguments, std::string_view linkage) {
  print_mistakes(arguments.linkage, {{"comparison_of_a_plane", "--compare",
                                      fmt::format("planar four-bars are compared with points and poses; this is a {}; "
                                                  "leave --compare out",
                                                  linkage)}});
  return mistake;
}

int refuse_instant(const AnalyzeArguments& arguments, std::string_view linkage) {
  print_mistakes(arguments.linkage,
                 {{"instant_of_a_plane", "--instant",
                   fmt::format("an instant is told of planar four-bars; this is a {}; leave --instant out", linkage)}});
  return mistake;
}

}  // namespace

int analyze(const AnalyzeArguments& arguments) {
  const Interruption interruption(Interruption::Answer::at_once);
  const std::string& report = arguments.report;
  if (!report.empty() && report != "-" && !ends_with(report, ".json") && !ends_with(report, ".csv")) {
    print_mistakes(report,
                   {{"unknown_format", "--output", "the file's name ends in .json or .csv, which chooses the format"}});
    return mistake;
  }
  if (const auto wrong = mistake_in(arguments)) {
    print_mistakes(arguments.linkage, {*wrong});
    return mistake;
  }
  auto linkage = read_linkage_file(arguments.linkage);
  if (!linkage) {
    if (arguments.instant && linkage.errors().front().code == "problem_without_linkage")
      return report_instant_of_problem(arguments);
    print_mistakes(arguments.linkage, linkage.errors());
    return mistake;
  }
  if (const auto* six_bar = std::get_if<StoredSixBar>(&linkage.value())) {
    if (arguments.instant) return refuse_instant(arguments, "six-bar");
    if (!arguments.compared.empty()) return refuse_comparison(arguments, "six-bar");
    if (arguments.drive == "input") return report_on(*six_bar, arguments);
    print_mistakes(arguments.linkage, {{"six_bar_driver", "--drive",
                                        "a six-bar is analysed as body 1 drives it, at hinge a; leave --drive out"}});
    return mistake;
  }
  if (auto* spherical = std::get_if<StoredSphericalFourBar>(&linkage.value())) {
    if (arguments.instant) return refuse_instant(arguments, "spherical four-bar");
    if (!arguments.compared.empty()) return refuse_comparison(arguments, "spherical four-bar");
    if (arguments.drive == "output") spherical->four_bar = spherical->four_bar.swapped();
    return report_on(*spherical, arguments);
  }
  auto four_bar = std::get<StoredLinkage>(*linkage);
  if (arguments.drive == "output") four_bar.four_bar = four_bar.four_bar.swapped();
  if (!arguments.compared.empty()) return compare(four_bar, arguments);
  return arguments.instant ? report_instant_of(four_bar, arguments) : report_on(four_bar, arguments);
}

}  // namespace linkwright::cli
