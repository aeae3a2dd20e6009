#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/number_text.hpp"
#include "linkwright/files/six_bar_file.hpp"

namespace linkwright {
namespace {

std::string six_bar_header() {
  std::string text = "driver_turn_from_position_1_deg";
  for (std::size_t joint = 0; joint < SixBar::joint_count; ++joint)
    text += fmt::format(",{0}_x,{0}_y", joint_name(joint));
  return text + ",body_x,body_y,body_theta_deg,transmission_angle_deg,position\n";
}

std::string table_line(const SixBarMotionState& state) {
  const SixBarState& place = state.place;
  std::string line = exact_text(degrees(place.turn));
  const auto put = [&line](double number) { line += ',' + exact_text(number); };
  for (const Point joint : place.joints) {
    put(joint.real());
    put(joint.imag());
  }
  put(place.body.origin.real());
  put(place.body.origin.imag());
  put(degrees(place.body.angle));
  put(degrees(std::asin(std::min(state.sine, 1.0))));
  return line + (place.pose < 0 ? ",\n" : fmt::format(",{}\n", place.pose + 1));
}

}  // namespace

std::string motion_table(const SixBarMotion& motion) {
  std::string table = six_bar_header();
  for (const SixBarMotionState& state : motion.states) table += table_line(state);
  return table;
}

std::vector<PrescribedPose> framed_poses(const StoredSixBar& linkage) {
  if (!linkage.poses.empty()) return linkage.poses;
  return {{{linkage.six_bar.at(SixBar::d), 0}, {}}};
}

StoredSixBarAnalysis analyze(const StoredSixBar& linkage) {
  return {analyze(linkage.six_bar, framed_poses(linkage)), linkage};
}

}  // namespace linkwright
