#include "planar/given_pivot_family.hpp"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/defects.hpp"
#include "support/circle_conditions.hpp"
#include "support/random_task.hpp"

namespace linkwright::given_pivot_family_test {
namespace {

using testing::uniform;

Point drawn_point(std::mt19937_64& random, double reach = 3) {
  return {uniform(random, -reach, reach), uniform(random, -reach, reach)};
}

struct Given {
  explicit Given(std::vector<PrescribedPose> of)
      : poses(std::move(of)),
        conditions(pose_conditions(poses)),
        dyads(std::make_shared<const ThreePoseDyads>(conditions)) {}

  [[nodiscard]] Dyad with(PivotKind kind, Point pivot) const {
    return dyads->dyad_with(kind, Homogeneous::of(conditions.frame.to_working(pivot))).value();
  }
  [[nodiscard]] Point user(Homogeneous p) const { return conditions.frame.to_user(finite_point(p).value()); }

  std::vector<PrescribedPose> poses;
  PoseConditions conditions;
  std::shared_ptr<const ThreePoseDyads> dyads;
};

TEST(DyadWith, IsWhatNewtonsMethodFindsOnTheCircles) {
  std::mt19937_64 random(2);
  int compared = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const Given task(testing::random_poses(random, 3));
    const Point pivot = drawn_point(random);
    const Dyad by_center = task.with(PivotKind::ground, pivot), by_circle = task.with(PivotKind::moving, pivot);
    EXPECT_LT(std::abs(task.user(by_center.center) - pivot), 1e-12);
    EXPECT_LT(std::abs(task.user(by_circle.circle) - pivot), 1e-12);
    const auto circle =
        testing::newton([&](Point z) { return testing::length_changes(task.poses, pivot, z); }, drawn_point(random));
    const auto center =
        testing::newton([&](Point c) { return testing::length_changes(task.poses, c, pivot); }, drawn_point(random));
    if (!circle || !center) continue;
    EXPECT_LT(std::abs(task.user(by_center.circle) - *circle), 1e-8 * (1 + std::abs(*circle)));
    EXPECT_LT(std::abs(task.user(by_circle.center) - *center), 1e-8 * (1 + std::abs(*center)));
    ++compared;
  }
  EXPECT_GT(compared, 50);
}

// Poses near a derivative, by Taylor's series: a grounded link keeps its length to the order that it prescribes.
TEST(DyadWith, KeepsItsLengthAlongMixedPositions) {
  std::mt19937_64 random(4);
  for (int trial = 0; trial < 20; ++trial)
    for (const std::vector<int>& pattern : {std::vector<int>{2, 1}, {1, 2}, {3}}) {
      const Given task(testing::random_poses(random, pattern));
      for (const PivotKind kind : {PivotKind::ground, PivotKind::moving}) {
        const Dyad dyad = task.with(kind, drawn_point(random));
        const Point center = task.user(dyad.center), circle = task.user(dyad.circle);
        if (std::abs(center) + std::abs(circle) > 100) continue;
        EXPECT_LT(testing::drift_along(task.poses, center, circle), 1e-6);
      }
    }
}

TEST(DyadWith, HasNoneAtAPole) {
  std::mt19937_64 random(6);
  const auto poses = testing::random_poses(random, 3);
  const Given task(poses);
  const Point turn = direction(poses[1].pose.angle - poses[0].pose.angle);
  const Point pole = (poses[1].pose.origin - turn * poses[0].pose.origin) / (1.0 - turn);
  const Homogeneous working = Homogeneous::of(task.conditions.frame.to_working(pole));
  EXPECT_FALSE(task.dyads->dyad_with(PivotKind::ground, working));
  EXPECT_FALSE(task.dyads->dyad_with(PivotKind::moving, working));  // in position 1 it is the pole of 1 and 2, too
}

TEST(GivenPivotsFamily, IsOneLinkage) {
  std::mt19937_64 random(8);
  const Given task(testing::random_poses(random, 3));
  const DyadPair links{task.with(PivotKind::ground, {1, 2}), task.with(PivotKind::moving, {-1, 0.5})};
  const GivenPivotsFamily family(task.conditions.frame, task.poses, links);
  RegionMap map;
  const auto input = family.samples(Side::input, 400, Spacing::coordinate),
             output = family.samples(Side::output, 400, Spacing::coordinate);
  ASSERT_EQ(input.size(), 1u);
  ASSERT_EQ(output.size(), 1u);
  family.classify(map, input, output, true);
  const FourBar bars = four_bar_of(*family.dyad_pair({input[0], output[0]})).value();
  EXPECT_EQ(map.type(0), linkage_type(bars.lengths()));
  EXPECT_LT(std::abs(task.conditions.frame.to_user(bars.input_fixed) - Point{1, 2}), 1e-12);
  EXPECT_LT(std::abs(task.conditions.frame.to_user(bars.output_moving) - Point{-1, 0.5}), 1e-12);
}

// Each cell is what the verdict on its one linkage says, and turns its driver as that does.
TEST(PivotPlaceFamily, JudgesEachCellAsTheLinkageThere) {
  std::mt19937_64 random(10);
  int whole = 0, free = 0;
  for (const Side given : {Side::input, Side::output})
    for (const PivotKind kind : {PivotKind::ground, PivotKind::moving})
      for (int trial = 0; trial < 3; ++trial) {
        const Given task(testing::random_poses(random, 3));
        const PivotPlaceFamily family(task.conditions.frame, task.poses, task.dyads, given,
                                      task.with(kind, drawn_point(random)), kind);
        const auto rows = family.samples(Side::input, 21, Spacing::coordinate),
                   columns = family.samples(Side::output, 17, Spacing::coordinate);
        RegionMap map;
        family.classify(map, rows, columns, true);
        for (std::size_t i = 0; i < rows.size(); ++i)
          for (std::size_t k = 0; k < columns.size(); ++k) {
            const std::size_t cell = map.index(i, k);
            const auto links = family.dyad_pair({rows[i], columns[k]});
            const auto bars = links ? four_bar_of(*links) : std::nullopt;
            if (!bars) {
              EXPECT_EQ(map.type(cell), LinkageType::degenerate);
              continue;
            }
            const DefectReport report = find_defects(*bars, family.working_poses({rows[i], columns[k]}, *bars), true);
            EXPECT_EQ(map.type(cell), report.type);
            EXPECT_EQ(map.defects(cell), report.defects);
            ++whole;
            if (!report.defects.none() || report.type == LinkageType::degenerate) continue;
            ++free;
            EXPECT_EQ(map.drive_sense(i, k), report.sense);
            EXPECT_NEAR(map.driver_sweep(i, k), report.sweep, 1e-5);
            EXPECT_NEAR(map.min_transmission_angle(cell), report.min_transmission_angle, 1e-4);
            const Point sought = kind == PivotKind::ground
                                     ? (given == Side::input ? bars->output_fixed : bars->input_fixed)
                                     : (given == Side::input ? bars->output_moving : bars->input_moving);
            const Point there = task.conditions.frame.to_user(sought);
            EXPECT_NEAR(family.axis_value(Side::output, columns[k]), there.real(), 1e-9 * (1 + std::abs(there)));
            EXPECT_NEAR(family.axis_value(Side::input, rows[i]), there.imag(), 1e-9 * (1 + std::abs(there)));
          }
      }
  EXPECT_GT(whole, 4000);
  EXPECT_GT(free, 100);
}

TEST(PivotsOnLineFamily, HasItsPivotsOnTheLineAtTheirPlaces) {
  std::mt19937_64 random(12);
  for (const PivotKind kind : {PivotKind::ground, PivotKind::moving})
    for (int trial = 0; trial < 5; ++trial) {
      const Given task(testing::random_poses(random, 3));
      const DirectedLine line{drawn_point(random), direction(uniform(random, -pi, pi))};
      const PivotsOnLineFamily family(task.conditions.frame, task.poses, task.dyads, kind, line);
      int found = 0;
      for (const double tau : family.samples(Side::input, 50, Spacing::coordinate)) {
        const auto dyad = family.dyad(Side::input, tau);
        if (!dyad || is_at_infinity(dyad->center) || is_at_infinity(dyad->circle)) continue;
        const Point center = task.user(dyad->center), circle = task.user(dyad->circle);
        const Point on_line = line.to_line(kind == PivotKind::ground ? center : circle);
        EXPECT_NEAR(on_line.imag(), 0, 1e-9 * (1 + std::abs(on_line)));
        EXPECT_NEAR(on_line.real(), family.axis_value(Side::input, tau), 1e-9 * (1 + std::abs(on_line)));
        EXPECT_LT(testing::length_change(task.poses, center, circle), 1e-9);
        ++found;
      }
      EXPECT_GT(found, 45);
      EXPECT_TRUE(family.is_symmetric());
    }
}

// In round numbers two dyads may be one: rounding is not to part them, nor to lose them both.
TEST(DyadsOnLines, ThatAreOneAreToldOnce) {
  const std::vector<PrescribedPose> poses = {{{{10, 20}, pi}, {}}, {{{0, 10}, 0}, {}}, {{{-10, 20}, 0}, {}}};
  const Given task(poses);
  const WorkingFrame& frame = task.conditions.frame;
  const auto found = task.dyads->dyads_on_lines({frame.to_working(Point{-10, 20}), direction(radians(135))},
                                                {frame.to_working(Point{0, 20}), direction(0)});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->size(), 1u);
}

