#include "linkwright/spherical/spherical_map.hpp"

#include <atomic>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/spherical_defects.hpp"
#include "linkwright/spherical/axis_curve.hpp"
#include "linkwright/spherical/spherical_family.hpp"
#include "support/spherical_case.hpp"

namespace linkwright::spherical_map_test {
namespace {

using Orientations = std::vector<PrescribedOrientation>;

SphericalAxis axis_over(const Orientations& orientations, int count) {
  const AxisCurve curve(orientation_conditions(orientations));
  std::vector<SphericalDyad> dyads;
  for (const double at : curve.samples(count, Spacing::coordinate)) dyads.push_back(curve.dyad(at));
  return SphericalAxis(std::move(dyads), orientations);
}

RegionMap map_of(const SphericalAxis& axis, const RegionOptions& options = {}) {
  RegionMap map;
  classify_pairs(map, axis, axis, options);
  return map;
}

TEST(SphericalMap, CellsAreTheVerdictsOfTheirLinkages) {
  std::mt19937_64 random(1);
  for (int task = 0; task < 6; ++task) {
    const Orientations orientations = testing::random_sweep(random, 4);
    const SphericalAxis axis = axis_over(orientations, 61);
    const RegionMap map = map_of(axis);
    const auto versines = map.values(measures::min_transmission_angle);
    const auto least = map.values(measures::min_link_angle), largest = map.values(measures::max_link_angle);
    for (std::size_t row = 0; row < map.rows(); ++row)
      for (std::size_t column = 0; column < map.columns(); ++column) {
        const std::size_t cell = map.index(row, column);
        const SphericalDyad &a = axis.dyads[row], &b = axis.dyads[column];
        const SphericalFourBar bars{a.fixed_axis, a.moving_axis, b.moving_axis, b.fixed_axis};
        const DefectReport report = find_defects(bars, orientations);
        ASSERT_EQ(map.type(cell), report.type) << row << " " << column;
        ASSERT_EQ(map.defects(cell), report.defects);
        if (report.type == LinkageType::degenerate) continue;
        EXPECT_NEAR(versines[cell], versine_of_angle(report.min_transmission_angle), 2e-6);
        EXPECT_NEAR(map.driver_sweep(row, column), report.sweep, 1e-5);
        double shortest = pi, longest = 0;
        for (const double arc : bars.angles().all()) {
          shortest = std::min({shortest, arc, pi - arc});
          longest = std::max(longest, std::min(arc, pi - arc));
        }
        EXPECT_NEAR(angle_of_versine(static_cast<double>(least[cell])), shortest, 1e-5);
        EXPECT_NEAR(angle_of_versine(static_cast<double>(largest[cell])), longest, 1e-3);
      }
  }
}

TEST(SphericalMap, TheSameBitsOnAllMachines) {
  std::mt19937_64 random(2);
  for (const int count : {1, 7, 64, 131}) {
    const SphericalAxis axis = axis_over(testing::random_sweep(random, 4), count);
    const RegionMap scalar = map_of(axis, {.threads = 1, .simd = Simd::scalar});
    for (const Simd simd : {Simd::baseline, Simd::avx2, Simd::avx512}) {
      if (!is_supported(simd)) continue;
      const RegionMap packed = map_of(axis, {.threads = 1, .simd = simd});
      EXPECT_TRUE(std::ranges::equal(packed.types(), scalar.types()));
      EXPECT_TRUE(std::ranges::equal(packed.defects(), scalar.defects()));
      for (const Measure& measure : spherical_measures)
        EXPECT_TRUE(std::ranges::equal(packed.values(measure), scalar.values(measure))) << measure.key;
    }
  }
}

// The other driver: its mirror image does the same task with both sides changed about.
TEST(SphericalMap, TheOtherDriverIsTheMirror) {
  std::mt19937_64 random(3);
  const Orientations orientations = testing::random_sweep(random, 4);
  const SphericalAxis axis = axis_over(orientations, 41);
  const RegionMap map = map_of(axis);
  Orientations mirrored;  // in the plane z = 0, which turns rotations about z the other way
  const auto mirror = [](Vector3 v) { return Vector3{v.x, v.y, -v.z}; };
  for (const auto& there : orientations) {
    const Vector3 v = there.orientation.v();
    mirrored.push_back({*UnitQuaternion::of(there.orientation.w(), {-v.x, -v.y, v.z}), {}});
  }
  for (std::size_t row = 0; row < map.rows(); ++row)
    for (std::size_t column = 0; column < map.columns(); ++column) {
      const SphericalDyad &a = axis.dyads[row], &b = axis.dyads[column];
      const SphericalFourBar other{mirror(b.fixed_axis), mirror(b.moving_axis), mirror(a.moving_axis),
                                   mirror(a.fixed_axis)};
      const DefectReport there = find_defects(other, mirrored);
      const std::size_t cell = map.index(column, row);
      EXPECT_EQ(there.type, map.type(cell));
      EXPECT_EQ(there.defects, map.defects(cell));
    }
}

TEST(SphericalMap, DiagonalIsDegenerateAndNotCounted) {
  std::mt19937_64 random(4);
  const RegionMap map = map_of(axis_over(testing::random_sweep(random, 4), 50));
  for (std::size_t i = 0; i < map.rows(); ++i) {
    EXPECT_TRUE(map.is_diagonal(i, i));
    EXPECT_EQ(map.type(map.index(i, i)), LinkageType::degenerate);
  }
  EXPECT_EQ(map.counts().pairs, 50 * 49);
}

TEST(SphericalMap, CancelledRowsAreEmpty) {
  std::mt19937_64 random(5);
  const SphericalAxis axis = axis_over(testing::random_sweep(random, 4), 50);
  RegionMap map;
  const std::atomic<bool> cancelled = true;
  classify_pairs(map, axis, axis, {}, Progress{{}, &cancelled});
  EXPECT_EQ(map.counts().types[static_cast<std::size_t>(LinkageType::degenerate)], 50 * 49);
}

}  // namespace
}  // namespace linkwright::spherical_map_test
