#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "linkwright/planar/path_task.hpp"

namespace linkwright {

/// Of a mistake: `task.points[i]`, from 0.
[[nodiscard]] std::string place_of_path_point(std::size_t point);

/// Largest distance of a point from the first, user's unit; 0 without points.
[[nodiscard]] double extent_of(const PathTask& task);

/// Of the ground pivots that are given: numbers that are none, plain points at a pivot, and both at one place. Of a
/// task whose points are numbers.
void check_pivots(const PathTask& task, std::vector<Error>& found);

}  // namespace linkwright
