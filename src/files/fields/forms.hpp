#pragma once

#include "core/number_check.hpp"
#include "fields/field_visitor.hpp"

// Values that several structs of a problem have.
namespace linkwright::forms {

inline constexpr Number coordinate = {.least = -largest_coordinate, .most = largest_coordinate, .name = "coordinate"};
inline constexpr Number degrees = {
    .least = -largest_coordinate, .most = largest_coordinate, .is_angle = true, .name = "coordinate"};
inline constexpr Number length = {.least = 0, .most = largest_coordinate, .above = true, .name = "length"};
inline constexpr Number signed_length = {
    .least = -largest_coordinate, .most = largest_coordinate, .name = "signed_length"};
inline constexpr Number positive = {.least = 0, .above = true};
inline constexpr Pair point = {.form = "[x, y]", .each = coordinate, .name = "point"};
inline constexpr Pair interval = {.form = {"low_high", "[low, high]"}, .name = "interval", .about = "[low, high]"};

/// `{"input": [x, y], "output": [x, y]}`.
inline void ground_pivots(FieldVisitor& v, Point& input, Point& output) {
  v.object({.name = "ground_pivots"}, [&](FieldVisitor& to) {
    to.required("input", input, point);
    to.required("output", output, point);
  });
}

/// The members x and y.
inline void coordinates(FieldVisitor& v, Point& at) {
  double x = at.real(), y = at.imag();
  v.required("x", x, coordinate);
  v.required("y", y, coordinate);
  at = {x, y};
}

}  // namespace linkwright::forms
