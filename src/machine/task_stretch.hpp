#pragma once

#include <cstddef>
#include <vector>

#include "linkwright/machine/moving_linkage.hpp"

namespace linkwright {

/// MovingLinkage::task: of the two senses the one in which the positions come in their order, the shorter where both
/// do; where neither does, the shortest stretch with all of them.
[[nodiscard]] std::vector<std::size_t> task_stretch(const MovingLinkage& linkage);

}  // namespace linkwright
