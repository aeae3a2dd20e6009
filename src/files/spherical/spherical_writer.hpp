#pragma once

#include <optional>
#include <vector>

#include "files/json/json_writer.hpp"
#include "files/tolerance_writer.hpp"
#include "linkwright/spherical/spherical_solution.hpp"

namespace linkwright {

/// `{"ground": …, "input": …, "coupler": …, "output": …}`, degrees.
void write_angles(JsonWriter& json, std::string_view key, const LinkAngles& angles);
/// `{"moving_axis": …, "fixed_axis": …, …}`.
void write_spherical_dyad(JsonWriter& json, const SphericalDyad& dyad, double residual);
/// The same with its multiplicity and condition.
void write_spherical_dyad(JsonWriter& json, const SphericalDyadPoint& point);

/// What a file says of a spherical four-bar beside the four-bar itself.
struct SphericalNotes {
  std::vector<PrescribedOrientation> orientations;  ///< of the coupler, where they are not the task's; otherwise none
  std::optional<double> free_value;                 ///< of a function task's free parameter, as files hold it
  ListedNotes listed{};
};

/// The notes of a four-bar of a map.
[[nodiscard]] SphericalNotes notes_on(const SphericalSolution& found, const SphericalFamily& family);

/// An element of a result's `linkages`.
void write_spherical_four_bar(JsonWriter& json, const SphericalSolution& found, const SphericalNotes& notes);

}  // namespace linkwright
