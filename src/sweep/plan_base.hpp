#pragma once

#include <nlohmann/json.hpp>

#include "linkwright/sweep/sweep_plan.hpp"

namespace linkwright {

struct SweepPlan::Base {
  nlohmann::json problem;
};

/// The plan of a sweep file's tree, however large it is written.
[[nodiscard]] Result<SweepPlan> read_sweep_tree(const nlohmann::json& tree, const std::filesystem::path& folder);

}  // namespace linkwright
