#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/six_bar_file.hpp"

namespace linkwright {
namespace {

std::vector<std::string> six_bar_columns() {
  std::vector<std::string> columns{"driver_turn_from_position_1_deg"};
  for (std::size_t joint = 0; joint < SixBar::joint_count; ++joint)
    for (const char* axis : {"x", "y"}) columns.push_back(fmt::format("{}_{}", joint_name(joint), axis));
  columns.insert(columns.end(), {"body_x", "body_y", "body_theta_deg", "transmission_angle_deg", "position",
                                 "position_error", "orientation_error_deg"});
  return columns;
}

void put_row(std::vector<double>& values, const SixBarMotionState& state) {
  const SixBarState& place = state.place;
  values.push_back(degrees(place.turn));
  for (const Point joint : place.joints) values.insert(values.end(), {joint.real(), joint.imag()});
  values.insert(values.end(), {place.body.origin.real(), place.body.origin.imag(), degrees(place.body.angle),
                               degrees(std::asin(std::min(state.sine, 1.0)))});
  if (place.pose < 0)
    values.insert(values.end(), 3, std::numeric_limits<double>::quiet_NaN());
  else
    values.insert(values.end(),
                  {static_cast<double>(place.pose + 1), place.error.distance, degrees(place.error.angle)});
}

}  // namespace

MotionTable motion_columns(const SixBarMotion& motion) {
  MotionTable table{six_bar_columns(), {}};
  for (const SixBarMotionState& state : motion.states) put_row(table.values, state);
  return table;
}

std::string motion_table(const SixBarMotion& motion) { return csv_text(motion_columns(motion)); }

std::vector<PrescribedPose> framed_poses(const StoredSixBar& linkage) {
  if (!linkage.poses.empty()) return linkage.poses;
  return {{{linkage.six_bar.at(SixBar::d), 0}, {}}};
}

StoredSixBarAnalysis analyze(const StoredSixBar& linkage) {
  return {analyze(linkage.six_bar, framed_poses(linkage)), linkage};
}

}  // namespace linkwright
