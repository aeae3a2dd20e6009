#include "linkwright/region/pivot_windows.hpp"

#include <algorithm>
#include <cmath>

namespace linkwright {

bool contains(const PivotWindow& window, Vector3 hinge) {
  return std::visit([&](const auto& of_shape) { return of_shape.contains(hinge); }, window);
}

double distance_to(const PivotWindow& window, Vector3 hinge) {
  if (contains(window, hinge)) return 0;
  if (const auto* cone = std::get_if<Cone>(&window)) return cone->angle_to(hinge) - cone->half_angle;
  const Box& box = std::get<Box>(window);
  return std::hypot(hinge.x - std::clamp(hinge.x, box.x_low, box.x_high),
                    hinge.y - std::clamp(hinge.y, box.y_low, box.y_high));
}

void append_border_values(const PivotWindow& window, Vector3 hinge, std::vector<double>& values) {
  if (const auto* cone = std::get_if<Cone>(&window)) {
    // Of a line, either sense: smooth across the plane at right angles to the axis as well.
    const double along = dot(normalized(cone->axis), hinge), border = std::cos(cone->half_angle);
    values.push_back(along * along - border * border);
    return;
  }
  const Box& box = std::get<Box>(window);
  values.insert(values.end(), {hinge.x - box.x_low, hinge.x - box.x_high, hinge.y - box.y_low, hinge.y - box.y_high});
}

bool PivotWindows::hold(const GroundedLinkPivots& link) const {
  return (!ground || (link.ground && contains(*ground, *link.ground))) &&
         (!moving || (link.moving && contains(*moving, *link.moving)));
}

std::optional<std::vector<double>> PivotWindows::border_values(const GroundedLinkPivots& link) const {
  if ((ground && !link.ground) || (moving && !link.moving)) return std::nullopt;
  std::vector<double> values;
  if (ground) append_border_values(*ground, *link.ground, values);
  if (moving) append_border_values(*moving, *link.moving, values);
  return values;
}

std::vector<AxisArc> arcs_within(const MapAxis& axis, std::vector<double> knots, const PivotWindows& windows,
                                 const std::function<GroundedLinkPivots(double)>& pivots_at,
                                 std::vector<double> borders) {
  for (const CurveBranch& branch : axis.branches) {
    knots.push_back(branch.from);
    if (branch.to > branch.from) knots.push_back(std::nextafter(branch.to, branch.from));
  }
  std::sort(knots.begin(), knots.end());
  knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
  const auto values_at = [&](double coordinate) { return windows.border_values(pivots_at(coordinate)); };
  const std::vector<double> between = borders_between(knots, values_at);
  borders.insert(borders.end(), between.begin(), between.end());
  return arcs_where(axis, std::move(borders), [&](double coordinate) { return windows.hold(pivots_at(coordinate)); });
}

PivotWindows windows_of(const Requirements& wanted, const LinkageClass& linkages) {
  PivotWindows windows;
  for (const RequirementKind kind : linkages.requirements) {
    const Criterion& asked = criterion(kind);
    if (const auto window = asked.window(wanted))
      (asked.rule == Criterion::Rule::ground_inside ? windows.ground : windows.moving) = window;
  }
  return windows;
}

}  // namespace linkwright
