#pragma once

#include <gtest/gtest.h>
#include <utility>

#include "linkwright/synthesis/solve.hpp"

namespace linkwright::testing {

/// The answer that a task without mistakes has.
template <class KindAnswer, class KindTask>
KindAnswer solved_as(const KindTask& task, const Requirements& wanted, const SynthesisOptions& options) {
  auto answer = solve({task, wanted, options});
  EXPECT_TRUE(answer.ok());
  return std::get<KindAnswer>(std::move(answer).value());
}
inline MotionAnswer solved(const MotionTask& task, const Requirements& wanted = {},
                           const SynthesisOptions& options = {}) {
  return solved_as<MotionAnswer>(task, wanted, options);
}
inline FunctionAnswer solved(const FunctionTask& task, const Requirements& wanted = {},
                             const SynthesisOptions& options = {}) {
  return solved_as<FunctionAnswer>(task, wanted, options);
}
inline SphericalMotionAnswer solved(const SphericalMotionTask& task, const Requirements& wanted = {},
                                    const SynthesisOptions& options = {}) {
  return solved_as<SphericalMotionAnswer>(task, wanted, options);
}
inline SphericalFunctionAnswer solved(const SphericalFunctionTask& task, const Requirements& wanted = {},
                                      const SynthesisOptions& options = {}) {
  return solved_as<SphericalFunctionAnswer>(task, wanted, options);
}

}  // namespace linkwright::testing
