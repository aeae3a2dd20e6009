#pragma once

#include "linkwright/region/criterion.hpp"
#include "linkwright/region/objective.hpp"
#include "linkwright/region/requirements.hpp"
#include "linkwright/straight_line/straight_path.hpp"

namespace linkwright {

/// What the path of a straight line is worth, measured or estimated: by this lines are asked for and ranked.
struct LineWorth {
  double usable = 0;                  ///< the length that counts, user's unit
  double deviation = 0;               ///< off the line over the stroke or, where none is asked for, over that length,
                                      ///< user's unit; infinite where the point does not go as far as the stroke, which
                                      ///< no requirement lets pass
  double min_transmission_angle = 0;  ///< over the same, radians; where the stroke is not reached over that length
  double velocity_nonuniformity = 0;  ///< over the same; infinite where the input turns back

  /// `over`: the length that counts.
  [[nodiscard]] static LineWorth of(const StrokeFigures& over, double deviation);
};

/// It does what one requirement asks; true of requirements that a straight line has not. `wanted` with max_length set.
[[nodiscard]] bool meets(RequirementKind kind, const TracingFourBar& linkage, const Requirements& wanted);
[[nodiscard]] bool meets(RequirementKind kind, const LineWorth& worth, const Requirements& wanted);

/// Of a type and of proportions that are asked for, whatever its size; no link without length.
[[nodiscard]] bool has_shape(const TracingFourBar& linkage, const Requirements& wanted);
/// Of a size and at a place that are asked for.
[[nodiscard]] bool has_place(const TracingFourBar& linkage, const Requirements& wanted);
[[nodiscard]] bool meets(const LineWorth& worth, const Requirements& wanted);

/// Larger is better.
[[nodiscard]] double score_of(Objective objective, const TracingFourBar& linkage, const LineWorth& worth);

}  // namespace linkwright
