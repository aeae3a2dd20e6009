#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "linkwright/core/parallel.hpp"
#include "linkwright/region/best_cells.hpp"
#include "linkwright/synthesis/answer.hpp"
#include "region/climb.hpp"
#include "region/window_look.hpp"
#include "region_count.hpp"

namespace linkwright {

/// What is made of the places that a search finds.
template <class Solution>
struct Making {
  /// Analysed and driven through in the user's coordinates; nothing where rounding keeps it from being any.
  std::function<std::optional<Solution>(MapPoint place)> make;
  /// It does in the user's coordinates what it was held for, and driving confirms it.
  std::function<bool(const Cell& held_for, const Solution& made)> is_confirmed;
};

template <class Solution>
struct BestLinkages {
  std::vector<Solution> linkages;
  std::int64_t left_out = 0;  ///< driving did not confirm them
  std::int64_t beyond = 0;    ///< of a few dyads: pairs that meet the requirements, beyond as many as are listed
};

/// Looks for the best linkages of a map.
template <class Solution>
class LinkageSearch {
 public:
  /// Refers to all of them; where it begins is counted.
  LinkageSearch(const LinkageFamily& family, const Making<Solution>& making, const Findings& findings,
                const CountedRegion& counted, const Progress& progress)
      : known_(family.known_places()),
        evaluator_(family, findings.requirements, findings.options.objective, counted.window, findings.added),
        making_(making),
        maps_(counted.maps(findings.region)),
        options_(findings.options),
        progress_(progress),
        is_discrete_(family.axis(Side::input).is_discrete() && family.axis(Side::output).is_discrete()) {}

  /// The tops of the hills, then the best that differ clearly from all before.
  [[nodiscard]] BestLinkages<Solution> best() && {
    const auto wanted = static_cast<std::size_t>(options_.best);
    const RegionMap& map = *maps_.front().map;
    const std::size_t most = is_discrete_ ? map.rows() * map.columns() : std::max(3 * wanted, least_feet);
    const std::vector<Climber> hills = climbed_from(feet(most), coarse);
    size_ = design_size(candidates_of(hills));
    const std::vector<Climber> tops = distinct(hills);
    // Another batch for those that driving did not confirm.
    auto next = tops.begin();
    while (next != tops.end() && goes_on(wanted)) {
      const auto last =
          next + std::min<std::ptrdiff_t>(tops.end() - next, static_cast<std::ptrdiff_t>(wanted - held_.size()));
      hold(candidates_of(distinct(climbed_from({next, last}, fine))));
      next = last;
    }
    if (!is_discrete_) add_clearly_different(wanted);
    std::sort(found_.begin(), found_.end(),
              [](const Found& a, const Found& b) { return is_better_candidate(a.candidate, b.candidate); });
    BestLinkages<Solution> best{{}, std::ssize(left_out_)};
    if (is_discrete_) best.beyond = tops.end() - next;
    for (Found& found : found_) best.linkages.push_back(std::move(found.linkage));
    return best;
  }

  /// Some of a front, as the map has them, in its order.
  [[nodiscard]] BestLinkages<Solution> along(const std::vector<ParetoCell>& front) && {
    std::vector<Candidate> candidates;
    for (const ParetoCell& cell : spread_over(front, static_cast<std::size_t>(options_.best)))
      if (const auto candidate = evaluator_.candidate(place_of(*maps_.front().map, {cell.row, cell.column})))
        candidates.push_back(*candidate);
    hold(candidates);  // no two are the same design: it is left at 0 what they differ by
    BestLinkages<Solution> found{{}, std::ssize(left_out_)};
    for (Found& each : found_) found.linkages.push_back(std::move(each.linkage));
    return found;
  }

 private:
  // A share as different_design.
  static constexpr double clearly_different_design = 0.15;

  // A climb that tells which hill is the better, and one that makes the numbers exact: along a ridge that is all but
  // level the top is lost in the noise of a search across it that is not far finer. Steps in shares of a step of the
  // map.
  struct Pace {
    double step, resolution, across;
  };
  static constexpr Pace coarse = {1, 1e-3, 1e-3}, fine = {0.1, 1e-6, 1e-7};
  // Where linkages are known already, whose places take long.
  static constexpr int few_evaluations = 8;
  static constexpr double rough = 2e-2;
  static constexpr std::size_t few_feet = 8;
  static constexpr std::size_t least_feet = 30;    // whatever number is asked for, the first is the same
  static constexpr std::size_t max_left_out = 60;  // each has been driven as long as a drive may last

