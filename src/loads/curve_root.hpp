#pragma once

#include <functional>
#include <optional>

namespace linkwright {

/// Over a travel; nothing where it is not defined.
using Curve = std::function<std::optional<double>(double turn)>;

/// Where a curve changes its sign between two turns, to rounding. Not defined is above 0.
[[nodiscard]] double root_between(double low, double high, const Curve& curve);

}  // namespace linkwright
