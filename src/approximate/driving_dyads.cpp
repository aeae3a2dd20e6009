#include <algorithm>
#include <cmath>

#include "approximate/dyad_scan.hpp"
#include "approximate/dyad_scan_kernel.hpp"

namespace linkwright {
namespace {

// The sum of the lengths over the largest distance, and their difference over the least, where the target does not
// tell.
constexpr std::array<double, 6> free_sums = {1.01, 1.06, 1.2, 1.5, 2.2, 4};
constexpr std::array<double, 5> free_differences = {0, 0.35, 0.65, 0.88, 0.985};
// The points are not the whole curve: its extremes lie a little beyond theirs.
constexpr std::array<double, 3> beyond_extremes = {0, 0.006, 0.03};
// Two local extremes that differ by less than this share of the range may both be where the dyad is stretched out.
constexpr double equal_extremes = 0.12;

// The points at which sides change, and the two that come next to be the first on the other side.
using Flips = std::vector<std::size_t>;

class DyadList {
 public:
  DyadList(const ScaledTarget& target, std::span<const Point> chosen, Point pivot)
      : closed_(target.closed), distances_(chosen.size()) {
    std::transform(chosen.begin(), chosen.end(), distances_.begin(),
                   [&](Point p) { return std::sqrt(std::norm(p - pivot)); });
    const auto nearer = [&](Point a, Point b) { return std::norm(a - pivot) < std::norm(b - pivot); };
    const auto [near, far] = std::minmax_element(target.points.begin(), target.points.end(), nearer);
    least_ = std::abs(*near - pivot);
    most_ = std::abs(*far - pivot);
  }

  std::vector<DrivingDyad> all() {
    add_free(SidePattern::none, {}, free_sums, free_differences);
    const Flips far = extremes(1), near = extremes(-1);
    const std::array<double, 1> told = {1};
    if (!closed_) {
      add_free(SidePattern::far, {far[0]}, told, free_differences);
      add_free(SidePattern::near, {near[0]}, free_sums, told);
    }
    for (const double beyond : beyond_extremes) {
      const std::array<double, 1> sum = {1 + beyond}, difference = {1 - beyond};
      add_free(SidePattern::far_and_near, {far[0], near[0]}, sum, difference);
    }
    if (far.size() > 1) add_free(SidePattern::twice_far, {far[0], far[1]}, told, free_differences);
    if (near.size() > 1) add_free(SidePattern::twice_near, {near[0], near[1]}, free_sums, told);
    if (far.size() > 1 && near.size() > 1)
      add_free(SidePattern::twice_both, {far[0], far[1], near[0], near[1]}, told, told);
    return std::move(dyads_);
  }

 private:
  // The farthest (sign 1) or nearest point, and the second local extreme if it is about as far.
  [[nodiscard]] Flips extremes(int sign) const {
    const std::size_t n = distances_.size();
    const auto height = [&](std::size_t j) { return sign * distances_[j % n]; };
    Flips found;
    for (std::size_t j = 0; j < n; ++j) {
      const bool before = (!closed_ && j == 0) || height(j) > height(j + n - 1);
      const bool after = (!closed_ && j + 1 == n) || height(j) >= height(j + 1);
      if (before && after) found.push_back(j);
    }
    if (found.empty()) found.push_back(0);
    std::stable_sort(found.begin(), found.end(), [&](std::size_t a, std::size_t b) { return height(a) > height(b); });
    const bool has_equal = found.size() > 1 && height(found[0]) - height(found[1]) < equal_extremes * (most_ - least_);
    found.resize(has_equal ? 2 : 1);
    return found;
  }

  // Sides change before or after each of the points, which themselves are on either; and either side begins.
  void add_free(SidePattern pattern, const Flips& flips, std::span<const double> sums,
                std::span<const double> differences) {
    const std::size_t ways = std::size_t{1} << flips.size();
    for (std::size_t way = 0; way < ways; ++way) {
      const std::uint32_t right = sides(flips, way);
      for (const double sum : sums) {
        for (const double difference : differences) {
          const double s = sum * most_, d = difference * least_;
          for (const std::uint32_t side : {right, ~right}) add({(s - d) / 2, (s + d) / 2, side, pattern});
        }
      }
    }
  }

  [[nodiscard]] std::uint32_t sides(const Flips& flips, std::size_t way) const {
    std::uint32_t right = 0;
    for (std::size_t k = 0; k < flips.size(); ++k) {
      const std::size_t first = flips[k] + (way >> k & 1);
      if (first < 32) right ^= ~std::uint32_t{0} << first;
    }
    return right;
  }

  void add(const DrivingDyad& dyad) {
    if (dyads_.size() < DyadBlock::size && dyad.input > 0) dyads_.push_back(dyad);
  }

  bool closed_;
  std::vector<double> distances_;
  double least_ = 0, most_ = 0;
  std::vector<DrivingDyad> dyads_;
};

}  // namespace

std::vector<DrivingDyad> driving_dyads(const ScaledTarget& target, std::span<const Point> chosen, Point pivot) {
  return DyadList(target, chosen, pivot).all();
}

}  // namespace linkwright
