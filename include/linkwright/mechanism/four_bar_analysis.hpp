#pragma once

#include <optional>
#include <vector>

#include "linkwright/mechanism/coupler_curve.hpp"
#include "linkwright/mechanism/drive_table.hpp"
#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/linkage_type.hpp"
#include "linkwright/mechanism/position.hpp"

namespace linkwright {

/// What can be said of one four-bar as it is, driven by its input. Angles in radians, from the ground link's direction.
struct FourBarAnalysis {
  LinkLengths lengths;
  LinkageType type = LinkageType::degenerate;
  ChangePointKind change_point = ChangePointKind::none;
  GrashofExcesses excesses;
  std::vector<AngleRange> input_ranges;
  std::vector<DeadPoint> dead_points;
  double transmission_angle = 0;                ///< as the linkage lies
  double min_transmission_angle_full_turn = 0;  ///< of a crank; 0 for other types
  TransmissionPeak largest_transmission;        ///< over the range of the input in which the linkage lies
  std::optional<RatioRange> output_rates;       ///< dψ/dφ over the turn of a crank; nothing for other types
  std::vector<MotionState> motion;              ///< tabulated_motion()
};

/// `traced`: the point of the coupler whose path is told, as the four-bar lies; fixed frame.
[[nodiscard]] FourBarAnalysis analyze(const FourBar& four_bar, Point traced);

/// The whole motion cycle in 361 states: a state a degree for a crank; from dead point to dead point and back on the
/// other assembly for all others.
[[nodiscard]] std::vector<MotionState> tabulated_motion(const FourBar& four_bar, Point traced);

}  // namespace linkwright
