#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/defects.hpp"
#include "linkwright/mechanism/spherical_defects.hpp"
#include "planar/function_linkage.hpp"
#include "spherical/spherical_function_family.hpp"
#include "spherical/spherical_function_linkage.hpp"
#include "support/random_function.hpp"

namespace linkwright::function_limit_law_test {
namespace {

constexpr double ground_angle = 5e-3;  // what it takes for one: a plane of that scale

// Where an axis meets the tangent plane at the input's fixed axis, in units of the ground link.
Point in_plane(Vector3 axis) { return Point{axis.x / axis.z, axis.y / axis.z} / std::tan(ground_angle); }

LinkageType spherical_class(LinkageType planar) {
  switch (planar) {
    case LinkageType::triple_rocker_ground:
    case LinkageType::triple_rocker_input:
    case LinkageType::triple_rocker_coupler:
    case LinkageType::triple_rocker_output:
      return LinkageType::triple_rocker;
    default:
      return planar;
  }
}

// Between fixed axes that nearly coincide, the linkages that lie near them are planar ones: they generate the same.
TEST(FunctionLimit, BetweenAxesCloseTogetherGeneratorsArePlanarOnes) {
  std::mt19937_64 random(3);
  int compared = 0, types = 0;
  for (int i = 0; i < 60; ++i) {
    SphericalFunctionTask task;
    task.pairs = testing::gentle_pairs(random, 4);
    task.ground_angle = ground_angle;
    const SphericalTaskFamily given = task_family(task);
    if (!given.family) continue;
    for (const double tau : given.family->samples(Side::input, 600, Spacing::coordinate)) {
      const auto links = given.family->dyad_pair({tau, 0.5});
      const Point a = in_plane(links->input.moving_axis), b = in_plane(links->output.moving_axis);
      const FourBar planar{0, a, 1, b};
      const LinkLengths l = planar.lengths();
      if (!(l.longest() < 8 && l.shortest() > 0.1)) continue;
      const SphericalFourBar bars = given.family->four_bar(*links);
      EXPECT_LT(coupler_residual(planar, task.pairs), 0.02) << tau;
      ++compared;
      const double together = l.ground + l.input + l.coupler + l.output;
      const SphericalExcesses t = spherical_excesses(bars.angles());
      if (std::min({std::abs(t.t1), std::abs(t.t2), std::abs(t.t3)}) < 0.02 * together * ground_angle) continue;
      EXPECT_EQ(linkage_type(bars.angles()), spherical_class(linkage_type(l))) << tau;
      ++types;
      const GeneratedFunction here = generated_function(bars, task.pairs[0]),
                              there = generated_function(planar, task.pairs[0]);
      const double input = 0.5 * (task.pairs[0].input + task.pairs[1].input);
      const auto one = here.output_at(input, 0), other = there.output_at(input, 0);
      if (one && other && std::abs(there.reach().to - there.reach().from) > 0.5) {
        EXPECT_NEAR(wrap_signed(*one - *other), 0, 0.05) << tau;
      }
    }
  }
  EXPECT_GT(compared, 100);
  EXPECT_GT(types, 100);
}

}  // namespace
}  // namespace linkwright::function_limit_law_test
