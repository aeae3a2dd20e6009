#pragma once

#include <string>
#include <utility>

#include "linkwright/algebra/matrix3x3.hpp"
#include "linkwright/core/result.hpp"

namespace linkwright {

/// A rotation as a unit quaternion (Euler parameters): scalar first, Hamilton's product (ij = k),
/// (w, v) = (cos θ/2, p sin θ/2) for the turn by θ about the unit axis p. q and −q are the same rotation and compare
/// equal. Like C_ij the quaternion q_ij maps coordinates in frame j to frame i, and q_ik = q_ij q_jk.
/// (Shuster, A survey of attitude representations, 1993, whose own product has the opposite order.)
class UnitQuaternion {
 public:
  /// The identity.
  constexpr UnitQuaternion() = default;

  /// (w, v) scaled to unit length; any finite length but zero. Errors: `not_finite`, `zero_quaternion`.
  [[nodiscard]] static Result<UnitQuaternion> of(double w, Vector3 v);

  /// The turn about a unit vector by `angle`, radians, right-handed. Both finite: asserted, for what is read is checked
  /// by AxisAngle::of() and EulerAngles::of().
  [[nodiscard]] static UnitQuaternion about(Vector3 unit_axis, double angle);

  /// From a matrix C_ij, taken to be a rotation (Rotation::from_matrix checks). Exact to a few ulps for every angle:
  /// the largest of the four components is never a difference of like numbers (Shepperd, Quaternion from rotation
  /// matrix, 1978). Of q and −q the canonical one.
  [[nodiscard]] static UnitQuaternion of_matrix(const Matrix3x3& c_ij);

  /// cos θ/2.
  [[nodiscard]] constexpr double w() const { return w_; }
  /// p sin θ/2; its coordinates are the same in frames i and j.
  [[nodiscard]] constexpr Vector3 v() const { return v_; }

  /// Of q and −q the one with w > 0; at w = 0, a half-turn, the one whose first component that is not zero is positive.
  [[nodiscard]] UnitQuaternion canonical() const;

  /// −q: the same rotation, bit by bit.
  [[nodiscard]] constexpr UnitQuaternion operator-() const { return {-w_, -v_}; }

  /// q_ji: of the inverse rotation.
  [[nodiscard]] constexpr UnitQuaternion inverse() const { return {w_, -v_}; }

  /// q_ik of q_ij and q_jk: the turn q_jk about axes carried along by the turn q_ij.
  friend UnitQuaternion operator*(const UnitQuaternion& ij, const UnitQuaternion& jk);

  /// (r)_i of (r)_j; equally the vector that r becomes when it is turned, both in one frame.
  [[nodiscard]] Vector3 apply(Vector3 r_j) const;

  /// The matrix C_ij.
  [[nodiscard]] Matrix3x3 matrix() const;

  /// A − E = 2 (w [v]× + [v]×²) without the cancellation of subtracting E: every element relatively exact for small
  /// turns. Maps coordinates in frame j to the difference (r)_i − (r)_j.
  [[nodiscard]] Matrix3x3 matrix_minus_identity() const;

  /// The same rotation, to the last bit of the components: q and −q are equal.
  friend constexpr bool operator==(const UnitQuaternion& a, const UnitQuaternion& b) {
    return (a.w_ == b.w_ && a.v_ == b.v_) || (a.w_ == -b.w_ && a.v_ == -b.v_);
  }

 private:
  constexpr UnitQuaternion(double w, Vector3 v) : w_(w), v_(v) {}

  /// Scaled to unit length; for what cannot be zero.
  [[nodiscard]] static UnitQuaternion normalized(double w, Vector3 v);

  double w_ = 1;
  Vector3 v_{};
};

/// The angle of the turn between two attitudes, in [0, π].
[[nodiscard]] double angle_between(const UnitQuaternion& a, const UnitQuaternion& b);

/// A rotation and the form in which a file gave it, which is kept so that files echo what was asked: matrix, axis and
/// angle, angles of a sequence. Another rotation assigned to it has none; the same rotation in another form is equal.
class GivenOrientation : public UnitQuaternion {
 public:
  GivenOrientation() = default;
  GivenOrientation(const UnitQuaternion& rotation, std::string form = {})
      : UnitQuaternion(rotation), form_(std::move(form)) {}

  /// The members that give it, as JSON text without braces: `"axis": [0,0,1], "angle_deg": 30`; empty: not from a file.
  [[nodiscard]] const std::string& form() const { return form_; }

 private:
  std::string form_;
};

}  // namespace linkwright
