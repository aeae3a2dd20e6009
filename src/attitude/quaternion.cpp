#include "linkwright/attitude/quaternion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "linkwright/core/precondition.hpp"

namespace linkwright {

Result<UnitQuaternion> UnitQuaternion::of(double w, Vector3 v) {
  if (!std::isfinite(w) || !is_finite(v))
    return Error{"not_finite", "quaternion", "a component is not a number or infinite: give four finite numbers"};
  const double largest = std::max({std::fabs(w), std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  if (largest == 0)
    return Error{"zero_quaternion", "quaternion", "all four components are zero: the identity is 1, 0, 0, 0"};
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
  if (std::fabs(w * w + dot(v, v) - 1) <= rounding)
    return UnitQuaternion{w, v};             // what was written reads back the same
  const int exponent = std::ilogb(largest);  // neither overflow nor underflow in the squares
  return normalized(std::scalbn(w, -exponent),
                    {std::scalbn(v.x, -exponent), std::scalbn(v.y, -exponent), std::scalbn(v.z, -exponent)});
}

UnitQuaternion UnitQuaternion::normalized(double w, Vector3 v) {
  const double length = std::sqrt(w * w + dot(v, v));
  return {w / length, v / length};
}

UnitQuaternion UnitQuaternion::about(Vector3 unit_axis, double angle) {
  require(std::isfinite(angle), "an angle is a number");
  return normalized(std::cos(angle / 2), std::sin(angle / 2) * unit_axis);
}

UnitQuaternion UnitQuaternion::of_matrix(const Matrix3x3& c) {
  // 4 q_k q, the row of 4 q qᵀ with the largest diagonal element: it is at least 1, so no digits are lost.
  const double t = trace(c);
  const std::array<double, 4> diagonal{1 + t, 1 + 2 * c(0, 0) - t, 1 + 2 * c(1, 1) - t, 1 + 2 * c(2, 2) - t};
  const Vector3 skew{c(2, 1) - c(1, 2), c(0, 2) - c(2, 0), c(1, 0) - c(0, 1)};
  const auto k = std::max_element(diagonal.begin(), diagonal.end()) - diagonal.begin();
  if (k == 0) return normalized(diagonal[0], skew).canonical();
  const auto i = static_cast<std::size_t>(k - 1);
  Vector3 v;
  for (std::size_t j = 0; j < 3; ++j) v[j] = i == j ? diagonal[i + 1] : c(i, j) + c(j, i);
  return normalized(skew[i], v).canonical();
}

UnitQuaternion UnitQuaternion::canonical() const {
  for (const double component : {w_, v_.x, v_.y, v_.z})
    if (component != 0) return component > 0 ? *this : -*this;
  return *this;
}

UnitQuaternion operator*(const UnitQuaternion& ij, const UnitQuaternion& jk) {
  const double w = ij.w_ * jk.w_ - dot(ij.v_, jk.v_);
  const Vector3 v = ij.w_ * jk.v_ + jk.w_ * ij.v_ + cross(ij.v_, jk.v_);
  return UnitQuaternion::normalized(w, v);  // products of any length stay on the unit sphere
}

Vector3 UnitQuaternion::apply(Vector3 r) const {
  const Vector3 t = 2.0 * cross(v_, r);
  return r + w_ * t + cross(v_, t);
}

Matrix3x3 UnitQuaternion::matrix() const { return Matrix3x3::identity() + matrix_minus_identity(); }

Matrix3x3 UnitQuaternion::matrix_minus_identity() const {
  // [v]×² = v vᵀ − v² E, its diagonal written as sums of squares.
  const double xx = v_.x * v_.x, yy = v_.y * v_.y, zz = v_.z * v_.z;
  const double xy = v_.x * v_.y, yz = v_.y * v_.z, zx = v_.z * v_.x;
  const Vector3 s = w_ * v_;
  // Not 2: the length, rounded, is some 1e-16 off 1, and this halves the error of the elements.
  const double two = 2 / (w_ * w_ + dot(v_, v_));
  return two *
         Matrix3x3{
             {{{-(yy + zz), xy - s.z, zx + s.y}, {xy + s.z, -(zz + xx), yz - s.x}, {zx - s.y, yz + s.x, -(xx + yy)}}}};
}

double angle_between(const UnitQuaternion& a, const UnitQuaternion& b) {
  const UnitQuaternion difference = a.inverse() * b;
  return 2 * std::atan2(norm(difference.v()), std::fabs(difference.w()));
}

}  // namespace linkwright
