#include "planar/linkage_search.hpp"

#include <algorithm>

#include "planar/candidate.hpp"

namespace linkwright {
namespace {

// Two linkages count as different designs when a pivot differs by this share of the size of the design.
constexpr double different_design = 0.02;
constexpr double clearly_different_design = 0.15;

// Largest distance of a pivot between two linkages.
double farthest_pivot(const FourBar& a, const FourBar& b) {
  return std::max({std::abs(a.input_center - b.input_center), std::abs(a.input_circle - b.input_circle),
                   std::abs(a.output_center - b.output_center), std::abs(a.output_circle - b.output_circle)});
}

// The same, whichever side link is named first.
double distance(const FourBar& a, const FourBar& b) {
  return std::min(farthest_pivot(a, b), farthest_pivot(a, b.swapped()));
}

bool better(const Candidate& a, const Candidate& b) {
  if (a.score != b.score) return a.score > b.score;
  return a.place.input != b.place.input ? a.place.input < b.place.input : a.place.output < b.place.output;
}

/// Takes candidates as they are offered, as many as wanted, none twice.
class Choice {
 public:
  explicit Choice(std::size_t wanted) : wanted_(wanted) {}

  void offer(const Candidate& candidate, double least_difference) {
    if (full()) return;
    for (const Candidate& held : held_)
      if (distance(candidate.bars, held.bars) < least_difference) return;
    held_.push_back(candidate);
  }
  [[nodiscard]] bool full() const { return held_.size() >= wanted_; }
  [[nodiscard]] std::vector<Candidate> best_first() && {
    std::sort(held_.begin(), held_.end(), better);
    return std::move(held_);
  }

 private:
  std::size_t wanted_;
  std::vector<Candidate> held_;
};

// The map's numbers are single: a cell on the very edge of a requirement may fail here.
std::vector<Candidate> candidates_at(const RegionMap& map, const Judge& judge, const std::vector<RankedCell>& cells) {
  std::vector<Candidate> found;
  for (const RankedCell& cell : cells)
    if (const auto candidate =
            judge.candidate({map.input_coordinates()[cell.row], map.output_coordinates()[cell.column]}))
      found.push_back(*candidate);
  return found;
}

std::vector<Candidate> chosen(const Solution& solution, const Judge& judge, const RequirementFilter& filter,
                              const Progress& progress) {
  constexpr std::size_t tiles = 48;
  const RegionMap& map = solution.region;
  const Objective objective = solution.options.objective;
  const auto wanted = static_cast<std::size_t>(solution.options.best);
  const double first_step = judge.largest_coordinate() / static_cast<double>(std::max(map.rows(), map.columns()));

  std::vector<Candidate> tops;
  for (const Candidate& foot : candidates_at(map, judge, hill_tops(map, filter, objective, 3 * wanted))) {
    if (progress.is_cancelled()) return {};
    tops.push_back(judge.from_better_side(climbed(judge, foot, first_step)));
  }
  std::sort(tops.begin(), tops.end(), better);
  // With small rotations the characteristic length is far larger than the machine: then the user's limit is its size.
  const double size =
      std::min(1.0, solution.requirements.max_length.value_or(Requirements::unlimited) / solution.given.frame().scale);
  Choice choice(wanted);
  for (const Candidate& top : tops) choice.offer(top, different_design * size);
  if (!choice.full())
    for (const Candidate& other : candidates_at(map, judge, tile_bests(map, filter, objective, tiles)))
      choice.offer(judge.from_better_side(other), clearly_different_design * size);
  return std::move(choice).best_first();
}

}  // namespace

std::vector<FourBarSolution> best_linkages(const Solution& solution, const RequirementFilter& filter,
                                           const Progress& progress) {
  if (solution.options.best == 0 || solution.meeting_requirements == 0) return {};
  const LinkageFamily& family = *solution.given.family;
  const Judge judge(family, solution.requirements, solution.options.objective, solution.options.window);
  std::vector<FourBarSolution> linkages;
  for (const Candidate& candidate : chosen(solution, judge, filter, progress)) {
    if (progress.is_cancelled()) return {};
    auto found = make_four_bar(solution.given, candidate.place, solution.requirements.respect_direction, true);
    if (!found) continue;
    found->local_optimum = candidate.local_optimum;
    linkages.push_back(*found);
  }
  return linkages;
}

}  // namespace linkwright
