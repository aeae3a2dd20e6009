#include "linkwright/spherical/spherical_motion_task.hpp"

#include <gtest/gtest.h>
#include <limits>

namespace linkwright::spherical_motion_task_test {
namespace {

SphericalMotionTask task_of(std::size_t count) {
  SphericalMotionTask task;
  for (std::size_t i = 0; i < count; ++i)
    task.orientations.push_back({UnitQuaternion::about({0, 0, 1}, 0.2 * static_cast<double>(i)), {}});
  return task;
}

std::vector<std::string> codes(const SphericalMotionTask& task) {
  std::vector<std::string> found;
  for (const Error& error : mistakes_in(task)) found.push_back(error.code + " " + error.place);
  return found;
}

TEST(SphericalMotionTask, FourAndFivePositionsAreTaken) {
  EXPECT_TRUE(codes(task_of(4)).empty());
  EXPECT_TRUE(codes(task_of(5)).empty());
  SphericalMotionTask mixed = task_of(3);
  mixed.orientations[1].derivatives = {{0, 0, 1}};
  EXPECT_TRUE(codes(mixed).empty());
  SphericalMotionTask instant = task_of(1);
  instant.orientations[0].derivatives = {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {0, 0, 0}};
  EXPECT_TRUE(codes(instant).empty());
}

TEST(SphericalMotionTask, OtherNumbersAreRefused) {
  EXPECT_EQ(codes(task_of(0)), (std::vector<std::string>{"too_few_orientations task.orientations"}));
  EXPECT_EQ(codes(task_of(3)), (std::vector<std::string>{"too_few_orientations task.orientations"}));
  EXPECT_EQ(codes(task_of(6)), (std::vector<std::string>{"too_many_orientations task.orientations"}));
}

TEST(SphericalMotionTask, ThreeGoWithGivenAxes) {
  SphericalMotionTask task = task_of(3);
  task.given = GivenAxes{GivenAxes::Kind::moving, {{{1, 0, 0}, {0, 2, 0}}}};
  EXPECT_TRUE(codes(task).empty());
  task.given->axes[1] = {-3, 0, 0};
  EXPECT_EQ(codes(task), (std::vector<std::string>{"same_axes task.given.moving_axes"}));
  task.given->axes[1] = {};
  EXPECT_EQ(codes(task), (std::vector<std::string>{"no_axis task.given.moving_axes[1]"}));
  SphericalMotionTask four = task_of(4);
  four.given = GivenAxes{GivenAxes::Kind::fixed, {{{1, 0, 0}, {0, 2, 0}}}};
  EXPECT_EQ(codes(four), (std::vector<std::string>{"unneeded_axes task.given"}));
  SphericalMotionTask two = task_of(2);
  two.orientations[0].derivatives = {{0, 0, 1}};
  two.given = four.given;
  EXPECT_EQ(codes(two), (std::vector<std::string>{"derivatives_with_axes task.orientations"}));
}

TEST(SphericalMotionTask, RatesAreNumbersAndNotZero) {
  SphericalMotionTask task = task_of(3);
  task.orientations[2].derivatives = {{0, 0, 0}};
  EXPECT_EQ(codes(task), (std::vector<std::string>{"zero_angular_velocity task.orientations[2].angular_velocity"}));
  task.orientations[2].derivatives = {{0, std::numeric_limits<double>::quiet_NaN(), 1}};
  EXPECT_EQ(codes(task), (std::vector<std::string>{"rate_range task.orientations[2].angular_velocity"}));
}

}  // namespace
}  // namespace linkwright::spherical_motion_task_test
