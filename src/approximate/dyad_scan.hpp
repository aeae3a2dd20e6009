#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "approximate/coupler_linkage.hpp"
#include "approximate/scan_target.hpp"

namespace linkwright {

/// A driving dyad and at which of the chosen points its moving pivot lies to the right of the direction to the point.
/// It changes sides where the dyad is stretched out, at the points farthest from the fixed pivot, and where it is
/// folded, at the nearest. Those that change sides alike are a group, and of those that keep to one side those with one
/// sum of lengths.
struct DrivingDyad {
  double input = 0, arm = 0;
  std::uint32_t right = 0;  ///< a bit to each point
  std::size_t group = 0;    ///< rising
};

/// What is tried where the target does not tell: the sum of a dyad's lengths over the largest distance of the target,
/// their difference over its least, and how far beyond the extremes of the points those of the curve lie.
struct DyadGrid {
  std::array<double, 6> sums;
  std::array<double, 5> differences;
  std::array<double, 3> beyond;
};
/// The usual one; by rising `round` others, with values between.
[[nodiscard]] DyadGrid dyad_grid(std::size_t round = 0);

/// All that are tried at a fixed pivot: lengths read off the largest and the least distance of the target, where they
/// change sides, and inflated otherwise.
[[nodiscard]] std::vector<DrivingDyad> driving_dyads(const ScaledTarget& target, std::span<const Point> chosen,
                                                     Point pivot, const DyadGrid& grid = dyad_grid());

/// A start of the least squares: a driving dyad and a second one.
struct ScannedPair {
  CouplerLinkage linkage;
  std::uint32_t right = 0;
  double score = 0;  ///< root mean square distance across the curve, to first order
  char driver = 0;   ///< 'e', 'u' or 'g', which turns one way and meets no dead point, as the points show; 0: none
};

/// Its fixed pivots are near each other, as those of most double cranks are: along a circle they are lost among long
/// linkages, which come nearer sooner.
[[nodiscard]] inline bool is_compact(const CouplerLinkage& linkage) {
  constexpr double near = 1;
  return std::norm(linkage.b0 - linkage.a0) < near * near;
}

/// The states of a pair at the points, its loop being closed as nearly as the second dyad fits.
[[nodiscard]] std::vector<LoopState> states_of(const ScannedPair& pair, std::span<const Point> chosen);

/// The second dyads that fit the poses of a driving dyad best, up to four, from the two smallest eigenvectors of their
/// linear equation: those of their combinations that are dyads.
struct SecondDyads {
  std::array<CouplerLinkage, 4> linkages;
  std::size_t count = 0;
};
[[nodiscard]] SecondDyads second_dyads(Point pivot, double input, double arm,
                                       const std::array<std::array<double, 7>, 2>& vectors);

/// The second dyad at a given place of its fixed pivot, from the first one, whose driven states (their u from the
/// moving pivot to the point) are given: with z from that pivot to the other, in the frame of u, the square of the
/// output's length is linear in z and one constant more. Its output has no length yet; nothing where z has none.
[[nodiscard]] std::optional<CouplerLinkage> second_dyad_at(Point second, double input, double arm,
                                                           std::span<const LoopState> driven,
                                                           std::span<const double> weights);

/// Which pairs are looked for at a fixed pivot.
struct PairWishes {
  DyadGrid grid = dyad_grid();
  std::string_view drivers = "eug";  ///< what may drive
  std::optional<Point> second;       ///< the other fixed pivot; nothing: anywhere
};
/// The best pairs at a fixed pivot: to each group of dyads the best one, and the best ones that have a driver.
[[nodiscard]] std::vector<ScannedPair> scan_pivot(const ScaledTarget& target, std::span<const Point> chosen,
                                                  std::span<const double> weights, Point pivot, double max_length,
                                                  Simd simd, const PairWishes& wishes = {});

}  // namespace linkwright
