#include <fmt/format.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/number_text.hpp"
#include "linkwright/files/spherical_file.hpp"

namespace linkwright {
namespace {

constexpr std::string_view spherical_header =
    "input_deg,output_deg,input_moving_x,input_moving_y,input_moving_z,output_moving_x,output_moving_y,"
    "output_moving_z,quaternion_w,quaternion_x,quaternion_y,quaternion_z,transmission_angle_deg,velocity_ratio,"
    "position\n";

std::string state_line(const SphericalState& state, const UnitQuaternion& first) {
  const UnitQuaternion orientation = (state.turn * first).canonical();
  std::string line = exact_text(degrees(state.configuration.input_angle));
  const auto put = [&line](double number) { line += ',' + exact_text(number); };
  put(degrees(state.configuration.output_angle));
  for (const Vector3 axis : {state.four_bar.input_moving, state.four_bar.output_moving})
    for (std::size_t i = 0; i < 3; ++i) put(axis[i]);
  put(orientation.w());
  for (std::size_t i = 0; i < 3; ++i) put(orientation.v()[i]);
  put(degrees(state.transmission_angle));
  line += state.velocity_ratio ? ',' + exact_text(*state.velocity_ratio) : ",";
  return line + (state.position ? fmt::format(",{}\n", *state.position) : ",\n");
}

}  // namespace

StoredSphericalAnalysis analyze(const StoredSphericalFourBar& linkage) {
  return {analyze(linkage.four_bar, linkage.orientations), linkage};
}

std::string motion_table(const StoredSphericalAnalysis& analysis) {
  const auto& orientations = analysis.linkage.orientations;
  const UnitQuaternion first = orientations.empty() ? GivenOrientation() : orientations.front().orientation;
  std::string table(spherical_header);
  for (const SphericalState& state : analysis.motion) table += state_line(state, first);
  return table;
}

}  // namespace linkwright
