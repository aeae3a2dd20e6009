#pragma once

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "linkwright/core/parallel.hpp"
#include "linkwright/region/best_cells.hpp"
#include "linkwright/synthesis/answer.hpp"
#include "region/climb.hpp"

namespace linkwright {

/// What a kind of linkage brings to be searched for: beside what judges a place of its map, how far apart two designs
/// are, and a linkage made of a candidate.
template <class Kind>
concept SearchedKind = CandidateEvaluator<Kind> && requires(const Kind& kind, const typename Kind::Candidate& candidate,
                                                            MapPoint place, const typename Kind::Solution& made) {
  /// The same bars driven from the better side; as they are where the family names the input.
  { kind.from_better_side(candidate) } -> std::same_as<typename Kind::Candidate>;
  /// Between two designs, whichever grounded link is named first.
  { kind.distance(candidate, candidate) } -> std::convertible_to<double>;
  /// What distances of designs are measured by.
  { kind.size(candidate) } -> std::convertible_to<double>;
  /// Analysed and driven through in the user's coordinates; nothing where rounding keeps it from being any.
  { kind.make(place) } -> std::same_as<std::optional<typename Kind::Solution>>;
  /// It does in the user's coordinates what it was held for, and driving confirms it.
  { kind.is_confirmed(candidate, made) } -> std::same_as<bool>;
  { made.local_optimum } -> std::convertible_to<bool>;
};

template <class Solution>
struct BestLinkages {
  std::vector<Solution> linkages;
  std::int64_t left_out = 0;  ///< driving did not confirm them
  std::int64_t beyond = 0;    ///< of a few dyads: pairs that meet the requirements, beyond as many as are listed
};

/// Looks for the best linkages of a map.
template <SearchedKind Kind>
class LinkageSearch {
 public:
  using Candidate = typename Kind::Candidate;
  using Solution = typename Kind::Solution;

  /// Refers to all of them.
  LinkageSearch(const Kind& kind, const Findings& findings, const RequirementFilter& filter, const Progress& progress)
      : kind_(kind),
        map_(findings.region),
        options_(findings.options),
        filter_(filter),
        progress_(progress),
        is_discrete_(kind.family().axis(Side::input).is_discrete() && kind.family().axis(Side::output).is_discrete()),
        first_step_(longest_axis(kind.family()) / static_cast<double>(std::max(map_.rows(), map_.columns()))) {}

  /// The tops of the hills, then the best that differ clearly from all before.
  [[nodiscard]] BestLinkages<Solution> best() && {
    const auto wanted = static_cast<std::size_t>(options_.best);
    const std::vector<Candidate> feet =
        candidates_at(hill_tops(map_, filter_, options_.objective,
                                is_discrete_ ? map_.rows() * map_.columns() : std::max(3 * wanted, least_feet)));
    const std::vector<Candidate> hills = climbed_from(feet, coarse);
    size_ = design_size(hills);
    const std::vector<Candidate> tops = distinct(hills);
    // Another batch for those that driving did not confirm.
    auto next = tops.begin();
    while (next != tops.end() && goes_on(wanted)) {
      const auto last =
          next + std::min<std::ptrdiff_t>(tops.end() - next, static_cast<std::ptrdiff_t>(wanted - held_.size()));
      hold(distinct(climbed_from({next, last}, fine)));
      next = last;
    }
    if (!is_discrete_) add_clearly_different(wanted);
    std::sort(found_.begin(), found_.end(),
              [](const Found& a, const Found& b) { return better(a.candidate, b.candidate); });
    BestLinkages<Solution> best{{}, std::ssize(left_out_)};
    if (is_discrete_) best.beyond = tops.end() - next;
    for (Found& found : found_) best.linkages.push_back(std::move(found.linkage));
    return best;
  }

