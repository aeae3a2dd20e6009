// What holds for the grounded links through any five positions, finite or infinitesimally close.

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "linkwright/core/angle.hpp"
#include "linkwright/planar/burmester_curve.hpp"
#include "linkwright/planar/burmester_points.hpp"
#include "support/dyad_measures.hpp"
#include "support/random_task.hpp"

namespace linkwright::five_positions_law_test {
namespace {

using testing::apart;
using testing::nearest;
using testing::relative_length_change;
using testing::uniform;

const std::vector<std::vector<int>> patterns = {{1, 1, 1, 1, 1}, {2, 1, 1, 1}, {2, 2, 1}, {3, 1, 1},
                                                {3, 2},          {4, 1},       {5}};

TEST(FivePositionsLaw, TwoThousandTasksOfEachPatternHaveFourDyadsThatMeetEveryCondition) {
  std::mt19937_64 random(61);
  for (const auto& multiplicities : patterns) {
    std::array<int, 5> tasks_with{};
    double worst = 0, worst_change = 0;
    for (int trial = 0; trial < 2000; ++trial) {
      const auto task = testing::random_poses(random, multiplicities);
      const PoseConditions conditions = pose_conditions(task);
      ASSERT_EQ(conditions.rank, 4);
      const BurmesterPoints found = burmester_points(conditions);
      ASSERT_FALSE(found.degeneracy);
      int counted = found.complex_roots;
      const auto poses = conditions.frame.to_working(task);
      const auto of_derivatives = derivative_conditions(task, conditions.frame);
      for (const BurmesterPoint& point : found.points) {
        counted += point.multiplicity;
        const auto& [center, circle, place] = point.dyad;
        EXPECT_NEAR(norm(center), 1, 1e-15);
        EXPECT_NEAR(norm(circle), 1, 1e-15);
        worst = std::max(worst, point.residual);
        for (const HomogeneousMatrix& row : of_derivatives)
          worst = std::max(worst, std::abs(dot(circle, row * center)));
        const auto c = finite_point(center), z = finite_point(circle);
        if (c && z && std::abs(*z - *c) > 1e-2 && std::abs(*z) < 1e2 && std::abs(*c) < 1e2)
          worst_change = std::max(worst_change, relative_length_change(poses, *c, *z));
      }
      EXPECT_EQ(counted, 4);
      ++tasks_with[static_cast<std::size_t>(4 - found.complex_roots)];
    }
    EXPECT_EQ(tasks_with[1] + tasks_with[3], 0);
    EXPECT_GT(tasks_with[0], 50);
    EXPECT_GT(tasks_with[2], 1000);
    EXPECT_GT(tasks_with[4], 50);
    EXPECT_LT(worst, 5e-15);
    EXPECT_LT(worst_change, 1e-8);
  }
}

// Ordered by rising distance of the circle point from the moving frame's origin in position 1.
TEST(FivePositionsLaw, TheyComeInAnOrderThatNamesThem) {
  std::mt19937_64 random(62);
  for (int trial = 0; trial < 200; ++trial) {
    const BurmesterPoints found = burmester_points(pose_conditions(testing::random_poses(random, 5)));
    for (std::size_t i = 0; i < found.points.size(); ++i) {
      EXPECT_EQ(found.points[i].dyad.coordinate, static_cast<double>(i) + 0.5);
      if (i > 0) {
        EXPECT_GE(found.points[i - 1].dyad.circle.w, found.points[i].dyad.circle.w);
      }
    }
  }
}

TEST(FivePositionsLaw, TheyLieOnTheBurmesterCurvesOfTheFourPositionsAmongThem) {
  std::mt19937_64 random(63);
  for (const auto& multiplicities : patterns)
    for (int trial = 0; trial < 100; ++trial) {
      const auto task = testing::random_poses(random, multiplicities);
      const PoseConditions conditions = pose_conditions(task);
      const BurmesterPoints found = burmester_points(conditions);
      // Each position but the first can go, the last derivative of its pose before the pose itself.
      for (std::size_t j = 0; j < task.size(); ++j) {
        auto four = task;
        if (!four[j].derivatives.empty())
          four[j].derivatives.pop_back();
        else if (j > 0)
          four.erase(four.begin() + static_cast<std::ptrdiff_t>(j));
        else
          continue;
        const PoseConditions fewer = pose_conditions(four);
        const BurmesterCurve curve(fewer);
        for (const BurmesterPoint& point : found.points) {
          const Dyad user = conditions.frame.to_user(point.dyad);
          const Dyad there{normalized(fewer.frame.to_working(user.center)),
                           normalized(fewer.frame.to_working(user.circle))};
          EXPECT_LT(curve.residual(there), 1e-14 * conditions.condition()) << pattern(task);
        }
      }
    }
}

TEST(FivePositionsLaw, RigidMotionAndScaleMoveThemAndKeepTheirOrder) {
  std::mt19937_64 random(64);
  for (const auto& multiplicities : patterns)
    for (int trial = 0; trial < 100; ++trial) {
      const auto task = testing::random_poses(random, multiplicities);
      const double scale = std::pow(10.0, uniform(random, -6, 6)), angle = uniform(random, -pi, pi);
      const Point shift = scale * Point{uniform(random, -50, 50), uniform(random, -50, 50)};
      const BurmesterPoints before = burmester_points(pose_conditions(task));
      const BurmesterPoints after = burmester_points(pose_conditions(testing::moved(task, scale, angle, shift)));
      ASSERT_EQ(before.points.size(), after.points.size());
      for (std::size_t i = 0; i < before.points.size(); ++i) {
        const BurmesterPoint& point = before.points[i];
        const auto turned = [&](Homogeneous p) {
          const Point v = direction(angle) * p.vector();
          return Homogeneous{p.w, v.real(), v.imag()};
        };
        // Adding the shift to the poses costs two digits.
        EXPECT_LT(apart(after.points[i].dyad, {turned(point.dyad.center), turned(point.dyad.circle)}),
                  1e-13 * point.condition);
      }
    }
}

TEST(FivePositionsLaw, AnyPoseCanBeTheFirst) {
  std::mt19937_64 random(65);
  for (int trial = 0; trial < 200; ++trial) {
    const auto task = testing::random_poses(random, 5);
    auto other_order = task;
    std::rotate(other_order.begin(), other_order.begin() + 1 + trial % 4, other_order.end());
    const PoseConditions conditions = pose_conditions(task), other = pose_conditions(other_order);
    const BurmesterPoints found = burmester_points(conditions), there = burmester_points(other);
    ASSERT_EQ(found.points.size(), there.points.size());
    const Pose &from = task[0].pose, &to = other_order[0].pose;
    const Point r = direction(to.angle - from.angle);
    for (const BurmesterPoint& point : found.points) {
      const Dyad user = conditions.frame.to_user(point.dyad);
      const Point moved = r * (user.circle.vector() - user.circle.w * from.origin) + user.circle.w * to.origin;
      const Homogeneous circle{user.circle.w, moved.real(), moved.imag()};
      EXPECT_LT(nearest(there, {other.frame.to_working(user.center), other.frame.to_working(circle)}),
                1e-14 * point.condition);
    }
  }
}

// A smooth motion by random Fourier coefficients, and its derivatives.
struct Motion {
  std::array<double, 3> sine{}, cosine{};

