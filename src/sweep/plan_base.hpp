#pragma once

#include <nlohmann/json.hpp>

#include "linkwright/sweep/sweep_plan.hpp"

namespace linkwright {

struct SweepPlan::Base {
  nlohmann::json problem;
};

}  // namespace linkwright
