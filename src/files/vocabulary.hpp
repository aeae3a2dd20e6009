#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace linkwright {

// The words of task.kind and task.mechanism, those not built yet included: they are refused by name.
inline constexpr std::array<std::string_view, 3> task_kinds = {"motion", "function", "straight_line"};
inline constexpr double largest_number =
    1e12;  ///< of coordinates and lengths: squares and products stay far from overflow

/// Longer lists than any task has are refused at once: comparing pairs of thousands is slow.
inline constexpr std::size_t most_positions_looked_at = 100;

inline constexpr std::array<std::string_view, 3> mechanism_names = {"four_bar", "six_bar", "spherical_four_bar"};

}  // namespace linkwright
