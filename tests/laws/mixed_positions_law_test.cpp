// Mixed positions are what they are said to be: limits of finite ones, and prescriptions of how a grounded link keeps
// its length.

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "linkwright/planar/burmester_curve.hpp"
#include "linkwright/planar/pose_conditions.hpp"
#include "support/dyad_measures.hpp"
#include "support/random_task.hpp"

namespace linkwright::mixed_positions_law_test {
namespace {

using testing::mixed_patterns;
using testing::relative_length_change;
using testing::uniform;

TEST(MixedPositionsLaw, TwoThousandTasksOfEachPatternAreMetByEveryDyad) {
  std::mt19937_64 random(31);
  for (const auto& multiplicities : mixed_patterns()) {
    double worst = 0, worst_change = 0;
    int loose = 0, dyads = 0;
    for (int trial = 0; trial < 2000; ++trial) {
      const auto task = testing::random_poses(random, multiplicities);
      const PoseConditions conditions = pose_conditions(task);
      ASSERT_EQ(conditions.rank, 3);
      const BurmesterCurve curve(conditions);
      const auto poses = conditions.frame.to_working(task);
      const auto of_derivatives = derivative_conditions(task, conditions.frame);
      for (int k = 0; k < 10; ++k, ++dyads) {
        const Dyad dyad = curve.dyad(uniform(random, 0, curve.coordinate_length()));
        for (const HomogeneousMatrix& row : conditions.rows)
          worst = std::max(worst, std::abs(dot(dyad.circle, row * dyad.center)));
        for (const HomogeneousMatrix& row : of_derivatives)
          worst = std::max(worst, std::abs(dot(dyad.circle, row * dyad.center)));
        const auto center = finite_point(dyad.center), circle = finite_point(dyad.circle);
        if (!center || !circle || std::abs(*circle - *center) < 1e-3) continue;
        const double change = relative_length_change(poses, *center, *circle);
        worst_change = std::max(worst_change, change);
        loose += change > 1e-10;
      }
    }
    EXPECT_LT(worst, 5e-15);
    EXPECT_LT(worst_change, 1e-7);
    EXPECT_LT(loose, dyads / 1000);
  }
}

// The pose at parameter t of the path whose derivatives at t = 0 are prescribed and whose higher ones are zero.
Pose on_path(const PrescribedPose& prescribed, double t) {
  Pose pose = prescribed.pose;
  double power = 1;
  for (std::size_t m = 0; m < prescribed.derivatives.size(); ++m) {
    power *= t / static_cast<double>(m + 1);
    pose.origin += power * prescribed.derivatives[m].origin;
    pose.angle += power * prescribed.derivatives[m].angle;
  }
  return pose;
}

TEST(MixedPositionsLaw, ASideLinkKeepsItsLengthAlongThePathToTheOrderPrescribed) {
  std::mt19937_64 random(32);
  for (const auto& multiplicities : mixed_patterns())
    for (int trial = 0; trial < 100; ++trial) {
      const auto task = testing::random_poses(random, multiplicities);
      const PoseConditions conditions = pose_conditions(task);
      const BurmesterCurve curve(conditions);
      const auto poses = conditions.frame.to_working(task);
      const Dyad dyad = curve.dyad(uniform(random, 0, curve.coordinate_length()));
      const auto center = finite_point(dyad.center), circle = finite_point(dyad.circle);
      if (!center || !circle || std::abs(*center) > 20 || std::abs(*circle) > 20) continue;
      for (const PrescribedPose& pose : poses) {
        const double order = pose.multiplicity();
        const Point there = displaced(*circle, poses[0].pose, pose.pose);
        const double squared = std::norm(there - *center);
        // Half the change of the squared length, the larger of both ways: (|c| + |d| t + …) t^order.
        const auto change = [&](double t) {
          double worst = 0;
          for (const double way : {t, -t})
            worst = std::max(
                worst, std::abs(std::norm(displaced(there, pose.pose, on_path(pose, way)) - *center) - squared) / 2);
          return worst;
        };
        if (pose.derivatives.empty()) continue;
        const double step = 0.02;
        const double noise = 1e-13 * (1 + squared + std::norm(there));
        EXPECT_LT(change(step / 2), 1.3 * change(step) / std::pow(2, order) + noise) << pattern(poses);
        EXPECT_LT(change(step / 4), 1.3 * change(step) / std::pow(4, order) + noise) << pattern(poses);
      }
    }
}

// A smooth motion, by random Fourier coefficients, and its derivatives.
struct Motion {
  std::array<double, 3> sine{}, cosine{};

