#include "linkwright/mechanism/drive_table.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <vector>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/position.hpp"
#include "transmission_angle.hpp"
#include "triangle.hpp"
#include "turn_extremes.hpp"

namespace linkwright {
namespace {

/// A place of the travel: a pose, or any other.
struct Stop {
  double turn = 0;
  int pose = -1;
};

std::vector<Stop> stops_of(const PoseVisits& visits, int samples) {
  std::vector<Stop> stops;
  for (const int pose : visits.order) stops.push_back({visits.turn[static_cast<std::size_t>(pose)], pose});
  const auto [from, to] = visits.travel;
  const double step = (to - from) / (samples - 1), too_near = 0.01 * step;
  const std::size_t poses = stops.size();
  for (int i = 0; i < samples; ++i) {
    const double turn = i + 1 == samples ? to : from + i * step;
    const bool taken = std::any_of(stops.begin(), stops.begin() + static_cast<std::ptrdiff_t>(poses),
                                   [&](const Stop& stop) { return std::abs(stop.turn - turn) < too_near; });
    if (!taken) stops.push_back({turn, -1});
  }
  std::sort(stops.begin(), stops.end(),
            [](const Stop& a, const Stop& b) { return std::tie(a.turn, a.pose) < std::tie(b.turn, b.pose); });
  return stops;
}

/// Makes states of one four-bar and strings them together, angles running on without jumps.
class DriveRecorder {
 public:
  DriveRecorder(const PoseVisits& visits, std::span<const PrescribedPose> poses)
      : visits_(visits),
        poses_(poses),
        reference_(visits.four_bars.front()),
        lengths_(reference_.lengths()),
        start_(configuration_of(reference_)),
        last_(start_) {}

  [[nodiscard]] std::optional<DriveState> state(const Stop& stop) {
    if (stop.pose >= 0) {
      const FourBar& here = visits_.four_bars[static_cast<std::size_t>(stop.pose)];
      DriveState found = recorded(stop.turn, configuration_of(here), here);
      const Pose& pose = poses_[static_cast<std::size_t>(stop.pose)].pose;
      found.body = {pose.origin, pose.angle + two_pi * std::round((found.body.angle - pose.angle) / two_pi)};
      return found;
    }
    const double sense = visits_.counter_clockwise ? 1 : -1;
    const auto configuration = assemble(lengths_, start_.input_angle + sense * stop.turn, visits_.assembly.front());
    if (!configuration) return std::nullopt;
    return recorded(stop.turn, *configuration, placed(reference_, *configuration));
  }

 private:
  DriveState recorded(double turn, Configuration c, const FourBar& bars) {
    c.coupler_angle = last_.coupler_angle + wrap_signed(c.coupler_angle - last_.coupler_angle);
    c.output_angle = last_.output_angle + wrap_signed(c.output_angle - last_.output_angle);
    last_ = c;
    DriveState state;
    state.turn = turn;
    state.four_bar = bars;
    state.coupler_turn = c.coupler_angle - start_.coupler_angle;
    state.output_turn = c.output_angle - start_.output_angle;
    const Pose& first = poses_.front().pose;
    state.body = {bars.input_moving + direction(state.coupler_turn) * (first.origin - reference_.input_moving),
                  first.angle + state.coupler_turn};
    state.transmission_angle = transmission_angle(lengths_, c);
    if (const auto rates = angle_rates(lengths_, c)) {
      state.velocity_ratio = rates->output;
      state.mechanical_advantage = rates->output != 0 ? std::abs(1 / rates->output) : 0;
    }
    return state;
  }

  const PoseVisits& visits_;
  std::span<const PrescribedPose> poses_;
  FourBar reference_;
  LinkLengths lengths_;
  Configuration start_, last_;
};

void turn_by(DriveState& state, double coupler, double output) {
  state.coupler_turn += coupler;
  state.body.angle += coupler;
  state.output_turn += output;
}

}  // namespace

DriveTable drive_table(const PoseVisits& visits, std::span<const PrescribedPose> poses, int samples) {
  DriveTable table;
  if (visits.four_bars.empty()) return table;
  table.full_turn = visits.full_turn;
  table.state_of_pose.assign(poses.size(), -1);
  DriveRecorder recorder(visits, poses);
  for (const Stop& stop : stops_of(visits, samples)) {
    const auto state = recorder.state(stop);
    if (!state) continue;
    if (stop.pose >= 0)
      table.state_of_pose[static_cast<std::size_t>(stop.pose)] = static_cast<int>(table.states.size());
    table.states.push_back(*state);
  }
  // Angles were counted from the travel's beginning; they are told from pose 0.
  const DriveState first = table.states[static_cast<std::size_t>(table.state_of_pose.front())];
  const double coupler = two_pi * std::round(first.coupler_turn / two_pi);
  const double output = two_pi * std::round(first.output_turn / two_pi);
  for (DriveState& state : table.states) turn_by(state, -coupler, -output);
  return table;
}

TransmissionPeak largest_transmission_angle(const LinkLengths& l, const AngleRange& range) {
  if (!are_links(l)) return {};
  // At right angles the diagonal's square is the sum of the other two.
  const double cosine = (l.ground * l.ground + l.input * l.input - l.coupler * l.coupler - l.output * l.output) /
                        (2 * l.ground * l.input);
  std::vector<double> candidates = {range.from, range.to, 0, pi};
  if (std::abs(cosine) <= 1) candidates.insert(candidates.end(), {std::acos(cosine), -std::acos(cosine)});
  TransmissionPeak peak{0, range.from};
  for (const double candidate : candidates) {
    const double input = candidate + two_pi * std::ceil((range.from - candidate) / two_pi);
    const auto there = input > range.to ? std::nullopt : assemble(l, input, Assembly::positive);
    if (!there) continue;
    if (const double angle = transmission_angle(l, *there); angle > peak.angle) peak = {angle, input};
  }
  return peak;
}

std::optional<RatioRange> output_rates_full_turn(const LinkLengths& lengths, Assembly assembly) {
  return extremes_over_turn([&](double input) -> std::optional<double> {
    const auto there = assemble(lengths, input, assembly);
    const auto rates = there ? angle_rates(lengths, *there) : std::nullopt;
    return rates ? std::optional(rates->output) : std::nullopt;
  });
}

}  // namespace linkwright
