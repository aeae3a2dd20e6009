#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "linkwright/region/map_axis.hpp"

namespace linkwright {

/// A stretch of an axis of a map, ends included; a single place where they are equal.
struct AxisArc {
  double from = 0, to = 0;

  friend bool operator==(const AxisArc&, const AxisArc&) = default;
};

/// The stretches of an axis on which a condition holds.
struct AxisArcs {
  std::vector<AxisArc> arcs;
  bool are_all = false;  ///< proved: it can change at roots that were all computed; else these were sought by samples
};

/// Where along an axis a condition holds that can change only at `borders` (in any order; others than those where it
/// changes do no harm): by rising coordinate, each within a branch. A border at which alone it holds, where a curve
/// touches a window or crosses one without height, is an arc of its own.
[[nodiscard]] std::vector<AxisArc> arcs_where(const MapAxis& axis, std::vector<double> borders,
                                              const std::function<bool(double coordinate)>& holds);

/// Where functions of one coordinate vanish that are smooth between `knots` (rising, those of a branch after those of
/// the one before), each knot with the value of every function there, nothing where they have none. Between two knots a
/// function may turn round once: where three knots show an extremum that comes near zero, it is found first. A pole
/// between two knots is taken for a border where the sign changes, and may hide others. A coordinate at which one only
/// touches zero to rounding is given, too.
using BorderValues = std::function<std::optional<std::vector<double>>(double coordinate)>;
[[nodiscard]] std::vector<double> borders_between(std::span<const double> knots, const BorderValues& values_at);

/// What an interval of the coordinate names of an axis: where that closes it may begin before the beginning, or go on
/// behind the end, which are one place; all of an axis that is discrete.
[[nodiscard]] std::vector<AxisArc> arcs_of(const MapAxis& axis, const std::array<double, 2>& interval);

/// What of the arcs lies within others, which do not meet.
[[nodiscard]] std::vector<AxisArc> clipped(const std::vector<AxisArc>& arcs, const std::vector<AxisArc>& within);

/// `count` coordinates over an arc, its ends left out; one of an arc that is a single place.
[[nodiscard]] std::vector<double> samples_over(const AxisArc& arc, int count);

}  // namespace linkwright
