#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace linkwright {

/// How the samples of a sweep are spread over what varies.
enum class Sampling { grid, list, sobol, halton, random };
/// As in files.
[[nodiscard]] std::string_view name(Sampling sampling);

/// How many coordinates a method can give: primes and direction numbers are tables.
inline constexpr std::size_t max_coordinates = 100;

/// The coordinate of a point of the Halton sequence in [0, 1): the radical inverse of `index` in the base of the
/// dimension-th prime, from 0 (J. H. Halton 1960). Index 0 is the origin.
[[nodiscard]] double halton_coordinate(std::uint64_t index, std::size_t dimension);

/// A number in [0, 1) that depends on nothing but its three arguments: SplitMix64's finalizer (G. L. Steele, D. Lea,
/// C. H. Flood 2014) over each in turn.
[[nodiscard]] double random_coordinate(std::uint64_t seed, std::uint64_t index, std::size_t dimension);

/// Coordinates in [0, 1) of the points of a sequence; any of them at once.
class PointSequence {
 public:
  /// `method`: sobol, halton or random; at most max_coordinates dimensions. A seed other than 0 shifts all points of
  /// Sobol's and Halton's sequences by one vector, modulo 1 (R. Cranley, T. N. L. Patterson 1976), which keeps them
  /// as even as they are.
  PointSequence(Sampling method, std::size_t dimensions, std::uint64_t seed);

  /// Sobol's point 0 is the origin; direction numbers of S. Joe and F. Y. Kuo (2008), points in Gray code order.
  [[nodiscard]] std::vector<double> point(std::uint64_t index) const;

 private:
  void move_by_seed(std::vector<double>& point) const;

  Sampling method_;
  std::size_t dimensions_;
  std::uint64_t seed_;
};

}  // namespace linkwright
