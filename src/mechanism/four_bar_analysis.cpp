#include "linkwright/mechanism/four_bar_analysis.hpp"

#include "range_around.hpp"
#include "transmission_angle.hpp"

namespace linkwright {

FourBarAnalysis analyze(const FourBar& four_bar, Point traced) {
  FourBarAnalysis analysis{.lengths = four_bar.lengths()};
  const LinkLengths& lengths = analysis.lengths;
  analysis.type = linkage_type(lengths);
  analysis.change_point = change_point_kind(lengths);
  analysis.excesses = grashof_excesses(lengths);
  analysis.input_ranges = input_ranges(lengths);
  analysis.dead_points = dead_points(lengths);
  analysis.transmission_angle = transmission_angle(lengths, configuration_of(four_bar));
  analysis.min_transmission_angle_full_turn = least_transmission_angle_full_turn(lengths);
  if (!analysis.input_ranges.empty())
    analysis.largest_transmission = largest_transmission_angle(
        lengths, range_around(analysis.input_ranges, configuration_of(four_bar).input_angle));
  if (input_is_crank(analysis.type)) analysis.output_rates = output_rates_full_turn(lengths, assembly_of(four_bar));
  analysis.motion = tabulated_motion(four_bar, traced);
  return analysis;
}

std::vector<MotionState> tabulated_motion(const FourBar& four_bar, Point traced) {
  constexpr int rows = 361;
  const auto ranges = input_ranges(four_bar.lengths());
  const bool turns_fully = !ranges.empty() && ranges.front().is_full_turn();
  return motion_cycle(four_bar, traced, turns_fully ? rows : (rows + 1) / 2);
}

}  // namespace linkwright
