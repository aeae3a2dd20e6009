#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "linkwright/region/axis_arcs.hpp"
#include "linkwright/region/criterion.hpp"
#include "linkwright/region/linkage_class.hpp"
#include "linkwright/region/region_map.hpp"
#include "linkwright/region/requirements.hpp"

namespace linkwright {

[[nodiscard]] bool contains(const PivotWindow& window, Vector3 hinge);
/// How far a hinge lies outside, user's unit or radians; 0 inside.
[[nodiscard]] double distance_to(const PivotWindow& window, Vector3 hinge);
/// Smooth functions of a hinge that change sign where it crosses a border: of a box its four sides, of a cone one.
void append_border_values(const PivotWindow& window, Vector3 hinge, std::vector<double>& values);

/// What is required of the places of hinges, position 1: of those on the ground, and of the others.
struct PivotWindows {
  std::optional<PivotWindow> ground, moving;

  [[nodiscard]] bool any() const { return ground || moving; }
  /// A grounded link has its hinges there; one at infinity is nowhere.
  [[nodiscard]] bool hold(const GroundedLinkPivots& link) const;
  /// Of a hinge on the ground and a moving one, one after the other, those of the windows there are. Nothing where a
  /// hinge that has a window is at infinity.
  [[nodiscard]] std::optional<std::vector<double>> border_values(const GroundedLinkPivots& link) const;

  friend bool operator==(const PivotWindows&, const PivotWindows&) = default;
};

/// Where along an axis a grounded link has its hinges in the windows, by its hinges at any coordinate (none: there is
/// no link) and knots in any order, between which and the ends of branches they move smoothly: by borders_between()
/// and the `borders` that are known.
[[nodiscard]] std::vector<AxisArc> arcs_within(const MapAxis& axis, std::vector<double> knots,
                                               const PivotWindows& windows,
                                               const std::function<GroundedLinkPivots(double)>& pivots_at,
                                               std::vector<double> borders = {});

/// Those that the requirements name and the class of linkages has.
[[nodiscard]] PivotWindows windows_of(const Requirements& wanted, const LinkageClass& linkages);

}  // namespace linkwright
