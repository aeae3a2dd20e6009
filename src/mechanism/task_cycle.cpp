#include "linkwright/mechanism/task_cycle.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/pose_visits.hpp"
#include "range_around.hpp"
#include "transmission_angle.hpp"

namespace linkwright {
namespace {

/// A place of the cycle: where it comes nearest to a pose, or any other.
struct CycleStop {
  double turn = 0;
  int pose = -1;
};

/// A way of the input in one assembly, turns from pose 0.
struct Leg {
  double from = 0, to = 0;
  Assembly assembly{};
};

class Cycle {
 public:
  Cycle(const FourBar& four_bar, std::span<const PrescribedPose> poses, double step)
      : poses_(poses), step_(step), visits_(pose_visits(four_bar, poses)), lengths_(four_bar.lengths()) {
    if (visits_.four_bars.empty()) return;
    start_ = configuration_of(four_bar);
    last_ = start_;
    ground_ = std::arg(four_bar.output_fixed - four_bar.input_fixed);
    range_ = range_around(input_ranges(lengths_), start_.input_angle);
    range_ = {range_.from - start_.input_angle, range_.to - start_.input_angle};
  }

  [[nodiscard]] std::vector<CycleState> states() {
    if (visits_.four_bars.empty()) return {};
    record({0, 0}, visits_.assembly.front());
    for (const Leg& leg : legs())
      for (const CycleStop& stop : stops_of(leg)) record(stop, leg.assembly);
    return std::move(states_);
  }

 private:
  [[nodiscard]] std::vector<Leg> legs() const {
    const Assembly here = visits_.assembly.front();
    const double sense = visits_.counter_clockwise ? 1 : -1;
    if (visits_.full_turn) return {{0, sense * two_pi, here}};
    const double ahead = visits_.counter_clockwise ? range_.to : range_.from;
    const double behind = visits_.counter_clockwise ? range_.from : range_.to;
    return {{0, ahead, here}, {ahead, behind, opposite(here)}, {behind, 0, here}};
  }

  /// Of a crank the same place within the turn that it makes; a rocker's turn as it is.
  [[nodiscard]] double within_a_turn(double turn) const {
    if (!visits_.full_turn) return turn;
    return visits_.counter_clockwise ? wrap_positive(turn) : -wrap_positive(-turn);
  }

  /// The turn at which a pose wants the input to be, within its reach.
  [[nodiscard]] double wanted_turn(std::size_t pose) const {
    const double turn = configuration_of(visits_.four_bars[pose]).input_angle - start_.input_angle;
    if (visits_.full_turn) return within_a_turn(turn);
    const double middle = (range_.from + range_.to) / 2;
    return std::clamp(middle + wrap_signed(turn - middle), range_.from, range_.to);
  }

  /// How far the moving pivots are from where a pose wants them, and by how much further the input ought to turn
  /// (Gauss–Newton); not at all at a dead point.
  struct Approach {
    double squared = 0, step = 0;
  };
  [[nodiscard]] std::optional<Approach> approach(std::size_t pose, Assembly assembly, double turn) const {
    const auto found = assemble(lengths_, start_.input_angle + turn, assembly);
    if (!found) return std::nullopt;
    const FourBar bars = placed(visits_.four_bars.front(), *found);
    const Point input_gap = visits_.four_bars[pose].input_moving - bars.input_moving,
                output_gap = visits_.four_bars[pose].output_moving - bars.output_moving;
    Approach here{std::norm(input_gap) + std::norm(output_gap), 0};
    if (const auto rates = angle_rates(lengths_, *found)) {
      const Point input_way = Point{0, 1} * (bars.input_moving - bars.input_fixed),
                  output_way = Point{0, rates->output} * (bars.output_moving - bars.output_fixed);
      here.step =
          (dot(input_way, input_gap) + dot(output_way, output_gap)) / (std::norm(input_way) + std::norm(output_way));
    }
    return here;
  }

