#include "linkwright/analysis/drive_through.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "analysis/configuration_curve.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

/// Velocities of the coupler's two pivots, in the four-bar's own frame: as a vector of four numbers.
struct PivotRates {
  Point input_circle, output_circle;
};

double rates_dot(const PivotRates& a, const PivotRates& b) {
  return dot(a.input_circle, b.input_circle) + dot(a.output_circle, b.output_circle);
}
double rates_norm(const PivotRates& a) { return std::hypot(std::abs(a.input_circle), std::abs(a.output_circle)); }

/// Where the poses want the moving pivots, how to move there, and the configuration that puts them there; the
/// four-bar's own frame.
struct Target {
  TorusVector configuration;
  Point input_circle, output_circle;
  std::optional<PivotRates> rates;  ///< any length
  bool met = false;
};

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

/// How fast the first derivative of a pose moves a point of the body that lies at `point` in it.
Point rate_of(const PrescribedPose& pose, Point point) {
  const PoseDerivative& d = pose.derivatives.front();
  return d.origin + Point{0, d.angle} * (point - pose.pose.origin);
}

Target target_of(const FourBar& four_bar, const Pose& first, const PrescribedPose& prescribed) {
  const Pose& pose = prescribed.pose;
  const Point ground = four_bar.output_center - four_bar.input_center;
  const Point turn = std::conj(ground) / std::abs(ground);
  const Point input_circle = displaced(four_bar.input_circle, first, pose);
  const Point output_circle = displaced(four_bar.output_circle, first, pose);
  const Point a = turn * (input_circle - four_bar.input_center), b = turn * (output_circle - four_bar.input_center);
  Target target{{std::arg(a), std::arg(b - a), std::arg(b - std::abs(ground))}, a, b, {}};
  if (!prescribed.derivatives.empty())
    target.rates = PivotRates{turn * rate_of(prescribed, input_circle), turn * rate_of(prescribed, output_circle)};
  return target;
}

bool opposite_signs(double x, double y) { return (x < 0) != (y < 0); }

/// Walks once round the circuit of pose 0 and writes down what it meets.
class Tracer {
 public:
  Tracer(const FourBar& four_bar, std::span<const PrescribedPose> poses, const DriveThroughOptions& options)
      : curve_(four_bar.lengths()), options_(options) {
    for (const PrescribedPose& pose : poses) targets_.push_back(target_of(four_bar, poses[0].pose, pose));
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
    for (Target& target : targets_) {
      if (target.met) continue;
      const auto along = distance_to(target.configuration, here, length);
      if (!along) continue;
      const auto point = curve_.advanced(here, *along, options_.corrector);
      const double most = std::min(options_.pose_tolerance, here.reach / 4);
      if (point && norm(shortest_way(*point, target.configuration)) <= most)
        meet(target, strand_at(*point), *along, here);
    }
  }

  void meet(Target& target, const Strand& at, double along, const Strand& here) {
    target.met = true;
    const bool past_dead_point = opposite_signs(here.tangent.input, at.tangent.input);
    Meeting meeting{static_cast<int>(&target - targets_.data()), way_ * (circuit_.length + along),
                    way_ * (circuit_.dead_points + (past_dead_point ? 1 : 0))};
    if (target.rates) compare_directions(*target.rates, at, meeting);
    circuit_.meetings.push_back(meeting);
    const auto [a, b] = curve_.moving_pivots(at.point);
    circuit_.worst_pose_error =
        std::max({circuit_.worst_pose_error, std::abs(a - target.input_circle), std::abs(b - target.output_circle)});
    circuit_.worst_closure = std::max(circuit_.worst_closure, at.closure_error);
  }

  /// How the coupler's pivots move as the walk goes on, from a step ahead and a step back; the length means nothing.
  [[nodiscard]] PivotRates rates_at(const Strand& at) const {
    constexpr double small_step = 1e-5;  // its square is lost beside the loop's closure
    const double step = std::min(small_step, at.reach / 4);
    const auto ahead = curve_.advanced(at, step, options_.corrector),
               back = curve_.advanced(at, -step, options_.corrector);
    if (!ahead || !back) return {};
    const auto [input_to, output_to] = curve_.moving_pivots(*ahead);
    const auto [input_from, output_from] = curve_.moving_pivots(*back);
    return {input_to - input_from, output_to - output_from};
  }

  void compare_directions(const PivotRates& wanted, const Strand& at, Meeting& meeting) {
    const PivotRates found = rates_at(at);
    const double along = rates_dot(wanted, found), lengths = rates_norm(wanted) * rates_norm(found);
    const double share = along / lengths;  // not a number where nothing moves
    const PivotRates aside{wanted.input_circle / rates_norm(wanted) - share * found.input_circle / rates_norm(found),
                           wanted.output_circle / rates_norm(wanted) - share * found.output_circle / rates_norm(found)};
    const double error = lengths > 0 ? std::atan2(rates_norm(aside), std::abs(share)) : pi / 2;
    circuit_.worst_direction_error = std::max(circuit_.worst_direction_error, error);
    meeting.forwards = error <= options_.pose_tolerance && way_ * along > 0;
    meeting.backwards = error <= options_.pose_tolerance && way_ * along < 0;
  }

  ConfigurationCurve curve_;
  DriveThroughOptions options_;
  std::vector<Target> targets_;
  TorusVector start_;
  double sense_ = 1;  ///< of the input's counter-clockwise turn against the curve's own tangent
  int way_ = 1;       ///< of the walk: ahead, or −1: back
  int steps_ = 0;     ///< both ways
  Circuit circuit_;
};

bool can_be_driven(const FourBar& four_bar, std::span<const PrescribedPose> poses, const DriveThroughOptions& options) {
  const LinkLengths lengths = four_bar.lengths();
  const double perimeter = lengths.perimeter();
  const bool links = std::isfinite(perimeter) && lengths.shortest() > tolerance::change_point * perimeter;
  return links && !poses.empty() && options.step > 0 &&
         std::all_of(poses.begin(), poses.end(),
                     [](const PrescribedPose& p) { return is_finite(p.pose.origin) && std::isfinite(p.pose.angle); });
}

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

DriveThroughReport drive_through(const FourBar& four_bar, std::span<const PrescribedPose> poses,
                                 const DriveThroughOptions& options) {
  if (!can_be_driven(four_bar, poses, options)) return {};
  Circuit circuit = Tracer(four_bar, poses, options).trace();
  if (!circuit.closed && circuit.meetings.size() < poses.size()) return {};
  sort_meetings(circuit);
  return {true,
          defects_of(circuit, poses.size(), options.respect_direction),
          visits(circuit),
          circuit.worst_closure,
          circuit.worst_pose_error,
          circuit.worst_direction_error};
}

}  // namespace linkwright
