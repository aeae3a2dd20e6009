#include "drawn_task.hpp"

#include "drawn_kinds.hpp"

namespace linkwright::soak {
namespace {

/// What the plane draws, asked of shafts that cross at an angle.
Json on_sphere(Draw& draw, Json task) {
  task["mechanism"] = "spherical_four_bar";
  task.erase("ground_pivots");
  if (draw.chance(0.98)) task["ground_angle_deg"] = draw.chance(0.3) ? 90.0 : draw.between(0.5, 179.5);
  return task;
}

}  // namespace

Json drawn_task(Draw& draw, const Sheet& sheet, std::string_view kind) {
  if (kind.starts_with("three")) return drawn_three_positions(draw, sheet, kind);
  if (kind.starts_with("four")) return drawn_four_positions(draw, sheet, kind);
  if (kind.starts_with("five")) return drawn_five_positions(draw, sheet, kind);
  if (kind.starts_with("pairs")) return drawn_pairs(draw, sheet, kind);
  if (kind.starts_with("function")) return drawn_function(draw, sheet, kind);
  if (kind == "path_near") return drawn_near_path(draw, sheet);
  if (kind.starts_with("path")) return drawn_path(draw, sheet, kind);
  if (kind.starts_with("line")) return drawn_line(draw, sheet, kind);
  if (kind.starts_with("sphere_pairs") || kind.starts_with("sphere_function"))
    return on_sphere(draw, drawn_task(draw, sheet, kind.substr(std::string_view("sphere_").size())));
  if (kind.starts_with("sphere")) return drawn_sphere(draw, kind);
  return drawn_six_bar(draw, sheet, kind);
}

Json written_point(const Sheet& sheet, Point p) {
  return Json::array({written(sheet, p.real()), written(sheet, p.imag())});
}

Json drawn_interval(Draw& draw, double low_reach, double high_reach) {
  const double low = draw.between(-low_reach, low_reach);
  return Json::array({low, low + draw.between(0.01, 1) * high_reach});
}

}  // namespace linkwright::soak
