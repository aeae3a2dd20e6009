#include "linkwright/spherical/spherical_drive.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/circuit_drive.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

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
