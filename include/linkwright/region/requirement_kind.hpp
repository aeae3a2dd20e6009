#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace linkwright {

/// What can be required of a linkage; which of them, the class of linkages says.
enum class RequirementKind : std::uint8_t {
  types,
  no_defects,
  min_transmission_angle,
  max_link_ratio,
  max_length,
  min_length,
  ground_pivots_within,
  moving_pivots_within,
  min_link_angle,
  max_link_angle,
  fixed_axes_within,
  moving_axes_within,
  min_stroke,
  max_deviation,
  max_tolerance_error,
  min_yield
};
inline constexpr std::size_t requirement_kind_count = 16;
/// Key in the problem file: types, no_defects, min_transmission_angle_deg, …
[[nodiscard]] std::string_view key(RequirementKind kind);
/// A number or a place of it is given as an angle: radians, degrees in files.
[[nodiscard]] bool is_angle(RequirementKind kind);

/// Requirements of one class of linkages, in the order in which they are told: each is a bit of what a cell fails.
using RequirementKinds = std::span<const RequirementKind>;
inline constexpr std::size_t max_requirements = 10;
/// What a cell fails: a bit to each of them, from the lowest on.
using FailureBits = std::uint16_t;
inline constexpr FailureBits all_failures = (1u << max_requirements) - 1;

/// Place of a kind among others; kinds.size() where it is not one of them.
[[nodiscard]] constexpr std::size_t place_among(RequirementKinds kinds, RequirementKind kind) {
  std::size_t place = 0;
  while (place < kinds.size() && kinds[place] != kind) ++place;
  return place;
}

}  // namespace linkwright
