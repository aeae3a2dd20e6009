#include <fmt/format.h>

#include "commands.hpp"
#include "linkwright/io/csv_table.hpp"
#include "linkwright/io/dxf_drawing.hpp"
#include "linkwright/io/result_file.hpp"
#include "linkwright/io/six_bar_file.hpp"
#include "linkwright/io/svg_drawing.hpp"
#include "linkwright/io/text_file.hpp"

namespace linkwright::cli {
namespace {

std::string table(const StoredLinkage& linkage) {
  return motion_table(tabulated_motion(linkage.four_bar, traced_point(linkage)));
}
std::string table(const StoredSixBar& linkage) { return motion_table(tabulated_motion(linkage)); }

template <class Stored>
std::string converted(const Stored& linkage, std::string_view format) {
  if (format == "svg") return draw_linkage(linkage);
  if (format == "dxf") return draw_dxf(linkage);
  if (format == "csv") return table(linkage);
  return write_linkage(linkage);
}

Result<std::vector<AnyStoredLinkage>> read_linkages(const std::string& path) {
  const auto text = read_text_file(path, most_result_bytes);
  return text ? read_any_result_linkages(*text) : Result<std::vector<AnyStoredLinkage>>(text.errors());
}

}  // namespace

int export_linkage(const ExportArguments& arguments) {
  constexpr int mistake = static_cast<int>(Status::mistake);
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
  const auto written_as = [&](auto linkage) {
    linkage.title += fmt::format("{}linkage {}", linkage.title.empty() ? "" : ", ", arguments.linkage);
    return write_output(arguments.output, [&](const TextSink& sink) { sink(converted(linkage, arguments.format)); });
  };
  const bool written = std::visit(written_as, (*linkages)[static_cast<std::size_t>(arguments.linkage - 1)]);
  return written ? 0 : static_cast<int>(Status::failure);
}

}  // namespace linkwright::cli
