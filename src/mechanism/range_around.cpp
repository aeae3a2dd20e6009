#include "range_around.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/angle.hpp"

namespace linkwright {

AngleRange range_around(const std::vector<AngleRange>& ranges, double angle) {
  AngleRange best = {angle, angle};
  double best_distance = two_pi;
  for (const AngleRange& range : ranges) {
    const double middle = (range.from + range.to) / 2, half = (range.to - range.from) / 2;
    const double offset = wrap_signed(angle - middle);
    const double distance = std::max(0.0, std::abs(offset) - half);
    if (distance >= best_distance) continue;
    best_distance = distance;
    best = {angle - offset - half, angle - offset + half};
  }
  return best;
}

}  // namespace linkwright
