#pragma once

#include <array>
#include <span>
#include <string_view>

#include "approximate/dyad_scan.hpp"
#include "approximate/dyad_scan_kernel.hpp"

namespace linkwright {

/// How well second dyads go with a driving one, at a fixed pivot.
class PairRating {
 public:
  /// The points do not lie at the pivot.
  PairRating(std::span<const Point> chosen, std::span<const double> weights, Point pivot, bool closed);

  /// To each of the points: a unit vector, and the distance.
  [[nodiscard]] Point direction(std::size_t j) const { return directions_[j]; }
  [[nodiscard]] double distance(std::size_t j) const { return distances_[j]; }

  /// The driving dyad whose second ones are rated from now on.
  void drive(double input, double arm, std::uint32_t right);
  /// The state at a point: the input, and the direction from its moving pivot to the point.
  [[nodiscard]] const LoopState& driven(std::size_t j) const { return driven_[j]; }

  /// Length of the output and score of a pair whose other numbers are known.
  void score(ScannedPair& pair);
  /// Of the pair that was scored last, the first among these letters that drives; 0: none.
  [[nodiscard]] char driver(const CouplerLinkage& linkage, std::string_view among = "eug") const;

 private:
  using States = std::array<LoopState, DyadBlock::most_points>;

  [[nodiscard]] double square_across(const CouplerLinkage& linkage) const;
  template <class Driving, class One, class Other>
  [[nodiscard]] bool drives(const Driving& driver, const One& one, const Other& other) const;

  std::size_t count_;
  std::span<const double> weights_;
  bool closed_;
  std::array<Point, DyadBlock::most_points> directions_, output_;
  std::array<double, DyadBlock::most_points> distances_;
  States driven_, states_;
};

}  // namespace linkwright
