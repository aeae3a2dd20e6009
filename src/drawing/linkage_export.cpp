#include "linkwright/drawing/linkage_export.hpp"

#include "dxf_drawing.hpp"
#include "linkwright/drawing/svg_drawing.hpp"
#include "linkwright/files/csv_table.hpp"

namespace linkwright {
namespace {

std::string table(const StoredLinkage& linkage) { return motion_table(linkage); }
std::string table(const StoredSixBar& linkage) {
  return motion_table(tabulated_motion(linkage.six_bar, framed_poses(linkage)));
}

std::string table(const StoredSphericalFourBar& linkage) { return motion_table(analyze(linkage)); }

template <class Stored>
std::string dxf_of(const Stored& linkage) {
  return draw_dxf(linkage);
}
// No drawing in a plane shows arcs on a sphere at true size.
std::string dxf_of(const StoredSphericalFourBar& /*linkage*/) { return ""; }

}  // namespace

std::string exported(const AnyStoredLinkage& linkage, std::string_view format) {
  return std::visit(
      [format](const auto& stored) {
        if (format == "svg") return draw_linkage(stored);
        if (format == "dxf") return dxf_of(stored);
        if (format == "csv") return table(stored);
        return write_linkage(stored);
      },
      linkage);
}

}  // namespace linkwright
