#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "linkwright/attitude/displacement.hpp"
#include "linkwright/attitude/screw.hpp"
#include "linkwright/core/result.hpp"

namespace linkwright {

/// What `linkwright attitude screw` reads: schema/attitude.schema.json. Lengths in the user's unit.
struct DisplacementTask {
  std::string length_unit;  ///< echoed, never converted
  Displacement displacement;
  std::optional<Screw> given;       ///< where it was given as a screw: as given, any number of turns
  bool small_turns_exact = false;   ///< given by axis and angle: the smallest turn is one
  std::vector<Vector3> points;      ///< to be displaced
  std::vector<Vector3> directions;  ///< the same, as directions
};

/// `{"linkwright": 1, "length_unit": …, "displacement": {…}, "points": [[x, y, z], …], "directions": …}`, the
/// displacement one of `matrix` (4×4), `orientation` (as in orientation_file.hpp) and `translation`, either of them
/// alone too, `screw` {`axis`, `point`, `angle_deg`, `slide`}, and `from` and `to`, two displacements of the forms
/// before: the one that carries the first pose to the second, in the fixed frame.
[[nodiscard]] Result<DisplacementTask> read_displacement_task(std::string_view text);

/// A displacement in every representation.
struct DisplacementReport {
  DisplacementTask task;
  Screw screw;
  std::vector<Vector3> displaced_points, displaced_directions;
};

/// Errors: those of screw_of(), place `displacement`.
[[nodiscard]] Result<DisplacementReport> displacement_report(const DisplacementTask& task);

[[nodiscard]] std::string write_displacement_report(const DisplacementReport& report);

}  // namespace linkwright
