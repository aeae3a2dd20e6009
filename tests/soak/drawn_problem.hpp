#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace linkwright::soak {

/// The kinds of problem that a file can state.
inline constexpr std::array<std::string_view, 46> kinds = {"three_lengths",
                                                           "three_length",
                                                           "three_angle",
                                                           "three_center",
                                                           "three_pivots",
                                                           "three_lines",
                                                           "three_mixed",
                                                           "four_finite",
                                                           "four_mixed",
                                                           "four_lines",
                                                           "five_finite",
                                                           "five_mixed",
                                                           "five_freed",
                                                           "pairs_four",
                                                           "pairs_mixed",
                                                           "pairs_five",
                                                           "pairs_free",
                                                           "function_named",
                                                           "function_table",
                                                           "six_bar_chain",
                                                           "six_bar_search",
                                                           "sphere_three",
                                                           "sphere_four",
                                                           "sphere_mixed",
                                                           "sphere_five",
                                                           "sphere_pairs_four",
                                                           "sphere_pairs_mixed",
                                                           "sphere_pairs_five",
                                                           "sphere_pairs_free",
                                                           "sphere_function_named",
                                                           "sphere_function_table",
                                                           "line_four",
                                                           "line_pole",
                                                           "line_five",
                                                           "line_mixed",
                                                           "line_lambda",
                                                           "line_search",
                                                           "path_timed",
                                                           "path_timed_five",
                                                           "path_timed_pivot",
                                                           "path_some_timed",
                                                           "path_poses",
                                                           "path_pivot",
                                                           "path_pivots",
                                                           "path_few",
                                                           "path_near"};

struct DrawnProblem {
  std::string_view kind;
  std::string text;  ///< the file
};

/// The task of this number, of any kind or of the one asked for.
[[nodiscard]] DrawnProblem drawn_problem(std::uint64_t seed, std::uint64_t index, std::optional<std::string_view> kind);

}  // namespace linkwright::soak
