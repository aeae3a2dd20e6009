#include "circuit_drive.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

double rates_dot(const HingePlaces& a, const HingePlaces& b) { return dot(a[0], b[0]) + dot(a[1], b[1]); }
double rates_norm(const HingePlaces& a) { return std::hypot(norm(a[0]), norm(a[1])); }

/// A pose met on the circuit of pose 0.
struct Meeting {
  int pose = 0;
  double arc = 0;                          ///< arc length on the torus from pose 0; negative: back
  int stretch = 0;                         ///< dead points passed on the way; negative: back
  bool forwards = true, backwards = true;  ///< passed as the pose wants when walking on, when walking back
};

/// The circuit of configurations through pose 0, from there with the input turning counter-clockwise and round. Where
/// it crosses itself, as at a change point: the arc around pose 0 that ends there.
struct Circuit {
  bool closed = false;
  double length = 0;  ///< radians on the torus, ahead of pose 0
  int dead_points = 0;
  std::vector<Meeting> meetings;
  double worst_closure = 0, worst_pose_error = 0, worst_direction_error = 0;
};

bool opposite_signs(double x, double y) { return (x < 0) != (y < 0); }

/// Walks once round the circuit of pose 0 and writes down what it meets.
class Tracer {
 public:
  Tracer(const ConfigurationCurve& curve, std::vector<DriveTarget> targets, const DriveThroughOptions& options)
      : curve_(curve), options_(options), targets_(std::move(targets)) {
    start_ = targets_[0].configuration;
    sense_ = curve_.strand_at(start_).tangent.input < 0 ? -1 : 1;
  }

  [[nodiscard]] Circuit trace() {
    const Strand start = strand_at(start_);
    meet(targets_[0], start, 0, start);
    walk();
    if (!circuit_.closed && circuit_.meetings.size() < targets_.size()) walk_back();
    return std::move(circuit_);
  }

 private:
  using Strand = ConfigurationCurve::Strand;

  [[nodiscard]] Strand strand_at(TorusVector point) const {
    Strand strand = curve_.strand_at(wrapped(point));
    strand.tangent = way_ * sense_ * strand.tangent;
    return strand;
  }

  void walk() {
    Strand here = strand_at(start_);
    for (int i = 0; steps_ < options_.max_steps && !circuit_.closed; ++i, ++steps_) {
      const auto next = step(here, i > 0);
      if (!next) break;
      here = *next;
    }
  }

  /// From pose 0 the other way, where no more can be seen ahead.
  void walk_back() {
    const double length = std::exchange(circuit_.length, 0);
    const int dead_points = std::exchange(circuit_.dead_points, 0);
    way_ = -1;
    walk();
    circuit_.closed = false;
    circuit_.length = length;
    circuit_.dead_points = dead_points;
  }

  /// Walks one step from `here` and returns its end; nothing where the curve cannot be followed.
  std::optional<Strand> step(const Strand& here, bool may_close) {
    if (!(here.singular_value > tolerance::crossing_strands)) return std::nullopt;
    const double length = std::min(options_.step, 0.75 * here.reach);
    const auto end = curve_.advanced(here, length, options_.corrector);
    if (!end) return std::nullopt;
    meet_targets(here, length);
    const auto home = may_close ? distance_to(start_, here, length) : std::nullopt;
    circuit_.closed = home.has_value();
    const Strand next = strand_at(home ? start_ : *end);
    if (opposite_signs(here.tangent.input, next.tangent.input)) ++circuit_.dead_points;
    circuit_.length += home.value_or(length);
    circuit_.worst_closure = std::max(circuit_.worst_closure, next.closure_error);
    return next;
  }

  /// How far along the step of `length` from `here` a point on the strand, or a little off it, lies; nothing where the
  /// step does not pass it. Points off the strand can fall into the wedge, open by less than 20°, between the planes
  /// that end one step and begin the next: they count for both.
  [[nodiscard]] static std::optional<double> distance_to(TorusVector point, const Strand& here, double length) {
    const TorusVector way = shortest_way(here.point, point);
    if (!(norm(way) <= here.reach)) return std::nullopt;
    const double along = dot(here.tangent, way);
    const double wedge = norm(way + -along * here.tangent) / 2;
    if (along < -wedge || along > length + wedge) return std::nullopt;
    return along;
  }

