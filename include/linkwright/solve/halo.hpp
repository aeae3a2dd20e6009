#pragma once

#include <cstdint>
#include <vector>

#include "linkwright/synthesis/solve.hpp"

namespace linkwright {

/// A part of a task, and how far it is moved.
struct HaloRequest {
  int part = 0;  ///< a pose, from 0; of six-bars after them the chain's hinges a, b, d
  bool turn = false;
  double reach = 0;  ///< user's unit, or radians
  int steps = 13, samples = 60;
};

/// Where a part of a task may go: how many cells of a coarse map meet the requirements after it was moved by each of
/// steps × steps offsets, evenly over ±reach (user's unit) in x and y, row-major [dy][dx], both rising; or turned about
/// its origin by each of `steps` angles, evenly over ±reach (radians). Tasks that are refused or degenerate count 0.
/// Lengths that are not given have each moved task's own defaults; yields are not looked at. Empty where the task has
/// no such part.
[[nodiscard]] std::vector<std::uint32_t> halo(const Problem& problem, const HaloRequest& request);

/// The offsets of a halo: `steps` values evenly over ±reach; 0 alone for a single step.
[[nodiscard]] std::vector<double> offset_values(double reach, int steps);

}  // namespace linkwright
