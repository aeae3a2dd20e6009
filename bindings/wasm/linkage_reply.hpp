#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "files/json/json_writer.hpp"
#include "linkwright/analysis/drive_table.hpp"
#include "linkwright/analysis/pose_visits.hpp"
#include "linkwright/planar/function_task.hpp"
#include "linkwright/planar/task_family.hpp"
#include "linkwright/synthesis/solve.hpp"

namespace linkwright::wasm {

/// One pair of grounded links of a task, and all there is to say of it.
struct PickedLinkage {
  Dyad input, output;                   ///< fixed frame
  std::optional<FourBarSolution> bars;  ///< nothing for a slider or a zero link
  PoseVisits visits;
  DriveTable drive;
  FailureBits fails = 0;
  std::optional<FunctionTask> task;          ///< of generators, the free parameter fixed
  std::optional<Notice> nothing;             ///< why there are no bars; none: as the grounded links tell
  std::optional<std::size_t> relaxed_index;  ///< how many of the poses served come before the freed one, if one is
};

/// `given` with a family.
[[nodiscard]] PickedLinkage picked_linkage(const TaskFamily& given, MapPoint place, bool respect_direction);

/// Linkage without the drive's states. `write_more`: members that only its kind has.
[[nodiscard]] std::string linkage_json(const PickedLinkage& picked, const WorkingFrame& frame,
                                       const std::function<void(JsonWriter&)>& write_more = {});

/// Rows as state_columns of the protocol.
inline constexpr std::size_t state_width = 13;
inline constexpr int states_of_a_drive = 361;
void append_states(const PickedLinkage& picked, std::vector<double>& states);

}  // namespace linkwright::wasm
