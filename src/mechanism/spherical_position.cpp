#include "linkwright/mechanism/spherical_position.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "circuit_drive.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/tolerance.hpp"
#include "spherical_triangle.hpp"

namespace linkwright {
namespace {

// The four-bar's own frame, by columns in the fixed frame.
Matrix3x3 own_frame(const SphericalFourBar& bars) {
  const Vector3 z = bars.input_fixed, y = normalized(cross(z, bars.output_fixed)), x = cross(y, z);
  return Matrix3x3::of_columns(x, y, z);
}

Vector3 about_z(double turn, double tilt) {
  return {std::cos(turn) * std::sin(tilt), std::sin(turn) * std::sin(tilt), std::cos(tilt)};
}

// From the own frame into that of the output's fixed axis: turned back about y.
Vector3 seen_from_output(Vector3 v, double ground) {
  const double c = std::cos(ground), s = std::sin(ground);
  return {c * v.x - s * v.z, v.y, s * v.x + c * v.z};
}
Vector3 from_output(Vector3 v, double ground) {
  const double c = std::cos(ground), s = std::sin(ground);
  return {c * v.x + s * v.z, v.y, c * v.z - s * v.x};
}

Vector3 input_moving(const LinkAngles& l, double input_angle) { return about_z(input_angle, l.input); }
Vector3 output_moving(const LinkAngles& l, double output_angle) {
  return from_output(about_z(output_angle, l.output), l.ground);
}

// From the output's fixed to the input's moving axis: how long, and in which direction about the former.
struct Diagonal {
  double arc = 0, direction = 0;
};
Diagonal diagonal_at(const LinkAngles& l, double input_angle) {
  const Vector3 seen = seen_from_output(input_moving(l, input_angle), l.ground);
  return {std::atan2(std::hypot(seen.x, seen.y), seen.z), std::atan2(seen.y, seen.x)};
}

// How long the diagonal may be: where coupler and output link fold over each other, and where they lie stretched.
std::array<double, 2> diagonal_limits(const LinkAngles& l) {
  return {std::abs(l.coupler - l.output), shorter_arc(l.coupler + l.output)};
}

// The input angle in [0, π] at which the diagonal has a length that it can have.
double input_at(const LinkAngles& l, double diagonal) { return angle_opposite_arc(diagonal, l.input, l.ground); }

/// The configurations of a spherical four-bar as the curve F(θ, ψ) = (W₁·W₂ − cos α₂)/Λ = 0, with Λ so that no second
/// derivative is steeper than 1. Points (θ, 0, ψ) of the torus.
class SphericalConfigurationCurve : public ConfigurationCurve {
 public:
  explicit SphericalConfigurationCurve(const SphericalFourBar& bars);

  [[nodiscard]] Strand strand_at(TorusVector point) const override;
  [[nodiscard]] std::optional<TorusVector> advanced(const Strand& strand, double along, double accuracy) const override;
  [[nodiscard]] HingePlaces moving_hinges(TorusVector point) const override;

 private:
  /// A link at some angle about its fixed axis: the moving axis and its derivative by the angle.
  struct Arm {
    Vector3 fixed, level, along, across;  ///< moving axis: level + cos·along + sin·across
    [[nodiscard]] Vector3 at(double angle) const { return level + std::cos(angle) * along + std::sin(angle) * across; }
    [[nodiscard]] Vector3 slope_at(double angle) const { return std::cos(angle) * across - std::sin(angle) * along; }
  };
  struct Closure {
    double value, by_input, by_output;
  };
  [[nodiscard]] static Arm arm_of(Vector3 fixed, Vector3 moving, Vector3 datum);
  [[nodiscard]] Closure closure_at(TorusVector point) const;

