#include "linkwright/mechanism/position.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/tolerance.hpp"
#include "triangle.hpp"

namespace linkwright {
namespace {

/// Unit vector; the axis itself where there is no direction (null, not finite).
Point unit(Point v) {
  const double length = std::abs(v);
  return length > 0 && std::isfinite(length) ? v / length : Point{1, 0};
}

Point axis_of(const FourBar& four_bar) { return unit(four_bar.output_fixed - four_bar.input_fixed); }

double angle_from(Point axis, Point v) { return wrap_signed(std::arg(unit(v) * std::conj(axis))); }

/// The input's travel in the upper half plane, mirrored in the lower one: |φ| in [nearest, farthest].
struct Travel {
  double nearest = 0, farthest = 0;  ///< from the direction of the output's centre, radians
};

/// The input angle in [0, π] at which the diagonal has a given length.
double input_angle_at(const LinkLengths& l, double diagonal_length) {
  return angle_opposite(diagonal_length, l.ground, l.input, 0);
}

/// The diagonal runs from |g − a| at φ = 0 to g + a at φ = π; the triangle needs it in [|h − b|, h + b].
std::optional<Travel> travel(const LinkLengths& l) {
  if (!are_links(l)) return std::nullopt;
  const double slack = diagonal_slack(l);
  const double least = std::abs(l.ground - l.input), most = l.ground + l.input;
  const double folded = std::abs(l.coupler - l.output), extended = l.coupler + l.output;
  if (least > extended + slack || folded > most + slack) return std::nullopt;
  return Travel{least >= folded - slack ? 0 : input_angle_at(l, folded),
                most <= extended + slack ? pi : input_angle_at(l, extended)};
}

bool in_one_line(const Configuration& c) {
  return std::abs(std::sin(c.coupler_angle - c.output_angle)) < tolerance::dead_point_sine;
}

void append_dead_point(std::vector<DeadPoint>& points, const LinkLengths& lengths, double input_angle) {
  const auto c = assemble(lengths, input_angle, Assembly::positive);
  if (c && in_one_line(*c)) points.push_back({*c, std::cos(c->coupler_angle - c->output_angle) < 0});
}

}  // namespace

Assembly assembly_of(const FourBar& four_bar) {
  const double joint =
      cross(four_bar.input_moving - four_bar.output_moving, four_bar.output_fixed - four_bar.output_moving);
  return joint < 0 ? Assembly::negative : Assembly::positive;
}

Configuration configuration_of(const FourBar& four_bar) {
  const Point axis = axis_of(four_bar);
  return {angle_from(axis, four_bar.input_moving - four_bar.input_fixed),
          angle_from(axis, four_bar.output_moving - four_bar.input_moving),
          angle_from(axis, four_bar.output_moving - four_bar.output_fixed)};
}

std::optional<Configuration> assemble(const LinkLengths& lengths, double input_angle, Assembly assembly) {
  if (!are_links(lengths) || !std::isfinite(input_angle)) return std::nullopt;
  const Point to_input = diagonal(lengths, input_angle);
  const double length = std::abs(to_input), slack = diagonal_slack(lengths);
  const double h = lengths.coupler, b = lengths.output;
  if (length > h + b + slack || length < std::abs(h - b) - slack) return std::nullopt;
  // The triangle (output circle, input circle, output centre) runs counter-clockwise in the positive assembly.
  const double sign = assembly == Assembly::positive ? 1 : -1;
  const double diagonal_angle = std::arg(to_input);
  return Configuration{input_angle, wrap_signed(diagonal_angle + pi + sign * angle_opposite(b, length, h, slack)),
                       wrap_signed(diagonal_angle - sign * angle_opposite(h, length, b, slack))};
}

FourBar placed(const FourBar& reference, const Configuration& configuration) {
  const LinkLengths lengths = reference.lengths();
  const Point axis = axis_of(reference);
  return {reference.input_fixed, reference.input_fixed + lengths.input * axis * direction(configuration.input_angle),
          reference.output_fixed,
          reference.output_fixed + lengths.output * axis * direction(configuration.output_angle)};
}

bool AngleRange::is_full_turn() const { return to - from >= two_pi; }

std::vector<AngleRange> input_ranges(const LinkLengths& lengths) {
  const auto t = travel(lengths);
  if (!t) return {};
  if (t->nearest == 0) return {{-t->farthest, t->farthest}};
  if (t->farthest == pi) return {{t->nearest, two_pi - t->nearest}};
  return {{-t->farthest, -t->nearest}, {t->nearest, t->farthest}};
}

std::vector<DeadPoint> dead_points(const LinkLengths& lengths) {
  const auto t = travel(lengths);
  if (!t) return {};
  std::vector<double> limits = {-t->farthest, -t->nearest, t->nearest, t->farthest};
  limits.erase(std::remove(limits.begin(), limits.end(), -pi), limits.end());  // −π is π
  limits.erase(std::unique(limits.begin(), limits.end()), limits.end());
  std::vector<DeadPoint> points;
  for (const double limit : limits) append_dead_point(points, lengths, limit);
  return points;
}

// The loop a e^{iφ} + h e^{iθ} = g + b e^{iψ}, differentiated by φ once and twice; the component along the output link
// leaves the coupler's rate, the component along the coupler the output's.
std::optional<AngleRates> angle_rates(const LinkLengths& lengths, const Configuration& configuration) {
  const auto [phi, theta, psi] = configuration;
  const double joint_sine = std::sin(theta - psi), joint_cosine = std::cos(theta - psi);
  if (!are_links(lengths) || !std::isfinite(phi) || !(std::abs(joint_sine) >= tolerance::dead_point_sine))
    return std::nullopt;
  const double a = lengths.input, h = lengths.coupler, b = lengths.output;
  AngleRates rates;
  rates.coupler = -a * std::sin(phi - psi) / (h * joint_sine);
  rates.output = -a * std::sin(phi - theta) / (b * joint_sine);
  const double coupler_pull = h * rates.coupler * rates.coupler, output_pull = b * rates.output * rates.output;
  rates.coupler_acceleration = (output_pull - a * std::cos(phi - psi) - coupler_pull * joint_cosine) / (h * joint_sine);
  rates.output_acceleration =
      (output_pull * joint_cosine - a * std::cos(phi - theta) - coupler_pull) / (b * joint_sine);
  return rates;
}

}  // namespace linkwright
