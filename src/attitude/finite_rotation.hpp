#pragma once

#include "dyadic.hpp"
#include "linkwright/attitude/axis_angle.hpp"

namespace linkwright {

/// The tensor of finite rotation A = cos θ E + (1 − cos θ) pp + sin θ p×, which turns a vector a₀ by the angle θ about
/// the unit vector p: a = A·a₀. (Liu Yanzhu, Mathematical description of the attitude of a rigid body (I): the finite
/// rotation tensor, 2021, equations 1 to 12; Euler, Nova methodus motum corporum rigidorum determinandi, 1775. Han
/// Jianyou et al., Modern Synthesis Theory and Methods of Linkages, 2013, section 1.1.3, a turn about any axis u by φ.)
///
/// p has the same coordinates before and after the turn, so the tensor has the same matrix in frame i (the article's
/// e^(0), before) and in frame j (e^(1), after): the matrix of direction cosines C_ij = A^(01).
class FiniteRotation {
 public:
  /// The rotation by an angle about an axis.
  explicit FiniteRotation(const AxisAngle& turn);

  [[nodiscard]] const AxisAngle& turn() const { return turn_; }

  /// a = cos θ a₀ + (1 − cos θ) p (p·a₀) + sin θ p × a₀ (Rodrigues' formula, the article's equation 4): the tensor
  /// acting on a vector, no matrix formed. Equally (r)_i of (r)_j.
  [[nodiscard]] Vector3 apply(Vector3 a0) const;

  /// The sum of dyads cos θ E + (1 − cos θ) pp + sin θ p× (equation 6).
  [[nodiscard]] Dyadic dyadic() const;

  /// The finite rotation matrix C_ij, element by element (equations 8 and 11).
  [[nodiscard]] Matrix3x3 matrix() const;

  /// A − E = 2 (w [v]× + [v]×²) with w = cos θ/2, v = p sin θ/2: without subtracting E, so that every element is
  /// relatively exact for small turns.
  [[nodiscard]] Matrix3x3 matrix_minus_identity() const;

  /// The tensor of the turn back: its conjugate.
  [[nodiscard]] FiniteRotation inverse() const { return FiniteRotation(turn_.inverse()); }

 private:
  AxisAngle turn_;
  double sine_ = 0, cosine_ = 1;
  double versine_ = 0;  ///< 1 − cos θ = 2 sin² θ/2
};

}  // namespace linkwright
