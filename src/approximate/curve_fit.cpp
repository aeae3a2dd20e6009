#include "linkwright/approximate/curve_fit.hpp"

#include <iterator>

#include "approximate/curve_search.hpp"
#include "approximate/fit_listing.hpp"
#include "approximate/fit_result.hpp"
#include "linkwright/core/parallel.hpp"

namespace linkwright {

CurveFits fit_curve(const CurveTarget& target, const CurveFitOptions& options, const Progress& progress) {
  require_curve_target(target);
  const ScaledTarget scaled = scaled_target(target);
  const FitLimits limits = scaled_limits(options, scaled);
  CurveSearch search = search_curves(scaled, limits, options, progress);
  const std::size_t found_count = search.minima.size();
  std::move(search.given.begin(), search.given.end(), std::back_inserter(search.minima));
  std::vector<FoundCurve> all(search.minima.size());
  parallel_for(all.size(), options.threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const CurveStart& start = search.minima[k];
      all[k] = {
          curve_fit_of(in_user_frame(start.linkage, scaled), start.states, target, options, FirstRealisation::best),
          start.linkage, k >= found_count};
    }
  });
  CurveFits found = sorted_out(std::move(all), target, options);
  found.counts = {search.places, search.starts, found_count};
  found.cancelled = search.cancelled;
  return found;
}

}  // namespace linkwright
