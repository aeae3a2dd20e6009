#pragma once

#include "linkwright/core/angle.hpp"

namespace linkwright {

/// The one of the angles φ + 2πk in [from, from + 2π).
[[nodiscard]] inline double turned_into(double angle, double from) { return from + wrap_positive(angle - from); }

}  // namespace linkwright
