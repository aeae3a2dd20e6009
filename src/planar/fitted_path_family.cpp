#include "fitted_path_family.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <utility>

#include "fit_requirements.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/planar/four_bar_map.hpp"
#include "listed_cells.hpp"
#include "pivot_path_family.hpp"

namespace linkwright {
namespace {

constexpr std::size_t most_positions = 5, most_realisations = 3;

constexpr auto fitted_measures = [] {
  std::array<Measure, planar_measures.size() + 1> all{};
  std::copy(planar_measures.begin(), planar_measures.end(), all.begin());
  all.back() = measures::path_error;
  return all;
}();

Point unit_towards(Point from, Point to) { return (to - from) / std::abs(to - from); }

// By how much a coupler that is turned about the point, which stands at `there`, fails to be held by its links.
double looseness(const TracingFourBar& linkage, Point turn, Point there) {
  const auto moved = [&](Point p) { return there + turn * (p - linkage.point); };
  const FourBar& bars = linkage.bars;
  const LinkLengths lengths = bars.lengths();
  return std::abs(std::abs(moved(bars.input_moving) - bars.input_fixed) - lengths.input) +
         std::abs(std::abs(moved(bars.output_moving) - bars.output_fixed) - lengths.output);
}

// A cognate's coupler turns as one of the three moving links of any other: as that with which it stays closed.
Point coupler_turn(const TracingFourBar& linkage, const FourBar& first, const FitState& state) {
  const FourBar& now = state.bars;
  const std::array<Point, 3> turns = {
      unit_towards(now.input_moving, now.output_moving) *
          std::conj(unit_towards(first.input_moving, first.output_moving)),
      unit_towards(now.input_fixed, now.input_moving) * std::conj(unit_towards(first.input_fixed, first.input_moving)),
      unit_towards(now.output_fixed, now.output_moving) *
          std::conj(unit_towards(first.output_fixed, first.output_moving))};
  return *std::min_element(turns.begin(), turns.end(), [&](Point a, Point b) {
    return looseness(linkage, a, state.point) < looseness(linkage, b, state.point);
  });
}

// On the ground pivots that are given: of the four-bars that trace a curve not all do.
bool stands_on(const NearestTarget& near, const FourBar& bars) {
  const double least = 1e-5 * near.target.diagonal();
  const auto is_at = [&](const std::optional<Point>& given, Point p) {
    return !given || std::abs(*given - p) <= least;
  };
  return is_at(near.pivots.input, bars.input_fixed) && is_at(near.pivots.output, bars.output_fixed);
}

// Of the points of the task alone, by their numbers there.
CurveError error_of(const NearestTarget& near, const CurveFit& fit) {
  CurveError error = fit.error;
  error.sum_of_squares = error.max = 0;
  double weights = 0;
  for (std::size_t j = 0; j < fit.states.size(); ++j) {
    if (near.point[j] == NearestTarget::between) continue;
    const double weight = near.target.weights[j], distance = fit.states[j].distance;
    weights += weight;
    error.sum_of_squares += weight * distance * distance;
    if (!(weight > 0 && distance >= error.max)) continue;
    error.max = distance;
    error.max_at = near.point[j];
  }
  error.rms = std::sqrt(error.sum_of_squares / weights);
  error.rms_over_diagonal = error.rms / near.target.diagonal();
  return error;
}

}  // namespace

FittedPathFamily::FittedPathFamily(NearestTarget near, FitMeasure measure, MapAxis input, MapAxis output)
    : PathFamily({near.target.points.front(), near.target.diagonal()}, std::move(input), std::move(output)),
      near_(std::move(near)),
      measure_(measure),
      positions_(spread_numbers(most_positions, near_.target.points.size(), near_.target.closed)) {}

FittedPathFamily::FittedPathFamily(NearestTarget near, std::vector<CurveFit> fits, FitMeasure measure)
    : FittedPathFamily(std::move(near), measure, axis_of_found(AxisQuantity::fitted_curve, "curve", fits.size()),
                       axis_of_found(AxisQuantity::realisation, "realisation", most_realisations)) {
  for (CurveFit& fit : fits) fits_.push_back(std::make_shared<const CurveFit>(std::move(fit)));
}

std::span<const Measure> FittedPathFamily::measures() const { return fitted_measures; }

std::optional<FittedPathFamily::Traced> FittedPathFamily::traced_at(MapPoint place) const {
  if (!(place.input >= 0 && place.output >= 0)) return std::nullopt;
  const auto curve = static_cast<std::size_t>(place.input), realisation = static_cast<std::size_t>(place.output);
  if (curve >= fits_.size() || realisation >= fits_[curve]->realisation_count) return std::nullopt;
  const Traced traced{fits_[curve], realisation};
  return stands_on(near_, traced.linkage().bars) ? std::optional(traced) : std::nullopt;
}

std::optional<DyadPair> FittedPathFamily::dyad_pair(MapPoint place) const {
  const auto traced = traced_at(place);
  if (!traced) return std::nullopt;
  const FourBar& bars = traced->linkage().bars;
  const auto link = [&](Point center, Point circle, Side side, double coordinate) {
    const double named = axis(side).is_discrete() ? std::floor(coordinate) + 0.5 : coordinate;
    return Dyad{Homogeneous::of(frame().to_working(center)), Homogeneous::of(frame().to_working(circle)), named};
  };
  return DyadPair{link(bars.input_fixed, bars.input_moving, Side::input, place.input),
                  link(bars.output_fixed, bars.output_moving, Side::output, place.output)};
}

std::vector<PrescribedPose> FittedPathFamily::user_poses(MapPoint place, const FourBar& /*bars*/) const {
  std::vector<PrescribedPose> poses;
  const auto traced = traced_at(place);
  if (!traced) return poses;
  const std::vector<FitState>& states = traced->fit->states;
  for (const std::size_t j : positions_)
    poses.push_back({{states[j].point, std::arg(coupler_turn(traced->linkage(), states.front().bars, states[j]))}, {}});
  return poses;
}

std::vector<PrescribedPose> FittedPathFamily::working_poses(MapPoint place, const FourBar& bars) const {
  return frame().to_working(user_poses(place, bars));
}

std::vector<PrescribedPose> FittedPathFamily::crank_poses(MapPoint place, const FourBar& bars) const {
  return crank_poses_of(bars, user_poses(place, bars), std::nullopt);
}

LinkageFamily::CellAt FittedPathFamily::cells(bool respect_direction) const {
  return [this, judge = PathFamily::cells(respect_direction)](MapPoint place, const auto& is_worth_it) {
    std::optional<Cell> cell = judge(place, is_worth_it);
    const auto traced = traced_at(place);
    if (!cell || !traced) return cell;
    const CurveError error = error_of(near_, *traced->fit);
    cell->values[planar_measures.size()] = measure_ == FitMeasure::least_largest ? error.max : error.rms;
    if (near_.target.closed) cell->values[0] = cell->values[1];  // it is run all along
    if (near_.target.closed && !input_is_crank(cell->type)) cell->defects.bits |= Defects::branch_bit;
    return cell;
  };
}

std::vector<Cell> FittedPathFamily::all_at(MapPoint place, bool respect_direction) const {
  std::vector<Cell> all;
  for (std::size_t k = 0; k < most_realisations; ++k)
    if (auto found = cell({place.input, static_cast<double>(k) + 0.5}, respect_direction)) all.push_back(*found);
  return all;
}

void FittedPathFamily::fill(RegionMap& map, std::span<const double> input, std::span<const double> output,
                            bool respect_direction, const RegionOptions& options, const Progress& progress) const {
  const auto bars_at = [this](MapPoint place) {
    const auto traced = traced_at(place);
    return traced ? std::optional(traced->linkage().bars) : std::nullopt;
  };
  fill_one_by_one(*this, bars_at, map, input, output, respect_direction, options, progress);
}

std::optional<FittedPath> FittedPathFamily::fitted_at(MapPoint place) const {
  const auto traced = traced_at(place);
  if (!traced) return std::nullopt;
  const CurveFit& fit = *traced->fit;
  const std::vector<FitState>& states = fit.states;
  FittedPath path;
  path.error = error_of(near_, fit);
  path.at_length_limit = fit.at_length_limit;
  const std::vector<double>& turns = fit.input_turns[traced->realisation];
  for (std::size_t j = 0; j < states.size(); ++j) {
    if (near_.point[j] == NearestTarget::between) continue;
    path.at.push_back({near_.point[j], turns[j], states[j].point, states[j].distance});
    if (states[j].distance > near_.tolerance[j]) path.outside.push_back(near_.point[j]);
  }
  path.realisations.push_back(traced->linkage().bars);
  for (std::size_t k = 0; k < fit.realisation_count; ++k)
    if (k != traced->realisation) path.realisations.push_back(fit.realisations[k].bars);
  return path;
}

std::optional<std::size_t> FittedPathFamily::curve_of(const Pivots& pivots) const {
  const FourBar bars = four_bar_of(pivots);
  const double near = 1e-9 * frame().scale;
  for (std::size_t i = 0; i < fits_.size(); ++i)
    for (std::size_t k = 0; k < fits_[i]->realisation_count; ++k) {
      const FourBar& known = fits_[i]->realisations[k].bars;
      if (std::abs(known.input_fixed - bars.input_fixed) <= near &&
          std::abs(known.output_fixed - bars.output_fixed) <= near &&
          std::abs(known.input_moving - bars.input_moving) <= near)
        return i;
    }
  return std::nullopt;
}

double FittedPathFamily::distance(const Pivots& one, const Pivots& other) const {
  const auto curve = curve_of(one);
  return curve && curve == curve_of(other) ? 0 : PathFamily::distance(one, other);
}

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
  fit.threads = options.threads;
  fit.simd = options.simd;
  return fit;
}

