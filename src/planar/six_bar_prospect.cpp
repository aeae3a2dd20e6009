#include "planar/six_bar_prospect.hpp"

#include <algorithm>

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
  return score_of(objective, rating.versine(), rating.shape.link_ratio, rating.shape.longest);
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

}  // namespace linkwright