  /// Some of a front, as the map has them, in its order.
  [[nodiscard]] BestLinkages<Solution> along(const std::vector<ParetoCell>& front) && {
    std::vector<Candidate> candidates;
    for (const ParetoCell& cell : spread_over(front, static_cast<std::size_t>(options_.best)))
      if (const auto candidate = kind_.candidate(place_of({cell.row, cell.column}))) candidates.push_back(*candidate);
    hold(candidates);  // no two are the same design: it is left at 0 what they differ by
    BestLinkages<Solution> found{{}, std::ssize(left_out_)};
    for (Found& each : found_) found.linkages.push_back(std::move(each.linkage));
    return found;
  }

 private:
  // Two linkages count as different designs at this share of what designs of the task are long.
  static constexpr double different_design = 0.02, clearly_different_design = 0.15;

  // A climb that tells which hill is the better, and one that makes the numbers exact: along a ridge that is all but
  // level the top is lost in the noise of a search across it that is not far finer. Steps in shares of a step of the
  // map.
  struct Pace {
    double step, resolution, across;
  };
  static constexpr Pace coarse = {1, 1e-3, 1e-3}, fine = {0.1, 1e-6, 1e-7};
  static constexpr std::size_t least_feet = 30;    // whatever number is asked for, the first is the same
  static constexpr std::size_t max_left_out = 60;  // each has been driven as long as a drive may last

  [[nodiscard]] static bool better(const Candidate& a, const Candidate& b) {
    if (a.score != b.score) return a.score > b.score;
    return a.place.input != b.place.input ? a.place.input < b.place.input : a.place.output < b.place.output;
  }

  [[nodiscard]] bool goes_on(std::size_t wanted) const {
    return held_.size() < wanted && left_out_.size() < max_left_out && !progress_.is_cancelled();
  }
  // The map's numbers are single: a cell on the very edge of a requirement may fail here.
  [[nodiscard]] std::vector<Candidate> candidates_at(const std::vector<RankedCell>& cells) const {
    std::vector<Candidate> found;
    for (const RankedCell& cell : cells)
      if (const auto candidate = kind_.candidate(place_of(cell))) found.push_back(*candidate);
    return found;
  }
  [[nodiscard]] MapPoint place_of(const RankedCell& cell) const {
    return {map_.input_coordinates()[cell.row], map_.output_coordinates()[cell.column]};
  }

  /// The middle one: a measure of designs that depends on neither the body's frame nor the map.
  [[nodiscard]] double design_size(const std::vector<Candidate>& candidates) const {
    std::vector<double> sizes;
    for (const Candidate& candidate : candidates) sizes.push_back(kind_.size(candidate));
    const auto middle = sizes.begin() + std::ssize(sizes) / 2;
    std::nth_element(sizes.begin(), middle, sizes.end());
    return sizes.empty() ? 0 : *middle;
  }
  [[nodiscard]] bool differs(const Candidate& candidate, const std::vector<Candidate>& held, double least) const {
    return std::all_of(held.begin(), held.end(),
                       [&](const Candidate& other) { return kind_.distance(candidate, other) >= least; });
  }

  [[nodiscard]] Ascent<Candidate> ascent_of(const Pace& pace) const {
    Ascent<Candidate> ascent;
    ascent.first_step = pace.step * first_step_;
    ascent.resolution = pace.resolution;
    ascent.across = pace.across;
    return ascent;
  }
  template <class Score>
  [[nodiscard]] Ascent<Candidate> ascent_of(const Pace& pace, const Score& score) const {
    Ascent<Candidate> ascent = ascent_of(pace);
    ascent.score = score;
    return ascent;
  }

