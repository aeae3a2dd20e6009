#pragma once

#include <optional>
#include <vector>

#include "linkage_reply.hpp"
#include "linkwright/planar/six_bar_solution.hpp"
#include "task_session.hpp"

namespace linkwright::wasm {

/// SixBarLinkage of the protocol, and its drive: rows of state_columns followed by x and y of each hinge. `fails`:
/// requirement bits.
inline constexpr std::size_t six_bar_state_width = state_width + 2 * SixBar::joint_count;
[[nodiscard]] LinkageReply six_bar_reply(const std::vector<PrescribedPose>& poses,
                                         const std::optional<SixBarSolution>& found, MapPoint point, FailureBits fails);

/// The path of a point of the body (as it lies in position 1) over the drive's states, x and y by turns.
[[nodiscard]] std::vector<double> six_bar_trace(const std::vector<PrescribedPose>& poses,
                                                const std::optional<SixBarSolution>& found, Point traced);

}  // namespace linkwright::wasm
