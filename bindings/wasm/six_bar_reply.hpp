#pragma once

#include <optional>
#include <vector>

#include "linkage_reply.hpp"
#include "linkwright/analysis/six_bar_check.hpp"
#include "linkwright/planar/six_bar_solution.hpp"
#include "task_session.hpp"

namespace linkwright::wasm {

/// SixBarLinkage of the protocol, and its drive: rows of state_columns followed by x and y of each hinge. `fails`:
/// requirement bits.
inline constexpr std::size_t six_bar_state_width = state_width + 2 * SixBar::joint_count;
[[nodiscard]] LinkageReply six_bar_reply(const std::vector<PrescribedPose>& poses,
                                         const std::optional<SixBarSolution>& found, MapPoint point, FailureBits fails);

/// A drive as it is shown.
struct SixBarDriveTable {
  std::vector<SixBarState> states;  ///< as they are passed
  std::vector<int> row_of_pose;     ///< −1 where the drive does not come to it
  int sense = 1;                    ///< of the travel: −1 clockwise
  bool full_turn = false;
  bool dead_at_start = false, dead_at_end = false;
};
/// The same of a drive that is known. `write_more`: members of its own.
[[nodiscard]] LinkageReply six_bar_reply(const SixBarDriveTable& drive, const std::optional<SixBarSolution>& found,
                                         MapPoint point, FailureBits fails,
                                         const std::function<void(JsonWriter&)>& write_more = {});

/// The path of a point of the body (as it lies in position 1) over the drive's states, x and y by turns.
[[nodiscard]] std::vector<double> six_bar_trace(const std::vector<PrescribedPose>& poses,
                                                const std::optional<SixBarSolution>& found, Point traced);

}  // namespace linkwright::wasm
