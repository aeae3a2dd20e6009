#include <algorithm>
#include <cmath>

#include "approximate/dyad_scan.hpp"
#include "approximate/dyad_scan_kernel.hpp"

namespace linkwright {
namespace {

constexpr DyadGrid usual_grid = {{1.01, 1.06, 1.2, 1.5, 2.2, 4}, {0, 0.35, 0.65, 0.88, 0.985}, {0, 0.006, 0.03}};
// Two local extremes that differ by less than this share of the range may both be where the dyad is stretched out.
constexpr double equal_extremes = 0.12;

// The points at which sides change, and the two that come next to be the first on the other side.
using Flips = std::vector<std::size_t>;

class DyadList {
 public:
  DyadList(const ScaledTarget& target, std::span<const Point> chosen, Point pivot, const DyadGrid& grid)
      : closed_(target.closed), grid_(grid), distances_(chosen.size()) {
    std::transform(chosen.begin(), chosen.end(), distances_.begin(),
                   [&](Point p) { return std::sqrt(std::norm(p - pivot)); });
    const auto nearer = [&](Point a, Point b) { return std::norm(a - pivot) < std::norm(b - pivot); };
    const auto [near, far] = std::minmax_element(target.points.begin(), target.points.end(), nearer);
    least_ = std::abs(*near - pivot);
    most_ = std::abs(*far - pivot);
  }

  std::vector<DrivingDyad> all() {
    // Near a circle dyads of any lengths come about as near, and lead to different linkages.
    for (const double& sum : grid_.sums) add_group({}, {&sum, 1}, grid_.differences);
    const Flips far = extremes(1), near = extremes(-1);
    const std::array<double, 1> told = {1};
    if (!closed_) {
      add_group({far[0]}, told, grid_.differences);
      add_group({near[0]}, grid_.sums, told);
    }
    for (const double beyond : grid_.beyond) {
      const std::array<double, 1> sum = {1 + beyond}, difference = {1 - beyond};
      add({far[0], near[0]}, sum, difference);
    }
    ++group_;
    if (far.size() > 1) add_group({far[0], far[1]}, told, grid_.differences);
    if (near.size() > 1) add_group({near[0], near[1]}, grid_.sums, told);
    if (far.size() > 1 && near.size() > 1) add_group({far[0], far[1], near[0], near[1]}, told, told);
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

  void add_group(const Flips& flips, std::span<const double> sums, std::span<const double> differences) {
    add(flips, sums, differences);
    ++group_;
  }

  // Sides change before or after each of the points, which themselves are on either; and either side begins.
  void add(const Flips& flips, std::span<const double> sums, std::span<const double> differences) {
    const std::size_t ways = std::size_t{1} << flips.size();
    for (std::size_t way = 0; way < ways; ++way) {
      const std::uint32_t right = sides(flips, way);
      for (const double sum : sums) {
        for (const double difference : differences) {
          const double s = sum * most_, d = difference * least_;
          for (const std::uint32_t side : {right, ~right}) add({(s - d) / 2, (s + d) / 2, side, group_});
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
  const DyadGrid& grid_;
  std::vector<double> distances_;
  double least_ = 0, most_ = 0;
  std::size_t group_ = 0;
  std::vector<DrivingDyad> dyads_;
};

}  // namespace

DyadGrid dyad_grid(std::size_t round) {
  DyadGrid grid = usual_grid;
  if (round == 0) return grid;
  // Each distance from 1 between its root of a half and of 2 times itself, by rising multiples of irrational numbers.
  constexpr double golden = 0.6180339887498949, silver = 0.4142135623730951;
  const auto factor = [&](double irrational) {
    const double share = static_cast<double>(round) * irrational;
    return std::exp2(share - std::floor(share) - 0.5);
  };
  const double of_sums = factor(golden), of_differences = factor(silver);
  for (double& sum : grid.sums) sum = 1 + of_sums * (sum - 1);
  for (double& difference : grid.differences) difference = std::max(0.0, 1 - of_differences * (1 - difference));
  for (double& beyond : grid.beyond) beyond *= of_sums;
  return grid;
}

std::vector<DrivingDyad> driving_dyads(const ScaledTarget& target, std::span<const Point> chosen, Point pivot,
                                       const DyadGrid& grid) {
  return DyadList(target, chosen, pivot, grid).all();
}

}  // namespace linkwright
