#include "linkwright/mechanism/spherical_analysis.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/tolerance.hpp"
#include "range_around.hpp"
#include "spherical_triangle.hpp"
#include "turn_extremes.hpp"

namespace linkwright {
namespace {

SphericalState state_at(const SphericalFourBar& bars, const SphericalConfiguration& there) {
  SphericalState state;
  state.configuration = there;
  state.four_bar = placed(bars, there);
  state.turn = coupler_turn(bars, state.four_bar);
  state.transmission_angle = transmission_angle(state.four_bar);
  state.velocity_ratio = velocity_ratio(state.four_bar);
  return state;
}

constexpr double near_orientation = 0.1;  // radians: what is farther off is no position of this drive

// Where the drive comes nearest to an orientation of the coupler.
class NearestInput {
 public:
  NearestInput(const SphericalFourBar& bars, const SphericalAnalysis& analysis, const UnitQuaternion& turn)
      : bars_(bars),
        angles_(analysis.angles),
        range_(analysis.input_range),
        wanted_{bars.input_fixed, turn.apply(bars.input_moving), turn.apply(bars.output_moving), bars.output_fixed} {}

  // Nothing where it is assembled otherwise there.
  [[nodiscard]] std::optional<double> find() const {
    constexpr int most_trials = 60;
    double input = wanted_input(), share = 1;
    auto here = approach(input);
    for (int trial = 0; trial < most_trials && here; ++trial) {
      const double next = std::clamp(input + share * here->step, range_.from, range_.to);
      const auto there = approach(next);
      const bool is_nearer = there && there->squared < here->squared;
      if (is_nearer) input = next, here = there;
      share = is_nearer ? 1 : share / 2;
    }
    return here && std::sqrt(here->squared) <= near_orientation ? std::optional(input) : std::nullopt;
  }

 private:
  // The nearest place of the range.
  [[nodiscard]] double wanted_input() const {
    const double length = range_.to - range_.from;
    const double from_low = wrap_positive(configuration_of(wanted_).input_angle - range_.from);
    if (from_low <= length) return range_.from + from_low;
    return from_low - length < two_pi - from_low ? range_.to : range_.from;
  }

  // How far the moving axes are from where they are wanted, and by how much further the input ought to turn
  // (Gauss–Newton); not at all at a dead point.
  struct Approach {
    double squared = 0, step = 0;
  };
  [[nodiscard]] std::optional<Approach> approach(double input) const {
    const auto found = assemble(angles_, input, assembly_of(bars_));
    if (!found) return std::nullopt;
    const SphericalFourBar there = placed(bars_, *found);
    const Vector3 input_gap = wanted_.input_moving - there.input_moving,
                  output_gap = wanted_.output_moving - there.output_moving;
    Approach here{dot(input_gap, input_gap) + dot(output_gap, output_gap), 0};
    if (const auto ratio = velocity_ratio(there)) {
      const Vector3 input_way = cross(there.input_fixed, there.input_moving),
                    output_way = *ratio * cross(there.output_fixed, there.output_moving);
      here.step = (dot(input_way, input_gap) + dot(output_way, output_gap)) /
                  (dot(input_way, input_way) + dot(output_way, output_way));
    }
    return here;
  }

  const SphericalFourBar& bars_;
  const LinkAngles& angles_;
  AngleRange range_;
  SphericalFourBar wanted_;
};

// π/2 where coupler and output stand at right angles: the diagonal's cosine is then the product of theirs. Else where
// the diagonal has an extreme or the range ends.
TransmissionPeak largest_transmission(const SphericalFourBar& bars, const SphericalAnalysis& analysis) {
  const LinkAngles& l = analysis.angles;
  const AngleRange& range = analysis.input_range;
  const double cosine = (std::cos(l.coupler) * std::cos(l.output) - std::cos(l.ground) * std::cos(l.input)) /
                        (std::sin(l.ground) * std::sin(l.input));
  std::vector<double> candidates = {range.from, range.to, 0, pi};
  // The input angle is counted so that either sign of this cosine may be meant.
  if (std::abs(cosine) <= 1)
    for (const double at : {std::acos(cosine), std::acos(-cosine)}) candidates.insert(candidates.end(), {at, -at});
  TransmissionPeak peak{-1, range.from};
  for (const double candidate : candidates) {
    const double input = candidate + two_pi * std::ceil((range.from - candidate) / two_pi);
    const auto there = input > range.to ? std::nullopt : assemble(l, input, assembly_of(bars));
    if (!there) continue;
    if (const double angle = transmission_angle(placed(bars, *there)); angle > peak.angle) peak = {angle, input};
  }
  return {std::max(peak.angle, 0.0), peak.input_angle};
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
  const auto turn_to = [&](std::size_t j) {
    return orientations[j].orientation * orientations[0].orientation.inverse();
  };
  std::vector<Stop> stops;
  for (int k = 0; k <= steps; ++k)
    stops.push_back(
        {analysis.input_range.from + (analysis.input_range.to - analysis.input_range.from) * k / steps, {}});
  for (std::size_t j = 0; j < orientations.size(); ++j) {
    if (const auto input = NearestInput(bars, analysis, turn_to(j)).find())
      stops.push_back({*input, static_cast<int>(j) + 1});
  }
  std::stable_sort(stops.begin(), stops.end(), [](const Stop& a, const Stop& b) { return a.input < b.input; });
  for (const Stop& stop : stops)
    if (const auto there = assemble(analysis.angles, stop.input, assembly_of(bars))) {
      analysis.motion.push_back(state_at(bars, *there));
      SphericalState& state = analysis.motion.back();
      state.position = stop.position;
      if (stop.position) {
        const UnitQuaternion off = turn_to(static_cast<std::size_t>(*stop.position) - 1) * state.turn.inverse();
        state.orientation_error = 2 * std::atan2(norm(off.v()), std::abs(off.w()));
      }
    }
  analysis.largest_transmission = largest_transmission(bars, analysis);
  if (input_is_crank(analysis.type)) {
    const LinkAngles& l = analysis.angles;
    const auto at = [&](double diagonal) { return acute_angle(angle_opposite_arc(diagonal, l.coupler, l.output)); };
    analysis.velocity_ratios = extremes_over_turn([&](double input) -> std::optional<double> {
      const auto there = assemble(l, input, assembly_of(bars));
      return there ? velocity_ratio(placed(bars, *there)) : std::nullopt;
    });
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
