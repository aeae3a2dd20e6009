#pragma once

#include <cstddef>

namespace linkwright {

inline constexpr double largest_number =
    1e12;  ///< of coordinates and lengths: squares and products stay far from overflow

/// Longer lists than any task has are refused at once: comparing pairs of thousands is slow.
inline constexpr std::size_t most_positions_looked_at = 100;

}  // namespace linkwright
