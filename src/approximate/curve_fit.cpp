#include "linkwright/approximate/curve_fit.hpp"

#include <algorithm>
#include <cmath>

#include "approximate/curve_search.hpp"
#include "approximate/fit_result.hpp"
#include "approximate/start_list.hpp"
#include "linkwright/core/parallel.hpp"

namespace linkwright {
namespace {

// A curve as it is told, and as it was found.
struct FoundCurve {
  CurveFit fit;
  CouplerLinkage linkage;

  [[nodiscard]] double measured(FitMeasure measure) const {
    return measure == FitMeasure::least_squares ? fit.error.sum_of_squares : fit.error.max;
  }
};

// Those that can be driven, and the best of those that cannot.
CurveFits sorted_out(std::vector<FoundCurve> all, const CurveTarget& target, const CurveFitOptions& options) {
  std::stable_sort(all.begin(), all.end(), [&](const FoundCurve& a, const FoundCurve& b) {
    return a.measured(options.measure) < b.measured(options.measure);
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

}  // namespace

CurveFits fit_curve(const CurveTarget& target, const CurveFitOptions& options, const Progress& progress) {
  require_curve_target(target);
  const ScaledTarget scaled = scaled_target(target);
  const FitLimits limits = scaled_limits(options, scaled);
  CurveSearch search = search_curves(scaled, limits, options, progress);
  std::vector<FoundCurve> all(search.minima.size());
  parallel_for(all.size(), options.threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const CurveStart& start = search.minima[k];
      all[k] = {
          curve_fit_of(in_user_frame(start.linkage, scaled), start.states, target, options, FirstRealisation::best),
          start.linkage};
    }
  });
  CurveFits found = sorted_out(std::move(all), target, options);
  found.counts = {search.places, search.starts, search.minima.size()};
  found.cancelled = search.cancelled;
  return found;
}

}  // namespace linkwright
