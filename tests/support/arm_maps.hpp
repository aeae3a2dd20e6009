#pragma once

#include <memory>
#include <vector>

#include "linkwright/region/requirements.hpp"
#include "planar/arm_family.hpp"

namespace linkwright::testing {

/// Nothing is required, so that no elbow is left out.
[[nodiscard]] Requirements anything();

/// The map of a task without mistakes, the largest transmission angle first.
[[nodiscard]] std::shared_ptr<const ArmFamily> arms_of(const PathTask& task, const Requirements& wanted = anything());

/// Where on the map an arm lies.
[[nodiscard]] MapPoint place_of(const PathTask& task, double link, double reach);
/// Where on a map of a pivot's places, which is the plane, it lies: half of the map within the points' size of their
/// middle.
[[nodiscard]] MapPoint place_of(const PathTask& task, Point pivot);
/// Where on the curve of arms that with a circle point, position 1 being a position with an angle.
[[nodiscard]] double curve_coordinate_of(const PathTask& task, Point circle_point);

/// The largest distance between pivots that should be the same.
[[nodiscard]] double off(const FourBar& a, const FourBar& b);
[[nodiscard]] FourBar nearest_of(const std::vector<Cell>& cells, const FourBar& wanted);

}  // namespace linkwright::testing
