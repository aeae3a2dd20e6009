#pragma once

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

/// Where along an axis a condition holds that can change only at `borders` (in any order; others than those where it
/// changes do no harm): by rising coordinate, each within a branch. A border at which alone it holds, where a curve
/// touches a window or crosses one without height, is an arc of its own.
[[nodiscard]] std::vector<AxisArc> arcs_where(const MapAxis& axis, std::vector<double> borders,
                                              const std::function<bool(double coordinate)>& holds);

/// Where functions of one coordinate vanish that are smooth between `knots` (rising, those of a branch after those of
/// the one before), each knot with the value of every function there, nothing where they have none. Between two knots a
/// function may turn round once: its extremum is found first. Infinite values between two knots are taken for a border.
/// A coordinate at which one only touches zero to rounding is given, too.
using BorderValues = std::function<std::optional<std::vector<double>>(double coordinate)>;
[[nodiscard]] std::vector<double> borders_between(std::span<const double> knots, const BorderValues& values_at);

/// The arcs within [low, high].
[[nodiscard]] std::vector<AxisArc> clipped(const std::vector<AxisArc>& arcs, double low, double high);

/// `count` coordinates over an arc, its ends left out; one of an arc that is a single place.
[[nodiscard]] std::vector<double> samples_over(const AxisArc& arc, int count);

}  // namespace linkwright
