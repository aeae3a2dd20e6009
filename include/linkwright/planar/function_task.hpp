#pragma once

#include <vector>

#include "linkwright/algebra/point.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/function/wanted_function.hpp"
#include "linkwright/mechanism/linkage_output.hpp"
#include "linkwright/region/linkage_class.hpp"

namespace linkwright {

/// Function generation by a planar four-bar on two given ground pivots.
struct FunctionTask : WantedFunction {
  static constexpr const LinkageClass& linkages = unloaded_linkages;
  static constexpr OutputKind output = OutputKind::angle;

  Point input_pivot = 0, output_pivot = 1;  ///< fixed frame, user's unit

  friend bool operator==(const FunctionTask&, const FunctionTask&) = default;
};

/// The caller's mistakes: those of the function, ground pivots that are not finite or coincide
/// (`task.ground_pivots…`).
[[nodiscard]] std::vector<Error> mistakes_in(const FunctionTask& task);

/// As wanted_at().
[[nodiscard]] FunctionTask task_at(const FunctionTask& task, double value);

}  // namespace linkwright
