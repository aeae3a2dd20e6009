#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <memory>
#include <utility>

#include "fit_requirements.hpp"
#include "fitted_path_family.hpp"
#include "pivot_path_family.hpp"

namespace linkwright {
namespace {

CurveFitOptions fit_options(const NearestTarget& near, const Requirements& requirements, const FitWishes& wishes,
                            const RegionOptions& options) {
  CurveFitOptions fit;
  const double diagonal = near.target.diagonal();
  fit.effort = wishes.effort;
  fit.measure = wishes.measure;
  fit.max_length = (1 - fit_inside) * *requirements.max_length / diagonal;
  fit.min_length = (1 + fit_inside) * *requirements.min_length / diagonal;
  fit.max_link_ratio = (1 - fit_inside) * requirements.max_link_ratio;
  fit.grashof_margin = wishes.grashof_margin;
  fit.min_transmission_angle = fitted_transmission_angle(requirements);
  if (requirements.ground_pivots_within) fit.windows.ground = *requirements.ground_pivots_within;
  if (requirements.moving_pivots_within) fit.windows.moving = *requirements.moving_pivots_within;
  fit.input_pivot = near.pivots.input;
  fit.output_pivot = near.pivots.output;
  for (const FitStart& start : wishes.starts)
    if (start.point) fit.starts.push_back({start.bars, *start.point});
  fit.threads = options.threads;
  fit.simd = options.simd;
  return fit;
}

CurveFits fits_of(const NearestTarget& near, const CurveFitOptions& options, const Progress& progress) {
  return near.timing ? fit_timed_curve(near.target, *near.timing, options, progress)
                     : fit_curve(near.target, options, progress);
}

Notice about_search(const NearestTarget& near, const CurveFits& found) {
  const auto [places, starts, minima] = found.counts;
  if (near.timing)
    return {"timed_path_fitted",
            fmt::format("The nearest paths at these angles of the crank were searched for: from {} shapes of four-bars "
                        "{} starts ran into {} different paths. That is evidence, no proof, that none comes nearer.",
                        places, starts, minima),
            {{"shapes", static_cast<double>(places)},
             {"starts", static_cast<double>(starts)},
             {"minima", static_cast<double>(minima)}}};
  if (near.pivots.count() > 0)
    return {
        "path_fitted_to_pivots",
        fmt::format("The nearest paths from the ground pivot that is given were searched for: {} starts ran into {} "
                    "different ones. That is evidence, no proof, that none comes nearer.",
                    starts, minima),
        {{"starts", static_cast<double>(starts)}, {"minima", static_cast<double>(minima)}}};
  return {"path_fitted",
          fmt::format("The nearest paths were searched for: from {} places of a ground pivot {} starts ran into {} "
                      "different paths. That is evidence, no proof, that none comes nearer.",
                      places, starts, minima),
          {{"places", static_cast<double>(places)},
           {"starts", static_cast<double>(starts)},
           {"minima", static_cast<double>(minima)}}};
}

std::optional<Notice> about_defects(const NearestTarget& near, const CurveFits& found) {
  if (!found.smallest_with_defects) return std::nullopt;
  const double with = near.error_of(*found.smallest_with_defects).rms;
  if (!found.fits.empty() && near.error_of(found.fits.front()).rms <= with) return std::nullopt;
  return Notice{"nearer_with_defects",
                fmt::format("With a defect – a dead point on the way, points on two circuits or out of order – a path "
                            "could pass at {:.4g} (root mean square).",
                            with),
                {{"rms", with}}};
}

// Of the best, where it would surprise whoever sees the points alone.
std::optional<Notice> about_straying(const FittedPathFamily& family, const NearestTarget& near) {
  constexpr double of_error = 3, of_diagonal = 0.1;
  const auto path = family.fitted_at({0.5, 0.5});
  if (!path || path->error.excursion <= std::max(of_error * path->error.max, of_diagonal * near.target.diagonal()))
    return std::nullopt;
  if (near.timing)
    return Notice{"timed_path_strays",
                  fmt::format("Between the points the nearest path strays {:.4g} from the polygon through them; give "
                              "more points there where that matters.",
                              path->error.excursion),
                  {{"excursion", path->error.excursion}}};
  return Notice{
      "path_strays",
      fmt::format("Between the points the nearest path strays {:.4g} from the polygon through them; give more "
                  "points there, or \"between\": \"polyline\".",
                  path->error.excursion),
      {{"excursion", path->error.excursion}}};
}

std::optional<Notice> about_exact(const NearestTarget& near) {
  // Nine numbers of a curve, two less to each pivot; two equations to each point at angles of the crank, from a datum
  // that is a tenth.
  const std::size_t most_exact = !near.timing            ? 9 - 2 * static_cast<std::size_t>(near.pivots.count())
                                 : near.timing->absolute ? 4
                                                         : 5;
  const std::size_t count = near.point_count();
  if (count > most_exact) return std::nullopt;
  return Notice{"exactly_solvable",
                fmt::format("Through {} points some four-bars pass exactly{}; those listed are some that come as near "
                            "as rounding lets them, or that the requirements leave.",
                            count, count < most_exact ? ", whole families of them" : ""),
                {{"count", static_cast<double>(count)}}};
}

// By what all tolerances are to be multiplied that a path keeps them.
double tolerance_factor(const NearestTarget& near, const CurveFit& fit) {
  double factor = 0;
  for (std::size_t j = 0; j < fit.states.size(); ++j)
    factor = std::max(factor, fit.states[j].distance / near.tolerance[j]);
  return factor;
}

std::optional<Notice> about_tolerance(const NearestTarget& near, const CurveFits& found) {
  double factor = std::numeric_limits<double>::infinity();
  for (const CurveFit& fit : found.fits) factor = std::min(factor, tolerance_factor(near, fit));
  if (factor <= 1) return std::nullopt;
  return Notice{"path_tolerance_missed",
                fmt::format("No path found keeps the tolerance at all points; {:.3g} times as much would do.", factor),
                {{"factor", factor}}};
}

Notice nothing_fits(const CurveFits& found) {
  return {"no_path_fits",
          fmt::format("Of {} different paths near these points none is that of a linkage without defects that keeps "
                      "the requirements. That is evidence, no proof: relax lengths, windows or transmission angle, "
                      "or look at more (\"fit\": {{\"effort\": \"deep\"}}).",
                      found.counts.minima),
          {{"minima", static_cast<double>(found.counts.minima)}}};
}

// The tolerance may be kept by a path whose largest distance is the least.
void add_least_largest(const NearestTarget& near, CurveFitOptions options, CurveFits& found, const Progress& progress) {
  const auto keeps = [&](const CurveFit& fit) { return tolerance_factor(near, fit) <= 1; };
  const bool is_kept = std::any_of(found.fits.begin(), found.fits.end(), keeps);
  if (is_kept || options.measure == FitMeasure::least_largest || progress.is_cancelled()) return;
  options.measure = FitMeasure::least_largest;
  for (CurveFit& fit : fits_of(near, options, progress).fits)
    if (keeps(fit)) found.fits.push_back(std::move(fit));
}

}  // namespace

TaskFamily family_of_nearest(const PathTask& task, const Requirements& requirements, const FitWishes& wishes,
                             const RegionOptions& options, const Progress& progress) {
  NearestTarget near = nearest_target(task);
  TaskFamily given;
  given.pattern = fmt::format("{} {}points", near.point_count(), near.timing ? "timed " : "");
  given.conditions.frame = {near.target.points.front(), near.target.diagonal()};
  given.size = given.frame().scale;
  given.warnings = near.warnings;
  const CurveFitOptions fit = fit_options(near, with_default_lengths(requirements, given.size), wishes, options);
  CurveFits found = fits_of(near, fit, progress);
  add_least_largest(near, fit, found, progress);
  if (auto notice = about_exact(near)) given.warnings.push_back(*std::move(notice));
  given.warnings.push_back(about_search(near, found));
  if (auto notice = about_defects(near, found)) given.warnings.push_back(*std::move(notice));
  given.has_no_dyads = found.fits.empty();
  if (given.has_no_dyads) {
    given.degeneracy = nothing_fits(found);
    return given;
  }
  if (auto notice = about_tolerance(near, found)) given.warnings.push_back(*std::move(notice));
  const auto curves = std::make_shared<const FittedPathFamily>(near, found.fits, wishes.measure);
  if (auto notice = about_straying(*curves, near)) given.warnings.push_back(*std::move(notice));
  given.paths = curves;
  if (task.map == NearestMap::pivots)
    given.paths = std::make_shared<const PivotPathFamily>(near, fit, found.fits, progress);
  given.family = given.paths;
  return given;
}

FitSearch search_nearest(const PathTask& task, const Requirements& requirements, const FitWishes& wishes,
                         const RegionOptions& options, const Progress& progress) {
  const NearestTarget near = nearest_target(task);
  const Requirements limits = with_default_lengths(requirements, near.target.diagonal());
  const CurveFits found = fits_of(near, fit_options(near, limits, wishes, options), progress);
  FitSearch search{{}, std::nullopt, found.counts.starts, found.counts.minima, found.cancelled};
  for (const CurveFit& fit : found.fits)
    search.linkages.push_back({fit.linkage().bars, fit.linkage().point, std::nullopt});
  if (!found.fits.empty()) search.rms = near.error_of(found.fits.front()).rms;
  return search;
}

}  // namespace linkwright
