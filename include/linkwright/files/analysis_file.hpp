#pragma once

#include <string>

#include "linkwright/files/comparison_file.hpp"
#include "linkwright/files/instant_file.hpp"
#include "linkwright/files/linkage_file.hpp"
#include "linkwright/files/pose_comparison_file.hpp"
#include "linkwright/mechanism/four_bar_analysis.hpp"

namespace linkwright {

/// The analysis of a four-bar and the file that it came from.
struct LinkageAnalysis : FourBarAnalysis {
  StoredLinkage linkage;
  std::optional<LinkageInstant> instant{};          ///< where it is asked for
  std::optional<PathComparison> comparison{};       ///< likewise
  std::optional<PoseComparison> pose_comparison{};  ///< likewise
};

/// What is asked of one instant of a linkage.
struct InstantAsked {
  std::optional<Point> point;         ///< of the coupler, as it lies; nothing: the linkage's own, if it has one
  std::optional<double> input_angle;  ///< from the ground link, radians; nothing: as the linkage lies
  double input_acceleration = 0;      ///< InstantQuestion
};
/// An input out of reach is a mistake, place `input_deg`.
[[nodiscard]] Result<LinkageInstant> instant_of(const StoredLinkage& linkage, const InstantAsked& asked);

/// Traced is traced_point().
[[nodiscard]] LinkageAnalysis analyze(const StoredLinkage& linkage);

/// As JSON text (schema/analysis.schema.json): angles in degrees with `_deg`, columns of the motion by name.
[[nodiscard]] std::string write_analysis(const LinkageAnalysis& analysis);

}  // namespace linkwright