  Arm input_, output_;
  double coupler_versine_ = 0, steepest_ = 1;
};

// Measured from the plane of both fixed axes.
SphericalConfigurationCurve::Arm SphericalConfigurationCurve::arm_of(Vector3 fixed, Vector3 moving, Vector3 datum) {
  const Vector3 across = normalized(cross(fixed, datum)), along = cross(across, fixed);
  const double sine = norm(cross(fixed, moving));
  return {fixed, dot(fixed, moving) * fixed, sine * along, sine * across};
}

SphericalConfigurationCurve::SphericalConfigurationCurve(const SphericalFourBar& bars)
    : input_(arm_of(bars.input_fixed, bars.input_moving, bars.output_fixed)),
      output_(arm_of(bars.output_fixed, bars.output_moving, bars.input_fixed)) {
  const Vector3 apart = bars.input_moving - bars.output_moving;
  coupler_versine_ = 0.5 * dot(apart, apart);
  // ∂²F/∂θ² is a moving axis' level part seen by the other link: at most the sine of the farthest that it gets.
  const LinkAngles l = bars.angles();
  const auto sine_up_to = [](double angle) { return angle < pi / 2 ? std::sin(angle) : 1.0; };
  const double s1 = std::sin(l.input), s3 = std::sin(l.output);
  const double of_input = s1 * sine_up_to(l.ground + l.output), of_output = s3 * sine_up_to(l.ground + l.input);
  steepest_ = std::hypot(std::hypot(of_input, of_output), std::sqrt(2.0) * s1 * s3);
}

// W₁·W₂ − cos α₂ by versines: half the squares of distances, which keep their digits for small links.
SphericalConfigurationCurve::Closure SphericalConfigurationCurve::closure_at(TorusVector point) const {
  const Vector3 a = input_.at(point.input), b = output_.at(point.output), apart = a - b;
  return {(coupler_versine_ - 0.5 * dot(apart, apart)) / steepest_, dot(input_.slope_at(point.input), b) / steepest_,
          dot(a, output_.slope_at(point.output)) / steepest_};
}

// The gradient changes by at most 1 over a distance of 1, so the reasoning of the planar curve holds with σ its length.
ConfigurationCurve::Strand SphericalConfigurationCurve::strand_at(TorusVector point) const {
  const Closure closure = closure_at(point);
  const double sigma = std::hypot(closure.by_input, closure.by_output);
  const TorusVector along = {closure.by_output, 0, -closure.by_input};
  return {point, sigma > 0 ? (1 / sigma) * along : along, sigma / 4, sigma, std::abs(closure.value)};
}

std::optional<TorusVector> SphericalConfigurationCurve::advanced(const Strand& strand, double along,
                                                                 double accuracy) const {
  constexpr int max_corrections = 8;
  const double enough = std::max(tolerance::loop_rounding * coupler_versine_ / steepest_ + tolerance::loop_rounding,
                                 std::min(accuracy, 0.01 * strand.singular_value * strand.reach));
  const TorusVector normal = {strand.tangent.output, 0, -strand.tangent.input};
  TorusVector p = strand.point + along * strand.tangent;
  for (int i = 0; i < max_corrections; ++i) {
    const Closure closure = closure_at(p);
    if (std::abs(closure.value) <= enough) return p;
    const double slope = closure.by_input * normal.input + closure.by_output * normal.output;
    if (!(std::abs(slope) > 0)) return std::nullopt;
    p = p + (-closure.value / slope) * normal;
  }
  return std::nullopt;
}

HingePlaces SphericalConfigurationCurve::moving_hinges(TorusVector point) const {
  return {input_.at(point.input), output_.at(point.output)};
}

double angle_about(Vector3 fixed, Vector3 moving, Vector3 datum) {
  const Vector3 across = normalized(cross(fixed, datum));
  return std::atan2(dot(moving, across), dot(moving, cross(across, fixed)));
}

DriveTarget target_of(const SphericalFourBar& bars, const UnitQuaternion& first, const PrescribedOrientation& there) {
  const Vector3 a = turned(bars.input_moving, first, there.orientation),
                b = turned(bars.output_moving, first, there.orientation);
  DriveTarget target{
      {angle_about(bars.input_fixed, a, bars.output_fixed), 0, angle_about(bars.output_fixed, b, bars.input_fixed)},
      {a, b},
      {}};
  if (!there.derivatives.empty())
    target.rates = {cross(there.derivatives.front(), a), cross(there.derivatives.front(), b)};
  return target;
}

}  // namespace

Assembly assembly_of(const SphericalFourBar& bars) {
  return determinant(bars.input_moving, bars.output_moving, bars.output_fixed) < 0 ? Assembly::negative
                                                                                   : Assembly::positive;
}

SphericalConfiguration configuration_of(const SphericalFourBar& bars) {
  const Matrix3x3 to_own = transposed(own_frame(bars));
  const double ground = bars.angles().ground;
  const Vector3 a = to_own * bars.input_moving, b = seen_from_output(to_own * bars.output_moving, ground);
  return {std::atan2(a.y, a.x), std::atan2(b.y, b.x)};
}

std::optional<SphericalConfiguration> assemble(const LinkAngles& l, double input_angle, Assembly assembly) {
  if (!are_links(l)) return std::nullopt;
  const Diagonal diagonal = diagonal_at(l, input_angle);
  const auto [shortest, longest] = diagonal_limits(l);
  constexpr double slack = 4 * tolerance::dead_point;  // the diagonal carries a few roundings of π
  if (diagonal.arc < shortest - slack || diagonal.arc > longest + slack) return std::nullopt;
  const double inner = angle_opposite_arc(l.coupler, std::clamp(diagonal.arc, shortest, longest), l.output);
  const double side = assembly == Assembly::positive ? inner : -inner;
  return SphericalConfiguration{input_angle, wrap_signed(diagonal.direction + side)};
}

SphericalFourBar placed(const SphericalFourBar& reference, const SphericalConfiguration& configuration) {
  const LinkAngles l = reference.angles();
  const Matrix3x3 frame = own_frame(reference);
  return {reference.input_fixed, frame * input_moving(l, configuration.input_angle),
          frame * output_moving(l, configuration.output_angle), reference.output_fixed};
}

UnitQuaternion coupler_turn(const SphericalFourBar& from, const SphericalFourBar& to) {
  const auto triad = [](const SphericalFourBar& bars) {
    const Vector3 across = normalized(cross(bars.input_moving, bars.output_moving));
    return Matrix3x3::of_columns(bars.input_moving, across, cross(bars.input_moving, across));
  };
  return UnitQuaternion::of_matrix(triad(to) * transposed(triad(from)));
}

// The diagonal grows with θ from |α₄ − α₁| at 0 to α₄ + α₁ (or the rest of the circle) at π.
std::vector<AngleRange> input_ranges(const LinkAngles& l) {
  if (!are_links(l)) return {};
  const auto [shortest, longest] = diagonal_limits(l);
  const double near = std::abs(l.ground - l.input), far = shorter_arc(l.ground + l.input);
  if (near > longest || far < shortest) return {};
  const bool passes_0 = near >= shortest, passes_pi = far <= longest;
  if (passes_0 && passes_pi) return {{-pi, pi}};
  if (passes_0) {
    const double end = input_at(l, longest);
    return {{-end, end}};
  }
  const double begin = input_at(l, shortest);
  if (passes_pi) return {{begin, two_pi - begin}};
  const double end = input_at(l, longest);
  return {{-end, -begin}, {begin, end}};
}

std::vector<SphericalDeadPoint> dead_points(const LinkAngles& l) {
  if (!are_links(l)) return {};
  const auto [shortest, longest] = diagonal_limits(l);
  const double near = std::abs(l.ground - l.input), far = shorter_arc(l.ground + l.input);
  std::vector<SphericalDeadPoint> found;
  const auto add = [&](double input_angle, bool extended) {
    if (const auto there = assemble(l, input_angle, Assembly::positive)) found.push_back({*there, extended});
  };
  const auto add_both = [&](double diagonal, bool extended) {
    const double input_angle = input_at(l, diagonal);
    if (input_angle > 0 && input_angle < pi) add(-input_angle, extended);
    add(input_angle, extended);
  };
  const bool stretches = l.coupler + l.output <= pi;
  if (near < shortest && shortest < far) add_both(shortest, false);
  if (near < longest && longest < far) add_both(longest, stretches);
  std::sort(found.begin(), found.end(), [](const SphericalDeadPoint& a, const SphericalDeadPoint& b) {
    return a.configuration.input_angle < b.configuration.input_angle;
  });
  return found;
}

double transmission_angle(const SphericalFourBar& bars) {
  return acute_angle(
      angle_between(cross(bars.output_moving, bars.input_moving), cross(bars.output_moving, bars.output_fixed)));
}

// The coupler keeps its angle: (ω₁ G₁ × W₁)·W₂ + W₁·(ω₃ G₂ × W₂) = 0.
std::optional<double> velocity_ratio(const SphericalFourBar& bars) {
  const double by_input = determinant(bars.input_fixed, bars.input_moving, bars.output_moving),
               by_output = determinant(bars.output_fixed, bars.output_moving, bars.input_moving);
  if (transmission_angle(bars) < tolerance::dead_point_sine) return std::nullopt;
  return -by_input / by_output;
}

DriveThroughReport drive_through(const SphericalFourBar& four_bar, std::span<const PrescribedOrientation> orientations,
                                 const DriveThroughOptions& options) {
  for (const double arc : four_bar.angles().all())
    if (!(std::min(arc, pi - arc) > tolerance::change_point)) return {};
  if (orientations.empty() || !(options.step > 0)) return {};
  std::vector<DriveTarget> targets;
  for (const PrescribedOrientation& there : orientations)
    targets.push_back(target_of(four_bar, orientations.front().orientation, there));
  return drive_along(SphericalConfigurationCurve(four_bar), std::move(targets), options);
}

}  // namespace linkwright
