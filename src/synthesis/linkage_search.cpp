#include "linkage_search.hpp"

#include <algorithm>

#include "linkwright/core/parallel.hpp"
#include "planar/candidate.hpp"

namespace linkwright {
namespace {

// Two linkages count as different designs when a pivot differs by this share of what designs of the task are long.
constexpr double different_design = 0.02;
constexpr double clearly_different_design = 0.15;

// A climb that tells which hill is the better, and one that makes the numbers exact: along a ridge that is all but
// level the top is lost in the noise of a search across it that is not far finer. Steps in shares of a step of the map.
struct Pace {
  double step, resolution, across;
};
constexpr Pace coarse = {1, 1e-3, 1e-3}, fine = {0.1, 1e-6, 1e-7};
constexpr std::size_t least_feet = 30;    // whatever number is asked for, the first is the same
constexpr std::size_t max_left_out = 60;  // each has been driven as long as a drive may last

// Largest distance of a pivot between two linkages.
double farthest_pivot(const FourBar& a, const FourBar& b) {
  return std::max({std::abs(a.input_center - b.input_center), std::abs(a.input_circle - b.input_circle),
                   std::abs(a.output_center - b.output_center), std::abs(a.output_circle - b.output_circle)});
}

// The same, whichever grounded link is named first.
double distance(const FourBar& a, const FourBar& b) {
  return std::min(farthest_pivot(a, b), farthest_pivot(a, b.swapped()));
}

// The middle one of their longest links: a measure of designs that depends on neither the body's frame nor the map.
double design_size(const std::vector<Candidate>& candidates) {
  std::vector<double> longest;
  for (const Candidate& candidate : candidates) longest.push_back(candidate.bars.lengths().longest());
  const auto middle = longest.begin() + std::ssize(longest) / 2;
  std::nth_element(longest.begin(), middle, longest.end());
  return longest.empty() ? 0 : *middle;
}

bool better(const Candidate& a, const Candidate& b) {
  if (a.score != b.score) return a.score > b.score;
  return a.place.input != b.place.input ? a.place.input < b.place.input : a.place.output < b.place.output;
}

bool differs(const Candidate& candidate, const std::vector<Candidate>& held, double least) {
  return std::all_of(held.begin(), held.end(),
                     [&](const Candidate& other) { return distance(candidate.bars, other.bars) >= least; });
}

/// Looks for the best linkages of a map.
class LinkageSearch {
 public:
  LinkageSearch(const FourBarAnswer& answer, const RequirementFilter& filter, const Progress& progress)
      : answer_(answer),
        map_(answer.region),
        options_(answer.options),
        filter_(filter),
        progress_(progress),
        evaluator_(*answer.given.family, answer.requirements, options_.objective, options_.window),
        first_step_(evaluator_.largest_coordinate() / static_cast<double>(std::max(map_.rows(), map_.columns()))) {}

  /// The tops of the hills, then the best that differ clearly from all before.
  [[nodiscard]] BestLinkages best() && {
    const auto wanted = static_cast<std::size_t>(options_.best);
    const std::vector<Candidate> feet =
        candidates_at(hill_tops(map_, filter_, options_.objective, std::max(3 * wanted, least_feet)));
    const std::vector<Candidate> hills = climbed_from(feet, coarse);
    size_ = design_size(hills);
    const std::vector<Candidate> tops = distinct(hills);
    // Another batch for those that driving did not confirm.
    for (auto next = tops.begin(); next != tops.end() && goes_on(wanted);) {
      const auto last =
          next + std::min<std::ptrdiff_t>(tops.end() - next, static_cast<std::ptrdiff_t>(wanted - held_.size()));
      hold(distinct(climbed_from({next, last}, fine)));
      next = last;
    }
    add_clearly_different(wanted);
    std::sort(found_.begin(), found_.end(),
              [](const Found& a, const Found& b) { return better(a.candidate, b.candidate); });
    BestLinkages best{{}, std::ssize(left_out_)};
    for (Found& found : found_) best.linkages.push_back(std::move(found.linkage));
    return best;
  }

