#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include "linkwright/planar/six_bar_solution.hpp"
#include "linkwright/planar/six_bar_synthesis.hpp"

namespace linkwright {

/// A six-bar that meets the requirements, and how good it is.
struct SixBarProspect {
  ThreeLinkChain chain;
  std::array<double, 2> tau{};
  double score = 0;  ///< as score_of
  SixBarMember member;
  bool local_optimum = false;
};

[[nodiscard]] double score_of(Objective objective, const SixBarRating& rating);

/// A number in [low, high): the standard distributions differ from machine to machine.
[[nodiscard]] inline double uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * std::ldexp(static_cast<double>(random() >> 11), -53);
}

/// Better first; ties by the coordinates.
[[nodiscard]] bool is_better(const SixBarProspect& a, const SixBarProspect& b);

/// The first so many of prospects sorted by is_better, no two of which have all hinges within `least` of each other.
[[nodiscard]] std::vector<SixBarProspect> distinct(const std::vector<SixBarProspect>& sorted, std::size_t most,
                                                   double least);

/// Each driven in exact steps, best first again. What then fails the requirements after all – searches take larger
/// steps – is left out. By a measure added to the map they stay in order.
[[nodiscard]] std::vector<SixBarSolution> driven_exactly(const std::vector<SixBarProspect>& prospects,
                                                         const SixBarTask& task, const SixBarRow& row,
                                                         const Requirements& wanted, const SixBarChoice& choice);

}  // namespace linkwright
