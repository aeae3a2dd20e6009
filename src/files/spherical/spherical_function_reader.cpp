#include "files/function/wanted_function_reader.hpp"
#include "files/spherical/spherical_kind.hpp"
#include "linkwright/core/angle.hpp"

namespace linkwright {

Task read_spherical_function(const JsonValue& value, const std::optional<Box>& /*options_box*/, Mistakes& mistakes) {
  const JsonObject object(value, mistakes, {"kind", "mechanism", "pairs", "function", "ground_angle_deg", "free"});
  SphericalFunctionTask task;
  bool complete = read_wanted_function(object, value, mistakes, task);
  const auto angle = object.require_number("ground_angle_deg");
  complete = complete && angle;
  task.ground_angle = radians(angle.value_or(0));
  if (complete) mistakes.add(mistakes_in(task));
  return task;
}

}  // namespace linkwright
