#pragma once

#include <span>
#include <vector>

#include "linkwright/algebra/point.hpp"

namespace linkwright {

/// An arm turned by an angle (radians) and, to each derivative of the angle, the same derivative of the arm:
/// v = e^{iα} arm, v′ = iα′v and so on. At most four derivatives.
[[nodiscard]] std::vector<Point> turned_arm(Point arm, double angle, std::span<const double> rates);

/// The reverse: derivatives of the angle of an arm from its own, of which the first entry is the arm itself; 0 of an
/// arm without length.
[[nodiscard]] std::vector<double> turn_rates(const std::vector<Point>& arm);

}  // namespace linkwright
