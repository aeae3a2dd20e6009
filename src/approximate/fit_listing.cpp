#include "approximate/fit_listing.hpp"

#include <algorithm>
#include <variant>

#include "approximate/fit_result.hpp"
#include "approximate/start_list.hpp"

namespace linkwright {
namespace {

double measured(const CurveFit& fit, FitMeasure measure) {
  return measure == FitMeasure::least_squares ? fit.error.sum_of_squares : fit.error.max;
}

}  // namespace

FitLimits scaled_limits(const CurveFitOptions& options, const ScaledTarget& target) {
  FitLimits limits = limits_of(options, target.closed, target.diagonal);
  const Box* box = options.windows.ground ? std::get_if<Box>(&*options.windows.ground) : nullptr;
  if (!box) return limits;
  const Point low = target.scaled({box->x_low, box->y_low}), high = target.scaled({box->x_high, box->y_high});
  limits.ground = Box{low.real(), high.real(), low.imag(), high.imag()};
  return limits;
}

CouplerLinkage in_user_frame(const CouplerLinkage& l, const ScaledTarget& target) {
  const double unit = target.radius;
  return {target.in_user_frame(l.a0), target.in_user_frame(l.b0), unit * l.a, unit * l.h, unit * l.b, unit * l.p};
}

CurveFits sorted_out(std::vector<FoundCurve> all, const CurveTarget& target, const CurveFitOptions& options) {
  std::stable_sort(all.begin(), all.end(), [&](const FoundCurve& a, const FoundCurve& b) {
    return measured(a.fit, options.measure) < measured(b.fit, options.measure);
  });
  CurveFits found;
  std::vector<const CouplerLinkage*> listed;
  for (FoundCurve& curve : all) {
    if (!curve.fit.drive.no_defects(target.closed)) {
      if (!found.smallest_with_defects) found.smallest_with_defects = std::move(curve.fit);
      continue;
    }
    const auto is_listed = [&](const CouplerLinkage* other) { return same_curve(*other, curve.linkage); };
    if (!curve.fit.within_limits || found.fits.size() == options.max_fits) continue;
    if (std::any_of(listed.begin(), listed.end(), is_listed)) continue;
    listed.push_back(&curve.linkage);
    found.fits.push_back(std::move(curve.fit));
  }
  return found;
}

}  // namespace linkwright
