#include "linkwright/io/csv_table.hpp"

#include <initializer_list>
#include <string_view>

#include "linkwright/analysis/position.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/io/number_text.hpp"

namespace linkwright {
namespace {

constexpr std::string_view header =
    "input_angle_deg,coupler_angle_deg,output_angle_deg,input_circle_x,input_circle_y,output_circle_x,output_circle_y,"
    "coupler_point_x,coupler_point_y,transmission_angle_deg,coupler_rate,output_rate,coupler_acceleration,"
    "output_acceleration\n";

void put_numbers(std::string& line, std::initializer_list<double> numbers) {
  for (const double number : numbers) {
    if (!line.empty()) line += ',';
    line += exact_text(number);
  }
}

std::string table_line(const MotionState& state) {
  std::string line;
  const Configuration& angles = state.configuration;
  const FourBar& bars = state.four_bar;
  put_numbers(line,
              {degrees(angles.input_angle), degrees(angles.coupler_angle), degrees(angles.output_angle),
               bars.input_circle.real(), bars.input_circle.imag(), bars.output_circle.real(), bars.output_circle.imag(),
               state.coupler_point.real(), state.coupler_point.imag(), degrees(state.transmission_angle)});
  if (!state.rates) return line + ",,,,\n";
  put_numbers(line, {state.rates->coupler, state.rates->output, state.rates->coupler_acceleration,
                     state.rates->output_acceleration});
  return line + '\n';
}

}  // namespace

std::string motion_table(std::span<const MotionState> motion) {
  std::string table(header);
  for (const MotionState& state : motion) table += table_line(state);
  return table;
}

std::vector<MotionState> tabulated_motion(const FourBar& four_bar, Point traced) {
  constexpr int rows = 361;
  const auto ranges = input_ranges(four_bar.lengths());
  const bool turns_fully = !ranges.empty() && ranges.front().is_full_turn();
  return motion_cycle(four_bar, traced, turns_fully ? rows : (rows + 1) / 2);
}

Point traced_point(const StoredLinkage& linkage) {
  return linkage.poses.empty() ? linkage.four_bar.input_circle : linkage.poses.front().pose.origin;
}

}  // namespace linkwright
