#include "approximate/fit_listing.hpp"

#include <algorithm>

#include "approximate/start_list.hpp"

namespace linkwright {
namespace {

double measured(const CurveFit& fit, FitMeasure measure) {
  return measure == FitMeasure::least_squares ? fit.error.sum_of_squares : fit.error.max;
}

}  // namespace

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
    if (curve.is_given && !found.fits.empty()) continue;
    if (!curve.fit.within_limits || found.fits.size() == options.max_fits) continue;
    if (std::any_of(listed.begin(), listed.end(), is_listed)) continue;
    listed.push_back(&curve.linkage);
    found.fits.push_back(std::move(curve.fit));
  }
  return found;
}

}  // namespace linkwright