TEST(DyadsOnLines, DoNotDependOnWhereTheLinesPointsLie) {
  std::mt19937_64 random(15);
  for (int trial = 0; trial < 40; ++trial) {
    const Given task(testing::random_poses(random, 3));
    const DirectedLine ground{drawn_point(random), direction(uniform(random, -pi, pi))},
        moving{drawn_point(random), direction(uniform(random, -pi, pi))};
    const auto along = [](const DirectedLine& line, double by) {
      return DirectedLine{line.to_fixed(by), line.direction};
    };
    const auto near = task.dyads->dyads_on_lines(ground, moving),
               far = task.dyads->dyads_on_lines(along(ground, 1e6), along(moving, -1e6));
    ASSERT_TRUE(near && far);
    ASSERT_EQ(near->size(), far->size());
    for (std::size_t i = 0; i < near->size(); ++i) EXPECT_LT(norm(cross((*near)[i].center, (*far)[i].center)), 1e-6);
  }
}

// Both unknowns at once: places along both lines, from a grid of starts.
TEST(DyadsOnLines, AreThoseThatNewtonsMethodFinds) {
  std::mt19937_64 random(14);
  std::array<int, 3> of_count{};
  for (int trial = 0; trial < 40; ++trial) {
    const Given task(testing::random_poses(random, 3));
    const DirectedLine ground{drawn_point(random), direction(uniform(random, -pi, pi))},
        moving{drawn_point(random), direction(uniform(random, -pi, pi))};
    const WorkingFrame& frame = task.conditions.frame;
    const auto working = [&](const DirectedLine& line) {
      return DirectedLine{frame.to_working(line.point), line.direction};
    };
    const auto found = task.dyads->dyads_on_lines(working(ground), working(moving));
    ASSERT_TRUE(found);
    ASSERT_LE(found->size(), 2u);
    ++of_count[found->size()];
    for (const Dyad& dyad : *found) {
      const Point center = task.user(dyad.center), circle = task.user(dyad.circle);
      EXPECT_NEAR(ground.to_line(center).imag(), 0, 1e-9 * (1 + std::abs(center)));
      EXPECT_NEAR(moving.to_line(circle).imag(), 0, 1e-9 * (1 + std::abs(circle)));
      EXPECT_LT(testing::length_change(task.poses, center, circle), 1e-8);
    }
    for (int start = 0; start < 25; ++start) {
      const auto places = testing::newton(
          [&](Point at) {
            return testing::length_changes(task.poses, ground.to_fixed(at.real()), moving.to_fixed(at.imag()));
          },
          drawn_point(random, 6));
      if (!places || std::abs(*places) > 1e3) continue;
      double nearest = 1;
      for (const Dyad& dyad : *found)
        nearest = std::min(nearest, std::abs(task.user(dyad.center) - ground.to_fixed(places->real())) +
                                        std::abs(task.user(dyad.circle) - moving.to_fixed(places->imag())));
      EXPECT_LT(nearest, 1e-6 * (1 + std::abs(*places)));
    }
  }
  EXPECT_GT(of_count[0], 0);
  EXPECT_GT(of_count[2], 10);
}

}  // namespace
}  // namespace linkwright::given_pivot_family_test
