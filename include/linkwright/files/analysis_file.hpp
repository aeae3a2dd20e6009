#pragma once

#include <string>
#include <vector>

#include "linkwright/analysis/coupler_curve.hpp"
#include "linkwright/analysis/linkage_type.hpp"
#include "linkwright/analysis/position.hpp"
#include "linkwright/files/linkage_file.hpp"

namespace linkwright {

/// What can be said of one linkage as it is, driven by its input. Angles in radians, from the ground link's direction.
struct LinkageAnalysis {
  StoredLinkage linkage;
  LinkLengths lengths;
  LinkageType type = LinkageType::degenerate;
  ChangePointKind change_point = ChangePointKind::none;
  GrashofExcesses excesses;
  std::vector<AngleRange> input_ranges;
  std::vector<DeadPoint> dead_points;
  double transmission_angle = 0;                ///< as the linkage lies
  double min_transmission_angle_full_turn = 0;  ///< of a crank; 0 for other types
  std::vector<MotionState> motion;              ///< tabulated_motion()
};

[[nodiscard]] LinkageAnalysis analyze(const StoredLinkage& linkage);

/// The analysis as JSON text: angles in degrees with `_deg`, columns of the motion by name.
[[nodiscard]] std::string write_analysis(const LinkageAnalysis& analysis);

}  // namespace linkwright
