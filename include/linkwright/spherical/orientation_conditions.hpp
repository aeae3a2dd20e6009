#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "linkwright/algebra/cubic_cone.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/mechanism/pose.hpp"

namespace linkwright {

/// What n positions of a body about a fixed centre ask of a grounded link: Gᵀ Dⱼ W = 0, j = 2 … n, for its fixed axis G
/// and its moving axis W in position 1. Of a finite orientation D = A₁ⱼ − E; of its derivatives D = [ω]× A₁ⱼ,
/// ([ε]× + [ω]×²) A₁ⱼ and so on, the derivatives of a rotation matrix. (J. M. McCarthy, G. S. Soh, Geometric Design of
/// Linkages, 2nd ed. 2011, chapter 9, for finite ones; docs/theory/spherical.md.)
struct OrientationConditions {
  std::vector<Matrix3x3> rows;   ///< unit Frobenius norm; null where an orientation repeats the first
  std::vector<Vector3> poles;    ///< moving axes, position 1, that one row leaves where it is: on every cone
  std::vector<double> singular;  ///< singular values of the rows, each as a vector of nine, falling
  bool are_finite = false;       ///< no derivatives
  /// Finite ones: quaternions of A₁ⱼ, canonical.
  std::vector<UnitQuaternion> turns;

  /// Largest over smallest singular value; infinite where they are dependent.
  [[nodiscard]] double condition() const;
};

/// At least two positions.
[[nodiscard]] OrientationConditions orientation_conditions(std::span<const PrescribedOrientation> orientations);

/// Of finite turns A₁ⱼ.
[[nodiscard]] OrientationConditions conditions_of_turns(std::span<const UnitQuaternion> turns);

/// The same without one of the rows (from 0). Poles are kept: meant for a row that depends on the others.
[[nodiscard]] OrientationConditions without_row(OrientationConditions conditions, std::size_t row);

/// The same with body and ground changing places: of the fixed axes what these are of the moving ones.
[[nodiscard]] OrientationConditions inverted(OrientationConditions conditions);

/// The cone of moving axes of the first three rows: det [D₂W D₃W D₄W], expanded by the rows' skew and symmetric parts,
/// since for small turns the terms of third order vanish identically and the bare determinant keeps nothing. Zero where
/// rounding has left nothing of it, and then every axis is a moving axis.
[[nodiscard]] CubicForm moving_axis_form(const OrientationConditions& conditions);

/// The fixed axis to a moving axis by the first `count` rows: the normal of the two vectors DⱼW that span most; unit.
[[nodiscard]] Vector3 fixed_axis_of(Vector3 moving_axis, const OrientationConditions& conditions);

/// Those of the rows that derivatives set; `positions` are what the conditions came from, or counted alike.
template <class Position>
[[nodiscard]] std::vector<Matrix3x3> derivative_rows(const std::vector<Position>& positions,
                                                     const OrientationConditions& conditions) {
  std::vector<Matrix3x3> rows;
  auto row = conditions.rows.begin();
  for (const Position& there : positions) {
    if (&there != &positions.front()) ++row;
    for (int m = 1; m < there.multiplicity(); ++m) rows.push_back(*row++);
  }
  return rows;
}

/// Largest |Gᵀ D W| over rows.
[[nodiscard]] double residual_of(Vector3 fixed_axis, Vector3 moving_axis, const std::vector<Matrix3x3>& rows);

/// Why every axis is a moving axis, or more than a curve: common_axis {x, y, z} (the body turns about one axis),
/// repeated_orientation {i, j} (from 1; the first two that are the same), else every_axis. Nothing where the first
/// three rows leave a cone.
[[nodiscard]] std::optional<Notice> orientation_degeneracy(std::span<const PrescribedOrientation> orientations,
                                                           const OrientationConditions& conditions);

}  // namespace linkwright