  /// Poses that this step passes. Within its reach a strand crosses each plane once: the point where it crosses the
  /// plane of a wanted configuration is that configuration, or the linkage misses it.
  void meet_targets(const Strand& here, double length) {
    for (DriveTarget& target : targets_) {
      if (target.met) continue;
      const auto along = distance_to(target.configuration, here, length);
      if (!along) continue;
      const auto point = curve_.advanced(here, *along, options_.corrector);
      const double most = std::min(options_.pose_tolerance, here.reach / 4);
      if (point && norm(shortest_way(*point, target.configuration)) <= most)
        meet(target, strand_at(*point), *along, here);
    }
  }

  void meet(DriveTarget& target, const Strand& at, double along, const Strand& here) {
    target.met = true;
    const bool past_dead_point = opposite_signs(here.tangent.input, at.tangent.input);
    Meeting meeting{static_cast<int>(&target - targets_.data()), way_ * (circuit_.length + along),
                    way_ * (circuit_.dead_points + (past_dead_point ? 1 : 0))};
    if (target.rates) compare_directions(*target.rates, at, meeting);
    circuit_.meetings.push_back(meeting);
    const HingePlaces found = curve_.moving_hinges(at.point);
    for (std::size_t i = 0; i < found.size(); ++i)
      circuit_.worst_pose_error = std::max(circuit_.worst_pose_error, norm(found[i] - target.hinges[i]));
    circuit_.worst_closure = std::max(circuit_.worst_closure, at.closure_error);
  }

  /// How the moving hinges move as the walk goes on, from a step ahead and a step back; the length means nothing.
  [[nodiscard]] HingePlaces rates_at(const Strand& at) const {
    constexpr double small_step = 1e-5;  // its square is lost beside the loop's closure
    const double step = std::min(small_step, at.reach / 4);
    const auto ahead = curve_.advanced(at, step, options_.corrector),
               back = curve_.advanced(at, -step, options_.corrector);
    if (!ahead || !back) return {};
    const HingePlaces to = curve_.moving_hinges(*ahead), from = curve_.moving_hinges(*back);
    return {to[0] - from[0], to[1] - from[1]};
  }

  void compare_directions(const HingePlaces& wanted, const Strand& at, Meeting& meeting) {
    const HingePlaces found = rates_at(at);
    const double along = rates_dot(wanted, found), lengths = rates_norm(wanted) * rates_norm(found);
    const double share = along / lengths;  // not a number where nothing moves
    const auto aside = [&](std::size_t i) {
      return (1 / rates_norm(wanted)) * wanted[i] - (share / rates_norm(found)) * found[i];
    };
    const double error = lengths > 0 ? std::atan2(rates_norm({aside(0), aside(1)}), std::abs(share)) : pi / 2;
    circuit_.worst_direction_error = std::max(circuit_.worst_direction_error, error);
    meeting.forwards = error <= options_.pose_tolerance && way_ * along > 0;
    meeting.backwards = error <= options_.pose_tolerance && way_ * along < 0;
  }

  const ConfigurationCurve& curve_;
  DriveThroughOptions options_;
  std::vector<DriveTarget> targets_;
  TorusVector start_;
  double sense_ = 1;  ///< of the input's counter-clockwise turn against the curve's own tangent
  int way_ = 1;       ///< of the walk: ahead, or −1: back
  int steps_ = 0;     ///< both ways
  Circuit circuit_;
};

/// Meetings by arc length in [0, circuit.length): a pose met a hair before the start lies at the end.
void sort_meetings(Circuit& circuit) {
  for (Meeting& meeting : circuit.meetings) {
    if (meeting.arc >= 0 || !circuit.closed) continue;
    meeting.arc += circuit.length;
    meeting.stretch += circuit.dead_points;
  }
  std::sort(circuit.meetings.begin(), circuit.meetings.end(),
            [](const Meeting& x, const Meeting& y) { return x.arc < y.arc; });
}

