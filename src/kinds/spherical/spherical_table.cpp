#include <array>
#include <limits>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/spherical_file.hpp"

namespace linkwright {
namespace {

const std::array spherical_columns = {"input_deg",
                                      "output_deg",
                                      "input_moving_x",
                                      "input_moving_y",
                                      "input_moving_z",
                                      "output_moving_x",
                                      "output_moving_y",
                                      "output_moving_z",
                                      "quaternion_w",
                                      "quaternion_x",
                                      "quaternion_y",
                                      "quaternion_z",
                                      "transmission_angle_deg",
                                      "velocity_ratio",
                                      "position",
                                      "orientation_error_deg"};

void put_row(std::vector<double>& values, const SphericalState& state, const UnitQuaternion& first) {
  constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
  const UnitQuaternion orientation = (state.turn * first).canonical();
  const Vector3 input = state.four_bar.input_moving, output = state.four_bar.output_moving, v = orientation.v();
  values.insert(values.end(), {degrees(state.configuration.input_angle), degrees(state.configuration.output_angle),
                               input.x, input.y, input.z, output.x, output.y, output.z, orientation.w(), v.x, v.y, v.z,
                               degrees(state.transmission_angle), state.velocity_ratio.value_or(undefined),
                               state.position ? static_cast<double>(*state.position) : undefined,
                               state.position ? degrees(state.orientation_error) : undefined});
}

}  // namespace

StoredSphericalAnalysis analyze(const StoredSphericalFourBar& linkage) {
  return {analyze(linkage.four_bar, linkage.orientations), linkage};
}

MotionTable motion_columns(const StoredSphericalAnalysis& analysis) {
  const auto& orientations = analysis.linkage.orientations;
  const UnitQuaternion first = orientations.empty() ? GivenOrientation() : orientations.front().orientation;
  MotionTable table{{spherical_columns.begin(), spherical_columns.end()}, {}};
  for (const SphericalState& state : analysis.motion) put_row(table.values, state, first);
  return table;
}

std::string motion_table(const StoredSphericalAnalysis& analysis) { return csv_text(motion_columns(analysis)); }

}  // namespace linkwright
