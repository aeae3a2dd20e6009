#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "function_conditions.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/planar/burmester_curve.hpp"
#include "linkwright/planar/function_task.hpp"

namespace linkwright {

/// All couplers that meet a task's pairs: dyads with circle point A on the input link and centre point B on the output
/// link, working frame of the conditions. Four positions leave a curve of them, five one or three (fewer where
/// solutions fall on the ground link).
struct FunctionCouplers {
  FunctionConditions given;
  std::shared_ptr<const BurmesterCurve> curve;  ///< four positions; five whose conditions depend on each other
  std::vector<Dyad> points;                     ///< five positions, without the ground link; coordinate = index + ½
  std::vector<Notice> warnings;                 ///< ill_conditioned {condition}, double_point, dependent_rows
  std::optional<Notice> degeneracy;             ///< why there are neither: parallelogram, every_point

  [[nodiscard]] const WorkingFrame& frame() const { return given.conditions.frame; }

  /// The coupler at τ: on the curve, or of the point that fills [index, index + 1). Nothing elsewhere.
  [[nodiscard]] std::optional<Dyad> coupler(double tau) const;

  /// τ of the ground link on the curve, where linkages shrink to nothing; nothing without a curve.
  [[nodiscard]] std::optional<double> ground_coordinate() const;
};

/// `task` without mistakes; a free parameter in it plays no part.
[[nodiscard]] FunctionCouplers function_couplers(const FunctionTask& task);

/// The four-bar on the task's ground pivots with a coupler, at the first pair, user's frame. Nothing where a moving
/// pivot is at infinity.
[[nodiscard]] std::optional<FourBar> function_four_bar(const FunctionTask& task, const WorkingFrame& frame,
                                                       const Dyad& coupler);

}  // namespace linkwright
