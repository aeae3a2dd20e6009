#pragma once

#include "linkwright/algebra/vector3.hpp"

namespace linkwright {

/// The direction in which the great circle from one axis to another sets out: at right angles to the first.
[[nodiscard]] inline Vector3 tangent(Vector3 from, Vector3 to) { return normalized(cross(cross(from, to), from)); }

}  // namespace linkwright
