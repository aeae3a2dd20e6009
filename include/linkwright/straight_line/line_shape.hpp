#pragma once

#include <array>
#include <cstddef>

namespace linkwright {

/// A kind of shape: a case with one of its lengths as unit.
enum class ShapeKind : std::size_t {
  four_point,
  ball_point_on_side_link,
  isosceles_trapezoid,
  pole_at_fixed_pivot,
  ball_point_on_frame,
  five_point,
  five_point_inflection_pole,
  five_point_side_link_on_frame,
  six_point,
  parallel_side_links,
  symmetric_lambda,
  two_tangencies,  ///< a λ that touches the line at two places
};
inline constexpr std::size_t shape_kind_count = 12;

/// Linkages of a case, without position and scale: what a search of all cases draws.
struct LineShape {
  ShapeKind kind = ShapeKind::four_point;
  std::array<double, 4> numbers{};  ///< in [0, 1], the first number_count(kind) of them
  unsigned turns = 0;  ///< bits: the other side of the line, the other sense of it, the other side of the dyad
};

/// How many numbers a shape of a kind has, 1 to 4.
[[nodiscard]] std::size_t number_count(ShapeKind kind);

}  // namespace linkwright
