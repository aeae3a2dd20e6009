#pragma once

#include <optional>

#include "linkwright/planar/motion_task.hpp"
#include "linkwright/planar/task_curve.hpp"
#include "linkwright/region/best_cells.hpp"
#include "linkwright/region/requirements.hpp"

namespace linkwright {

/// A place on the map, as a continuous pair of curve coordinates.
struct RegionPlace {
  double input = 0, output = 0;  ///< τ of the driving and of the other side link
};

/// The top of the hill on which a linkage stands: climbed continuously in both coordinates, on the same branches, with
/// the same type and driver, meeting the requirements (max_length set) all the way. Nothing where the linkage does not
/// meet them itself or is at the top already.
[[nodiscard]] std::optional<RegionPlace> improved_linkage(const MotionTask& task, const TaskCurve& given,
                                                          const Requirements& requirements, Objective objective,
                                                          RegionPlace start);

}  // namespace linkwright
