#include <fmt/format.h>

#include "commands.hpp"
#include "linkage_words.hpp"
#include "linkwright/io/analysis_file.hpp"
#include "linkwright/io/csv_table.hpp"
#include "linkwright/io/result_file.hpp"
#include "linkwright/io/text_file.hpp"

namespace linkwright::cli {
namespace {

constexpr int mistake = static_cast<int>(Status::mistake), failure = static_cast<int>(Status::failure);

bool ends_with(std::string_view text, std::string_view end) {
  return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

Result<StoredLinkage> read_linkage_file(const std::string& path) {
  const auto text = read_text_file(path, most_result_bytes);
  return text ? read_linkage(*text) : Result<StoredLinkage>(text.errors());
}

bool write_report(const std::string& path, const LinkageAnalysis& analysis) {
  return write_output(path, [&](const TextSink& sink) {
    sink(ends_with(path, ".csv") ? motion_table(analysis.motion) : write_analysis(analysis));
  });
}

}  // namespace

int analyze(const AnalyzeArguments& arguments) {
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
  if (arguments.drive == "output") linkage->four_bar = linkage->four_bar.swapped();
  const LinkageAnalysis analysis = linkwright::analyze(*linkage);
  if (!report.empty() && !write_report(report, analysis)) return failure;
  return report == "-" || print_answer(linkage_words(analysis, arguments.drive)) ? 0 : failure;
}

}  // namespace linkwright::cli
