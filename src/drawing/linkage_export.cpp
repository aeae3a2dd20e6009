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

/// What the drawings of a linkage show of its loads.
const Loads* drawn(const StoredLinkage& linkage, const std::optional<Loads>& loads) {
  return loads && !linkage.poses.empty() ? &*loads : nullptr;
}

std::string svg_of(const StoredLinkage& linkage, const std::optional<Loads>& loads) {
  return draw_linkage(linkage, drawn(linkage, loads));
}
std::string svg_of(const auto& linkage, const std::optional<Loads>& /*loads*/) { return draw_linkage(linkage); }

std::string dxf_of(const StoredLinkage& linkage, const std::optional<Loads>& loads) {
  return draw_dxf(linkage, drawn(linkage, loads));
}
std::string dxf_of(const StoredSixBar& linkage, const std::optional<Loads>& /*loads*/) { return draw_dxf(linkage); }
// No drawing in a plane shows arcs on a sphere at true size.
std::string dxf_of(const StoredSphericalFourBar& /*linkage*/, const std::optional<Loads>& /*loads*/) { return ""; }

}  // namespace

std::string exported(const AnyStoredLinkage& linkage, std::string_view format, const std::optional<Loads>& loads) {
  return std::visit(
      [&](const auto& stored) {
        if (format == "svg") return svg_of(stored, loads);
        if (format == "dxf") return dxf_of(stored, loads);
        if (format == "csv") return table(stored);
        return write_linkage(stored);
      },
      linkage);
}

}  // namespace linkwright