Notice about_search(const GroundPivots& pivots, const CurveFits& found) {
  const auto [places, starts, minima] = found.counts;
  if (pivots.count() > 0)
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
  const double with = error_of(near, *found.smallest_with_defects).rms;
  if (!found.fits.empty() && error_of(near, found.fits.front()).rms <= with) return std::nullopt;
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
  return Notice{
      "path_strays",
      fmt::format("Between the points the nearest path strays {:.4g} from the polygon through them; give more "
                  "points there, or \"between\": \"polyline\".",
                  path->error.excursion),
      {{"excursion", path->error.excursion}}};
}

std::optional<Notice> about_exact(const NearestTarget& near) {
  const std::size_t count = near.point_count(), most_exact = 9 - 2 * static_cast<std::size_t>(near.pivots.count());
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
  for (CurveFit& fit : fit_curve(near.target, options, progress).fits)
    if (keeps(fit)) found.fits.push_back(std::move(fit));
}

}  // namespace

TaskFamily family_of_nearest(const PathTask& task, const Requirements& requirements, const FitWishes& wishes,
                             const RegionOptions& options, const Progress& progress) {
  NearestTarget near = nearest_target(task);
  TaskFamily given;
  given.pattern = fmt::format("{} points", near.point_count());
  given.conditions.frame = {near.target.points.front(), near.target.diagonal()};
  given.size = given.frame().scale;
  given.warnings = near.warnings;
  const CurveFitOptions fit = fit_options(near, with_default_lengths(requirements, given.size), wishes, options);
  CurveFits found = fit_curve(near.target, fit, progress);
  add_least_largest(near, fit, found, progress);
  if (auto notice = about_exact(near)) given.warnings.push_back(*std::move(notice));
  given.warnings.push_back(about_search(task.pivots, found));
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

}  // namespace linkwright