  /// The tops of their hills, driven from the better side, best first.
  [[nodiscard]] std::vector<Candidate> climbed_from(std::vector<Candidate> feet, const Pace& pace) const {
    parallel_for(feet.size(), options_.region.threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end && !progress_.is_cancelled(); ++i)
        feet[i] = kind_.from_better_side(climbed(kind_, feet[i], ascent_of(pace), progress_));
    });
    std::sort(feet.begin(), feet.end(), better);
    return feet;
  }

  /// What a design differs from others by at least. Pairs of a few dyads are each a design, however alike they are
  /// beside the largest of them.
  [[nodiscard]] double same_within(const Candidate& candidate) const {
    constexpr double rounding = 1e-9;
    return is_discrete_ ? rounding * kind_.size(candidate) : different_design * size_;
  }

  /// Sorted candidates without those that are the same design as a better one.
  [[nodiscard]] std::vector<Candidate> distinct(const std::vector<Candidate>& sorted) const {
    std::vector<Candidate> held;
    for (const Candidate& candidate : sorted)
      if (differs(candidate, held, same_within(candidate))) held.push_back(candidate);
    return held;
  }

  [[nodiscard]] bool is_new(const Candidate& candidate) const {
    return differs(candidate, held_, same_within(candidate)) && differs(candidate, left_out_, same_within(candidate));
  }

  /// Made, driven through the task, and held where driving confirms what they do.
  void hold(const std::vector<Candidate>& candidates) {
    std::vector<std::optional<Solution>> made(candidates.size());
    parallel_for(made.size(), options_.region.threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end && !progress_.is_cancelled(); ++i) made[i] = kind_.make(candidates[i].place);
    });
    for (std::size_t i = 0; i < made.size(); ++i) {
      if (!made[i] || !is_new(candidates[i])) continue;
      if (!kind_.is_confirmed(candidates[i], *made[i])) {
        left_out_.push_back(candidates[i]);
        continue;
      }
      made[i]->local_optimum = candidates[i].local_optimum;
      held_.push_back(candidates[i]);
      found_.push_back({candidates[i], *std::move(made[i])});
    }
  }

  /// While there are fewer than wanted: the best of what differs clearly from all that is held, climbed as far as it
  /// does.
  void add_clearly_different(std::size_t wanted) {
    if (held_.size() >= wanted) return;
    constexpr std::size_t tiles = 48;
    const double least = clearly_different_design * (held_.empty() ? size_ : design_size(held_));
    for (const RankedCell& cell : tile_bests(map_, filter_, options_.objective, tiles)) {
      if (!goes_on(wanted)) return;
      const auto foot = kind_.candidate(place_of(cell));
      if (!foot || !differs(*foot, held_, least) || !is_new(*foot)) continue;
      const auto score = [&](const Candidate& c) {
        return differs(c, held_, least) ? std::optional<double>(c.score) : std::nullopt;
      };
      Candidate end = kind_.from_better_side(climbed(kind_, *foot, ascent_of(coarse, score), progress_));
      end.local_optimum = false;
      hold({end});
    }
  }

  struct Found {
    Candidate candidate;
    Solution linkage;
  };

  const Kind& kind_;
  const RegionMap& map_;
  const SynthesisOptions& options_;
  const RequirementFilter& filter_;
  const Progress& progress_;
  bool is_discrete_;  ///< few dyads: every pair is listed
  double first_step_;
  double size_ = 0;              ///< design_size of the hills
  std::vector<Candidate> held_;  ///< as in found_
  std::vector<Found> found_;
  std::vector<Candidate> left_out_;  ///< driving did not confirm them
};

/// The best linkages of a solved region: its hill tops, climbed continuously in the two coordinates, then, while there
/// are fewer than wanted, the best of those that differ clearly from all before. Distinct, best first, each analysed
/// and driven through in user coordinates.
template <SearchedKind Kind>
[[nodiscard]] BestLinkages<typename Kind::Solution> best_linkages(const Kind& kind, const Findings& findings,
                                                                  const RequirementFilter& filter,
                                                                  const Progress& progress) {
  if (findings.options.best == 0 || findings.meeting_requirements == 0) return {};
  LinkageSearch<Kind> search(kind, findings, filter, progress);
  return findings.options.pareto ? std::move(search).along(findings.pareto) : std::move(search).best();
}

}  // namespace linkwright
