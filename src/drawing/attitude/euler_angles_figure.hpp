#pragma once

#include <string>

#include "linkwright/attitude/euler_angles.hpp"

namespace linkwright {

/// Three turns as a picture (SVG, 640 px wide): one after another, and together with the axes of all three. Extrinsic
/// angles are drawn as the intrinsic ones that make the same rotation.
[[nodiscard]] std::string draw_euler_angles(const EulerAngles& angles);

}  // namespace linkwright
