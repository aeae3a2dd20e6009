#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "fields/field_visitor.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/defects.hpp"

// Values that several structs of a result have.
namespace linkwright::forms {

inline constexpr Number not_negative = {.least = 0};
inline constexpr Number share = {.least = 0, .most = 1};
inline constexpr Number or_infinite = {.null = Number::unlimited};
inline constexpr Number angle_deg = {.least = 0, .most = 90, .name = "angle_deg"};
inline constexpr Number arc_deg = {.least = 0, .most = 180, .name = "arc_deg"};
inline constexpr Whole count = {0, std::numeric_limits<std::int64_t>::max()};
inline constexpr Pair two_numbers = {.form = "[x, y]"};
inline constexpr Pair shown_point = {.form = "[x, y]", .name = "point"};
inline constexpr Vector axis = {.each = {.least = -1.001, .most = 1.001}, .name = "axis", .about = "Unit vector."};
inline constexpr List on_lines = {.what = "", .on_lines = true};
inline constexpr List on_a_line = {.what = ""};
inline constexpr List numbers = {.what = "", .name = "numbers"};
inline constexpr List branches = {.what = "", .on_lines = true, .name = "branches"};

inline const Names<LinkageType> linkage_types = {
    {LinkageType::crank_rocker, LinkageType::rocker_crank, LinkageType::double_crank, LinkageType::double_rocker,
     LinkageType::triple_rocker_ground, LinkageType::triple_rocker_input, LinkageType::triple_rocker_coupler,
     LinkageType::triple_rocker_output, LinkageType::change_point, LinkageType::degenerate, LinkageType::triple_rocker},
    "linkage_type"};

/// The value where it is one.
template <class Value>
[[nodiscard]] std::optional<Value> where(bool is, Value value) {
  return is ? std::optional(std::move(value)) : std::nullopt;
}

[[nodiscard]] inline std::optional<double> degrees_of(const std::optional<double>& radians) {
  return radians ? std::optional(linkwright::degrees(*radians)) : std::nullopt;
}

}  // namespace linkwright::forms
