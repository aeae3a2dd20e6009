#include "linkwright/region/requirement_filter.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/planar/pose_conditions.hpp"
#include "support/case_region.hpp"
#include "support/planar_case.hpp"

namespace linkwright::requirement_filter_test {
namespace {

class LandingGearFilter : public ::testing::Test {
 protected:
  LandingGearFilter() {
    wanted.min_transmission_angle = radians(30);
    wanted.max_link_ratio = 5;
    wanted.max_length = 2000;
    wanted.min_length = 150;
    wanted.ground_pivots_within = Box{-2000, 2000, -2000, 2000};
  }
  [[nodiscard]] RequirementFilter filter() const {
    return {map, wanted, [this] { return testing::pivots_of(axis, axis, frame); }};
  }
  [[nodiscard]] std::int64_t meeting() const { return filter().census().meeting; }

  // Slowly and from the pivots.
  [[nodiscard]] bool meets(std::size_t row, std::size_t column) const {
    const Dyad a = axis.dyads[row], b = axis.dyads[column];
    const auto p = finite_point(a.center), q = finite_point(a.circle), r = finite_point(b.center),
               s = finite_point(b.circle);
    if (row == column || !p || !q || !r || !s) return false;
    const FourBar bars{frame.to_user(*p), frame.to_user(*q), frame.to_user(*r), frame.to_user(*s)};
    const LinkLengths lengths = bars.lengths();
    const DefectReport report = find_defects(bars, poses);
    return report.defects.none() && report.min_transmission_angle >= wanted.min_transmission_angle &&
           lengths.longest() <= wanted.max_link_ratio * lengths.shortest() && lengths.longest() <= *wanted.max_length &&
           lengths.shortest() >= *wanted.min_length && wanted.ground_pivots_within->contains(bars.input_fixed) &&
           wanted.ground_pivots_within->contains(bars.output_fixed);
  }

  std::vector<PrescribedPose> poses = testing::planar_case("landing_gear").poses;
  WorkingFrame frame = pose_conditions(poses).frame;
  DyadAxis axis = testing::axis_of(poses, 150);
  RegionMap map = testing::region_of(poses, axis);
  Requirements wanted;
};

TEST_F(LandingGearFilter, PassesExactlyTheLinkagesThatMeetEverything) {
  const RequirementFilter passing = filter();
  int differing = 0;
  for (std::size_t row = 0; row < map.rows(); ++row)
    for (std::size_t column = 0; column < map.columns(); ++column)
      differing += passing.passes(row, column) != meets(row, column);
  EXPECT_EQ(differing, 0);
  EXPECT_GT(meeting(), 100);
}

TEST_F(LandingGearFilter, JudgesAllCellsAsItJudgesOne) {
  wanted.types = {LinkageType::crank_rocker, LinkageType::triple_rocker_output};
  const RequirementFilter judging = filter();
  std::vector<FailureBits> failures(map.rows() * map.columns());
  judging.failures_of_all(failures);
  for (std::size_t row = 0; row < map.rows(); ++row)
    for (std::size_t column = 0; column < map.columns(); ++column)
      ASSERT_EQ(failures[map.index(row, column)], judging.failures(row, column));
  const RequirementCensus one = judging.census(), other = judging.census(failures);
  EXPECT_EQ(one.failing, other.failing);
  EXPECT_EQ(one.meeting_types, other.meeting_types);
  EXPECT_EQ(one.meeting, one.meeting_types[0] + one.meeting_types[7]);
}

TEST_F(LandingGearFilter, CountsWhatIsLeftAfterEachRequirement) {
  const RequirementCensus census = filter().census();
  const auto left = [&](RequirementKind kind) { return census.left_after(kind); };
  EXPECT_EQ(left(RequirementKind::types), map.counts().pairs - map.counts().types[9]);
  EXPECT_EQ(left(RequirementKind::no_defects), map.counts().defect_free);
  EXPECT_LT(left(RequirementKind::min_transmission_angle), left(RequirementKind::no_defects));
  EXPECT_EQ(left(RequirementKind::moving_pivots_within), census.meeting);
}

TEST_F(LandingGearFilter, DroppingARequirementAddsWhatTheCensusPromised) {
  const RequirementCensus census = filter().census();
  const std::int64_t before = census.meeting;
  const Requirements all = wanted;
  wanted.min_transmission_angle = 0;
  EXPECT_EQ(meeting() - before, census.failing_only(RequirementKind::min_transmission_angle));
  wanted = all;
  wanted.max_link_ratio = Requirements::unlimited;
  EXPECT_EQ(meeting() - before, census.failing_only(RequirementKind::max_link_ratio));
  wanted = all;
  wanted.max_length = Requirements::unlimited;
  EXPECT_EQ(meeting() - before, census.failing_only(RequirementKind::max_length));
  wanted = all;
  wanted.min_length = 0;
  EXPECT_EQ(meeting() - before, census.failing_only(RequirementKind::min_length));
  EXPECT_GT(meeting(), before);
  wanted = all;
  wanted.ground_pivots_within.reset();
  EXPECT_EQ(meeting() - before, census.failing_only(RequirementKind::ground_pivots_within));
}

TEST_F(LandingGearFilter, CensusCountsEveryLinkageOnce) {
  const RequirementCensus census = filter().census();
  std::int64_t sum = 0;
  for (const auto& [set, cells] : census.failing) sum += cells;
  const RegionCounts counts = map.counts();
  EXPECT_EQ(sum, counts.pairs - counts.types[static_cast<std::size_t>(LinkageType::degenerate)]);
}

TEST_F(LandingGearFilter, StopsCountingWhenCancelled) {
  const std::atomic<bool> cancelled = true;
  Progress progress;
  progress.cancelled = &cancelled;
  EXPECT_EQ(filter().census(progress).meeting, 0);
  EXPECT_EQ(filter().relaxations(filter().census(), progress).size(), filter().relaxations(filter().census()).size());
}

// Counted over parts of the rows, in any order.
TEST_F(LandingGearFilter, TellsTheSameOnAnyNumberOfThreads) {
  const auto relaxed = [&](int threads) {
    map = testing::region_of(poses, 150, {.threads = threads});
    const RequirementFilter some = filter();
    return some.relaxations(some.census());
  };
  const auto one = relaxed(1), all = relaxed(0);
  ASSERT_EQ(one.size(), all.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].value, all[i].value);
    EXPECT_EQ(one[i].leaves, all[i].leaves);
  }
  EXPECT_FALSE(one.empty());
}

