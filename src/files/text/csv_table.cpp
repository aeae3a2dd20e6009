#include "linkwright/files/csv_table.hpp"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/number_text.hpp"
#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/position.hpp"

namespace linkwright {
namespace {

const std::array four_bar_columns = {"driver_turn_from_position_1_deg",
                                     "input_angle_from_x_deg",
                                     "coupler_angle_from_x_deg",
                                     "output_angle_from_x_deg",
                                     "input_circle_x",
                                     "input_circle_y",
                                     "output_circle_x",
                                     "output_circle_y",
                                     "body_x",
                                     "body_y",
                                     "body_theta_deg",
                                     "transmission_angle_deg",
                                     "coupler_rate",
                                     "output_rate",
                                     "coupler_acceleration",
                                     "output_acceleration",
                                     "position",
                                     "position_error",
                                     "orientation_error_deg"};

constexpr double row_step = radians(1), undefined = std::numeric_limits<double>::quiet_NaN();

void put_row(std::vector<double>& values, const CycleState& state) {
  const FourBar& bars = state.four_bar;
  values.insert(values.end(), {degrees(state.turn), degrees(state.input_angle), degrees(state.coupler_angle),
                               degrees(state.output_angle), bars.input_moving.real(), bars.input_moving.imag(),
                               bars.output_moving.real(), bars.output_moving.imag(), state.body.origin.real(),
                               state.body.origin.imag(), degrees(state.body.angle), degrees(state.transmission_angle)});
  if (state.rates)
    values.insert(values.end(), {state.rates->coupler, state.rates->output, state.rates->coupler_acceleration,
                                 state.rates->output_acceleration});
  else
    values.insert(values.end(), 4, undefined);
  if (state.pose < 0)
    values.insert(values.end(), 3, undefined);
  else
    values.insert(values.end(),
                  {static_cast<double>(state.pose + 1), state.error.distance, degrees(state.error.angle)});
}

}  // namespace

MotionTable motion_columns(const StoredLinkage& linkage) {
  MotionTable table{{four_bar_columns.begin(), four_bar_columns.end()}, {}};
  if (linkage.point) table.columns.insert(table.columns.end(), {"point_x", "point_y"});
  for (const CycleState& state : tabulated_cycle(linkage)) {
    put_row(table.values, state);
    if (!linkage.point) continue;
    const Point point = TracingFourBar{linkage.four_bar, *linkage.point}.moved_to(state.four_bar).point;
    table.values.insert(table.values.end(), {point.real(), point.imag()});
  }
  return table;
}

std::string motion_table(const StoredLinkage& linkage) { return csv_text(motion_columns(linkage)); }

std::vector<CycleState> tabulated_cycle(const StoredLinkage& linkage) {
  return task_cycle(linkage.four_bar, framed_poses(linkage), row_step);
}

std::vector<PrescribedPose> framed_poses(const StoredLinkage& linkage) {
  if (!linkage.poses.empty()) return linkage.poses;
  return {{{linkage.four_bar.input_moving, 0}, {}}};
}

Point traced_point(const StoredLinkage& linkage) {
  if (linkage.point) return *linkage.point;
  return linkage.poses.empty() ? linkage.four_bar.input_moving : linkage.poses.front().pose.origin;
}

std::string csv_text(const MotionTable& table) {
  std::string text = fmt::format("{}\n", fmt::join(table.columns, ","));
  const std::size_t columns = table.columns.size();
  for (std::size_t i = 0; i < table.values.size(); ++i) {
    if (!std::isnan(table.values[i])) text += exact_text(table.values[i]);
    text += (i + 1) % columns == 0 ? '\n' : ',';
  }
  return text;
}

}  // namespace linkwright
