#include "linkwright/region/map_axis.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/angle.hpp"

namespace linkwright {
namespace {

constexpr std::array<std::string_view, 30> quantity_names = {
    "curve_coordinate", "burmester_point", "side_direction", "side_length", "output_scale", "pair_output",
    "nothing",          "link_direction",  "link_ray",       "point_ray",   "pole_height",  "pivot_height",
    "frame_height",     "pivot_distance",  "output_arm",     "link_length", "crank_length", "point_arm",
    "crank_range",      "center_x",        "center_y",       "circle_x",    "circle_y",     "center_on_line",
    "circle_on_line",   "arm_reach",       "arm_difference", "layer",       "fitted_curve", "realisation"};

}  // namespace

std::string_view name(AxisQuantity quantity) { return quantity_names[static_cast<std::size_t>(quantity)]; }
bool is_angle(AxisQuantity quantity) {
  switch (quantity) {
    case AxisQuantity::side_direction:
    case AxisQuantity::pair_output:
    case AxisQuantity::link_direction:
    case AxisQuantity::link_ray:
    case AxisQuantity::point_ray:
    case AxisQuantity::crank_range:
      return true;
    default:
      return false;
  }
}

std::string_view name(Spacing spacing) { return spacing == Spacing::coordinate ? "coordinate" : "arc_length"; }

double AxisStretch::onto(double coordinate) const {
  if (closed) return from + wrap_period(coordinate - from, to - from);
  return std::clamp(coordinate, from, std::max(from, std::nextafter(to, from)));
}

double MapAxis::onto(double coordinate) const {
  const double length = coordinate_length();
  if (layers > 0 && coordinate >= 1 && coordinate < layers + 1) return coordinate - std::floor(coordinate);
  const bool is_on = coordinate >= 0 && coordinate < length;
  return is_on || !is_closed() || !(length > 0) ? coordinate : wrap_period(coordinate, length);
}

AxisStretch MapAxis::stretch_around(double coordinate) const {
  const double branch = std::floor(coordinate);
  return {branch, branch + 1, is_closed()};
}

}  // namespace linkwright
