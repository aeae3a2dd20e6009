#pragma once

#include <atomic>
#include <cstdint>
#include <optional>

#include "linkwright/sweep/sweep_plan.hpp"
#include "linkwright/sweep/sweep_table.hpp"

namespace linkwright {

/// The rows of samples [first, last) of a plan, computed by the calling thread alone; nothing when cancelled before all
/// are there. A sample whose values make no problem is a row that says so.
[[nodiscard]] std::optional<SweepRows> sweep_samples(const SweepPlan& plan, std::int64_t first, std::int64_t last,
                                                     const std::atomic<bool>* cancelled = nullptr);

/// The same of block number `block` of the plan, from 0.
[[nodiscard]] std::optional<SweepRows> sweep_block(const SweepPlan& plan, std::int64_t block,
                                                   const std::atomic<bool>* cancelled = nullptr);

}  // namespace linkwright
