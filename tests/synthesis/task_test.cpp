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
  EXPECT_EQ(mistakes_in(Task{motion}).size(), mistakes_in(motion).size());
  EXPECT_EQ(mistakes_in(Task{function}).size(), mistakes_in(function).size());
  EXPECT_EQ(mistakes_in(Task{six_bar}).size(), mistakes_in(six_bar).size());
  EXPECT_FALSE(mistakes_in(Task{six_bar}).empty());
}

}  // namespace
}  // namespace linkwright::task_test
