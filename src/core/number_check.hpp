#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "linkwright/core/result.hpp"

namespace linkwright {

/// Largest coordinate (user's unit), angle (degrees) and derivative that a task may give.
inline constexpr double largest_coordinate = 1e9;

/// Adds a mistake `number_range` {name, most} to those found where a number of a task, called `what`, is beyond
/// ± largest_coordinate or none.
void check_number(double value, std::string_view what, const std::string& place, std::vector<Error>& found);
/// The same of an angle in radians; the largest is largest_coordinate degrees, although these are a little more once
/// they are turned back.
void check_angle(double angle, std::string_view what, const std::string& place, std::vector<Error>& found);

}  // namespace linkwright
