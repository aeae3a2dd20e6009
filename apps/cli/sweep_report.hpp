#pragma once

#include <string>

#include "linkwright/sweep/sweep_plan.hpp"
#include "sweep_file.hpp"

namespace linkwright::cli {

/// What varies and how, how many samples, the first of them.
[[nodiscard]] std::string report_plan(const SweepPlan& plan);

/// What is in a table: where from, its columns with units and ranges, how many samples came to what.
[[nodiscard]] std::string report_sweep_file(const SweepFileSummary& summary);

}  // namespace linkwright::cli
