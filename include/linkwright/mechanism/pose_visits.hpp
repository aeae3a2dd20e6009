#pragma once

#include <optional>
#include <span>
#include <vector>

#include "linkwright/core/result.hpp"
#include "linkwright/mechanism/defects.hpp"
#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/pose.hpp"
#include "linkwright/mechanism/position.hpp"

namespace linkwright {

/// Where a driven four-bar that passes through poses meets them: the details behind its defects. Closed form, by the
/// joint signs of find_defects. Turns are angles of the input from where it stands in pose 0, radians, positive in the
/// sense of travel; that is the sense in which the poses come in order, or most nearly so, and of two as good the one
/// in which fewer poses with derivatives are passed against their direction.
struct PoseVisits {
  std::vector<FourBar> four_bars;  ///< at each pose
  std::vector<bool> on_circuit;    ///< by pose: reached from pose 0 without reassembly
  std::vector<bool> on_branch;     ///< by pose: reached from pose 0 without passing a dead point
  std::vector<double> turn;        ///< by pose; only where on_branch
  std::vector<int> order;          ///< the poses on the branch of pose 0 as they are met; a crank's from pose 0 on
  bool counter_clockwise = true;   ///< sense of travel
  bool full_turn = false;          ///< the input can go round
  /// Travel without change of assembly: from dead point to dead point, or a whole turn with the poses in its middle.
  AngleRange travel;

  /// First pose that stands on another circuit, or another branch, than the one before it; 0 where all are on one.
  [[nodiscard]] int first_on_another_circuit() const;
  [[nodiscard]] int first_on_another_branch() const;

  std::vector<Assembly> assembly;  ///< by pose, of coupler and output link
  std::vector<bool> circuit_sign;  ///< by pose: equal on one circuit
};

/// `poses` as in find_defects, links of positive length; all is empty where there are none.
[[nodiscard]] PoseVisits pose_visits(const FourBar& four_bar, std::span<const PrescribedPose> poses);

/// Why the drive does not do the task: circuit_defect {from, to}, branch_defect {from, to} (poses on either side of the
/// gap), order_defect {order}, direction_defect, change_point_defect. Nothing without defects. `numbers`: what the
/// poses are called; none: counted from 1.
[[nodiscard]] std::optional<Notice> defect_notice(Defects defects, const PoseVisits& visits,
                                                  std::span<const int> numbers = {});

}  // namespace linkwright
