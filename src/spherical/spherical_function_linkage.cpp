#include "spherical_function_linkage.hpp"

#include <algorithm>
#include <cmath>

#include "algebra/binary_form.hpp"
#include "linkwright/mechanism/spherical_position.hpp"

namespace linkwright {
namespace {

// An axis on a link that turns about a fixed axis, and its derivatives: v′ = α′ G × v and so on.
std::vector<Vector3> turned_axis(Vector3 fixed, Vector3 moving, double angle,
                                 const std::vector<AngleDerivative>& derivatives, double AngleDerivative::*which) {
  std::vector<Vector3> v = {UnitQuaternion::about(fixed, angle).apply(moving)};
  for (std::size_t m = 0; m < derivatives.size(); ++m) {
    Vector3 sum{};
    for (std::size_t k = 0; k <= m; ++k) sum = sum + binomial[m][k] * (derivatives[k].*which) * v[m - k];
    v.push_back(cross(fixed, sum));
  }
  return v;
}

struct MovingAxes {
  std::vector<Vector3> input, output;  // with derivatives
};

MovingAxes axes_at(const SphericalFourBar& bars, const AnglePair& first, const AnglePair& pair) {
  return {turned_axis(bars.input_fixed, bars.input_moving, pair.input - first.input, pair.derivatives,
                      &AngleDerivative::input),
          turned_axis(bars.output_fixed, bars.output_moving, pair.output - first.output, pair.derivatives,
                      &AngleDerivative::output)};
}

// The ω with ω × a = da and, but for a change of the angle between them, ω × b = db; a and b are unit vectors.
Vector3 rate_of(Vector3 a, Vector3 da, Vector3 b, Vector3 db) {
  const Vector3 across_a = cross(a, da), across_b = cross(b, db);
  const double c = dot(a, b), sine = norm(cross(a, b));
  if (!(sine > 0)) return across_a;
  return across_a + (dot(across_b, a) + c * dot(across_a, b)) / (sine * sine) * a;
}

// a⁽ᵐ⁺¹⁾ = Σ (m over k) ω⁽ᵏ⁾ × a⁽ᵐ⁻ᵏ⁾, solved for the highest of ω.
std::vector<Vector3> coupler_rates(const MovingAxes& axes) {
  std::vector<Vector3> rates;
  for (std::size_t m = 0; m + 1 < axes.input.size(); ++m) {
    Vector3 da = axes.input[m + 1], db = axes.output[m + 1];
    for (std::size_t k = 0; k < m; ++k) {
      da = da - binomial[m][k] * cross(rates[k], axes.input[m - k]);
      db = db - binomial[m][k] * cross(rates[k], axes.output[m - k]);
    }
    rates.push_back(rate_of(axes.input[0], da, axes.output[0], db));
  }
  return rates;
}

}  // namespace

SphericalFourBar with_short_side_links(SphericalFourBar bars) {
  if (dot(bars.input_fixed, bars.input_moving) < 0) bars.input_moving = -bars.input_moving;
  if (dot(bars.output_fixed, bars.output_moving) < 0) bars.output_moving = -bars.output_moving;
  return bars;
}

std::vector<PrescribedOrientation> coupler_orientations(const SphericalFourBar& four_bar,
                                                        const std::vector<AnglePair>& pairs) {
  std::vector<PrescribedOrientation> orientations;
  for (const AnglePair& pair : pairs) {
    const MovingAxes axes = axes_at(four_bar, pairs.front(), pair);
    const SphericalFourBar there{four_bar.input_fixed, axes.input[0], axes.output[0], four_bar.output_fixed};
    orientations.push_back({coupler_turn(four_bar, there), coupler_rates(axes)});
  }
  return orientations;
}

double coupler_residual(const SphericalFourBar& four_bar, const std::vector<AnglePair>& pairs) {
  const double angle = four_bar.angles().coupler;
  double worst = 0;
  for (const AnglePair& pair : pairs) {
    const MovingAxes axes = axes_at(four_bar, pairs.front(), pair);
    worst = std::max(worst, std::abs(angle_between(axes.input[0], axes.output[0]) - angle));
  }
  return worst;
}

GeneratedFunction generated_function(const SphericalFourBar& four_bar, const AnglePair& first) {
  const LinkAngles angles = four_bar.angles();
  const Assembly assembly = assembly_of(four_bar);
  const SphericalConfiguration start = configuration_of(four_bar);
  const auto output_angle = [angles, assembly](double input_angle) {
    const auto there = assemble(angles, input_angle, assembly);
    return there ? std::optional(there->output_angle) : std::nullopt;
  };
  return {output_angle, {start.input_angle, start.output_angle}, input_ranges(angles), first};
}

}  // namespace linkwright
