#include "linkwright/spherical/relaxed_orientation.hpp"

#include <gtest/gtest.h>
#include <random>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/spherical_position.hpp"
#include "support/attitude_case.hpp"
#include "support/spherical_case.hpp"

namespace linkwright::relaxed_orientation_test {
namespace {

SphericalFourBar random_bars(std::mt19937_64& random) { return testing::random_spherical_four_bar(random); }

TEST(OrientationError, VanishesOnTheWay) {
  std::mt19937_64 random(1);
  int on_the_way = 0;
  for (int i = 0; i < 100; ++i) {
    const SphericalFourBar bars = random_bars(random);
    const auto there = assemble(bars.angles(), configuration_of(bars).input_angle + 0.1, assembly_of(bars));
    if (!there) continue;
    ++on_the_way;
    const UnitQuaternion first = testing::random_rotation(random);
    const auto error = orientation_error(bars, first, coupler_turn(bars, placed(bars, *there)) * first);
    ASSERT_TRUE(error);
    EXPECT_LT(error->angle, 1e-6);
  }
  EXPECT_GT(on_the_way, 50);
}

// By looking along the whole drive.
TEST(OrientationError, IsTheLeastNearby) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 30; ++i) {
    const SphericalFourBar bars = random_bars(random);
    const UnitQuaternion wanted = UnitQuaternion::about(testing::random_direction(random), 0.05);
    const auto error = orientation_error(bars, {}, wanted);
    if (!error) continue;
    double least = pi;
    for (double input = error->input - 0.2; input <= error->input + 0.2; input += 1e-3)
      if (const auto there = assemble(bars.angles(), input, assembly_of(bars)))
        least = std::min(least, angle_between(coupler_turn(bars, placed(bars, *there)), wanted));
    EXPECT_LE(error->angle, least + 1e-4);
  }
}

// A linkage through four orientations, and a fifth a little off its way.
TEST(RelaxedOrientation, FindsTheLinkageThatNearlyDoesIt) {
  std::mt19937_64 random(3);
  SphericalMotionTask task{testing::spherical_case("folding-wing-4").orientations, {}};
  const SphericalTaskFamily given = task_family(task);
  constexpr bool verify = true;
  std::optional<SphericalSolution> good;
  for (double a = 0.02; a < 1 && !good; a += 0.03)
    for (double b = 0.01; b < 1 && !good; b += 0.03) {
      auto made = make_spherical_four_bar(given, {a, b}, true, verify);
      if (made && made->report.min_transmission_angle > radians(35)) good = std::move(made);
    }
  ASSERT_TRUE(good);
  const auto there = assemble(good->angles,
                              configuration_of(good->four_bar).input_angle +
                                  (good->report.sense == DriveSense::cw ? -1.05 : 1.05) * good->report.sweep,
                              assembly_of(good->four_bar));
  if (!there) GTEST_SKIP() << "its range ends there";
  const UnitQuaternion on_the_way =
      coupler_turn(good->four_bar, placed(good->four_bar, *there)) * task.orientations.front().orientation;
  task.orientations.push_back({UnitQuaternion::about({0.6, 0, 0.8}, radians(1)) * on_the_way, {}});
  const auto found = drop_one_orientation(task, {});
  ASSERT_EQ(found.size(), 5u);
  ASSERT_TRUE(found.front().linkage);
  EXPECT_LT(found.front().error.angle, radians(1) + 1e-6);
  for (std::size_t i = 1; i < found.size(); ++i)
    EXPECT_TRUE(!found[i].linkage || found[i].error.angle >= found[i - 1].error.angle);
}

}  // namespace
}  // namespace linkwright::relaxed_orientation_test
