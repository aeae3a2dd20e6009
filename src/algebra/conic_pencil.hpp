#pragma once

#include <array>

#include "linkwright/algebra/homogeneous.hpp"

namespace linkwright {

/// Real points that two conics of the projective plane have in common.
struct ConicIntersection {
  struct Place {
    Homogeneous point;     ///< unit vector
    int multiplicity = 1;  ///< points closer than tolerance::double_point are one
  };

  std::array<Place, 4> places{};
  int count = 0;
  int complex_points = 0;         ///< with multiplicity
  bool common_component = false;  ///< a line, or a whole conic; `places` has what there is beside
};

/// `a`, `b`: symmetric matrices, Zᵀ A Z = 0. In closed form: the pencil of the two has a degenerate member, a pair of
/// lines, and each line meets another member in two points. The member taken belongs to the root of the pencil's cubic
/// that stands apart from the others, so that touching conics do no harm: their point of contact lies on one of the two
/// lines, where it is a double root of a quadratic equation. A Newton correction on both conics follows.
[[nodiscard]] ConicIntersection intersection_of(const HomogeneousMatrix& a, const HomogeneousMatrix& b);

}  // namespace linkwright
