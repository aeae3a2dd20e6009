#pragma once

#include <array>
#include <optional>

#include "linkwright/algebra/cubic_cone.hpp"

namespace linkwright {

/// The six lines, counted with multiplicity, that the four cones of a 3 × 4 matrix of linear forms have in common.
struct CommonLines {
  struct Line {
    Vector3 axis{};        ///< unit
    bool is_pair = false;  ///< two that nearly coincide, real or complex: their middle
  };
  std::array<Line, 6> lines{};  ///< the first `count`
  int count = 0;
  int complex_lines = 0;  ///< those that are not near a real one
};

/// How many pencils of planes common_lines() can sort the lines by.
inline constexpr int line_pencils = 3;

/// The eigenvectors of multiplication by a linear form in the ring of the forms modulo the maximal minors, in degree 4
/// (S. Telen, B. Mourrain, M. Van Barel, Solving polynomial systems via truncated normal forms, 2018): numerically
/// stable in whatever directions the lines point, infinity included, and where a conic holds them all. `pencil` <
/// line_pencils: the planes by which eigenvalues part the lines; lines in one plane of a pencil come out inaccurate.
/// Nothing where the cones share more than lines.
[[nodiscard]] std::optional<CommonLines> common_lines(const std::array<CubicForm, 4>& minors, int pencil);

}  // namespace linkwright
