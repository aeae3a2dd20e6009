#pragma once

#include <string>
#include <vector>

#include "linkwright/planar/four_bar_solution.hpp"

namespace linkwright::cli {

// Cells of tables of four-bars.

/// Least transmission angle over the task, "–" with a defect.
[[nodiscard]] std::string task_gamma(const DefectReport& report);

/// Over the full turn of a crank, "–" for others.
[[nodiscard]] std::string full_turn_gamma(const DefectReport& report);

/// The sense in which it is driven, or the defect that forbids it.
[[nodiscard]] std::string drive_text(const DefectReport& report);

/// Longest over shortest link, ground, input, coupler, output.
[[nodiscard]] std::vector<std::string> length_cells(const LinkLengths& lengths, int decimals);

/// "x, y".
[[nodiscard]] std::string pivot_text(Point pivot, int decimals);

/// Decimals for the lengths of all of them.
[[nodiscard]] int decimals_for(const std::vector<FourBarSolution>& linkages);

}  // namespace linkwright::cli