/// The stretch of pose 0 reaches from the circuit's last dead point to its first.
bool on_first_stretch(const Circuit& circuit, const Meeting& meeting) {
  return meeting.stretch == 0 || (circuit.closed && meeting.stretch == circuit.dead_points);
}

/// How far each pose lies from pose 0 when the input turns counter-clockwise (sense +1) or clockwise (−1): round and
/// round where there are no dead points, otherwise negative on the other side of pose 0.
std::vector<double> travelled(const Circuit& circuit, int sense) {
  std::vector<double> distance(circuit.meetings.size());
  for (const Meeting& meeting : circuit.meetings) {
    double& d = distance[static_cast<std::size_t>(meeting.pose)];
    const double ahead = meeting.stretch == 0 ? meeting.arc : meeting.arc - circuit.length;
    d = sense * ahead;
    if (circuit.closed && circuit.dead_points == 0 && d < 0) d += circuit.length;
  }
  return distance;
}

bool in_order(const Circuit& circuit, int sense) {
  const std::vector<double> distance = travelled(circuit, sense);
  return std::adjacent_find(distance.begin(), distance.end(), std::greater_equal<>()) == distance.end();
}

/// On the stretch of pose 0 the input turns counter-clockwise as the walk goes on.
bool in_direction(const Circuit& circuit, int sense) {
  return std::all_of(circuit.meetings.begin(), circuit.meetings.end(),
                     [&](const Meeting& meeting) { return sense > 0 ? meeting.forwards : meeting.backwards; });
}

Defects defects_of(const Circuit& circuit, std::size_t poses, bool respect_direction) {
  if (circuit.meetings.size() < poses) return {Defects::circuit_bit | Defects::branch_bit};
  const bool one_stretch = std::all_of(circuit.meetings.begin(), circuit.meetings.end(),
                                       [&](const Meeting& meeting) { return on_first_stretch(circuit, meeting); });
  if (!one_stretch) return {Defects::branch_bit};
  for (const int sense : {+1, -1})
    if (in_order(circuit, sense) && (!respect_direction || in_direction(circuit, sense))) return {};
  return {Defects::order_bit};
}

/// Of a circuit that crosses itself: from pose 0 to the crossing beyond pose 1.
std::vector<int> poses_ahead(const Circuit& circuit) {
  const auto arc_of = [&](int pose) {
    return std::find_if(circuit.meetings.begin(), circuit.meetings.end(),
                        [&](const Meeting& meeting) { return meeting.pose == pose; })
        ->arc;
  };
  const bool back = circuit.meetings.size() > 1 && arc_of(1) < 0;
  std::vector<int> poses;
  for (const Meeting& meeting : circuit.meetings)
    if (back ? meeting.arc <= 0 : meeting.arc >= 0) poses.push_back(meeting.pose);
  if (back) std::reverse(poses.begin(), poses.end());
  return poses;
}

/// Poses as the input meets them from pose 0; the other way round where that leads to pose 1 sooner.
std::vector<int> visits(const Circuit& circuit) {
  std::vector<int> poses;
  for (const Meeting& meeting : circuit.meetings) poses.push_back(meeting.pose);
  if (!circuit.closed) return poses_ahead(circuit);
  const auto second = std::find(poses.begin(), poses.end(), 1);
  if (second == poses.end()) return poses;
  const auto before = second - poses.begin(), after = poses.end() - second;
  const double arc = circuit.meetings[static_cast<std::size_t>(before)].arc;
  if (after < before || (after == before && arc > circuit.length / 2)) std::reverse(poses.begin() + 1, poses.end());
  return poses;
}

}  // namespace

DriveThroughReport drive_along(const ConfigurationCurve& curve, std::vector<DriveTarget> targets,
                               const DriveThroughOptions& options) {
  const std::size_t count = targets.size();
  Circuit circuit = Tracer(curve, std::move(targets), options).trace();
  if (!circuit.closed && circuit.meetings.size() < count) return {};
  sort_meetings(circuit);
  return {true,
          defects_of(circuit, count, options.respect_direction),
          visits(circuit),
          circuit.worst_closure,
          circuit.worst_pose_error,
          circuit.worst_direction_error};
}

}  // namespace linkwright
