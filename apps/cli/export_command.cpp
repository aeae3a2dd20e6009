#include <fmt/format.h>

#include "commands.hpp"
#include "linkwright/drawing/linkage_export.hpp"
#include "linkwright/files/result_file.hpp"
#include "linkwright/files/text_file.hpp"

namespace linkwright::cli {
namespace {

Result<std::vector<AnyStoredLinkage>> read_linkages(const std::string& path) {
  const auto text = read_text_file(path, max_result_bytes);
  return text ? read_any_result_linkages(*text) : Result<std::vector<AnyStoredLinkage>>(text.errors());
}

}  // namespace

int export_linkage(const ExportArguments& arguments) {
  const Interruption interruption(Interruption::Answer::at_once);
  const auto linkages = read_linkages(arguments.result);
  if (!linkages) {
    print_mistakes(arguments.result, linkages.errors());
    return mistake;
  }
  const auto count = static_cast<int>(linkages->size());
  if (arguments.linkage < 1 || arguments.linkage > count) {
    const std::string message =
        count == 0 ? "this result holds no linkages; its \"reason\" says why"
                   : fmt::format("there is no linkage {}; this result holds 1 to {}", arguments.linkage, count);
    print_mistakes(arguments.result, {{"no_such_linkage", "--linkage", message}});
    return mistake;
  }
  AnyStoredLinkage linkage = (*linkages)[static_cast<std::size_t>(arguments.linkage - 1)];
  std::string& title = std::visit([](auto& stored) -> std::string& { return stored.title; }, linkage);
  title += fmt::format("{}linkage {}", title.empty() ? "" : ", ", arguments.linkage);
  const std::string text = exported(linkage, arguments.format);
  if (text.empty()) {
    print_mistakes(arguments.result, {{"format_of_a_sphere", "--format",
                                       "the links of a spherical four-bar are arcs on a sphere, which no drawing in a "
                                       "plane shows at true size; export it as svg, csv or json"}});
    return mistake;
  }
  const bool written = write_output(arguments.output, [&](const TextSink& sink) { sink(text); });
  return written ? 0 : static_cast<int>(Status::failure);
}

}  // namespace linkwright::cli
