#include "linkwright/approximate/pivot_fits.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "approximate/curve_search.hpp"
#include "approximate/fit_parts.hpp"
#include "approximate/fit_result.hpp"
#include "approximate/limit_refit.hpp"
#include "approximate/start_list.hpp"
#include "linkwright/core/parallel.hpp"

namespace linkwright {
namespace {

constexpr unsigned first_pivot = 0b11;  // bits of CurveStart::held

void keep_better(std::optional<CurveStart>& best, CurveStart start) {
  if (!best || start.cost() < best->cost()) best = std::move(start);
}

}  // namespace

class PivotFits::Places {
 public:
  Places(const CurveTarget& target, const CurveFitOptions& options)
      : target_(target),
        options_(options),
        scaled_(scaled_target(target)),
        limits_(scaled_limits(options, scaled_)),
        chosen_(scaled_.chosen_points()),
        chosen_weights_(scaled_.chosen_weights()) {}

  void lay(std::span<const Point> lattice, std::span<const CurveFit> known, const Progress& progress) {
    constexpr int rounds = 3;  // what is found at a place spreads by as many
    for (const Point place : lattice) found_.push_back({scaled_.scaled(place), {}, {}});
    for (int round = 0; round < rounds; ++round) {
      const std::vector<Found> before = found_;
      parallel_for(found_.size(), options_.threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end && !progress.is_cancelled(); ++k)
          found_[k] =
              nearer(before[k], round == 0 ? scanned_starts(before[k].place) : starts_around(before, before[k].place));
      });
      progress(static_cast<double>(round + 1) / rounds);
    }
    for (const CurveFit& fit : known) add_known(fit);
  }

  [[nodiscard]] std::optional<CurveFit> at(Point pivot) const {
    const Point place = scaled_.scaled(pivot);
    std::vector<CurveStart> starts = starts_around(found_, place), scanned = scanned_starts(place);
    std::move(scanned.begin(), scanned.end(), std::back_inserter(starts));
    const std::vector<CurveStart> begun = moved_to(place, std::move(starts));
    std::optional<CurveFit> best = finished(best_of(begun, is_driven));
    if (best && best->within_limits && best->drive.no_defects(target_.closed)) return best;
    std::optional<CurveFit> other = finished(best_of(begun, is_other));
    const auto is_nearer = [&] { return other->error.sum_of_squares < best->error.sum_of_squares; };
    return !best || (other && is_nearer()) ? other : best;
  }

 private:
  // What was found at a place, on the chosen points: the nearest that its input drives, and the nearest of all others.
  struct Found {
    Point place{};
    std::optional<CurveStart> driven, other;
  };

  // From dyads there.
  [[nodiscard]] std::vector<CurveStart> scanned_starts(Point place) const {
    constexpr std::size_t most = 4;
    const PairWishes wishes{.drivers = "eu"};  // the output stands elsewhere
    std::vector<ScannedPair> pairs =
        scan_pivot(scaled_, chosen_, chosen_weights_, place, limits_.max_length, options_.simd, wishes);
    return starts_of(distinct_pairs(std::move(pairs), most), chosen_);
  }

  // Those of the places nearest by, the farther out the wider.
  [[nodiscard]] std::vector<CurveStart> starts_around(const std::vector<Found>& found, Point place) const {
    constexpr std::size_t most = 4;
    std::vector<const Found*> around;
    for (const Found& one : found) around.push_back(&one);
    const auto distance = [&](const Found* one) {
      return std::norm(one->place - place) / (1 + std::norm(one->place) + std::norm(place));
    };
    const auto is_closer = [&](const Found* a, const Found* b) {
      return std::pair(distance(a), a) < std::pair(distance(b), b);
    };
    const std::size_t count = std::min(most, around.size());
    std::partial_sort(around.begin(), around.begin() + static_cast<std::ptrdiff_t>(count), around.end(), is_closer);
    std::vector<CurveStart> starts;
    for (std::size_t k = 0; k < count; ++k) {
      if (around[k]->driven) starts.push_back(*around[k]->driven);
      if (around[k]->other) starts.push_back(*around[k]->other);
    }
    return starts;
  }

  // What was found, or what least squares reach from the starts.
  [[nodiscard]] Found nearer(Found found, std::vector<CurveStart> starts) const {
    const std::vector<CurveStart> begun = moved_to(found.place, std::move(starts));
    if (auto best = best_of(begun, is_driven)) keep_better(found.driven, *std::move(best));
    if (auto best = best_of(begun, is_other)) keep_better(found.other, *std::move(best));
    return found;
  }

  static bool is_driven(const CurveStart& start) { return start.branch != 0; }
  static bool is_other(const CurveStart& start) { return start.branch == 0; }

  // With their pivot there, after a few steps; the nearest first.
  [[nodiscard]] std::vector<CurveStart> moved_to(Point place, std::vector<CurveStart> starts) const {
    constexpr int iterations = 4;
    std::vector<CurveStart> moved;
    for (CurveStart& start : starts) {
      start.linkage.a0 = place;
      start.held = first_pivot;
      start.converged = false;
      const auto closes = [&](LoopState& state) { return close_loop(start.linkage, state); };
      if (std::all_of(start.states.begin(), start.states.end(), closes))
        moved.push_back(improved(std::move(start), iterations));
    }
    sort_by_cost(moved);
    return moved;
  }

  // Of those of a kind, by the two nearest.
  template <class IsOfKind>
  [[nodiscard]] std::optional<CurveStart> best_of(const std::vector<CurveStart>& begun, const IsOfKind& is_of) const {
    constexpr int iterations = 25;
    std::optional<CurveStart> best;
    int left = 2;
    for (const CurveStart& start : begun) {
      if (!is_of(start)) continue;
      keep_better(best, improved(start, iterations));
      if (--left == 0) break;
    }
    return best;
  }

  [[nodiscard]] CurveStart improved(CurveStart start, int iterations) const {
    const FitTask task = task_of({chosen_, chosen_weights_, limits_}, start);
    evaluate(task, start);
    improve(task, start, iterations);
    return start;
  }

  // On all points, and within the limits.
  [[nodiscard]] std::optional<CurveFit> finished(std::optional<CurveStart> start) const {
    constexpr int iterations = 40;
    if (!start) return std::nullopt;
    const FitTask task = task_of({scaled_.points, scaled_.weights, limits_}, *start);
    if (scaled_.chosen.size() != scaled_.points.size()) {
      start->converged = false;
      if (!spread_to_all_points(scaled_, *start)) return std::nullopt;
    }
    evaluate(task, *start);
    improve(task, *start, iterations);
    if (options_.measure == FitMeasure::least_largest) fit_least_largest(task, *start);
    refit_within_limits(task, *start);
    slide_to_nearest(task, *start);
    return curve_fit_of(in_user_frame(start->linkage, scaled_), start->states, target_, options_,
                        FirstRealisation::as_given);
  }

  // At each of its pivots from which it can be driven.
  void add_known(const CurveFit& fit) {
    const CurveStart start = known_start(fit);
    add_with_same_input(start);
    if (fit.drive.output_drives) add_with_same_input(driven_by_output(start));
  }
  void add_with_same_input(const CurveStart& start) {
    found_.push_back({start.linkage.a0, start, {}});
    if (const auto other = with_same_input(start)) found_.push_back({other->linkage.a0, *other, {}});
  }

  [[nodiscard]] CurveStart known_start(const CurveFit& fit) const {
    CurveStart start;
    const LinkLengths lengths = fit.linkage().bars.lengths();
    const auto unit = [](Point from, Point to) { return (to - from) / std::abs(to - from); };
    for (const std::size_t j : scaled_.chosen) {
      const FourBar& bars = fit.states[j].bars;
      start.states.push_back({unit(bars.input_fixed, bars.input_moving), unit(bars.input_moving, bars.output_moving)});
    }
    const TracingFourBar& first = fit.linkage();
    const double unit_length = scaled_.radius;
    start.linkage = {scaled_.scaled(first.bars.input_fixed),
                     scaled_.scaled(first.bars.output_fixed),
                     lengths.input / unit_length,
                     lengths.coupler / unit_length,
                     lengths.output / unit_length,
                     product(first.point - first.bars.input_moving,
                             std::conj(unit(first.bars.input_moving, first.bars.output_moving))) /
                         unit_length};
    start.branch = cross(start.states[0].u, LoopGradient(start.linkage, start.states[0]).g) > 0 ? 1 : -1;
    return start;
  }

  const CurveTarget target_;
  const CurveFitOptions options_;
  const ScaledTarget scaled_;
  const FitLimits limits_;
  const std::vector<Point> chosen_;
  const std::vector<double> chosen_weights_;
  std::vector<Found> found_;
};

PivotFits::PivotFits(const CurveTarget& target, const CurveFitOptions& options, std::span<const Point> lattice,
                     std::span<const CurveFit> known, const Progress& progress)
    : places_(std::make_unique<Places>(target, options)) {
  require_curve_target(target);
  places_->lay(lattice, known, progress);
}
PivotFits::~PivotFits() = default;
PivotFits::PivotFits(PivotFits&&) noexcept = default;
PivotFits& PivotFits::operator=(PivotFits&&) noexcept = default;

std::optional<CurveFit> PivotFits::at(Point pivot) const { return places_->at(pivot); }

}  // namespace linkwright
