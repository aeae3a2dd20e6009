#pragma once

#include <optional>
#include <string>
#include <vector>

#include "linkwright/files/csv_table.hpp"
#include "linkwright/mechanism/pose.hpp"
#include "linkwright/mechanism/spherical_analysis.hpp"
#include "linkwright/mechanism/spherical_four_bar.hpp"

namespace linkwright {

/// A spherical four-bar as files carry it.
struct StoredSphericalFourBar {
  SphericalFourBar four_bar;                        ///< as it lies in position 1
  std::string title, length_unit;                   ///< empty when the file does not say
  std::vector<PrescribedOrientation> orientations;  ///< of the coupler; empty when the file does not say
  std::string record;  ///< the element of a result's `linkages` it came from, JSON text; or empty
};

/// As JSON text that read_any_linkage() reads back bit-identical.
[[nodiscard]] std::string write_linkage(const StoredSphericalFourBar& linkage);

/// The analysis of a spherical four-bar and the file that it came from.
struct StoredSphericalAnalysis : SphericalAnalysis {
  StoredSphericalFourBar linkage;
};
[[nodiscard]] StoredSphericalAnalysis analyze(const StoredSphericalFourBar& linkage);

/// As JSON text (schema/analysis.schema.json): angles in degrees with `_deg`, columns of the motion by name.
[[nodiscard]] std::string write_analysis(const StoredSphericalAnalysis& analysis);

/// A motion, a row a state: input and output angle in degrees, both moving axes, the coupler's orientation against
/// position 1 as a quaternion [w, x, y, z] (against the task's reference attitude where orientations are known),
/// transmission angle in degrees, velocity ratio, the number of the orientation that it comes nearest to there, from 1,
/// and how far it is from it, not defined between.
[[nodiscard]] MotionTable motion_columns(const StoredSphericalAnalysis& analysis);
/// The same as csv_text().
[[nodiscard]] std::string motion_table(const StoredSphericalAnalysis& analysis);

}  // namespace linkwright
