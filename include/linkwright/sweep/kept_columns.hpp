#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "linkwright/sweep/sweep_table.hpp"
#include "linkwright/synthesis/problem.hpp"

namespace linkwright {

/// A number, flag or word of the linkages of a result file that a sweep can keep.
struct KeptColumn {
  SweepColumn column;
  bool by_default = false;  ///< kept where a sweep does not say which
};

/// All that can be kept of the linkages of a problem; columns of tolerances where it has some.
[[nodiscard]] std::vector<KeptColumn> keepable_columns(const Problem& problem);

}  // namespace linkwright
