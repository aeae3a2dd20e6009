#include "planar/six_bar_prospect.hpp"

#include <algorithm>

#include "linkwright/planar/four_bar_map.hpp"

namespace linkwright {
namespace {

double farthest_hinge(const SixBar& a, const SixBar& b) {
  double farthest = 0;
  for (std::size_t j = 0; j < SixBar::joint_count; ++j)
    farthest = std::max(farthest, std::abs(a.joints[j].point - b.joints[j].point));
  return farthest;
}

}  // namespace

double score_of(Objective objective, const SixBarRating& rating) {
  return rank_of(objective, planar_measures).score(rating.cell());
}

bool is_better(const SixBarProspect& a, const SixBarProspect& b) {
  if (a.score != b.score) return a.score > b.score;
  return a.tau < b.tau;
}

std::vector<SixBarProspect> distinct(const std::vector<SixBarProspect>& sorted, std::size_t most, double least) {
  std::vector<SixBarProspect> kept;
  for (const SixBarProspect& prospect : sorted) {
    if (kept.size() >= most) break;
    const bool alike = std::any_of(kept.begin(), kept.end(), [&](const SixBarProspect& held) {
      return farthest_hinge(held.member.six_bar, prospect.member.six_bar) < least;
    });
    if (!alike) kept.push_back(prospect);
  }
  return kept;
}

std::vector<SixBarSolution> driven_exactly(const std::vector<SixBarProspect>& prospects, const SixBarTask& task,
                                           const SixBarRow& row, const Requirements& wanted,
                                           const SixBarChoice& choice) {
  std::vector<SixBarSolution> solutions;
  for (const SixBarProspect& prospect : prospects) {
    SixBarSolution exact = solution_of(task.poses, prospect.chain, row, prospect.member);
    if (!meets(with_defaults(wanted, prospect.chain), exact.member.six_bar, exact.rating)) continue;
    exact.local_optimum = prospect.local_optimum;
    solutions.push_back(std::move(exact));
  }
  if (is_of_tolerances(choice.objective)) return solutions;
  std::sort(solutions.begin(), solutions.end(), [&](const SixBarSolution& a, const SixBarSolution& b) {
    const double one = score_of(choice.objective, a.rating), other = score_of(choice.objective, b.rating);
    return one != other ? one > other : a.member.coordinates < b.member.coordinates;
  });
  return solutions;
}

}  // namespace linkwright
