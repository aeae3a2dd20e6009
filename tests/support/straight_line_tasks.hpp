#pragma once

#include <random>
#include <vector>

#include "linkwright/straight_line/straight_line_task.hpp"

namespace linkwright::testing {

/// One task of every case, each with linkages; both cases with the pole at a pivot, contacts on one side and at an
/// angle, a λ of any range and of one, a search.
[[nodiscard]] const std::vector<StraightLineTask>& straight_line_tasks();

/// A task without mistakes of one of those cases, `which` counted as there: numbers up to a few units.
[[nodiscard]] StraightLineTask random_straight_line(std::mt19937_64& random, std::size_t which);

}  // namespace linkwright::testing
