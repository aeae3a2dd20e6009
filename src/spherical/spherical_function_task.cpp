#include "linkwright/spherical/spherical_function_task.hpp"

#include <cmath>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {

std::array<Vector3, 2> fixed_axes(double ground_angle) {
  return {Vector3{0, 0, 1}, Vector3{std::sin(ground_angle), 0, std::cos(ground_angle)}};
}

std::vector<Error> mistakes_in(const SphericalFunctionTask& task) {
  std::vector<Error> found = mistakes_in(static_cast<const WantedFunction&>(task));
  const double least = tolerance::parallel_lines;
  if (!(task.ground_angle > least && task.ground_angle < pi - least))
    found.push_back(
        {"ground_angle_range", "task.ground_angle_deg",
         "the angle between the fixed axes lies between 0 and 180 degrees; at either end they are one line, "
         "and a planar four-bar is what you want"});
  return found;
}

SphericalFunctionTask task_at(const SphericalFunctionTask& task, double value) {
  return {wanted_at(task, value), task.ground_angle};
}

}  // namespace linkwright