  [[nodiscard]] bool goes_on(std::size_t wanted) const {
    return held_.size() < wanted && left_out_.size() < max_left_out && !progress_.is_cancelled();
  }

  /// A candidate, and how far apart the coordinates of the map are on which it was found.
  struct Climber {
    Candidate candidate;
    MapPoint step;
  };
  [[nodiscard]] static std::vector<Candidate> candidates_of(const std::vector<Climber>& climbers) {
    std::vector<Candidate> candidates;
    for (const Climber& climber : climbers) candidates.push_back(climber.candidate);
    return candidates;
  }

  /// Of the map of the findings up to `most`, of all that look closer together as many again.
  [[nodiscard]] std::vector<Climber> feet(std::size_t most) const {
    if (!known_.empty()) most = std::min(most, few_feet);
    std::vector<Climber> found = feet_of(maps_.front(), most), closer;
    for (std::size_t i = 1; i < maps_.size(); ++i) {
      const std::vector<Climber> of_map = feet_of(maps_[i], most);
      closer.insert(closer.end(), of_map.begin(), of_map.end());
    }
    std::sort(closer.begin(), closer.end(), ranks_first);
    if (closer.size() > most) closer.resize(most);
    found.insert(found.end(), closer.begin(), closer.end());
    for (const MapPoint place : known_)
      if (const auto candidate = evaluator_.candidate(place)) found.push_back({*candidate, maps_.front().step});
    return found;
  }
  // The map's numbers are single: a cell on the very edge of a requirement may fail here.
  [[nodiscard]] std::vector<Climber> feet_of(const SearchMap& map, std::size_t most) const {
    std::vector<Climber> found;
    for (const RankedCell& cell : hill_tops(*map.map, *map.filter, options_.objective, most))
      if (const auto candidate = evaluator_.candidate(place_of(*map.map, cell)))
        found.push_back({*candidate, map.step});
    return found;
  }
  [[nodiscard]] static MapPoint place_of(const RegionMap& map, const RankedCell& cell) {
    return {map.input_coordinates()[cell.row], map.output_coordinates()[cell.column]};
  }
  [[nodiscard]] static bool ranks_first(const Climber& a, const Climber& b) {
    return is_better_candidate(a.candidate, b.candidate);
  }

  /// The middle one: a measure of designs that depends on neither the body's frame nor the map.
  [[nodiscard]] double design_size(const std::vector<Candidate>& candidates) const {
    std::vector<double> sizes;
    for (const Candidate& candidate : candidates) sizes.push_back(evaluator_.size(candidate));
    const auto middle = sizes.begin() + std::ssize(sizes) / 2;
    std::nth_element(sizes.begin(), middle, sizes.end());
    return sizes.empty() ? 0 : *middle;
  }
  [[nodiscard]] bool differs(const Candidate& candidate, const std::vector<Candidate>& held, double least) const {
    return std::all_of(held.begin(), held.end(),
                       [&](const Candidate& other) { return evaluator_.distance(candidate, other) >= least; });
  }

  [[nodiscard]] Ascent ascent_of(const Pace& pace, MapPoint step) const {
    Ascent ascent;
    ascent.first_step = {pace.step * step.input, pace.step * step.output};
    ascent.resolution = pace.resolution;
    ascent.across = pace.across;
    if (!known_.empty()) {
      ascent.max_evaluations = few_evaluations;
      ascent.resolution = std::max(pace.resolution, rough);
    }
    return ascent;
  }

  /// The top of its hill, driven from the better side.
  [[nodiscard]] Climber climbed_to_top(const Climber& foot, const Ascent& ascent) const {
    const Candidate top = climbed(evaluator_, foot.candidate, ascent, progress_);
    Climber end{evaluator_.from_better_side(top), foot.step};
    const bool swapped = end.candidate.cell.place.input != top.cell.place.input;
    if (swapped) std::swap(end.step.input, end.step.output);
    return end;
  }