TEST_F(LandingGearFilter, TypesAreKeptOrDropped) {
  wanted.types = {LinkageType::double_rocker};
  const RequirementFilter only = filter();
  for (std::size_t row = 0; row < map.rows(); ++row)
    for (std::size_t column = 0; column < map.columns(); ++column) {
      if (!only.passes(row, column)) continue;
      EXPECT_EQ(map.type(map.index(row, column)), LinkageType::double_rocker);
    }
}

TEST_F(LandingGearFilter, RelaxedValueLeavesWhatItPromises) {
  wanted.min_transmission_angle = radians(89.9);
  const RequirementFilter strict = filter();
  const auto relaxed = strict.relaxations(strict.census());
  ASSERT_FALSE(relaxed.empty());
  EXPECT_EQ(relaxed[0].requirement, RequirementKind::min_transmission_angle);
  ASSERT_TRUE(relaxed[0].value);
  EXPECT_GT(relaxed[0].leaves, 0);
  wanted.min_transmission_angle = *relaxed[0].value;
  EXPECT_EQ(meeting(), relaxed[0].leaves);
}

TEST_F(LandingGearFilter, RelaxedLengthAndRatioLeaveWhatTheyPromise) {
  const Requirements all = wanted;
  const auto expect_promise = [&](RequirementKind kind, const auto& relax) {
    const auto found = filter().relaxations(filter().census());
    const auto relaxation = std::find_if(found.begin(), found.end(), [&](auto r) { return r.requirement == kind; });
    ASSERT_NE(relaxation, found.end());
    ASSERT_TRUE(relaxation->value);
    EXPECT_GT(relaxation->leaves, 0);
    relax(*relaxation->value);
    EXPECT_EQ(meeting(), relaxation->leaves);
  };
  wanted.max_length = 1;
  expect_promise(RequirementKind::max_length, [&](double value) { wanted.max_length = value; });
  wanted = all;
  wanted.max_link_ratio = 1.05;
  expect_promise(RequirementKind::max_link_ratio, [&](double value) { wanted.max_link_ratio = value; });
}

TEST_F(LandingGearFilter, LargerBoxLeavesWhatItPromises) {
  const auto expect_promise = [&](RequirementKind kind, std::optional<Box>& asked) {
    const Box before = *asked;
    const auto found = filter().relaxations(filter().census());
    const auto relaxation =
        std::find_if(found.begin(), found.end(), [&](const auto& r) { return r.requirement == kind; });
    ASSERT_NE(relaxation, found.end());
    ASSERT_TRUE(relaxation->box);
    EXPECT_GT(relaxation->leaves, 0);
    EXPECT_LT(relaxation->leaves, relaxation->only_this) << "no larger than it must be";
    EXPECT_TRUE(relaxation->box->x_low <= before.x_low && relaxation->box->x_high >= before.x_high &&
                relaxation->box->y_low <= before.y_low && relaxation->box->y_high >= before.y_high);
    asked = relaxation->box;
    EXPECT_EQ(meeting(), relaxation->leaves);
  };
  wanted.ground_pivots_within = Box{0, 10, 0, 10};
  ASSERT_EQ(meeting(), 0);
  expect_promise(RequirementKind::ground_pivots_within, wanted.ground_pivots_within);
  wanted.ground_pivots_within.reset();
  wanted.moving_pivots_within = Box{-10, 0, 0, 10};
  ASSERT_EQ(meeting(), 0);
  expect_promise(RequirementKind::moving_pivots_within, wanted.moving_pivots_within);
}

