#pragma once

#include <array>

#include "linkwright/algebra/cubic_cone.hpp"
#include "linkwright/spherical/orientation_conditions.hpp"

namespace linkwright {

/// The matrix of a condition in its two parts, D = [a]× + S: of a small turn S is far smaller than a, and keeps all of
/// its digits beside it.
struct ConditionParts {
  Vector3 skew{};         ///< a
  Matrix3x3 symmetric{};  ///< S

  [[nodiscard]] Matrix3x3 matrix() const { return skew_matrix(skew) + symmetric; }
};

[[nodiscard]] inline ConditionParts operator+(const ConditionParts& p, const ConditionParts& q) {
  return {p.skew + q.skew, p.symmetric + q.symmetric};
}
[[nodiscard]] inline ConditionParts operator*(double s, const ConditionParts& p) {
  return {s * p.skew, s * p.symmetric};
}

/// Of row `index`, of unit Frobenius norm: exact for finite turns of any size.
[[nodiscard]] ConditionParts parts_of(const OrientationConditions& conditions, std::size_t index);

/// det [D₁W D₂W D₃W] as a form of W, in which the term [a₁]× [a₂]× [a₃]×, identically zero, never appears: nothing
/// cancels for small turns.
[[nodiscard]] CubicForm minor_form(const ConditionParts& first, const ConditionParts& second,
                                   const ConditionParts& third);

/// Those of four conditions, each without one of them: the last first.
[[nodiscard]] std::array<CubicForm, 4> minor_forms(const std::array<ConditionParts, 4>& conditions);

}  // namespace linkwright
