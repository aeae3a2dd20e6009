#include "linkwright/synthesis/task.hpp"

#include <gtest/gtest.h>

#include "support/tailgate.hpp"

namespace linkwright::task_test {
namespace {

TEST(Task, MistakesAreThoseOfItsKind) {
  EXPECT_TRUE(mistakes_in(Task{testing::tailgate_task()}).empty());
  const MotionTask motion;
  const FunctionTask function;
  const SixBarTask six_bar;
  const SphericalFunctionTask spherical_function;
  EXPECT_EQ(mistakes_in(Task{spherical_function}).size(), mistakes_in(spherical_function).size());
  EXPECT_EQ(mistakes_in(Task{motion}).size(), mistakes_in(motion).size());
  EXPECT_EQ(mistakes_in(Task{function}).size(), mistakes_in(function).size());
  EXPECT_EQ(mistakes_in(Task{six_bar}).size(), mistakes_in(six_bar).size());
  EXPECT_FALSE(mistakes_in(Task{six_bar}).empty());
}

TEST(Task, TellsTheFunctionThatItAsksFor) {
  const Task planar = FunctionTask{}, spherical = SphericalFunctionTask{}, motion = MotionTask{};
  EXPECT_EQ(wanted_function(planar), &std::get<FunctionTask>(planar));
  EXPECT_EQ(wanted_function(spherical), &std::get<SphericalFunctionTask>(spherical));
  EXPECT_EQ(wanted_function(motion), nullptr);
}

}  // namespace
}  // namespace linkwright::task_test
