#pragma once

#include <array>
#include <random>
#include <string>
#include <vector>

#include "linkwright/planar/function_task.hpp"

namespace linkwright::testing {

/// Pairs of angles of no particular kind, with derivatives to match the multiplicities.
[[nodiscard]] std::vector<AnglePair> random_pairs(std::mt19937_64& random, const std::vector<int>& multiplicities);

/// Pairs as people give them: the input goes on by up to 40° from pair to pair, the output by up to 30° either way.
[[nodiscard]] std::vector<AnglePair> gentle_pairs(std::mt19937_64& random, int count);

/// The pair a short while t after one with derivatives, by the Taylor polynomials of its angles.
[[nodiscard]] AnglePair pair_after(const AnglePair& pair, double t);

/// A named function of x over a range, both dials from 0, its Chebyshev points taken as the pairs.
[[nodiscard]] FunctionTask named_task(const std::string& expression, std::array<double, 2> x, double input_deg,
                                      double output_deg);

/// All patterns of four positions, finite ones first.
[[nodiscard]] const std::vector<std::vector<int>>& four_position_patterns();

}  // namespace linkwright::testing
