#include <fmt/format.h>

#include "commands.hpp"
#include "linkage_report.hpp"
#include "linkwright/files/analysis_file.hpp"
#include "linkwright/files/csv_table.hpp"
#include "linkwright/files/result_file.hpp"
#include "linkwright/files/six_bar_file.hpp"
#include "linkwright/files/text_file.hpp"
#include "six_bar_report.hpp"
#include "spherical_report.hpp"

namespace linkwright::cli {
namespace {

bool ends_with(std::string_view text, std::string_view end) {
  return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

Result<AnyStoredLinkage> read_linkage_file(const std::string& path) {
  const auto text = read_text_file(path, max_result_bytes);
  return text ? read_any_linkage(*text) : Result<AnyStoredLinkage>(text.errors());
}

std::string table_of(const LinkageAnalysis& analysis) { return motion_table(tabulated_cycle(analysis.linkage)); }
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

}  // namespace

int analyze(const AnalyzeArguments& arguments) {
  const Interruption interruption(Interruption::Answer::at_once);
  const std::string& report = arguments.report;
  if (!report.empty() && report != "-" && !ends_with(report, ".json") && !ends_with(report, ".csv")) {
    print_mistakes(report,
                   {{"unknown_format", "--output", "the file's name ends in .json or .csv, which chooses the format"}});
    return mistake;
  }
  auto linkage = read_linkage_file(arguments.linkage);
  if (!linkage) {
    print_mistakes(arguments.linkage, linkage.errors());
    return mistake;
  }
  if (const auto* six_bar = std::get_if<StoredSixBar>(&linkage.value())) {
    if (arguments.drive == "input") return report_on(*six_bar, arguments);
    print_mistakes(arguments.linkage, {{"six_bar_driver", "--drive",
                                        "a six-bar is analysed as body 1 drives it, at hinge a; leave --drive out"}});
    return mistake;
  }
  if (auto* spherical = std::get_if<StoredSphericalFourBar>(&linkage.value())) {
    if (arguments.drive == "output") spherical->four_bar = spherical->four_bar.swapped();
    return report_on(*spherical, arguments);
  }
  auto four_bar = std::get<StoredLinkage>(*linkage);
  if (arguments.drive == "output") four_bar.four_bar = four_bar.four_bar.swapped();
  return report_on(four_bar, arguments);
}

}  // namespace linkwright::cli