  explicit Motion(std::mt19937_64& random) {
    for (std::size_t i = 0; i < 3; ++i) sine[i] = uniform(random, -1, 1), cosine[i] = uniform(random, -1, 1);
  }
  [[nodiscard]] PoseDerivative at(double t, int m) const {
    const double quarter = pi / 2 * m;
    const auto part = [&](std::size_t i) {
      return sine[i] * std::sin(t + quarter) + cosine[i] * std::pow(0.5, m) * std::cos(t / 2 + quarter);
    };
    return {{part(0), part(1)}, part(2) + (m == 0 ? t : m == 1 ? 1 : 0)};
  }
  // Positions h apart; infinitesimally close where h is 0.
  [[nodiscard]] std::vector<PrescribedPose> positions(const std::vector<int>& multiplicities, double h) const {
    std::vector<PrescribedPose> poses;
    for (std::size_t j = 0; j < multiplicities.size(); ++j)
      for (int i = 0; i < multiplicities[j]; ++i) {
        const PoseDerivative here = at(0.8 * static_cast<double>(j) + h * i, h > 0 ? 0 : i);
        if (h > 0 || i == 0)
          poses.push_back({{here.origin, here.angle}, {}});
        else
          poses.back().derivatives.push_back(here);
      }
    return poses;
  }
};

TEST(FivePositionsLaw, FinitePositionsThatApproachEachOtherHaveTheirDyadsInTheLimit) {
  std::mt19937_64 random(66);
  for (const auto& multiplicities : patterns) {
    if (multiplicities.size() == 5) continue;
    // Five positions h apart leave a condition of h⁻⁴.
    const double far = multiplicities.size() == 1 ? 2e-2 : 1e-3;
    std::vector<double> gains;
    for (int trial = 0; trial < 40; ++trial) {
      const Motion motion(random);
      const PoseConditions limit = pose_conditions(motion.positions(multiplicities, 0));
      const BurmesterPoints wanted = burmester_points(limit);
      std::array<double, 2> distance{};
      for (std::size_t k = 0; k < 2; ++k) {
        const PoseConditions close = pose_conditions(motion.positions(multiplicities, k == 0 ? far : far / 4));
        const BurmesterPoints found = burmester_points(close);
        for (const BurmesterPoint& point : wanted.points) {
          const Dyad user = limit.frame.to_user(point.dyad);
          const double miss =
              nearest(found, {close.frame.to_working(user.center), close.frame.to_working(user.circle)});
          distance[k] = std::max(distance[k], miss);
        }
      }
      if (!wanted.points.empty()) gains.push_back(distance[0] / distance[1]);
    }
    // Four times nearer, four times closer: O(h).
    ASSERT_GT(gains.size(), 20u);
    std::nth_element(gains.begin(), gains.begin() + static_cast<std::ptrdiff_t>(gains.size() / 2), gains.end());
    EXPECT_NEAR(gains[gains.size() / 2], 4, 0.4) << multiplicities.size();
  }
}

}  // namespace
}  // namespace linkwright::five_positions_law_test
