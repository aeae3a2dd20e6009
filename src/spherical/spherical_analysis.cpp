#include "linkwright/spherical/spherical_analysis.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/tolerance.hpp"
#include "spherical/spherical_triangle.hpp"

namespace linkwright {
namespace {

// The range in which the input stands, moved by whole turns so that its angle is in it.
AngleRange range_around(const std::vector<AngleRange>& ranges, double input_angle) {
  AngleRange nearest{input_angle, input_angle};
  double least = two_pi;
  for (const AngleRange& range : ranges) {
    const double from_low = wrap_positive(input_angle - range.from), length = range.to - range.from;
    const double missed = std::max(0.0, std::min(from_low - length, two_pi - from_low));
    if (missed >= least) continue;
    least = missed;
    const double low =
        from_low - length > two_pi - from_low ? input_angle + (two_pi - from_low) : input_angle - from_low;
    nearest = {low, low + length};
  }
  return nearest;
}

SphericalState state_at(const SphericalFourBar& bars, const SphericalConfiguration& there) {
  SphericalState state;
  state.configuration = there;
  state.four_bar = placed(bars, there);
  state.turn = coupler_turn(bars, state.four_bar);
  state.transmission_angle = transmission_angle(state.four_bar);
  state.velocity_ratio = velocity_ratio(state.four_bar);
  return state;
}

// Where on the drive the linkage stands in an orientation; nothing where it is assembled otherwise there.
std::optional<double> input_of(const SphericalFourBar& bars, const SphericalAnalysis& analysis,
                               const UnitQuaternion& turn) {
  constexpr double met = 1e-6;
  const SphericalFourBar wanted{bars.input_fixed, turn.apply(bars.input_moving), turn.apply(bars.output_moving),
                                bars.output_fixed};
  const double length = analysis.input_range.to - analysis.input_range.from;
  const double from_low = wrap_positive(configuration_of(wanted).input_angle - analysis.input_range.from);
  if (from_low > length + met && from_low < two_pi - met) return std::nullopt;
  const double input = analysis.input_range.from + (from_low > length + met ? 0 : std::min(from_low, length));
  const auto there = assemble(analysis.angles, input, assembly_of(bars));
  if (!there || norm(placed(bars, *there).output_moving - wanted.output_moving) > met) return std::nullopt;
  return input;
}

}  // namespace

SphericalAnalysis analyze(const SphericalFourBar& bars, std::span<const PrescribedOrientation> orientations,
                          int steps) {
  SphericalAnalysis analysis;
  analysis.angles = bars.angles();
  analysis.type = linkage_type(analysis.angles);
  analysis.triple_rocker = triple_rocker_kind(analysis.angles);
  if (analysis.type == LinkageType::degenerate) return analysis;
  analysis.configuration = configuration_of(bars);
  analysis.dead_points = dead_points(analysis.angles);
  analysis.transmission_angle = transmission_angle(bars);
  analysis.velocity_ratio = velocity_ratio(bars);
  analysis.input_range = range_around(input_ranges(analysis.angles), analysis.configuration.input_angle);
  struct Stop {
    double input;
    std::optional<int> position;
  };
  std::vector<Stop> stops;
  for (int k = 0; k <= steps; ++k)
    stops.push_back(
        {analysis.input_range.from + (analysis.input_range.to - analysis.input_range.from) * k / steps, {}});
  for (std::size_t j = 0; j < orientations.size(); ++j) {
    const UnitQuaternion turn = orientations[j].orientation * orientations[0].orientation.inverse();
    if (const auto input = input_of(bars, analysis, turn)) stops.push_back({*input, static_cast<int>(j) + 1});
  }
  std::stable_sort(stops.begin(), stops.end(), [](const Stop& a, const Stop& b) { return a.input < b.input; });
  for (const Stop& stop : stops)
    if (const auto there = assemble(analysis.angles, stop.input, assembly_of(bars))) {
      analysis.motion.push_back(state_at(bars, *there));
      analysis.motion.back().position = stop.position;
    }
  if (input_is_crank(analysis.type)) {
    const LinkAngles& l = analysis.angles;
    const auto at = [&](double diagonal) { return acute_angle(angle_opposite_arc(diagonal, l.coupler, l.output)); };
    analysis.min_transmission_angle = std::min(at(std::abs(l.ground - l.input)), at(shorter_arc(l.ground + l.input)));
  }
  return analysis;
}

std::vector<Vector3> coupler_path(const SphericalAnalysis& analysis, Vector3 axis) {
  std::vector<Vector3> path;
  for (const SphericalState& state : analysis.motion) path.push_back(state.turn.apply(axis));
  return path;
}

}  // namespace linkwright
