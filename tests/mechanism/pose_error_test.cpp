#include "linkwright/mechanism/pose_error.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/defects.hpp"
#include "linkwright/mechanism/position.hpp"
#include "support/random_four_bar.hpp"
#include "support/random_task.hpp"

namespace linkwright::pose_error_test {
namespace {

using testing::coupler_pose;
using testing::RandomFourBars;

/// A linkage on its way: five of its poses, 0.2 radians of the input apart.
struct Travel {
  FourBar bars;
  std::vector<Pose> poses;
};

constexpr double step = 0.2;

std::vector<PrescribedPose> without(const std::vector<Pose>& poses, std::size_t left_out) {
  std::vector<PrescribedPose> served;
  for (std::size_t j = 0; j < poses.size(); ++j)
    if (j != left_out) served.push_back({poses[j], {}});
  return served;
}

std::vector<Travel> travels(int count) {
  RandomFourBars random(71);
  std::vector<Travel> found;
  while (static_cast<int>(found.size()) < count) {
    const LinkLengths lengths = random.lengths();
    const double from = random.input_angle(lengths);
    const Assembly assembly = random.assembly();
    Travel travel;
    for (int j = 0; j < 5; ++j) {
      const auto there = assemble(lengths, from + step * j, assembly);
      if (!there) break;
      const FourBar bars = testing::four_bar_at(lengths, from + step * j, assembly);
      if (j == 0) travel.bars = bars;
      travel.poses.push_back(coupler_pose(bars));
    }
    // Steps may jump over a narrow sector that the input cannot enter.
    if (travel.poses.size() == 5 && find_defects(travel.bars, without(travel.poses, 5)).defects.none())
      found.push_back(travel);
  }
  return found;
}

// As it lies in the first pose served.
FourBar in(const FourBar& bars, const Pose& from, const Pose& to) {
  return {bars.input_fixed, displaced(bars.input_moving, from, to), bars.output_fixed,
          displaced(bars.output_moving, from, to)};
}

TEST(PoseError, IsNothingWhereTheLinkagePassesThePose) {
  for (const Travel& travel : travels(200))
    for (std::size_t relaxed = 0; relaxed < 5; ++relaxed) {
      const auto served = without(travel.poses, relaxed);
      const FourBar bars = in(travel.bars, travel.poses[0], served[0].pose);
      const auto error = pose_error(bars, served, {travel.poses[relaxed], relaxed, 1.5});
      ASSERT_TRUE(error);
      EXPECT_LT(error->combined(1.5), 1e-9);
      const double from_first = step * (static_cast<double>(relaxed) - (relaxed == 0 ? 1 : 0));
      // A crank's rest of the turn is one range, whether it lies before the first pose or after the last.
      EXPECT_LT(std::abs(wrap_signed(error->turn - from_first)), 1e-8);
    }
}

// Over input angles from..to, by the position analysis of one configuration after the other.
double least_by_brute_force(const FourBar& bars, const Pose& given, const RelaxedPose& relaxed, double from,
                            double to) {
  const Configuration start = configuration_of(bars);
  constexpr int samples = 4000;
  double least = 1e300;
  for (int i = 0; i <= samples; ++i) {
    const auto there =
        assemble(bars.lengths(), start.input_angle + from + (to - from) * i / samples, assembly_of(bars));
    if (!there) continue;
    const FourBar moved = placed(bars, *there);
    const double turn = there->coupler_angle - start.coupler_angle;
    const Point origin = moved.input_moving + direction(turn) * (given.origin - bars.input_moving);
    const double angle = wrap_signed(given.angle + turn - relaxed.pose.angle);
    least = std::min(least, std::hypot(std::abs(origin - relaxed.pose.origin), relaxed.size * angle));
  }
  return least;
}

TEST(PoseError, IsTheLeastBetweenTheNeighbours) {
  RandomFourBars random(72);
  for (const Travel& travel : travels(60)) {
    const std::size_t relaxed = 1 + static_cast<std::size_t>(random.below(3));
    const auto served = without(travel.poses, relaxed);
    RelaxedPose wanted{travel.poses[relaxed], relaxed, random.uniform(0.3, 3)};
    wanted.pose.origin += Point{random.uniform(-1, 1), random.uniform(-1, 1)};
    wanted.pose.angle += random.uniform(-1, 1);
    const auto error = pose_error(travel.bars, served, wanted);
    ASSERT_TRUE(error);
    const double before = step * (static_cast<double>(relaxed) - 1);
    const double least = least_by_brute_force(travel.bars, travel.poses[0], wanted, before, before + 2 * step);
    EXPECT_LT(error->combined(wanted.size), least + 1e-9);
    EXPECT_GT(error->combined(wanted.size), least - 1e-3 * (1 + least));  // dead points have samples far apart
  }
}

TEST(PoseError, DoesNotCountThePoseWhereItIsMetOutOfOrder) {
  for (const Travel& travel : travels(50)) {
    const auto served = without(travel.poses, 4);
    const auto last = pose_error(travel.bars, served, {travel.poses[4], 4, 1});
    const auto second = pose_error(travel.bars, served, {travel.poses[4], 1, 1});
    ASSERT_TRUE(last && second);
    EXPECT_LT(last->combined(1), 1e-9);
    EXPECT_GT(second->combined(1), 1e-3);
    EXPECT_GE(second->turn, -1e-9);
    EXPECT_LE(second->turn, step + 1e-9);
  }
}

TEST(PoseError, GrowsWithTheDrawingAndMovesWithIt) {
  RandomFourBars random(73);
  for (const Travel& travel : travels(40)) {
    const auto served = without(travel.poses, 2);
    RelaxedPose wanted{travel.poses[2], 2, 0.8};
    wanted.pose.origin += Point{0.2, -0.1};
    const double scale = std::pow(10.0, random.uniform(-5, 5)), angle = random.uniform(-3, 3);
    const Point shift = scale * Point{random.uniform(-9, 9), random.uniform(-9, 9)};
    const auto point = [&](Point p) { return scale * direction(angle) * p + shift; };
    const FourBar& b = travel.bars;
    const FourBar moved{point(b.input_fixed), point(b.input_moving), point(b.output_fixed), point(b.output_moving)};
    const auto before = pose_error(b, served, wanted);
    const auto after = pose_error(moved, testing::moved(served, scale, angle, shift),
                                  {{point(wanted.pose.origin), wanted.pose.angle + angle}, 2, scale * wanted.size});
    ASSERT_TRUE(before && after);
    EXPECT_NEAR(after->combined(scale * wanted.size) / scale, before->combined(wanted.size), 1e-7);
  }
}

TEST(PoseError, NeedsALinkage) {
  const std::vector<PrescribedPose> served = {{{{0, 0}, 0}, {}}, {{{1, 0}, 0.2}, {}}};
  EXPECT_FALSE(pose_error({{0, 0}, {0, 0}, {3, 0}, {2, 1}}, served, {{{2, 0}, 0.3}, 2, 1}));
}

}  // namespace
}  // namespace linkwright::pose_error_test
