#pragma once

#include <optional>
#include <span>
#include <vector>

#include "linkwright/mechanism/drive_table.hpp"
#include "linkwright/mechanism/linkage_type.hpp"
#include "linkwright/mechanism/pose.hpp"
#include "linkwright/mechanism/spherical_defects.hpp"
#include "linkwright/mechanism/spherical_position.hpp"

namespace linkwright {

/// One state of a drive.
struct SphericalState {
  SphericalConfiguration configuration;
  SphericalFourBar four_bar;
  UnitQuaternion turn;  ///< of the coupler from position 1
  double transmission_angle = 0;
  std::optional<double> velocity_ratio;  ///< dψ/dθ; nothing at a dead point
  std::optional<int> position;           ///< number of the orientation that it comes nearest to there, from 1
  double orientation_error = 0;          ///< how far it is from that orientation, radians in [0, π]

  /// The number of the orientation that it passes there, to rounding.
  [[nodiscard]] std::optional<int> met() const { return orientation_error <= 1e-6 ? position : std::nullopt; }
};

/// What a spherical four-bar does when its input drives it, in the assembly in which it is given.
struct SphericalAnalysis {
  LinkAngles angles;
  LinkageType type = LinkageType::degenerate;
  TripleRockerKind triple_rocker = TripleRockerKind::none;
  SphericalConfiguration configuration;  ///< as given
  AngleRange input_range;                ///< around the configuration given
  std::vector<SphericalDeadPoint> dead_points;
  double transmission_angle = 0;          ///< as given
  double min_transmission_angle = 0;      ///< over the range of the input: 0 unless it is a crank
  TransmissionPeak largest_transmission;  ///< over the range of the input
  std::optional<double> velocity_ratio;
  std::optional<RatioRange> velocity_ratios;  ///< over the turn of a crank; nothing for other types
  std::vector<SphericalState> motion;  ///< by rising input angle over the whole range, orientations that are met among
                                       ///< them
};

/// Even steps of the input's range, dead points at its ends, and for each of `orientations` (the first being the one in
/// which `four_bar` is given) that the drive passes by 0.1 radians or less, where the moving axes come nearest to it.
[[nodiscard]] SphericalAnalysis analyze(const SphericalFourBar& four_bar,
                                        std::span<const PrescribedOrientation> orientations = {}, int steps = 360);

/// The path of an axis of the coupler over the motion, unit vectors: `axis` as it lies in position 1.
[[nodiscard]] std::vector<Vector3> coupler_path(const SphericalAnalysis& analysis, Vector3 axis);

}  // namespace linkwright
