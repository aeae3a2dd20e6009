#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

// Of arrays by station, which are padded to a multiple of so many numbers that compilers take at once.
namespace linkwright::place_lanes {

inline constexpr std::size_t lanes = 8;
/// Measured stroke without which there is no law of a force, in the unit of length.
inline constexpr double no_travel_at_all = 1e-9;

[[nodiscard]] inline double largest_of(const std::vector<double>& values) {
  std::array<double, lanes> most;
  std::copy_n(values.begin(), lanes, most.begin());
  for (std::size_t i = lanes; i < values.size(); i += lanes)
    for (std::size_t k = 0; k < lanes; ++k) most[k] = values[i + k] > most[k] ? values[i + k] : most[k];
  return *std::max_element(most.begin(), most.end());
}
[[nodiscard]] inline double least_of(const std::vector<double>& values) {
  std::array<double, lanes> least;
  std::copy_n(values.begin(), lanes, least.begin());
  for (std::size_t i = lanes; i < values.size(); i += lanes)
    for (std::size_t k = 0; k < lanes; ++k) least[k] = values[i + k] < least[k] ? values[i + k] : least[k];
  return *std::min_element(least.begin(), least.end());
}

[[nodiscard]] inline double larger(double a, double b) { return a > b ? a : b; }
[[nodiscard]] inline double smaller(double a, double b) { return a < b ? a : b; }

}  // namespace linkwright::place_lanes