TEST_F(LandingGearFilter, NamesTheRequirementsThatLeaveNothingTogether) {
  EXPECT_FALSE(filter().census().joint_relaxation()) << "while something is left";
  wanted.max_length = 1;
  wanted.ground_pivots_within = Box{0, 10, 0, 10};
  const RequirementCensus census = filter().census();
  ASSERT_TRUE(filter().relaxations(census).empty());
  const auto joint = census.joint_relaxation();
  ASSERT_TRUE(joint);
  EXPECT_EQ(joint->requirements, (std::vector{RequirementKind::max_length, RequirementKind::ground_pivots_within}));
  EXPECT_EQ(joint_relaxation_text({joint->requirements, 1234}),
            "No linkage looked at fails a single requirement alone: without max_length and ground_pivots_within "
            "together 1 234 "
            "would be "
            "left.");
  wanted.max_length = Requirements::unlimited;
  wanted.ground_pivots_within.reset();
  EXPECT_EQ(meeting(), joint->leaves);
}

TEST(RequirementCensus, GivesUpFreedomFromDefectsLast) {
  using enum RequirementKind;
  RequirementCensus census;
  const std::vector kinds = {no_defects, max_length, min_transmission_angle, ground_pivots_within};
  census.kinds = kinds;
  census.failing[0b0011] = 1000;  // with a defect, and too long
  census.failing[0b1110] = 3;
  census.failing[0b1010] = 2;
  EXPECT_EQ(census.joint_relaxation()->requirements, (std::vector{max_length, ground_pivots_within}));
  EXPECT_EQ(census.joint_relaxation()->leaves, 2);
  census.failing[0b1110] = census.failing[0b1010] = 0;
  EXPECT_EQ(census.joint_relaxation()->requirements, (std::vector{no_defects, max_length}));
}

TEST_F(LandingGearFilter, RelaxedValuesHaveTwoDigits) {
  int told = 0;
  wanted.ground_pivots_within.reset();
  for (const double length : {300, 500, 700, 900, 1200, 1600, 2000, 3000}) {
    wanted.min_transmission_angle = 0;
    wanted.max_link_ratio = 1.05;
    wanted.max_length = length;
    for (const Relaxation& relaxation : filter().relaxations(filter().census()))
      if (relaxation.value) {
        EXPECT_EQ(*relaxation.value, std::stod(fmt::format("{:.2g}", *relaxation.value)));
        EXPECT_GT(relaxation.leaves, meeting());
        ++told;
      }
  }
  EXPECT_GT(told, 5);
}

TEST_F(LandingGearFilter, DegenerateCellsFailEverything) { EXPECT_EQ(filter().failures(3, 3), all_failures); }

/// Linkages of the spherical class over a grid of whole degrees: the row is the least link angle, the column the
/// largest, the fixed axes stand so many degrees off the z axis as the row says, one of them upside down.
class SphericalFilter : public ::testing::Test {
 protected:
  SphericalFilter() {
    static constexpr std::array kept = {measures::min_transmission_angle, measures::min_link_angle,
                                        measures::max_link_angle};
    std::vector<double> rows, columns;
    for (int degree = 1; degree < 90; ++degree) rows.push_back(degree);
    columns = rows;
    map.evaluate_cells(rows, columns, kept, {}, [](std::size_t row, std::size_t column) {
      const auto versine = [](std::size_t degree) {
        return static_cast<float>(versine_of_angle(radians(static_cast<double>(degree) + 1)));
      };
      const LinkageType type = column < row ? LinkageType::degenerate : LinkageType::triple_rocker;
      return MapCell{type, {}, {versine(44), versine(row), versine(column)}};
    });
  }
  [[nodiscard]] RequirementFilter filter() const {
    const auto pivots = [this] {
      return MapPivots{{}, {}, [this](std::size_t row, std::size_t column) {
                         const double angle = radians(map.input_coordinates()[row]);
                         const Vector3 axis{std::sin(angle), 0, std::cos(angle)};
                         const double other = radians(map.output_coordinates()[column]);
                         return std::optional(Pivots{{axis, -axis}, {{0, std::sin(other), std::cos(other)}}});
                       }};
    };
    return {map, wanted, pivots, spherical_linkages};
  }
  [[nodiscard]] std::int64_t meeting() const { return filter().census().meeting; }
  [[nodiscard]] const Relaxation* relaxation(RequirementKind kind) {
    relaxed = filter().relaxations(filter().census());
    const auto found = std::find_if(relaxed.begin(), relaxed.end(), [&](auto& r) { return r.requirement == kind; });
    return found == relaxed.end() ? nullptr : &*found;
  }

