#include "linkwright/core/tolerance.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace linkwright::tolerance_test {
namespace {

constexpr double rounding = std::numeric_limits<double>::epsilon();

TEST(Tolerance, IsAbovePlainRounding) {
  for (const double t : {tolerance::infinity, tolerance::change_point, tolerance::dead_point, tolerance::dependent_rows,
                         tolerance::vanishing_coefficient, tolerance::node, tolerance::pure_translation,
                         tolerance::line_of_partners, tolerance::repeated_pose, tolerance::same_linkage}) {
    EXPECT_GE(t, 10 * rounding);
    EXPECT_LT(t, 1e-3);
  }
}

// A diagonal δ · perimeter short of h + b leaves sin² μ = 2 (h + b) δ perimeter / (h b) ≥ 16 δ: a configuration that
// was not taken for a dead point has rates.
TEST(Tolerance, OfADeadPointsSineLiesBelowWhatIsNotADeadPoint) {
  EXPECT_LT(tolerance::dead_point_sine, std::sqrt(16 * tolerance::dead_point));
}

// Flat triangles by rounding belong to change points; linkages that are not change points are not snapped flat.
TEST(Tolerance, OfADeadPointLiesFarBelowThatOfAChangePoint) {
  EXPECT_LE(1e3 * tolerance::dead_point, tolerance::change_point);
}

// An excess of the size of the change point's tolerance leaves strands √tolerance apart: they can be told apart.
TEST(Tolerance, OfCrossingStrandsLetsThroughAllButChangePoints) {
  EXPECT_LT(tolerance::crossing_strands, 0.1 * std::sqrt(tolerance::change_point));
}

// Poses that count as two must give rows that count as independent (condition ~ distance⁻¹ for neighbours).
TEST(Tolerance, OfRepeatedPosesIsAboveThatOfDependentRows) {
  EXPECT_GE(tolerance::repeated_pose, tolerance::dependent_rows);
}

TEST(Tolerance, OfConditionLeavesSevenDigits) { EXPECT_LE(tolerance::ill_conditioned * rounding, 1e-6); }

}  // namespace
}  // namespace linkwright::tolerance_test
