#include "fitted_path_family.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "linkwright/core/angle.hpp"
#include "linkwright/planar/four_bar_map.hpp"
#include "listed_cells.hpp"

namespace linkwright {
namespace {

constexpr std::size_t most_positions = 5, most_realisations = 3;

constexpr auto fitted_measures = [] {
  std::array<Measure, planar_measures.size() + 1> all{};
  std::copy(planar_measures.begin(), planar_measures.end(), all.begin());
  all.back() = measures::path_error;
  return all;
}();

// Of a curve at angles of the crank only those whose cranks turn alike; of absolute angles one.
std::size_t realisations_of(const NearestTarget& near) {
  return !near.timing ? most_realisations : near.timing->absolute ? 1 : 2;
}

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

}  // namespace

FittedPathFamily::FittedPathFamily(NearestTarget near, FitMeasure measure, MapAxis input, MapAxis output)
    : PathFamily({near.target.points.front(), near.target.diagonal()}, std::move(input), std::move(output)),
      near_(std::move(near)),
      measure_(measure),
      positions_(spread_numbers(most_positions, near_.target.points.size(), near_.target.closed)) {}

FittedPathFamily::FittedPathFamily(NearestTarget near, std::vector<CurveFit> fits, FitMeasure measure)
    : FittedPathFamily(std::move(near), measure, axis_of_found(AxisQuantity::fitted_curve, "curve", fits.size()),
                       axis_of_found(AxisQuantity::realisation, "realisation", realisations_of(near))) {
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
    const CurveError error = near_.error_of(*traced->fit);
    cell->values[planar_measures.size()] = measure_ == FitMeasure::least_largest ? error.max : error.rms;
    if (near_.target.closed) cell->values[0] = cell->values[1];  // it is run all along
    if (near_.target.closed && !input_is_crank(cell->type) && cell->defects.none())
      cell->defects.bits |= Defects::branch_bit;
    return cell;
  };
}

std::vector<Cell> FittedPathFamily::all_at(MapPoint place, bool respect_direction) const {
  std::vector<Cell> all;
  for (std::size_t k = 0; k < realisations_of(near_); ++k)
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
  path.timed = near_.timing.has_value();
  path.error = near_.error_of(fit);
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

}  // namespace linkwright
