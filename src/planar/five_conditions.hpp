#pragma once

#include <array>

#include "algebra/conic_pencil.hpp"
#include "linkwright/algebra/homogeneous.hpp"
#include "linkwright/mechanism/four_bar.hpp"

namespace linkwright {

/// Zᵀ M C of five positions is linear in seven numbers (w, z and w′, C being the parts of Z and C):
/// √½ Re z C̄, √½ Im z C̄, Re z w′, Im z w′, Re w C, Im w C, w w′. In them orthonormal matrices M are orthonormal rows.
using ConditionRow = std::array<double, 7>;
using ConditionRows = std::array<ConditionRow, 4>;

/// The numbers of all dyads that meet four rows, linear in three parameters: one vector of parameters a number.
using DyadSpace = std::array<Homogeneous, 7>;

/// Orthonormal, by Householder reflections.
[[nodiscard]] DyadSpace dyad_space(const ConditionRows& rows);

/// Where the seven numbers are those of a pair of points, z C̄ · w w′ = z w′ · w C̄: two conics in the parameters.
[[nodiscard]] ConicIntersection dyads_in(const DyadSpace& space);

/// The pair of points with these numbers, unit vectors; w and w′ are not negative. Where both are at infinity only the
/// angle between them is determined: then z has the direction of x.
[[nodiscard]] Dyad factors_of(const DyadSpace& space, Homogeneous parameters);

/// The order of Burmester points: by the distance of the circle point from the origin, then of the centre.
[[nodiscard]] bool comes_before(const Dyad& a, const Dyad& b);

}  // namespace linkwright
