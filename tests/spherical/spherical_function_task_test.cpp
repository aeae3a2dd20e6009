#include "linkwright/spherical/spherical_function_task.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "linkwright/core/angle.hpp"

namespace linkwright::spherical_function_task_test {
namespace {

SphericalFunctionTask four_pairs() {
  SphericalFunctionTask task;
  task.pairs = {{0, 0, {}}, {0.3, 0.2, {}}, {0.7, 0.8, {}}, {1.1, 1.3, {}}};
  task.ground_angle = radians(60);
  return task;
}

std::string codes(const SphericalFunctionTask& task) {
  std::string text;
  for (const Error& e : mistakes_in(task)) text += (text.empty() ? "" : " ") + e.code + "@" + e.place.substr(5);
  return text;
}

TEST(SphericalFunctionTask, FixedAxesAreTwo) {
  SphericalFunctionTask task = four_pairs();
  EXPECT_EQ(codes(task), "");
  for (const double wrong : {0.0, pi, -1.0, 4.0, std::numeric_limits<double>::quiet_NaN()}) {
    task.ground_angle = wrong;
    EXPECT_EQ(codes(task), "ground_angle_range@ground_angle_deg") << wrong;
  }
}

TEST(SphericalFunctionTask, TheMistakesOfTheFunctionAreItsOwn) {
  SphericalFunctionTask task = four_pairs();
  task.pairs[2].input = task.pairs[0].input + two_pi;
  EXPECT_EQ(codes(task), "repeated_input@pairs[2].input_deg");
}

TEST(SphericalFunctionTask, KeepsItsAxesWhenItsParameterIsFixed) {
  SphericalFunctionTask task = four_pairs();
  task.free = FreeParameter{FreeParameter::Kind::output_scale, {0.5, 2}};
  const SphericalFunctionTask fixed = task_at(task, 2);
  EXPECT_NEAR(fixed.pairs[3].output, 2.6, 1e-15);
  EXPECT_EQ(fixed.ground_angle, task.ground_angle);
  EXPECT_FALSE(fixed.free);
}

TEST(SphericalFunctionTask, TheFixedAxesLieAtTheirAngle) {
  for (const double angle : {0.1, 1.0, 3.0}) {
    const auto [input, output] = fixed_axes(angle);
    EXPECT_EQ(input, (Vector3{0, 0, 1}));
    EXPECT_NEAR(angle_between(input, output), angle, 1e-15);
  }
}

}  // namespace
}  // namespace linkwright::spherical_function_task_test
