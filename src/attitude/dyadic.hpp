#pragma once

#include <vector>

#include "linkwright/algebra/matrix3x3.hpp"

namespace linkwright {

/// A dyadic: a sum of dyads ab, pairs of vectors written side by side. Its scalar product with a vector is
/// (ab)·c = a (b·c) and c·(ab) = (c·a) b; by coordinates in a frame it is the matrix Σ a bᵀ, a tensor of second order.
/// Many sums are the same tensor: compare matrices, not terms. (Liu Yanzhu, Mathematical description of the attitude of
/// a rigid body (I), 2021, section 2 and appendix 2; Gibbs and Wilson, Vector analysis, 1901, for the names.)
class Dyadic {
 public:
  struct Dyad {
    Vector3 antecedent, consequent;
  };

  /// The null dyadic.
  Dyadic() = default;
  /// The dyad ab.
  Dyadic(Vector3 a, Vector3 b) : dyads_{{a, b}} {}

  /// The unit dyadic E = e₁e₁ + e₂e₂ + e₃e₃: E·c = c.
  [[nodiscard]] static Dyadic unit();
  /// The dyadic p× = (p × e₁) e₁ + (p × e₂) e₂ + (p × e₃) e₃: (p×)·c = p × c. Its matrix is [p]×, and (p×)·(p×) = pp −
  /// E for a unit vector p.
  [[nodiscard]] static Dyadic cross(Vector3 p);

  [[nodiscard]] const std::vector<Dyad>& dyads() const { return dyads_; }

  /// The conjugate (transposed): antecedents and consequents change places.
  [[nodiscard]] Dyadic conjugate() const;
  /// The scalar of the dyadic, Σ a·b: the trace of its matrix.
  [[nodiscard]] double scalar() const;
  /// The vector of the dyadic, Σ a × b: minus twice the axial vector of its matrix.
  [[nodiscard]] Vector3 vector() const;
  /// The matrix Σ a bᵀ, by coordinates in the frame that the vectors are written in.
  [[nodiscard]] Matrix3x3 matrix() const;

  friend Dyadic operator+(const Dyadic& a, const Dyadic& b);
  friend Dyadic operator*(double s, const Dyadic& a);
  /// The scalar product with the vector on the right.
  friend Vector3 dot(const Dyadic& a, Vector3 c);
  /// The scalar product with the vector on the left.
  friend Vector3 dot(Vector3 c, const Dyadic& a);
  /// The scalar product of two dyadics, (ab)·(cd) = (b·c) ad: one after the other, the right one first.
  friend Dyadic dot(const Dyadic& a, const Dyadic& b);

 private:
  std::vector<Dyad> dyads_;
};

[[nodiscard]] Dyadic operator+(const Dyadic& a, const Dyadic& b);
[[nodiscard]] Dyadic operator*(double s, const Dyadic& a);
[[nodiscard]] Vector3 dot(const Dyadic& a, Vector3 c);
[[nodiscard]] Vector3 dot(Vector3 c, const Dyadic& a);
[[nodiscard]] Dyadic dot(const Dyadic& a, const Dyadic& b);

}  // namespace linkwright
