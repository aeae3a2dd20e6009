#include "linkwright/region/linkage_family.hpp"

namespace linkwright {

double LinkageFamily::axis_value(Side /*side*/, double coordinate) const { return coordinate; }

std::vector<double> LinkageFamily::samples(Side side, int count, Spacing /*spacing*/) const {
  const MapAxis& along = axis(side);
  std::vector<double> coordinates;
  if (along.is_discrete()) {
    for (const CurveBranch& branch : along.branches) coordinates.push_back((branch.from + branch.to) / 2);
    return coordinates;
  }
  for (int i = 0; i < count && along.coordinate_length() > 0; ++i)
    coordinates.push_back(along.coordinate_length() * (i + 0.5) / count);
  return coordinates;
}

std::vector<double> samples_within(const LinkageFamily& family, Side side, const std::optional<MapWindow>& window,
                                   int count, Spacing spacing) {
  if (!window || family.axis(side).is_discrete()) return family.samples(side, count, spacing);
  const auto [low, high] = side == Side::input ? window->input : window->output;
  std::vector<double> coordinates;
  for (int i = 0; i < count; ++i) coordinates.push_back(low + (high - low) * (i + 0.5) / count);
  return coordinates;
}

bool is_within(const LinkageFamily& family, const std::optional<MapWindow>& window, MapPoint point) {
  const auto holds = [&](Side side, const std::array<double, 2>& interval, double coordinate) {
    return family.axis(side).is_discrete() || (coordinate >= interval[0] && coordinate <= interval[1]);
  };
  return !window ||
         (holds(Side::input, window->input, point.input) && holds(Side::output, window->output, point.output));
}

}  // namespace linkwright
