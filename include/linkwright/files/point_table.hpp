#pragma once

#include <string_view>
#include <vector>

#include "linkwright/algebra/point.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/mechanism/pose.hpp"

namespace linkwright {

/// Points of a table as text, "x,y" a line: separated by commas, semicolons, tabs or blanks. With semicolons, tabs or
/// blanks between the numbers a comma in them is a decimal one. A first line that begins with no number is a heading;
/// empty lines and those that begin with # are left out. Three points at least, 100 000 at most. Mistakes, by lines:
/// `table_decimal_comma`, `table_columns`, `table_number`, `table_of_too_few`, `table_of_too_much`.
[[nodiscard]] Result<std::vector<Point>> read_point_table(std::string_view text);

/// Poses likewise, "x,y,theta_deg" a line: the place of a frame's origin and its angle in degrees.
[[nodiscard]] Result<std::vector<Pose>> read_pose_table(std::string_view text);
/// Whether the first line below the heading has three columns.
[[nodiscard]] bool is_pose_table(std::string_view text);

}  // namespace linkwright
