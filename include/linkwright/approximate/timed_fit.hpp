#pragma once

#include <optional>
#include <vector>

#include "linkwright/approximate/curve_fit.hpp"

namespace linkwright {

/// At which angle of the input each point of a target is to be passed.
struct CurveTiming {
  /// To each point, radians, counter-clockwise: rising or falling throughout, by less than a turn in all.
  std::vector<double> input;
  /// Angles of input_fixed → input_moving from the x axis of the fixed frame. Otherwise datum and sense are free: by
  /// how much the input turns from point to point counts, and not which way round.
  bool absolute = false;
};

/// Four-bars whose coupler point is nearest to the points of a target at the angles of the input: the distances are
/// those of the point at these angles. Evidence, not proof. Ratios of lengths and the angle of the ground link are
/// scanned; the rest are three complex unknowns of a linear problem, so that every cell of the scan has its error in
/// closed form. The best are starts of least squares over all ten dimensions. Limits act as in fit_curve(). Of fewer
/// than six points exact solutions exist. Of absolute angles one realisation is listed, otherwise two: that of Roberts'
/// cognates whose input turns alike. `counts.places`: shapes that were scanned. Same input, same output. `target` as
/// CurveTarget says, `timing` as CurveTiming says, asserted.
[[nodiscard]] CurveFits fit_timed_curve(const CurveTarget& target, const CurveTiming& timing,
                                        const CurveFitOptions& options = {}, const Progress& progress = {});

/// How near the point of a linkage is to a target at angles of its input, with the datum and the sense for which the
/// sum of squares is least, unless the timing is absolute; the assembly mode is that in which it lies. The linkage is
/// the only realisation told. Nothing where a link has no length, or where the input does not reach the angles.
[[nodiscard]] std::optional<CurveFit> compare_with_timed_curve(const TracingFourBar& linkage, const CurveTarget& target,
                                                               const CurveTiming& timing,
                                                               const CurveFitOptions& options = {});

}  // namespace linkwright