 private:
  [[nodiscard]] bool goes_on(std::size_t wanted) const {
    return held_.size() < wanted && left_out_.size() < max_left_out && !progress_.is_cancelled();
  }
  // The map's numbers are single: a cell on the very edge of a requirement may fail here.
  [[nodiscard]] std::vector<Candidate> candidates_at(const std::vector<RankedCell>& cells) const {
    std::vector<Candidate> found;
    for (const RankedCell& cell : cells)
      if (const auto candidate = evaluator_.candidate(place_of(cell))) found.push_back(*candidate);
    return found;
  }
  [[nodiscard]] MapPoint place_of(const RankedCell& cell) const {
    return {map_.input_coordinates()[cell.row], map_.output_coordinates()[cell.column]};
  }

  [[nodiscard]] Ascent ascent_of(const Pace& pace) const {
    Ascent ascent;
    ascent.first_step = pace.step * first_step_;
    ascent.resolution = pace.resolution;
    ascent.across = pace.across;
    return ascent;
  }
  template <class Score>
  [[nodiscard]] Ascent ascent_of(const Pace& pace, const Score& score) const {
    Ascent ascent = ascent_of(pace);
    ascent.score = score;
    return ascent;
  }

  /// The tops of their hills, driven from the better side, best first.
  [[nodiscard]] std::vector<Candidate> climbed_from(std::vector<Candidate> feet, const Pace& pace) const {
    parallel_for(feet.size(), options_.region.threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end && !progress_.is_cancelled(); ++i)
        feet[i] = evaluator_.from_better_side(climbed(evaluator_, feet[i], ascent_of(pace), progress_));
    });
    std::sort(feet.begin(), feet.end(), better);
    return feet;
  }

  /// Sorted candidates without those that are the same design as a better one.
  [[nodiscard]] std::vector<Candidate> distinct(const std::vector<Candidate>& sorted) const {
    std::vector<Candidate> held;
    for (const Candidate& candidate : sorted)
      if (differs(candidate, held, different_design * size_)) held.push_back(candidate);
    return held;
  }

  [[nodiscard]] bool is_new(const Candidate& candidate) const {
    return differs(candidate, held_, different_design * size_) &&
           differs(candidate, left_out_, different_design * size_);
  }

  /// Made, driven through the task, and held where driving confirms what they do.
  void hold(const std::vector<Candidate>& candidates) {
    std::vector<std::optional<FourBarSolution>> made(candidates.size());
    parallel_for(made.size(), options_.region.threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end && !progress_.is_cancelled(); ++i)
        made[i] = make_four_bar(answer_.given, candidates[i].place, answer_.requirements.respect_direction, true);
    });
    for (std::size_t i = 0; i < made.size(); ++i) {
      if (!made[i] || !is_new(candidates[i])) continue;
      const DefectReport &here = candidates[i].report, &there = made[i]->report;
      const bool same = here.type == there.type && here.defects == there.defects;  // in the user's coordinates
      if (!same || is_unconfirmed(*made[i])) {
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
      const auto foot = evaluator_.candidate(place_of(cell));
      if (!foot || !differs(*foot, held_, least) || !is_new(*foot)) continue;
      const auto score = [&](const Candidate& c) {
        return differs(c, held_, least) ? std::optional(c.score) : std::nullopt;
      };
      Candidate end = evaluator_.from_better_side(climbed(evaluator_, *foot, ascent_of(coarse, score), progress_));
      end.local_optimum = false;
      hold({end});
    }
  }

  struct Found {
    Candidate candidate;
    FourBarSolution linkage;
  };

  const FourBarAnswer& answer_;
  const RegionMap& map_;
  const SynthesisOptions& options_;
  const RequirementFilter& filter_;
  const Progress& progress_;
  CellEvaluator evaluator_;
  double first_step_;
  double size_ = 0;              ///< design_size of the hills
  std::vector<Candidate> held_;  ///< as in found_
  std::vector<Found> found_;
  std::vector<Candidate> left_out_;  ///< driving did not confirm them
};

}  // namespace

BestLinkages best_linkages(const FourBarAnswer& answer, const RequirementFilter& filter, const Progress& progress) {
  if (answer.options.best == 0 || answer.meeting_requirements == 0) return {};
  return LinkageSearch(answer, filter, progress).best();
}

}  // namespace linkwright
