#include "linkwright/files/csv_table.hpp"

#include <fmt/format.h>
#include <initializer_list>
#include <string_view>

#include "linkwright/analysis/position.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/number_text.hpp"
#include "linkwright/mechanism/tracing_four_bar.hpp"

namespace linkwright {
namespace {

constexpr std::string_view four_bar_header =
    "driver_turn_from_position_1_deg,input_angle_from_x_deg,coupler_angle_from_x_deg,output_angle_from_x_deg,"
    "input_circle_x,input_circle_y,output_circle_x,output_circle_y,body_x,body_y,body_theta_deg,transmission_angle_deg,"
    "coupler_rate,output_rate,coupler_acceleration,output_acceleration,position";

constexpr double row_step = radians(1);

void put_numbers(std::string& line, std::initializer_list<double> numbers) {
  for (const double number : numbers) {
    if (!line.empty()) line += ',';
    line += exact_text(number);
  }
}

std::string table_line(const CycleState& state) {
  std::string line;
  const FourBar& bars = state.four_bar;
  put_numbers(line, {degrees(state.turn), degrees(state.input_angle), degrees(state.coupler_angle),
                     degrees(state.output_angle), bars.input_circle.real(), bars.input_circle.imag(),
                     bars.output_circle.real(), bars.output_circle.imag(), state.body.origin.real(),
                     state.body.origin.imag(), degrees(state.body.angle), degrees(state.transmission_angle)});
  if (state.rates)
    put_numbers(line, {state.rates->coupler, state.rates->output, state.rates->coupler_acceleration,
                       state.rates->output_acceleration});
  else
    line += ",,,,";
  return line + (state.pose < 0 ? "," : fmt::format(",{}", state.pose + 1));
}

}  // namespace

std::string motion_table(const StoredLinkage& linkage) {
  std::string table(four_bar_header);
  table += linkage.point ? ",point_x,point_y\n" : "\n";
  for (const CycleState& state : tabulated_cycle(linkage)) {
    std::string line = table_line(state);
    if (linkage.point) {
      const Point point = TracingFourBar{linkage.four_bar, *linkage.point}.moved_to(state.four_bar).point;
      put_numbers(line, {point.real(), point.imag()});
    }
    table += line + "\n";
  }
  return table;
}

std::vector<CycleState> tabulated_cycle(const StoredLinkage& linkage) {
  return task_cycle(linkage.four_bar, framed_poses(linkage), row_step);
}

std::vector<PrescribedPose> framed_poses(const StoredLinkage& linkage) {
  if (!linkage.poses.empty()) return linkage.poses;
  return {{{linkage.four_bar.input_circle, 0}, {}}};
}

Point traced_point(const StoredLinkage& linkage) {
  if (linkage.point) return *linkage.point;
  return linkage.poses.empty() ? linkage.four_bar.input_circle : linkage.poses.front().pose.origin;
}

}  // namespace linkwright
