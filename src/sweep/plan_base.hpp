#pragma once

#include "files/json/json.hpp"
#include "linkwright/sweep/sweep_plan.hpp"

namespace linkwright {

struct SweepPlan::Base {
  Json problem;
};

/// The plan of a sweep file's tree, however large it is written.
[[nodiscard]] Result<SweepPlan> read_sweep_tree(const Json& tree, const std::filesystem::path& folder);

}  // namespace linkwright