  /// Where the linkage comes nearest to a pose, from where that wants the input on.
  [[nodiscard]] double nearest_turn(std::size_t pose, Assembly assembly) const {
    constexpr int most_trials = 60;
    double turn = wanted_turn(pose), share = 1;
    auto here = approach(pose, assembly, turn);
    for (int trial = 0; trial < most_trials && here; ++trial) {
      const double next = turn + share * here->step;
      const bool in_reach = visits_.full_turn || (next >= range_.from && next <= range_.to);
      const auto there = in_reach ? approach(pose, assembly, next) : std::nullopt;
      const bool is_nearer = there && there->squared < here->squared;
      if (is_nearer) turn = next, here = there;
      share = is_nearer ? 1 : share / 2;
    }
    return turn;
  }

  /// Where the leg begins is told by the leg before.
  [[nodiscard]] std::vector<CycleStop> stops_of(const Leg& leg) const {
    const double low = std::min(leg.from, leg.to), high = std::max(leg.from, leg.to), too_near = 0.01 * step_;
    std::vector<CycleStop> stops = poses_on(leg);
    const std::size_t met = stops.size();
    const auto add = [&](double turn) {
      const bool taken = std::abs(turn - leg.from) < too_near ||
                         std::any_of(stops.begin(), stops.begin() + static_cast<std::ptrdiff_t>(met),
                                     [&](const CycleStop& stop) { return std::abs(stop.turn - turn) < too_near; });
      if (!taken) stops.push_back({turn, -1});
    };
    for (double k = std::ceil(low / step_); k * step_ <= high; ++k)
      if (std::abs(k * step_ - leg.to) >= too_near) add(k * step_);
    add(leg.to);
    const bool rises = leg.to > leg.from;
    std::stable_sort(stops.begin(), stops.end(),
                     [&](const CycleStop& a, const CycleStop& b) { return rises ? a.turn < b.turn : a.turn > b.turn; });
    return stops;
  }

  [[nodiscard]] std::vector<CycleStop> poses_on(const Leg& leg) const {
    std::vector<CycleStop> stops;
    for (std::size_t pose = 1; pose < poses_.size(); ++pose) {
      if (!visits_.on_circuit[pose] || visits_.assembly[pose] != leg.assembly) continue;
      const double turn = within_a_turn(nearest_turn(pose, leg.assembly));
      if (turn >= std::min(leg.from, leg.to) && turn <= std::max(leg.from, leg.to))
        stops.push_back({turn, static_cast<int>(pose)});
    }
    return stops;
  }

  void record(const CycleStop& stop, Assembly assembly) {
    if (stop.pose == 0) return record(stop, start_, visits_.four_bars.front());
    if (const auto found = assemble(lengths_, start_.input_angle + stop.turn, assembly))
      record(stop, *found, placed(visits_.four_bars.front(), *found));
  }

  void record(const CycleStop& stop, Configuration c, const FourBar& bars) {
    c.coupler_angle = last_.coupler_angle + wrap_signed(c.coupler_angle - last_.coupler_angle);
    c.output_angle = last_.output_angle + wrap_signed(c.output_angle - last_.output_angle);
    last_ = c;
    const Pose body = body_at(bars, c.coupler_angle - start_.coupler_angle);
    const BodyError error =
        stop.pose < 0 ? BodyError{} : body_error(body, poses_[static_cast<std::size_t>(stop.pose)].pose);
    states_.push_back({stop.turn, bars, ground_ + start_.input_angle + stop.turn, ground_ + c.coupler_angle,
                       ground_ + c.output_angle, body, transmission_angle(lengths_, c), angle_rates(lengths_, c),
                       stop.pose, error});
  }

  [[nodiscard]] Pose body_at(const FourBar& bars, double coupler_turn) const {
    const Pose& first = poses_.front().pose;
    const Point arm = first.origin - visits_.four_bars.front().input_moving;
    return {bars.input_moving + direction(coupler_turn) * arm, first.angle + coupler_turn};
  }

  std::span<const PrescribedPose> poses_;
  double step_;
  PoseVisits visits_;
  LinkLengths lengths_;
  Configuration start_{}, last_{};
  double ground_ = 0;   ///< direction of the ground link
  AngleRange range_{};  ///< turns from pose 0
  std::vector<CycleState> states_;
};

}  // namespace

std::vector<CycleState> task_cycle(const FourBar& four_bar, std::span<const PrescribedPose> poses, double step) {
  return Cycle(four_bar, poses, step).states();
}

}  // namespace linkwright
