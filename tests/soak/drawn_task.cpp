#include "drawn_task.hpp"

#include "drawn_kinds.hpp"

namespace linkwright::soak {

Json drawn_task(Draw& draw, const Sheet& sheet, std::string_view kind) {
  if (kind.starts_with("three")) return drawn_three_positions(draw, sheet, kind);
  if (kind.starts_with("four")) return drawn_four_positions(draw, sheet, kind);
  if (kind.starts_with("five")) return drawn_five_positions(draw, sheet, kind);
  if (kind.starts_with("pairs")) return drawn_pairs(draw, sheet, kind);
  if (kind.starts_with("function")) return drawn_function(draw, sheet, kind);
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
