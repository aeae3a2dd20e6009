#include "linkwright/straight_line/line_design.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "linkwright/core/tolerance.hpp"

namespace linkwright {

// By squares: a map asks for each of its cells.
LineDesign line_design(const TracingFourBar& linkage, double scale) {
  const FourBar& bars = linkage.bars;
  double farthest = 0;
  for (const Point p : {bars.input_fixed, bars.input_moving, bars.output_fixed, bars.output_moving}) {
    const Point away = p - linkage.point;
    const double square = std::norm(away);
    if (!std::isnan(square))
      farthest = std::max(farthest, square);
    else if (std::isinf(away.real()) || std::isinf(away.imag()))
      farthest = std::numeric_limits<double>::infinity();
    else
      return {};
  }
  constexpr double sliding = tolerance::sliding_pivot, vanishing = tolerance::vanishing_link;
  if (!(farthest * sliding * sliding <= scale * scale)) return {DesignKind::slider, {}};
  double shortest = std::numeric_limits<double>::infinity(), longest = 0;
  for (const Point link : {bars.output_fixed - bars.input_fixed, bars.input_moving - bars.input_fixed,
                           bars.output_moving - bars.input_moving, bars.output_moving - bars.output_fixed,
                           linkage.point - bars.input_moving, linkage.point - bars.output_moving}) {
    shortest = std::min(shortest, std::norm(link));
    longest = std::max(longest, std::norm(link));
  }
  if (!(shortest > vanishing * vanishing * longest)) return {};
  return {DesignKind::four_bar, linkage};
}

}  // namespace linkwright
