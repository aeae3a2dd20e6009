#include "linkwright/attitude/common_normal.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

#include "linkwright/core/angle.hpp"
#include "support/attitude_case.hpp"

namespace linkwright::common_normal_test {
namespace {

using testing::random_direction;

CommonNormal normal_of(const Line& first, const Line& second) {
  const Result<CommonNormal> result = common_normal(first, second);
  EXPECT_TRUE(result.ok());
  return result ? *result : CommonNormal{};
}

TEST(CommonNormal, OfTwoEdgesOfABoxIsTheThird) {
  const CommonNormal n = normal_of({{7, 0, 0}, {3, 0, 0}}, {{0, -5, 2}, {0, 0.5, 0}});
  EXPECT_EQ(n.lines, LinePair::crossing);
  EXPECT_EQ(n.direction, (Vector3{0, 0, 1}));
  EXPECT_EQ(n.foot_on_first, Vector3{});
  EXPECT_EQ(n.foot_on_second, (Vector3{0, 0, 2}));
  EXPECT_EQ(n.distance, 2);
  EXPECT_DOUBLE_EQ(n.twist, pi / 2);
}

TEST(CommonNormal, StandsOnBothLinesAndLeadsFromOneToTheOther) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 2000; ++i) {
    const Line first{random_direction(random), random_direction(random)},
        second{random_direction(random), random_direction(random)};
    const CommonNormal n = normal_of(first, second);
    const double sine = std::fabs(std::sin(n.twist)), limit = 1e-14 / (sine * sine);
    EXPECT_LE(std::fabs(dot(n.direction, first.direction)), 1e-15 / sine);
    EXPECT_LE(std::fabs(dot(n.direction, second.direction)), 1e-15 / sine);
    EXPECT_LE(norm(cross(n.foot_on_first - first.point, first.direction)), limit);
    EXPECT_LE(norm(cross(n.foot_on_second - second.point, second.direction)), limit);
    EXPECT_LE(norm(n.foot_on_first + n.distance * n.direction - n.foot_on_second), limit);
    EXPECT_GE(n.distance, 0);
    const Result<Rotation> twist = Rotation::about_axis(n.direction, n.twist);
    EXPECT_LE(norm(twist->apply(first.direction) - second.direction), 1e-14 / sine);
  }
}

TEST(CommonNormal, OfParallelsStartsAtTheGivenPoint) {
  const CommonNormal same = normal_of({{0, 0, 5}, {0, 0, 1}}, {{3, 4, -7}, {0, 0, 2}});
  EXPECT_EQ(same.lines, LinePair::parallel);
  EXPECT_EQ(same.foot_on_first, (Vector3{0, 0, 5}));
  EXPECT_EQ(same.foot_on_second, (Vector3{3, 4, 5}));
  EXPECT_EQ(same.distance, 5);
  EXPECT_EQ(same.twist, 0);
  EXPECT_DOUBLE_EQ(normal_of({{0, 0, 5}, {0, 0, 1}}, {{3, 4, -7}, {0, 0, -2}}).twist, pi) << "against each other";
}

TEST(CommonNormal, OfOneLineIsAnyNormal) {
  const CommonNormal n = normal_of({{1, 2, 3}, {1, 1, 0}}, {{3, 4, 3}, {-2, -2, 0}});
  EXPECT_EQ(n.lines, LinePair::coincident);
  EXPECT_EQ(n.distance, 0);
  EXPECT_LE(std::fabs(dot(n.direction, {1, 1, 0})), 1e-16);
  EXPECT_DOUBLE_EQ(norm(n.direction), 1);
  EXPECT_DOUBLE_EQ(std::fabs(n.twist), pi);
}

TEST(CommonNormal, OfLinesThatMeetIsTheirCrossProduct) {
  const CommonNormal n = normal_of({{1, 1, 1}, {1, 0, 0}}, {{1, 1, 1}, {0, 2, 0}});
  EXPECT_EQ(n.lines, LinePair::crossing);
  EXPECT_EQ(n.direction, (Vector3{0, 0, 1}));
  EXPECT_EQ(n.distance, 0);
  EXPECT_EQ(n.foot_on_first, (Vector3{1, 1, 1}));
}

TEST(CommonNormal, DoesNotDependOnTheLengthsGiven) {
  const CommonNormal a = normal_of({{1, 2, 3}, {1e-300, 0, 0}}, {{0, 0, 0}, {1e300, 1e300, 0}});
  const CommonNormal b = normal_of({{1, 2, 3}, {1, 0, 0}}, {{0, 0, 0}, {1, 1, 0}});
  EXPECT_EQ(a.foot_on_first, b.foot_on_first);
  EXPECT_EQ(a.twist, b.twist);
}

TEST(CommonNormal, RefusesWhatIsNoLine) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Line good;
  EXPECT_EQ(common_normal({{}, {}}, good).errors().front().code, "zero_direction");
  EXPECT_EQ(common_normal(good, {{}, {}}).errors().front().place, "second");
  EXPECT_EQ(common_normal(good, {{nan, 0, 0}, {1, 0, 0}}).errors().front().code, "not_finite");
}

}  // namespace
}  // namespace linkwright::common_normal_test
