#include "fitted_motion_family.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <utility>

#include "fit_requirements.hpp"
#include "listed_cells.hpp"

namespace linkwright {
namespace {

constexpr std::size_t most_told = 5;  // positions that reports and drawings tell

// The first and the last, exact ones, and others between.
std::vector<std::size_t> told_positions(const PoseTarget& target) {
  std::vector<std::size_t> told = target.exact;
  const auto add = [&](std::size_t j) {
    if (told.size() < most_told && std::find(told.begin(), told.end(), j) == told.end()) told.push_back(j);
  };
  add(0);
  add(target.poses.size() - 1);
  for (const std::size_t j : spread_numbers(most_told, target.poses.size(), false)) add(j);
  std::sort(told.begin(), told.end());
  return told;
}

class FittedError : public CellMeasure {
 public:
  explicit FittedError(std::shared_ptr<const FittedMotionFamily> family)
      : CellMeasure(measures::near_error), family_(std::move(family)) {}

  [[nodiscard]] std::optional<double> at(MapPoint place) const override {
    const PoseFit* fit = family_->fit_at(place);
    return fit ? std::optional(fit->error.rms) : std::nullopt;
  }

 private:
  std::shared_ptr<const FittedMotionFamily> family_;
};

}  // namespace

FittedMotionFamily::FittedMotionFamily(std::shared_ptr<const NearPoses> near, std::vector<PoseFit> fits)
    : FourBarFamily({near->target().poses.front().origin, near->target().turning_length},
                    axis_of_found(AxisQuantity::fitted_curve, "linkage", fits.size()),
                    axis_of_found(AxisQuantity::nothing, "", 1)),
      near_(std::move(near)),
      fits_(std::move(fits)),
      positions_(told_positions(near_->target())) {}

const PoseFit* FittedMotionFamily::fit_at(MapPoint place) const {
  if (!(place.input >= 0 && place.output >= 0 && place.output <= 1)) return nullptr;
  const auto k = static_cast<std::size_t>(place.input);
  return k < fits_.size() ? &fits_[k] : nullptr;
}

std::optional<DyadPair> FittedMotionFamily::dyad_pair(MapPoint place) const {
  const PoseFit* fit = fit_at(place);
  if (!fit) return std::nullopt;
  const auto link = [&](Point center, Point circle, double coordinate) {
    return Dyad{Homogeneous::of(frame().to_working(center)), Homogeneous::of(frame().to_working(circle)),
                std::floor(coordinate) + 0.5};
  };
  return DyadPair{link(fit->bars.input_fixed, fit->bars.input_moving, place.input),
                  link(fit->bars.output_fixed, fit->bars.output_moving, 0)};
}

std::vector<PrescribedPose> FittedMotionFamily::user_poses(MapPoint place, const FourBar& /*bars*/) const {
  std::vector<PrescribedPose> poses;
  if (const PoseFit* fit = fit_at(place))
    for (const std::size_t j : positions_) poses.push_back({fit->states[j].body, {}});
  return poses;
}

std::vector<PrescribedPose> FittedMotionFamily::working_poses(MapPoint place, const FourBar& bars) const {
  return frame().to_working(user_poses(place, bars));
}

void FittedMotionFamily::fill(RegionMap& map, std::span<const double> input, std::span<const double> output,
                              bool respect_direction, const RegionOptions& options, const Progress& progress) const {
  const auto bars_at = [this](MapPoint place) {
    const PoseFit* fit = fit_at(place);
    return fit ? std::optional(fit->bars) : std::nullopt;
  };
  fill_one_by_one(*this, bars_at, map, input, output, respect_direction, options, progress);
}

std::shared_ptr<const CellMeasure> fitted_error_measure(std::shared_ptr<const FittedMotionFamily> family) {
  return std::make_shared<const FittedError>(std::move(family));
}

namespace {

PoseFitOptions pose_options(const PoseTarget& target, const Requirements& requirements, const FitWishes& wishes,
                            const RegionOptions& options) {
  const double scale = target.scale();
  PoseFitOptions fit;
  fit.effort = wishes.effort;
  fit.measure = wishes.measure;
  fit.max_length = (1 - fit_inside) * *requirements.max_length / scale;
  fit.min_length = (1 + fit_inside) * *requirements.min_length / scale;
  fit.max_link_ratio = (1 - fit_inside) * requirements.max_link_ratio;
  fit.min_transmission_angle = fitted_transmission_angle(requirements);
  if (requirements.ground_pivots_within) fit.windows.ground = *requirements.ground_pivots_within;
  if (requirements.moving_pivots_within) fit.windows.moving = *requirements.moving_pivots_within;
  for (const FitStart& start : wishes.starts) fit.starts.push_back({start.bars, start.pose});
  fit.threads = options.threads;
  return fit;
}

Notice about_search(const PoseFits& found) {
  const auto [dyads, starts, minima] = found.counts;
  return {"poses_fitted",
          fmt::format("The linkages that come nearest were searched for: from pairs of {} dyads {} starts ran into {} "
                      "different linkages. That is evidence, no proof, that none comes nearer.",
                      dyads, starts, minima),
          {{"dyads", static_cast<double>(dyads)},
           {"starts", static_cast<double>(starts)},
           {"minima", static_cast<double>(minima)}}};
}

std::optional<Notice> about_defects(const PoseFits& found) {
  if (!found.smallest_with_defects) return std::nullopt;
  const double with = found.smallest_with_defects->error.rms;
  if (!found.fits.empty() && found.fits.front().error.rms <= with) return std::nullopt;
  return Notice{
      "nearer_poses_with_defects",
      fmt::format("With a defect – a dead point on the way, poses on two circuits or out of order – a linkage "
                  "could pass at {:.4g} (root mean square).",
                  with),
      {{"rms", with}}};
}

std::optional<Notice> about_exact(const PoseTarget& target) {
  constexpr std::size_t most_exact = 5;
  const std::size_t count = target.poses.size();
  if (count > most_exact) return std::nullopt;
  return Notice{"poses_exactly_solvable",
                fmt::format("Through {} poses some four-bars may pass exactly; leave out \"near\" to have {}.", count,
                            count < most_exact ? "all of them" : "the few there are"),
                {{"count", static_cast<double>(count)}}};
}

std::optional<Notice> about_tolerance(const NearPoses& near, const PoseFits& found) {
  double factor = std::numeric_limits<double>::infinity();
  for (const PoseFit& fit : found.fits) factor = std::min(factor, near.tolerance_factor(fit));
  if (!near.has_tolerance() || factor <= 1) return std::nullopt;
  return Notice{
      "pose_tolerance_missed",
      fmt::format("No linkage found keeps the tolerance at all poses; {:.3g} times as much would do.", factor),
      {{"factor", factor}}};
}

Notice nothing_fits(const PoseFits& found) {
  return {"no_pose_fits",
          fmt::format("Of {} different linkages that pass near these poses none is without defects and keeps the "
                      "requirements. That is evidence, no proof: relax lengths, windows or transmission angle, or look "
                      "at more (\"fit\": {{\"effort\": \"deep\"}}).",
                      found.counts.minima),
          {{"minima", static_cast<double>(found.counts.minima)}}};
}

// The tolerance may be kept by a linkage whose largest error is the least.
void add_least_largest(const NearPoses& near, PoseFitOptions options, PoseFits& found, const Progress& progress) {
  const auto keeps = [&](const PoseFit& fit) { return near.tolerance_factor(fit) <= 1; };
  const bool is_kept = std::any_of(found.fits.begin(), found.fits.end(), keeps);
  if (is_kept || options.measure == FitMeasure::least_largest || progress.is_cancelled()) return;
  options.measure = FitMeasure::least_largest;
  for (PoseFit& fit : fit_poses(near.target(), options, progress).fits)
    if (keeps(fit)) found.fits.push_back(std::move(fit));
}

}  // namespace

TaskFamily family_of_near(const MotionTask& task, const Requirements& requirements, const FitWishes& wishes,
                          const RegionOptions& options, const Progress& progress) {
  const auto near = std::make_shared<const NearPoses>(task);
  const PoseTarget& target = near->target();
  TaskFamily given;
  given.pattern = fmt::format("{} poses", target.poses.size());
  given.conditions.frame = {target.poses.front().origin, target.turning_length};
  given.size = target.scale();
  given.near = near;
  const PoseFitOptions fit = pose_options(target, with_default_lengths(requirements, given.size), wishes, options);
  PoseFits found = fit_poses(target, fit, progress);
  add_least_largest(*near, fit, found, progress);
  if (auto notice = about_exact(target)) given.warnings.push_back(*std::move(notice));
  given.warnings.push_back(about_search(found));
  if (auto notice = about_defects(found)) given.warnings.push_back(*std::move(notice));
  given.has_no_dyads = found.fits.empty();
  if (given.has_no_dyads) {
    given.degeneracy = nothing_fits(found);
    return given;
  }
  if (auto notice = about_tolerance(*near, found)) given.warnings.push_back(*std::move(notice));
  const auto family = std::make_shared<const FittedMotionFamily>(near, std::move(found.fits));
  given.near_error = fitted_error_measure(family);
  given.family = family;
  return given;
}

FitSearch search_near(const MotionTask& task, const Requirements& requirements, const FitWishes& wishes,
                      const RegionOptions& options, const Progress& progress) {
  const NearPoses near(task);
  const PoseTarget& target = near.target();
  const Requirements limits = with_default_lengths(requirements, target.scale());
  const PoseFits found = fit_poses(target, pose_options(target, limits, wishes, options), progress);
  FitSearch search{{}, std::nullopt, found.counts.starts, found.counts.minima, found.cancelled};
  for (const PoseFit& fit : found.fits) search.linkages.push_back({fit.bars, std::nullopt, fit.states.front().body});
  if (!found.fits.empty()) search.rms = found.fits.front().error.rms;
  return search;
}

}  // namespace linkwright
