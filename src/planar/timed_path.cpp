#include "linkwright/planar/timed_path.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/defects.hpp"
#include "linkwright/mechanism/position.hpp"
#include "planar/turned_arm.hpp"

namespace linkwright {
namespace {

// From the crank's moving pivot to the point, with derivatives: what is left of the point's way after the crank's.
std::vector<Point> coupler_arm(const FourBar& bars, const PrescribedPose& there, double turned) {
  std::vector<double> rates;
  for (const PoseDerivative& d : there.derivatives) rates.push_back(d.angle);
  std::vector<Point> arm = turned_arm(bars.input_moving - bars.input_fixed, turned, rates);
  for (std::size_t m = 0; m < arm.size(); ++m)
    arm[m] = (m == 0 ? there.pose.origin - bars.input_fixed : there.derivatives[m - 1].origin) - arm[m];
  return arm;
}

FourBar moved_to(const FourBar& bars, const Pose& first, const Pose& there) {
  return {bars.input_fixed, displaced(bars.input_moving, first, there), bars.output_fixed,
          displaced(bars.output_moving, first, there)};
}

// Within the range of input angles that holds it; nothing outside.
std::optional<double> within(const AngleRange& range, double angle) {
  for (const double whole_turn : {0.0, two_pi})
    if (angle + whole_turn >= range.from && angle + whole_turn <= range.to) return angle + whole_turn;
  return std::nullopt;
}

// Places along a circuit that is closed by a period.
struct CircuitPlaces {
  std::vector<double> at;
  double period = two_pi;
};

// A rocker runs over its range in one assembly and back in the other.
std::optional<CircuitPlaces> places_on_circuit(const FourBar& bars, std::span<const PrescribedPose> poses) {
  const std::vector<AngleRange> ranges = input_ranges(bars.lengths());
  const double start = configuration_of(bars).input_angle;
  const auto range = std::find_if(ranges.begin(), ranges.end(), [&](const AngleRange& r) { return within(r, start); });
  if (range == ranges.end()) return std::nullopt;
  CircuitPlaces places;
  const double span = range->to - range->from;
  const bool is_crank = range->is_full_turn();
  if (!is_crank) places.period = 2 * span;
  for (const PrescribedPose& pose : poses) {
    const FourBar there = moved_to(bars, poses.front().pose, pose.pose);
    const auto angle = within(*range, configuration_of(there).input_angle);
    if (!angle) return std::nullopt;
    const double along = *angle - range->from;
    places.at.push_back(is_crank || assembly_of(there) == Assembly::positive ? along : 2 * span - along);
  }
  return places;
}

}  // namespace

std::vector<PrescribedPose> path_poses(const FourBar& bars, std::span<const PrescribedPose> crank_poses) {
  const Point first = crank_poses.front().pose.origin - bars.input_moving;
  std::vector<PrescribedPose> poses;
  for (const PrescribedPose& there : crank_poses) {
    const std::vector<Point> arm = coupler_arm(bars, there, there.pose.angle - crank_poses.front().pose.angle);
    const bool is_first = &there == &crank_poses.front();
    PrescribedPose pose{{there.pose.origin, is_first ? 0 : std::arg(arm[0] * std::conj(first))}, {}};
    const std::vector<double> rates = turn_rates(arm);
    for (std::size_t m = 0; m < rates.size(); ++m) pose.derivatives.push_back({there.derivatives[m].origin, rates[m]});
    poses.push_back(std::move(pose));
  }
  return poses;
}

FourBar timed_cognate(const FourBar& bars, Point point) {
  const Point crank = bars.input_moving - bars.input_fixed;
  const Point similar = (point - bars.input_moving) / (bars.output_moving - bars.input_moving);
  const Point fixed = bars.input_fixed + similar * (bars.output_fixed - bars.input_fixed);
  const Point moving = fixed + (1.0 - similar) * crank;
  const Point back = -similar / (1.0 - similar);
  return {fixed, moving, fixed + (bars.input_fixed - fixed) / back, moving + (point - moving) / back};
}

std::optional<bool> circuit_order(const FourBar& bars, std::span<const PrescribedPose> poses) {
  constexpr bool respect_direction = false;
  if (find_defects(bars, poses, respect_direction).defects.circuit()) return std::nullopt;
  const auto places = places_on_circuit(bars, poses);
  if (!places) return std::nullopt;
  std::vector<double> from_first;
  for (const double at : places->at) {
    const double way = std::fmod(at - places->at.front(), places->period);
    from_first.push_back(way < 0 ? way + places->period : way);
  }
  const auto others = from_first.begin() + 1;
  return std::is_sorted(others, from_first.end()) || std::is_sorted(others, from_first.end(), std::greater<>{});
}

TimedPath timed_path(const FourBar& bars, std::span<const PrescribedPose> crank_poses) {
  TimedPath path;
  const std::vector<PrescribedPose> poses = path_poses(bars, crank_poses);
  path.point = poses.front().pose.origin;
  for (const PrescribedPose& pose : crank_poses) path.input.push_back(pose.pose.angle - crank_poses.front().pose.angle);
  for (const PrescribedPose& pose : poses) path.coupler.push_back(pose.pose.angle);
  path.cognate = timed_cognate(bars, path.point);
  path.cognate_size = path.cognate->lengths().input / bars.lengths().input;
  path.full_turn = input_is_crank(linkage_type(bars.lengths()));
  path.circuit_order = circuit_order(bars, poses);
  return path;
}

}  // namespace linkwright