  explicit Motion(std::mt19937_64& random) {
    for (std::size_t i = 0; i < 3; ++i) sine[i] = uniform(random, -1, 1), cosine[i] = uniform(random, -1, 1);
  }
  // m-th derivatives of x, y, θ: each a sine of 1 and a cosine of ½ times the parameter, and θ grows evenly beside.
  [[nodiscard]] PoseDerivative at(double t, int m) const {
    const double quarter = 1.5707963267948966 * m;
    const auto part = [&](std::size_t i) {
      return sine[i] * std::sin(t + quarter) + cosine[i] * std::pow(0.5, m) * std::cos(t / 2 + quarter);
    };
    return {{part(0), part(1)}, part(2) + (m == 0 ? t : m == 1 ? 1 : 0)};
  }
};

std::vector<PrescribedPose> mixed_on(const Motion& motion, const std::vector<int>& multiplicities) {
  std::vector<PrescribedPose> poses;
  for (std::size_t j = 0; j < multiplicities.size(); ++j) {
    const double t = 0.8 * static_cast<double>(j);
    const PoseDerivative here = motion.at(t, 0);
    poses.push_back({{here.origin, here.angle}, {}});
    for (int m = 1; m < multiplicities[j]; ++m) poses.back().derivatives.push_back(motion.at(t, m));
  }
  return poses;
}

// The same positions `h` apart instead of infinitesimally close.
std::vector<PrescribedPose> apart_on(const Motion& motion, const std::vector<int>& multiplicities, double h) {
  std::vector<PrescribedPose> poses;
  for (std::size_t j = 0; j < multiplicities.size(); ++j)
    for (int i = 0; i < multiplicities[j]; ++i) {
      const PoseDerivative here = motion.at(0.8 * static_cast<double>(j) + h * i, 0);
      poses.push_back({{here.origin, here.angle}, {}});
    }
  return poses;
}

// How far, by the sum of the angles between the unit vectors, the dyads of one curve lie from the other's: the median.
double median_distance(const PoseConditions& from, const PoseConditions& to) {
  const BurmesterCurve here(from), there(to);
  std::vector<double> distances;
  for (const double tau : here.samples(200, Spacing::arc_length)) {
    const Dyad dyad = from.frame.to_user(here.dyad(tau));
    const Homogeneous circle = to.frame.to_working(dyad.circle), center = to.frame.to_working(dyad.center);
    const auto place = there.circle_curve().coordinate_of(circle);
    if (!place) continue;
    const Dyad found = there.dyad(*place);
    distances.push_back(great_circle(found.circle, circle) + great_circle(found.center, center));
  }
  EXPECT_GT(distances.size(), 150u);
  std::nth_element(distances.begin(), distances.begin() + 100, distances.end());
  return distances[100];
}

TEST(MixedPositionsLaw, FinitePositionsThatApproachEachOtherHaveTheirDyadsInTheLimit) {
  std::mt19937_64 random(33);
  for (const auto& multiplicities : mixed_patterns()) {
    std::vector<double> gains;
    for (int trial = 0; trial < 40; ++trial) {
      const Motion motion(random);
      const PoseConditions limit = pose_conditions(mixed_on(motion, multiplicities));
      const PoseConditions coarse = pose_conditions(apart_on(motion, multiplicities, 4e-3));
      const PoseConditions fine = pose_conditions(apart_on(motion, multiplicities, 4e-4));
      const double far = median_distance(limit, coarse), near = median_distance(limit, fine);
      EXPECT_LT(near, 0.05) << pattern(mixed_on(motion, multiplicities));
      gains.push_back(far / near);
    }
    // Ten times nearer, ten times closer: O(h).
    std::nth_element(gains.begin(), gains.begin() + 20, gains.end());
    EXPECT_NEAR(gains[20], 10, 0.7) << multiplicities.size();
  }
}

// Derivatives by s of a pose given by t, with t = αs + βs² + γs³.
PrescribedPose by_another_parameter(PrescribedPose pose, double alpha, double beta, double gamma) {
  const auto old = pose.derivatives;
  const auto combined = [&](double first, double second, double third) {
    const std::array<double, 3> share = {first, second, third};
    PoseDerivative sum;
    for (std::size_t m = 0; m < old.size(); ++m) {
      sum.origin += share[m] * old[m].origin;
      sum.angle += share[m] * old[m].angle;
    }
    return sum;
  };
  const std::array<PoseDerivative, 3> found = {combined(alpha, 0, 0), combined(2 * beta, alpha * alpha, 0),
                                               combined(6 * gamma, 6 * alpha * beta, std::pow(alpha, 3))};
  std::copy_n(found.begin(), old.size(), pose.derivatives.begin());
  return pose;
}

TEST(MixedPositionsLaw, AnyParameterThatIncreasesGivesTheSameDyads) {
  std::mt19937_64 random(34);
  for (const auto& multiplicities : mixed_patterns())
    for (int trial = 0; trial < 50; ++trial) {
      auto poses = testing::random_poses(random, multiplicities);
      const PoseConditions conditions = pose_conditions(poses);
      for (PrescribedPose& pose : poses)
        pose = by_another_parameter(pose, uniform(random, 0.3, 3), uniform(random, -1, 1), uniform(random, -1, 1));
      const PoseConditions other = pose_conditions(poses);
      const BurmesterCurve curve(conditions), other_curve(other);
      EXPECT_NEAR(*curve.kappa(), *other_curve.kappa(), 1e-9);
      for (int k = 0; k < 20; ++k) {
        const Dyad dyad = conditions.frame.to_user(curve.dyad(uniform(random, 0, curve.coordinate_length())));
        const Dyad there{normalized(other.frame.to_working(dyad.center)),
                         normalized(other.frame.to_working(dyad.circle))};
        EXPECT_LT(other_curve.residual(there), 1e-12);
      }
    }
}

}  // namespace
}  // namespace linkwright::mixed_positions_law_test
