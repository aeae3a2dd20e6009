#include "linkwright/attitude/euler_rates.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

/// π/2 less its double: t ± π/2 keeps the digits that t has near there.
constexpr double half_pi_rest = 6.123233995736766e-17;

/// The first and the third axis of an intrinsic sequence by their bisectors, in i:
/// first = cosine · sum + sine · difference, third = third_sign (cosine · sum − sine · difference). With the second
/// axis the two are an orthonormal triad, and none of the six numbers is a difference of like ones: with the sum s and
/// the difference d of the rates ṫ₁ and third_sign · ṫ₃, ω = s cosine · sum + d sine · difference + ṫ₂ · second.
struct BisectorTriad {
  Vector3 sum, difference, second;
  double cosine = 0, sine = 0;  ///< of half the angle from the first axis to ± the third
  double third_sign = 1;        ///< of the permutation of Cardan axes; 1 for proper Euler angles

  explicit BisectorTriad(const EulerAngles& intrinsic) {
    const EulerSequence& sequence = intrinsic.sequence;
    const Vector3 a = unit_vector(sequence.first()), b = unit_vector(sequence.second()), n = cross(a, b);
    if (sequence.is_proper_euler()) {
      cosine = std::cos(intrinsic.second / 2);
      sine = std::sin(intrinsic.second / 2);
    } else {
      cosine = std::sin(((intrinsic.second + pi / 2) + half_pi_rest) / 2);
      sine = std::sin(((intrinsic.second - pi / 2) - half_pi_rest) / 2);
      third_sign = dot(n, unit_vector(sequence.third()));
    }
    const Rotation first_turn = Rotation::about(sequence.first(), intrinsic.first);
    sum = first_turn.apply(cosine * a - sine * n);
    difference = first_turn.apply(cosine * n + sine * a);
    second = first_turn.apply(b);
  }

  [[nodiscard]] Vector3 first() const { return cosine * sum + sine * difference; }
  [[nodiscard]] Vector3 third() const { return third_sign * (cosine * sum - sine * difference); }
  [[nodiscard]] double lock_distance() const { return std::min(std::fabs(cosine), std::fabs(sine)); }
  [[nodiscard]] bool locked() const { return lock_distance() <= tolerance::gimbal_lock; }

  /// B x.
  [[nodiscard]] Vector3 turned_by(const std::array<double, 3>& x) const {
    return x[0] * first() + x[1] * second + x[2] * third();
  }

  /// Ḃ ṫ: each axis is carried along by the turns before it.
  [[nodiscard]] Vector3 carried(const std::array<double, 3>& rate) const {
    return (rate[0] * rate[1]) * cross(first(), second) +
           rate[2] * cross(rate[0] * first() + rate[1] * second, third());
  }

  /// The x of B x = u, and |u − B x|: at a lock the least x of the least squares.
  [[nodiscard]] std::pair<std::array<double, 3>, double> solve(Vector3 u) const {
    const double along_sum = dot(sum, u), along_difference = dot(difference, u);
    const bool sum_lost = locked() && std::fabs(cosine) < std::fabs(sine), difference_lost = locked() && !sum_lost;
    const double s = sum_lost ? 0 : along_sum / cosine, d = difference_lost ? 0 : along_difference / sine;
    const double left_over = sum_lost ? along_sum : difference_lost ? along_difference : 0;
    return {{0.5 * (s + d), dot(second, u), third_sign * 0.5 * (s - d)}, std::fabs(left_over)};
  }
};

bool is_intrinsic(const EulerAngles& angles) { return angles.sequence.turning() == Turning::intrinsic; }

/// The intrinsic sequence that makes the same rotation.
EulerAngles as_intrinsic(const EulerAngles& angles) {
  if (is_intrinsic(angles)) return angles;
  return {angles.sequence.reversed(), angles.third, angles.second, angles.first};
}

EulerRates reversed(EulerRates rates) {
  std::swap(rates.rates[0], rates.rates[2]);
  std::swap(rates.accelerations[0], rates.accelerations[2]);
  return rates;
}

bool is_finite(const EulerAngles& angles) {
  return std::isfinite(angles.first) && std::isfinite(angles.second) && std::isfinite(angles.third);
}

bool is_finite(const EulerRates& rates) {
  const auto finite = [](double x) { return std::isfinite(x); };
  return std::all_of(rates.rates.begin(), rates.rates.end(), finite) &&
         std::all_of(rates.accelerations.begin(), rates.accelerations.end(), finite);
}

}  // namespace

Matrix3x3 rate_matrix(const EulerAngles& angles) {
  const BisectorTriad triad(as_intrinsic(angles));
  return is_intrinsic(angles) ? Matrix3x3::of_columns(triad.first(), triad.second, triad.third())
                              : Matrix3x3::of_columns(triad.third(), triad.second, triad.first());
}

AngularMotion angular_motion(const EulerAngles& angles, const EulerRates& rates) {
  const BisectorTriad triad(as_intrinsic(angles));
  const auto& [rate, acceleration] = is_intrinsic(angles) ? rates : reversed(rates);
  return {triad.turned_by(rate), triad.turned_by(acceleration) + triad.carried(rate)};
}

Result<EulerRatesFit> euler_rates(const EulerAngles& angles, const AngularMotion& in_i) {
  if (!is_finite(angles) || !is_finite(in_i.velocity) || !is_finite(in_i.acceleration))
    return Error{"not_finite", "angles", "an angle or the motion is not a number or infinite: give finite numbers"};
  const BisectorTriad triad(as_intrinsic(angles));
  EulerRatesFit fit;
  fit.lock_distance = triad.lock_distance();
  fit.singularity = triad.locked() ? Singularity::gimbal_lock : Singularity::none;
  auto& [rate, acceleration] = fit.rates;
  std::tie(rate, fit.velocity_residual) = triad.solve(in_i.velocity);
  std::tie(acceleration, fit.acceleration_residual) = triad.solve(in_i.acceleration - triad.carried(rate));
  if (!is_intrinsic(angles)) fit.rates = reversed(fit.rates);
  if (!is_finite(fit.rates))
    return Error{"rates_too_large", "motion", "the rates are larger than numbers reach: take a larger unit of time"};
  return fit;
}

}  // namespace linkwright
