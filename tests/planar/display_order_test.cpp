#include "linkwright/planar/display_order.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "linkwright/planar/four_bar_map.hpp"
#include "linkwright/region/region_map.hpp"
#include "planar/task_curve.hpp"
#include "support/planar_case.hpp"
#include "support/random_task.hpp"
#include "support/tailgate.hpp"

namespace linkwright::display_order_test {
namespace {

using testing::planar_cases;
using testing::tailgate_task;

TaskCurve curve_of(const std::vector<PrescribedPose>& poses) { return task_curve({poses}); }

DisplayOrder order_of(const TaskCurve& given, Spacing spacing = Spacing::coordinate, int code = 0) {
  return {*given.curve, spacing, given.conditions.frame, code};
}

std::vector<double> sorted(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values;
}

TEST(DisplayOrder, IsAPermutationOfTheCurvesSamples) {
  for (const auto& c : planar_cases()) {
    const TaskCurve given = curve_of(c.poses);
    for (const Spacing spacing : {Spacing::coordinate, Spacing::arc_length})
      for (const int count : {9, 50, 200}) {
        const auto samples = given.curve->samples(count, spacing);
        EXPECT_EQ(sorted(order_of(given, spacing, 1).samples(*given.curve, count)), samples) << c.name << count;
      }
  }
}

TEST(DisplayOrder, PlacesAndCoordinatesAreInverse) {
  for (const auto& c : planar_cases()) {
    const TaskCurve given = curve_of(c.poses);
    for (const Spacing spacing : {Spacing::coordinate, Spacing::arc_length})
      for (const int code : {0, 1}) {
        const DisplayOrder order = order_of(given, spacing, code);
        for (const double tau : given.curve->samples(60, Spacing::coordinate)) {
          const auto place = order.place(tau);
          ASSERT_TRUE(place) << c.name << " τ " << tau;
          ASSERT_GE(*place, 0);
          ASSERT_LE(*place, 1);
          ASSERT_NEAR(order.coordinate(*place), tau, 1e-9) << c.name;
        }
      }
  }
}

TEST(DisplayOrder, ABranchBeginsWithItsOwnDyads) {
  int begun = 0;
  for (const auto& c : planar_cases()) {
    const TaskCurve given = curve_of(c.poses);
    const DisplayOrder order = order_of(given);
    for (const CurveBranch& branch : given.curve->branches()) {
      if (branch.from == branch.to) continue;
      const auto place = order.place(branch.from);
      ASSERT_TRUE(place) << c.name << branch.name;
      EXPECT_EQ(order.coordinate(*place), branch.from) << c.name << branch.name;
      begun += branch.from > 0;
    }
  }
  EXPECT_GT(begun, 3);
}

TEST(DisplayOrder, BlocksFillTheAxisWithoutGaps) {
  for (const auto& c : planar_cases()) {
    const TaskCurve given = curve_of(c.poses);
    const DisplayOrder order = order_of(given, Spacing::arc_length);
    double place = 0;
    for (const OrderBlock& block : order.blocks()) {
      EXPECT_EQ(block.from, place);
      EXPECT_GT(block.to, block.from);
      EXPECT_EQ(block.knots.front()[0], block.from);
      EXPECT_EQ(block.knots.back()[0], block.to);
      for (std::size_t k = 1; k < block.knots.size(); ++k) EXPECT_GT(block.knots[k][0], block.knots[k - 1][0]);
      place = block.to;
    }
    EXPECT_EQ(place, given.curve->coordinate_length() > 0 ? 1 : 0) << c.name;
  }
}

TEST(DisplayOrder, OfOneBranchRunsFromThreeQuartersBothWays) {
  std::mt19937_64 random(5);
  TaskCurve given = curve_of(testing::random_poses(random));
  while (given.curve->kind() != CubicKind::one_branch) given = curve_of(testing::random_poses(random));
  const DisplayOrder order = order_of(given);
  EXPECT_EQ(order.coordinate(0.1), 0.65);
  EXPECT_EQ(order.coordinate(0.4), 0.35);
  EXPECT_NEAR(order.coordinate(0.6), 0.85, 1e-15);
  EXPECT_NEAR(order.coordinate(0.9), 0.15, 1e-15);
  const DisplayOrder exchanged = order_of(given, Spacing::coordinate, 1);
  EXPECT_EQ(exchanged.code(), 1);
  EXPECT_NEAR(exchanged.coordinate(0.1), 0.85, 1e-15);
}

TEST(DisplayOrder, PartsOfTheAxisAreSampledEvenlyByPlace) {
  const TaskCurve given = task_curve(tailgate_task());
  const DisplayOrder order = order_of(given);
  const auto part = order.samples(4, 0.5, 0.75);
  for (int i = 0; i < 4; ++i)
    EXPECT_EQ(part[static_cast<std::size_t>(i)], order.coordinate(0.5 + 0.25 * (i + 0.5) / 4));
  const auto whole = order.samples(40, 0, 1), permuted = order.samples(*given.curve, 40);
  for (std::size_t i = 0; i < 40; ++i) EXPECT_NEAR(whole[i], permuted[i], 1e-12);
}

/// The map of the tailgate with pose 3 moved, as the page shows it.
struct Frame {
  TaskCurve given;
  DisplayOrder order;
  RegionMap map;
};

Frame frame_at(Point offset, const DisplayOrder* before) {
  constexpr int samples = 200;
  MotionTask task = tailgate_task();
  task.poses[2].pose.origin += offset;
  Frame frame{task_curve(task), {}, {}};
  const WorkingFrame& working = frame.given.conditions.frame;
  const BurmesterCurve& curve = *frame.given.curve;
  frame.order = before ? DisplayOrder::nearest(curve, Spacing::coordinate, working, *before)
                       : DisplayOrder(curve, Spacing::coordinate, working);
  std::vector<Dyad> dyads;
  for (const double tau : frame.order.samples(curve, samples)) dyads.push_back(curve.dyad(tau));
  const DyadAxis axis(std::move(dyads), working.to_working(task.poses));
  classify_pairs(frame.map, axis, axis, working.scale);
  return frame;
}

double changed_share(const RegionMap& a, const RegionMap& b) {
  std::size_t changed = 0;
  for (std::size_t cell = 0; cell < a.types().size(); ++cell)
    changed += a.types()[cell] != b.types()[cell] || a.defects()[cell] != b.defects()[cell];
  return static_cast<double>(changed) / static_cast<double>(a.types().size());
}

// Acceptance walk-through 13: the map keeps still while κ passes through zero under the user's hand.
TEST(DisplayOrder, KeepsTheMapStillWhereTheCurveChangesItsKind) {
  constexpr double step = 0.6, fine = 0.04;
  for (const Point way : {Point{1, 0}, Point{0, 1}, Point{1, 1}, Point{1, 0.5}, Point{-0.3, 1}}) {
    int crossings = 0;
    Frame last = frame_at(-30.0 * way, nullptr);
    for (double at = -30 + step; at <= 30; at += step) {
      Frame next = frame_at(at * way, &last.order);
      if ((*last.given.curve->kappa() < 0) != (*next.given.curve->kappa() < 0)) {
        double low = at - step, high = at;
        while (high - low > fine) {
          const double middle = (low + high) / 2;
          const bool before =
              (*frame_at(middle * way, nullptr).given.curve->kappa() < 0) == (*last.given.curve->kappa() < 0);
          (before ? low : high) = middle;
        }
        const Frame one = frame_at(low * way, &last.order), other = frame_at(high * way, &one.order);
        EXPECT_LT(changed_share(one.map, other.map), 0.1) << "along " << way << " at " << low;
        ++crossings;
      }
      last = std::move(next);
    }
    EXPECT_GE(crossings, 2) << "along " << way;
  }
}

TEST(DisplayOrder, ExchangesTheBlocksWhereTheFocalFormTurnsRound) {
  // In order 0 nearly every cell changes between these two tasks, half a millimetre apart.
  const Frame one = frame_at({-0.42, 0}, nullptr), other = frame_at({-0.37, 0}, &one.order),
              plain = frame_at({-0.37, 0}, nullptr);
  EXPECT_EQ(one.order.code(), 0);
  EXPECT_EQ(other.order.code(), 1);
  EXPECT_GT(changed_share(one.map, plain.map), 0.8);
  EXPECT_LT(changed_share(one.map, other.map), 0.1);
}

TEST(DisplayOrder, SamplesTakeTheirRoomAndGapsNone) {
  const std::vector<CurveBranch> branches = {{"sheet_1", 0, 1}, {"sheet_2", 1, 2}};
  const std::vector<double> samples = {0.1, 0.12, 0.6, 0.62, 1.1, 1.12, 1.6, 1.62};
  const DisplayOrder order(branches, samples);
  ASSERT_EQ(order.blocks().size(), 2u);
  EXPECT_EQ(order.blocks()[1].from, 0.5);
  const std::vector<double> again = order.samples(8, 0, 1);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    EXPECT_NEAR(again[i], samples[i], 1e-12);
    EXPECT_NEAR(order.place(samples[i]).value_or(-1), (static_cast<double>(i) + 0.5) / 8, 1e-12);
  }
  const DisplayOrder plain(branches);
  EXPECT_EQ(plain.coordinate(0.75), 1.5);
  EXPECT_TRUE(DisplayOrder(std::vector<CurveBranch>{}, {}).blocks().empty());
}

}  // namespace
}  // namespace linkwright::display_order_test
