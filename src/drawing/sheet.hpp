#pragma once

#include <string>
#include <string_view>

#include "drawing/plane_window.hpp"
#include "drawing/svg_canvas.hpp"
#include "linkwright/files/problem_file.hpp"

// The sheets that solutions and single linkages are drawn on.
namespace linkwright {

/// A solution: the task, its map or what stands in its place, the best linkage in numbers.
namespace solution_sheet {
inline constexpr double width = 1440, height = 900, border = 24;
inline constexpr PixelBox task_card{border, 84, 796, 664};
inline constexpr PixelBox strip_card{border, 764, width - 2 * border, 112};
inline constexpr std::string_view separator = "   ·   ";

/// An empty sheet with title and `subtitle`.
[[nodiscard]] SvgCanvas begin(const Problem& problem, std::string_view subtitle);
}  // namespace solution_sheet

/// One linkage.
namespace linkage_sheet {
inline constexpr double width = 1000, height = 800, border = 20;

/// An empty sheet with its title, on the right what `kind` it is.
[[nodiscard]] SvgCanvas begin(const std::string& title, std::string_view kind);
}  // namespace linkage_sheet

}  // namespace linkwright
