#include "linkwright/attitude/euler_rates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <vector>

#include "linkwright/core/angle.hpp"
#include "support/attitude_case.hpp"
#include "support/central_difference.hpp"

namespace linkwright::euler_rates_test {
namespace {

using testing::random_direction;
using testing::ulps_between;

std::vector<EulerSequence> all_sequences() {
  std::vector<EulerSequence> sequences;
  for (const Turning turning : {Turning::intrinsic, Turning::extrinsic})
    for (const EulerSequence& sequence : EulerSequence::all(turning)) sequences.push_back(sequence);
  return sequences;
}

std::string text(const EulerSequence& sequence) {
  return sequence.name() + (sequence.turning() == Turning::intrinsic ? " intrinsic" : " extrinsic");
}

/// A motion by polynomials of the time in the three angles.
struct AngleMotion {
  EulerSequence sequence;
  std::array<double, 3> start, rate, acceleration;

  [[nodiscard]] EulerAngles angles(double t) const {
    const auto at = [&](std::size_t i) { return start[i] + t * (rate[i] + 0.5 * t * acceleration[i]); };
    return {sequence, at(0), at(1), at(2)};
  }
};

AngleMotion random_motion(const EulerSequence& sequence, std::mt19937_64& random) {
  std::uniform_real_distribution<double> any(-pi, pi), rate(-1, 1);
  const auto three = [&](auto& of) { return std::array<double, 3>{of(random), of(random), of(random)}; };
  return {sequence, three(any), three(rate), three(rate)};
}

double largest(const std::array<double, 3>& x) { return std::max({std::fabs(x[0]), std::fabs(x[1]), std::fabs(x[2])}); }

double largest_difference(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return largest({a[0] - b[0], a[1] - b[1], a[2] - b[2]});
}

TEST(EulerRates, OfEverySequenceAreTheDerivativesOfItsMatrix) {
  std::mt19937_64 random(1);
  for (const EulerSequence& sequence : all_sequences()) {
    for (int i = 0; i < 20; ++i) {
      const AngleMotion motion = random_motion(sequence, random);
      const auto matrix = [&](double t) { return motion.angles(t).rotation().matrix(); };
      const EulerRates rates{motion.rate, motion.acceleration};
      const RotationDerivatives exact =
          rotation_derivatives(motion.angles(0).rotation(), angular_motion(motion.angles(0), rates));
      EXPECT_LE(frobenius_norm(exact.first - testing::first_difference(matrix, 0, 0.01)), 1e-10) << text(sequence);
      EXPECT_LE(frobenius_norm(exact.second - testing::second_difference(matrix, 0, 0.01)), 1e-9) << text(sequence);
    }
  }
}

TEST(EulerRates, MatrixHasTheAxesOfTheTurnsForColumns) {
  std::mt19937_64 random(2);
  for (const EulerSequence& sequence : all_sequences()) {
    const EulerAngles angles = random_motion(sequence, random).angles(0);
    const Rotation a = Rotation::about(sequence.first(), angles.first),
                   b = Rotation::about(sequence.second(), angles.second),
                   c = Rotation::about(sequence.third(), angles.third);
    const Vector3 e1 = unit_vector(sequence.first()), e2 = unit_vector(sequence.second()),
                  e3 = unit_vector(sequence.third());
    const Matrix3x3 expected = sequence.turning() == Turning::intrinsic
                                   ? Matrix3x3::of_columns(e1, a.apply(e2), (a * b).apply(e3))
                                   : Matrix3x3::of_columns((c * b).apply(e1), c.apply(e2), e3);
    EXPECT_LE(ulps_between(rate_matrix(angles), expected), 3) << text(sequence);
    const double margin = sequence.is_proper_euler() ? std::sin(angles.second) : std::cos(angles.second);
    EXPECT_LE(ulps_between(std::fabs(determinant(rate_matrix(angles))), std::fabs(margin)), 4) << text(sequence);
  }
}

TEST(EulerRates, ComeBackFromTheMotion) {
  std::mt19937_64 random(3);
  double worst = 0;
  for (const EulerSequence& sequence : all_sequences()) {
    for (int i = 0; i < 2000; ++i) {
      const AngleMotion motion = random_motion(sequence, random);
      const EulerRates given{motion.rate, motion.acceleration};
      const Result<EulerRatesFit> fit = euler_rates(motion.angles(0), angular_motion(motion.angles(0), given));
      ASSERT_TRUE(fit.ok());
      EXPECT_EQ(fit->singularity, Singularity::none);
      const double unit = testing::ulp / fit->lock_distance;
      worst = std::max({worst, largest_difference(fit->rates.rates, given.rates) / unit,
                        largest_difference(fit->rates.accelerations, given.accelerations) / unit * fit->lock_distance});
    }
  }
  EXPECT_LE(worst, 4);
  RecordProperty("worst_ulps", std::to_string(worst));
}

/// |B x − u| with columns and products of long double, for intrinsic sequences.
long double residual(const EulerAngles& angles, const std::array<double, 3>& x, Vector3 u) {
  using Wide = std::array<long double, 3>;
  const auto axis = [](Axis a) {
    Wide e{};
    e[static_cast<std::size_t>(a)] = 1;
    return e;
  };
  const auto turn = [](Axis a, long double angle, const Wide& r) {
    const auto i = static_cast<std::size_t>(a), j = (i + 1) % 3, k = (i + 2) % 3;
    Wide turned = r;
    turned[j] = std::cos(angle) * r[j] - std::sin(angle) * r[k];
    turned[k] = std::sin(angle) * r[j] + std::cos(angle) * r[k];
    return turned;
  };
  const EulerSequence& s = angles.sequence;
  const Wide first = axis(s.first()), second = turn(s.first(), angles.first, axis(s.second())),
             third = turn(s.first(), angles.first, turn(s.second(), angles.second, axis(s.third())));
  long double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const long double r = x[0] * first[i] + x[1] * second[i] + x[2] * third[i] - u[i];
    sum += r * r;
  }
  return std::sqrt(sum);
}

TEST(EulerRates, NearGimbalLockAreExactToRounding) {
  std::mt19937_64 random(4);
  double worst = 0;
  for (const EulerSequence& sequence : EulerSequence::all()) {
    const double half = pi / 2;
    for (const double lock : sequence.is_proper_euler() ? std::array{0.0, pi} : std::array{-half, half}) {
      for (int k = 1; k <= 16; ++k) {
        for (const double side : {-1.0, 1.0}) {
          const EulerAngles angles{sequence, 0.4, lock + side * std::pow(10, -k), -1.3};
          const AngularMotion motion{random_direction(random), {}};
          const Result<EulerRatesFit> fit = euler_rates(angles, motion);
          ASSERT_TRUE(fit.ok());
          const double size = std::max(1.0, largest(fit->rates.rates));
          const auto left = static_cast<double>(residual(angles, fit->rates.rates, motion.velocity));
          if (fit->singularity == Singularity::none)
            worst = std::max(worst, left / size / testing::ulp);
          else
            EXPECT_NEAR(left, fit->velocity_residual, 2e-15) << text(sequence) << ' ' << angles.second;
          EXPECT_EQ(fit->singularity == Singularity::gimbal_lock, fit->lock_distance <= tolerance::gimbal_lock);
        }
      }
    }
  }
  EXPECT_LE(worst, 2);
  RecordProperty("worst_ulps", std::to_string(worst));
}

TEST(EulerRates, NearGimbalLockAreRelativelyExact) {
  // Cardan 1-2-3: ω seen after the first turn is (α̇ + γ̇ sin β, β̇, γ̇ cos β); near π/2 a double of β leaves cos β all its
  // digits, so γ̇ = ω_z / cos β has them too.
  const Vector3 omega{0.3, -0.4, 0.7};
  const double alpha = 0.4;
  const long double seen =
      std::cos(alpha) * static_cast<long double>(omega.z) - std::sin(alpha) * static_cast<long double>(omega.y);
  for (const double lock : {-pi / 2, pi / 2}) {
    for (int k = 1; k <= 14; ++k) {
      for (const double side : {-1.0, 1.0}) {
        const double beta = lock + side * std::pow(10, -k);
        const Result<EulerRatesFit> fit = euler_rates({EulerSequence::cardan_123(), alpha, beta, -1.3}, {omega, {}});
        const auto exact = static_cast<double>(seen / std::cos(static_cast<long double>(beta)));
        EXPECT_LE(std::fabs(fit->rates.rates[2] / exact - 1), 8 * testing::ulp) << beta - lock;
      }
    }
  }
}

TEST(EulerRates, AtGimbalLockAreTheLeastOfTheLeastSquares) {
  for (const EulerSequence& sequence : all_sequences()) {
    for (const double second : sequence.is_proper_euler() ? std::array{0.0, pi} : std::array{-pi / 2, pi / 2}) {
      const EulerAngles angles{sequence, 0.4, second, -1.3};
      const Matrix3x3 b = rate_matrix(angles);
      const Vector3 outside = normalized(cross(b.column(0), b.column(1)));
      const Vector3 inside = 0.6 * b.column(0) + 0.7 * b.column(1);
      const Result<EulerRatesFit> fit = euler_rates(angles, {inside + 0.5 * outside, {}});
      ASSERT_TRUE(fit.ok());
      EXPECT_EQ(fit->singularity, Singularity::gimbal_lock) << text(sequence);
      EXPECT_LE(fit->lock_distance, 1e-15);
      EXPECT_NEAR(fit->velocity_residual, 0.5, 1e-15);
      const auto& x = fit->rates.rates;
      EXPECT_LE(ulps_between(b * Vector3{x[0], x[1], x[2]}, inside), 4) << text(sequence);
      EXPECT_NEAR(std::fabs(x[0]), 0.3, 1e-15) << "shared evenly";
      EXPECT_NEAR(std::fabs(x[2]), 0.3, 1e-15);
      EXPECT_NEAR(x[1], 0.7, 1e-15);
    }
  }
}

TEST(EulerRates, OfASteadyTopAreThoseOfTheTextbook) {
  // Precession Ω about the vertical, spin s about the axis of the top, nutation 60°: ε = Ω e_z × s e_3.
  const EulerAngles top{EulerSequence::euler_313(), 0, pi / 3, 0.8};
  const AngularMotion motion = angular_motion(top, EulerRates{{2, 0, 10}, {}});
  EXPECT_LE(ulps_between(motion.velocity, {0, -10 * std::sin(pi / 3), 2 + 10 * std::cos(pi / 3)}), 8);
  EXPECT_LE(ulps_between(motion.acceleration, {20 * std::sin(pi / 3), 0, 0}), 16);
}

TEST(EulerRates, RefuseWhatIsNotANumberOrGrowsBeyondNumbers) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const EulerSequence sequence = EulerSequence::cardan_123();
  EXPECT_FALSE(euler_rates({sequence, 0, nan, 0}, {}).ok());
  EXPECT_FALSE(euler_rates({sequence, 0, 0, 0}, {{nan, 0, 0}, {}}).ok());
  EXPECT_FALSE(euler_rates({sequence, 0, 0, 0}, {{}, {0, 0, nan}}).ok());
  EXPECT_FALSE(euler_rates({sequence, 0, pi / 2 - 1e-12, 0}, {{1e300, 1e300, 1e300}, {}}).ok());
}

}  // namespace
}  // namespace linkwright::euler_rates_test
