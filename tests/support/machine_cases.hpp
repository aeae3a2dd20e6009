#pragma once

#include <string>
#include <vector>

#include "linkwright/machine/machine.hpp"

namespace linkwright::testing {

/// Linkages of all kinds as files carry them: of solved examples the best, and linkages with a traced point.
[[nodiscard]] const std::vector<AnyStoredLinkage>& stored_linkages_of_examples();

/// The machines of these.
[[nodiscard]] const std::vector<Machine>& machines();

}  // namespace linkwright::testing
