#include "linkwright/drawing/linkage_export.hpp"

#include "linkwright/drawing/dxf_drawing.hpp"
#include "linkwright/drawing/svg_drawing.hpp"
#include "linkwright/files/csv_table.hpp"

namespace linkwright {
namespace {

std::string table(const StoredLinkage& linkage) { return motion_table(tabulated_cycle(linkage)); }
std::string table(const StoredSixBar& linkage) {
  return motion_table(tabulated_motion(linkage.six_bar, framed_poses(linkage)));
}

}  // namespace

std::string exported(const AnyStoredLinkage& linkage, std::string_view format) {
  return std::visit(
      [format](const auto& stored) {
        if (format == "svg") return draw_linkage(stored);
        if (format == "dxf") return draw_dxf(stored);
        if (format == "csv") return table(stored);
        return write_linkage(stored);
      },
      linkage);
}

}  // namespace linkwright
