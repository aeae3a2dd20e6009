#include "region/ordered_axes.hpp"

#include <algorithm>
#include <utility>

namespace linkwright {

Hill OrderedAxes::hill(std::function<std::optional<double>(double, double)> score_at, MapPoint around) const {
  AxisStretch first = family_.stretch_around(Side::input, around),
              second = family_.stretch_around(Side::output, around);
  if (swapped_) std::swap(first, second);
  return {std::move(score_at), first, second};
}

double longest_axis(const LinkageFamily& family) {
  return std::max(family.axis(Side::input).coordinate_length(), family.axis(Side::output).coordinate_length());
}

}  // namespace linkwright
