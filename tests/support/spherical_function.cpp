#include "support/spherical_function.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

#include "linkwright/core/angle.hpp"
#include "support/random_function.hpp"

namespace linkwright::testing {

SphericalFunctionTask spherical_function_case(const std::string& name) {
  const auto c = nlohmann::json::parse(std::ifstream(LINKWRIGHT_DATA_DIR "/spherical/" + name + ".json"))["input"];
  SphericalFunctionTask task;
  task.ground_angle = c["frame_angle"];
  for (std::size_t j = 0; j < c["theta"].size(); ++j) task.pairs.push_back({c["theta"][j], c["psi"][j], {}});
  return task;
}

SphericalFunctionTask named_spherical_task(const std::string& expression, std::array<double, 2> x, double input_deg,
                                           double output_deg, double ground_deg) {
  return {named_task(expression, x, input_deg, output_deg), radians(ground_deg)};
}

}  // namespace linkwright::testing
