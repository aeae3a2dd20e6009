#include "linkwright/straight_line/line_design.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/tolerance.hpp"

namespace linkwright {

LineDesign line_design(const TracingFourBar& linkage, double scale) {
  const FourBar& bars = linkage.bars;
  double farthest = 0;
  for (const Point p : {bars.input_center, bars.input_circle, bars.output_center, bars.output_circle}) {
    const double distance = std::abs(p - linkage.point);
    if (std::isnan(distance)) return {};
    farthest = std::max(farthest, distance);
  }
  if (!(farthest * tolerance::sliding_pivot <= scale)) return {DesignKind::slider, {}};
  if (!(linkage.shortest() > tolerance::vanishing_link * linkage.longest())) return {};
  return {DesignKind::four_bar, linkage};
}

}  // namespace linkwright
