#include "region_scale.hpp"

#include <algorithm>
#include <cmath>

namespace linkwright {
namespace {

constexpr double gap = 4;  // px between blocks

std::size_t branch_of(const std::vector<CurveBranch>& branches, double tau) {
  std::size_t branch = 0;
  while (branch + 1 < branches.size() && tau >= branches[branch].to) ++branch;
  return branch;
}

bool passes_infinity(Homogeneous from, Homogeneous to) {
  if (is_at_infinity(from) && is_at_infinity(to)) return false;  // a branch that lies there, with w rounded
  return (dot(from, to) < 0 ? -1 : 1) * from.w * to.w < 0;
}

}  // namespace

RegionScale::RegionScale(const std::vector<CurveBranch>& branches, std::span<const double> coordinates,
                         std::span<const Dyad> dyads, double length)
    : length_(length), coordinates_(coordinates.begin(), coordinates.end()), dyads_(dyads.begin(), dyads.end()) {
  std::size_t last_branch = branches.size();
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    const std::size_t branch = branch_of(branches, coordinates[i]);
    if (blocks_.empty() || branch != last_branch) {
      blocks_.push_back({branches.empty() ? "" : branches[branch].name, i, i, 0, 0});
    }
    blocks_.back().last = i + 1;
    last_branch = branch;
  }
  if (blocks_.empty()) return;
  const double step =
      (length - gap * static_cast<double>(blocks_.size() - 1)) / static_cast<double>(coordinates.size());
  double px = 0;
  for (Block& block : blocks_) {
    block.from_px = px;
    block.to_px = px + step * static_cast<double>(block.last - block.first);
    px = block.to_px + gap;
  }
}

int RegionScale::sample_at(double px) const {
  for (const Block& block : blocks_) {
    if (px < block.from_px || px >= block.to_px) continue;
    const double share = (px - block.from_px) / (block.to_px - block.from_px);
    const auto count = static_cast<double>(block.last - block.first);
    return static_cast<int>(block.first) + std::min(static_cast<int>(share * count), static_cast<int>(count) - 1);
  }
  return -1;
}

/// px of the middle of a sample's cell; `sample` may lie between two.
double RegionScale::middle_of(const Block& block, double sample) const {
  const auto count = static_cast<double>(block.last - block.first);
  const double share = (sample - static_cast<double>(block.first) + 0.5) / count;
  return block.from_px + std::clamp(share, 0.0, 1.0) * (block.to_px - block.from_px);
}

std::optional<double> RegionScale::position(double tau) const {
  constexpr double reach = 1.5;  // steps beyond the first and last sample: steps even in length are not even in τ
  for (const Block& block : blocks_) {
    const auto begin = coordinates_.begin() + static_cast<std::ptrdiff_t>(block.first);
    const auto end = coordinates_.begin() + static_cast<std::ptrdiff_t>(block.last);
    if (end - begin == 1 && std::abs(tau - *begin) <= 0.5) return middle_of(block, static_cast<double>(block.first));
    if (end - begin < 2) continue;
    auto upper = std::upper_bound(begin, end, tau);
    upper = std::clamp(upper, begin + 1, end - 1);
    const auto lower = upper - 1;
    const double share = (tau - *lower) / (*upper - *lower);
    if (share > -reach && share < 1 + reach)
      return middle_of(block, static_cast<double>(lower - coordinates_.begin()) + share);
  }
  return std::nullopt;
}

std::vector<double> RegionScale::crossings_of_infinity() const {
  std::vector<double> places;
  if (dyads_.empty()) return places;
  for (const Block& block : blocks_) {
    for (std::size_t i = block.first; i + 1 < block.last; ++i) {
      const Dyad &from = dyads_[i], &to = dyads_[i + 1];
      const bool crosses = passes_infinity(from.center, to.center) || passes_infinity(from.circle, to.circle);
      if (crosses) places.push_back(middle_of(block, static_cast<double>(i) + 0.5));
    }
  }
  return places;
}

}  // namespace linkwright
