#pragma once

#include <gtest/gtest.h>
#include <utility>

#include "linkwright/synthesis/solve.hpp"

namespace linkwright::testing {

/// The answer to a task without mistakes.
inline MotionAnswer solved(const MotionTask& task, const Requirements& wanted = {},
                           const SynthesisOptions& options = {}) {
  auto answer = solve(task, wanted, options);
  EXPECT_TRUE(answer.ok());
  return std::get<MotionAnswer>(std::move(answer).value());
}
inline FunctionAnswer solved(const FunctionTask& task, const Requirements& wanted = {},
                             const SynthesisOptions& options = {}) {
  auto answer = solve(task, wanted, options);
  EXPECT_TRUE(answer.ok());
  return std::get<FunctionAnswer>(std::move(answer).value());
}

}  // namespace linkwright::testing