  /// The tops of their hills, best first.
  [[nodiscard]] std::vector<Climber> climbed_from(std::vector<Climber> feet, const Pace& pace) const {
    parallel_for(feet.size(), options_.region.threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end && !progress_.is_cancelled(); ++i)
        feet[i] = climbed_to_top(feet[i], ascent_of(pace, feet[i].step));
    });
    std::sort(feet.begin(), feet.end(), ranks_first);
    return feet;
  }

  /// What a design differs from others by at least.
  [[nodiscard]] double same_within(const Candidate& candidate) const {
    return evaluator_.same_within(candidate, size_);
  }

  /// Sorted, without those that are the same design as a better one.
  [[nodiscard]] std::vector<Climber> distinct(const std::vector<Climber>& sorted) const {
    std::vector<Climber> kept;
    std::vector<Candidate> held;
    for (const Climber& climber : sorted) {
      if (!differs(climber.candidate, held, same_within(climber.candidate))) continue;
      held.push_back(climber.candidate);
      kept.push_back(climber);
    }
    return kept;
  }

  [[nodiscard]] bool is_new(const Candidate& candidate) const {
    return differs(candidate, held_, same_within(candidate)) && differs(candidate, left_out_, same_within(candidate));
  }

  /// Made, driven through the task, and held where driving confirms what they do.
  void hold(const std::vector<Candidate>& candidates) {
    std::vector<std::optional<Solution>> made(candidates.size());
    parallel_for(made.size(), options_.region.threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end && !progress_.is_cancelled(); ++i)
        made[i] = making_.make(candidates[i].cell.place);
    });
    for (std::size_t i = 0; i < made.size(); ++i) {
      if (!made[i] || !is_new(candidates[i])) continue;
      if (!making_.is_confirmed(candidates[i].cell, *made[i])) {
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
    const auto score = [&](const Candidate& c) {
      return differs(c, held_, least) ? std::optional<double>(c.score) : std::nullopt;
    };
    for (const SearchMap& map : maps_)
      for (const RankedCell& cell : tile_bests(*map.map, *map.filter, options_.objective, tiles)) {
        if (!goes_on(wanted)) return;
        const auto foot = evaluator_.candidate(place_of(*map.map, cell));
        if (!foot || !differs(*foot, held_, least) || !is_new(*foot)) continue;
        Ascent ascent = ascent_of(coarse, map.step);
        ascent.score = score;
        Candidate end = climbed_to_top({*foot, map.step}, ascent).candidate;
        end.local_optimum = false;
        hold({end});
      }
  }

  struct Found {
    Candidate candidate;
    Solution linkage;
  };

  std::vector<MapPoint> known_;  ///< LinkageFamily::known_places()
  Evaluator evaluator_;
  const Making<Solution>& making_;
  std::vector<SearchMap> maps_;
  const SynthesisOptions& options_;
  const Progress& progress_;
  bool is_discrete_;             ///< few dyads: every pair is listed
  double size_ = 0;              ///< design_size of the hills
  std::vector<Candidate> held_;  ///< as in found_
  std::vector<Found> found_;
  std::vector<Candidate> left_out_;  ///< driving did not confirm them
};

/// The best linkages of a solved region: its hill tops, and those of maps that look closer (`maps`, its own first),
/// climbed continuously in the two coordinates, then, while there are fewer than wanted, the best of those that differ
/// clearly from all before. Distinct, best first, each analysed and driven through in user coordinates.
template <class Solution>
[[nodiscard]] BestLinkages<Solution> best_linkages(const LinkageFamily& family, const Making<Solution>& making,
                                                   const Findings& findings, const CountedRegion& counted,
                                                   const Progress& progress) {
  if (findings.options.best == 0) return {};
  const bool found_between = findings.meeting_requirements == 0;  // the map's own front is empty
  LinkageSearch<Solution> search(family, making, findings, counted, progress);
  return findings.options.pareto && !found_between ? std::move(search).along(findings.pareto)
                                                   : std::move(search).best();
}

}  // namespace linkwright