  RegionMap map;
  Requirements wanted;  // max_length need not be set: the class has no lengths
  std::vector<Relaxation> relaxed;
};

TEST_F(SphericalFilter, HasTheRequirementsOfItsClassInTheirOrder) {
  EXPECT_EQ(meeting(), 89 * 90 / 2);
  wanted.max_link_ratio = 1;
  EXPECT_EQ(meeting(), 89 * 90 / 2) << "no requirement of the class";
  wanted.types = {LinkageType::triple_rocker};
  EXPECT_EQ(filter().census().meeting_types[static_cast<std::size_t>(LinkageType::triple_rocker)], 89 * 90 / 2);
  wanted.types = {LinkageType::crank_rocker};
  wanted.min_link_angle = radians(10.5);
  EXPECT_EQ(filter().failures(0, 5), 0b0001001) << "types and min_link_angle";
  EXPECT_EQ(filter().failures(20, 25), 0b0000001);
  EXPECT_EQ(filter().failures(5, 0), all_failures) << "degenerate";
}

TEST_F(SphericalFilter, BoundsTheLinkAngles) {
  wanted.min_link_angle = radians(80.5);
  EXPECT_EQ(meeting(), 9 * 10 / 2);
  wanted.max_link_angle = radians(88.5);
  EXPECT_EQ(meeting(), 8 * 9 / 2);
  const RequirementCensus census = filter().census();
  EXPECT_EQ(census.left_after(RequirementKind::min_link_angle), 9 * 10 / 2);
  EXPECT_EQ(census.left_after(RequirementKind::max_link_angle), census.meeting);
  EXPECT_EQ(census.failing_only(RequirementKind::max_link_angle), 9);
  EXPECT_EQ(census.failing_only(RequirementKind::max_length), 0) << "no requirement of the class";
}

TEST_F(SphericalFilter, RelaxesALinkAngleToARoundOne) {
  wanted.types = {LinkageType::triple_rocker};
  wanted.max_link_angle = radians(2.5);
  wanted.min_link_angle = radians(2.75);
  ASSERT_EQ(meeting(), 0);
  const Relaxation* least = relaxation(RequirementKind::min_link_angle);
  ASSERT_NE(least, nullptr);
  ASSERT_TRUE(least->value);
  EXPECT_NEAR(degrees(*least->value), 2, 0.11) << "two digits, and no more than the map's singles say";
  EXPECT_GT(least->leaves, 0);
  const std::int64_t promised = least->leaves;
  wanted.min_link_angle = least->value;
  EXPECT_EQ(meeting(), promised);
}

TEST_F(SphericalFilter, KeepsAxesInACone) {
  wanted.fixed_axes_within = Cone{{0, 0, 2}, radians(30.5)};
  EXPECT_EQ(meeting(), 30 * 89 - 29 * 30 / 2) << "either sense of an axis";
  EXPECT_EQ(filter().failures(40, 50), 0b0100000);
  wanted.moving_axes_within = Cone{{0, 0, -1}, radians(10.5)};
  EXPECT_EQ(meeting(), 10 * 11 / 2);
  EXPECT_EQ(filter().failures(5, 50), 0b1000000);
}

TEST_F(SphericalFilter, WidensAConeToARoundAngleThatLeavesWhatItPromises) {
  wanted.min_link_angle = radians(33.5);
  wanted.fixed_axes_within = Cone{{0, 0, 1}, radians(20)};
  ASSERT_EQ(meeting(), 0);
  const Relaxation* wider = relaxation(RequirementKind::fixed_axes_within);
  ASSERT_NE(wider, nullptr);
  ASSERT_TRUE(wider->value);
  EXPECT_FALSE(wider->box);
  EXPECT_GE(degrees(*wider->value), 34);
  EXPECT_LE(degrees(*wider->value), 35 + 1e-9);
  EXPECT_GT(wider->leaves, 0);
  EXPECT_LT(wider->leaves, wider->only_this);
  const std::int64_t promised = wider->leaves;
  wanted.fixed_axes_within->half_angle = *wider->value + 1e-9;
  EXPECT_EQ(meeting(), promised);
}

}  // namespace
}  // namespace linkwright::requirement_filter_test
