#pragma once

#include "drawn_task.hpp"

// One to each family of kinds; drawn_task() chooses.
namespace linkwright::soak {

[[nodiscard]] Json drawn_three_positions(Draw& draw, const Sheet& sheet, std::string_view kind);
[[nodiscard]] Json drawn_four_positions(Draw& draw, const Sheet& sheet, std::string_view kind);
[[nodiscard]] Json drawn_five_positions(Draw& draw, const Sheet& sheet, std::string_view kind);
[[nodiscard]] Json drawn_six_bar(Draw& draw, const Sheet& sheet, std::string_view kind);
[[nodiscard]] Json drawn_pairs(Draw& draw, const Sheet& sheet, std::string_view kind);
[[nodiscard]] Json drawn_function(Draw& draw, const Sheet& sheet, std::string_view kind);
[[nodiscard]] Json drawn_path(Draw& draw, const Sheet& sheet, std::string_view kind);
/// A drawn path: points that are passed near.
[[nodiscard]] Json drawn_near_path(Draw& draw, const Sheet& sheet);
[[nodiscard]] Json drawn_line(Draw& draw, const Sheet& sheet, std::string_view kind);
/// About a fixed centre: of no sheet.
[[nodiscard]] Json drawn_sphere(Draw& draw, std::string_view kind);

}  // namespace linkwright::soak
