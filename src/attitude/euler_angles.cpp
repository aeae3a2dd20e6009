#include "linkwright/attitude/euler_angles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

UnitQuaternion turn_about(Axis axis, double angle) { return UnitQuaternion::about(unit_vector(axis), angle); }

/// The quaternion in the order of an intrinsic sequence: scalar, first, second and remaining axis, the last one with
/// the sign of their permutation.
struct OrderedQuaternion {
  double a = 0, b = 0, c = 0, d = 0;
  double sign = 1;  ///< of the permutation

  OrderedQuaternion(const UnitQuaternion& q, const EulerSequence& sequence) : a(q.w()) {
    const auto i = static_cast<std::size_t>(sequence.first()), j = static_cast<std::size_t>(sequence.second());
    sign = (i + 1) % 3 == j ? 1 : -1;
    b = q.v()[i];
    c = q.v()[j];
    d = sign * q.v()[3 - i - j];
  }
};

/// A rotation as (a, b) = high (cos h₊, sin h₊), (c, d) = low (cos h₋, sin h₋), h± = ½ (first ± third), high² + low² =
/// 1: the ordered quaternion itself for proper Euler angles, turned by an eighth for Cardan angles (whose third angle
/// then appears with the opposite sign of the permutation).
struct HalfAngles {
  double a, b, c, d;
  double high = 0, low = 0;

  HalfAngles(const OrderedQuaternion& q, bool proper) : a(q.a), b(q.b), c(q.c), d(q.d) {
    if (!proper) {
      constexpr double r = 1 / std::numbers::sqrt2;
      a = r * (q.a - q.c), b = r * (q.b - q.d), c = r * (q.c + q.a), d = r * (q.d + q.b);
    }
    high = std::hypot(a, b);
    low = std::hypot(c, d);
  }

  [[nodiscard]] double twice_sum() const { return 2 * std::atan2(b, a); }
  [[nodiscard]] double twice_difference() const { return 2 * std::atan2(d, c); }
};

/// In (−π, π], and 0 without a sign: a sine that arithmetic has left a little below zero would make −π of π.
double angle_of(double sine, double cosine) {
  const double angle = std::atan2(sine, cosine);
  return angle <= -pi ? pi : angle + 0.0;
}

/// The second angle, exact at both ends and, for Cardan angles, relatively exact in the middle.
double second_angle(const OrderedQuaternion& q, const HalfAngles& h, bool proper) {
  if (proper) return 2 * std::atan2(h.low, h.high);
  return angle_of(2 * (q.a * q.c + q.b * q.d), 2 * h.low * h.high);
}

/// First and third by one quotient each: relatively exact far from a lock; nearer, their errors are not in step.
std::pair<double, double> split_by_quotients(const OrderedQuaternion& q, bool proper) {
  const auto [a, b, c, d, sign] = q;
  if (proper) return {angle_of(b * c + a * d, a * c - b * d), angle_of(b * c - a * d, a * c + b * d)};
  const double even = (a - c) * (a + c), odd = (b - d) * (b + d);
  return {angle_of(2 * (a * b - c * d), even - odd), angle_of(2 * sign * (a * d - b * c), even + odd)};
}

/// First and third by the half-angles, their errors in step: they always make the rotation again.
std::pair<double, double> split_by_half_angles(const HalfAngles& h, double third_sign) {
  const double sum = std::atan2(h.b, h.a), difference = std::atan2(h.d, h.c);
  return {wrap_signed(sum + difference) + 0.0, wrap_signed(third_sign * (sum - difference)) + 0.0};
}

EulerDecomposition intrinsic_angles(const UnitQuaternion& q_ij, const EulerSequence& sequence) {
  const bool proper = sequence.is_proper_euler();
  const OrderedQuaternion q(q_ij, sequence);
  const HalfAngles h(q, proper);
  const int third_sign = proper || q.sign < 0 ? 1 : -1;
  const bool at_low_end = h.low < h.high;

  EulerDecomposition result{.angles = {sequence}};
  result.lock_distance = std::min(h.low, h.high);
  result.determined = wrap_signed(at_low_end ? h.twice_sum() : h.twice_difference()) + 0.0;
  result.determined_sign = at_low_end ? third_sign : -third_sign;
  result.angles.second = second_angle(q, h, proper);
  if (result.lock_distance <= tolerance::gimbal_lock) {
    result.singularity = Singularity::gimbal_lock;
    result.angles.first = result.determined;
    // Not the noise that is left: without the chosen angle it would tilt the wrong way.
    result.angles.second = (proper ? pi / 2 : 0) + (at_low_end ? -pi / 2 : pi / 2);
    return result;
  }
  const bool far_from_lock = 4 * h.low * h.high >= 1;  // sine or cosine of the second angle above ½
  std::tie(result.angles.first, result.angles.third) =
      far_from_lock ? split_by_quotients(q, proper) : split_by_half_angles(h, third_sign);
  return result;
}

std::optional<Axis> axis_of(char letter) {
  switch (letter) {
    case 'x':
    case 'X':
    case '1':
      return Axis::x;
    case 'y':
    case 'Y':
    case '2':
      return Axis::y;
    case 'z':
    case 'Z':
    case '3':
      return Axis::z;
    default:
      return std::nullopt;
  }
}

/// Three letters or digits; two hyphens, as in 3-1-3, or none.
std::string without_hyphens(std::string_view name) {
  if (name.size() != 5 || name[1] != '-' || name[3] != '-') return std::string(name);
  return {name[0], name[2], name[4]};
}

}  // namespace

Result<EulerAngles> EulerAngles::of(const EulerSequence& sequence, double first, double second, double third) {
  std::vector<Error> errors;
  const std::array<double, 3> angles{first, second, third};
  for (std::size_t i = 0; i < 3; ++i)
    if (!std::isfinite(angles[i]))
      errors.push_back({"not_finite", fmt::format("angles[{}]", i), "not a number or infinite: give a finite angle"});
  if (!errors.empty()) return errors;
  return EulerAngles{sequence, first, second, third};
}

UnitQuaternion EulerAngles::quaternion() const {
  const UnitQuaternion a = turn_about(sequence.first(), first), b = turn_about(sequence.second(), second),
                       c = turn_about(sequence.third(), third);
  return sequence.turning() == Turning::intrinsic ? a * b * c : c * b * a;
}

Rotation EulerAngles::rotation() const {
  const Rotation a = Rotation::about(sequence.first(), first), b = Rotation::about(sequence.second(), second),
                 c = Rotation::about(sequence.third(), third);
  return sequence.turning() == Turning::intrinsic ? a * b * c : c * b * a;
}

bool EulerDecomposition::is_near_gimbal_lock() const { return lock_distance < tolerance::near_gimbal_lock; }

EulerDecomposition euler_angles(const UnitQuaternion& q_ij, const EulerSequence& sequence) {
  if (sequence.turning() == Turning::intrinsic) return intrinsic_angles(q_ij, sequence);
  EulerDecomposition result = intrinsic_angles(q_ij, sequence.reversed());
  std::swap(result.angles.first, result.angles.third);
  result.angles.sequence = sequence;
  result.determined = wrap_signed(result.determined_sign * result.determined) + 0.0;
  return result;
}

EulerDecomposition euler_angles(const Rotation& c_ij, const EulerSequence& sequence) {
  return euler_angles(c_ij.quaternion(), sequence);
}

Result<EulerSequence> EulerSequence::named(std::string_view name, Turning turning) {
  const std::string letters = without_hyphens(name);
  if (letters.size() == 3) {
    const auto a = axis_of(letters[0]), b = axis_of(letters[1]), c = axis_of(letters[2]);
    if (a && b && c && a != b && b != c) return EulerSequence(*a, *b, *c, turning);
  }
  return Error{"unknown_sequence",
               "sequence",
               fmt::format("\"{}\" is no sequence of three turns about axes: take xyz, xzy, yxz, yzx, zxy, zyx, xyx, "
                           "xzx, yxy, yzy, zxz or zyz",
                           name),
               {{"given", fmt::format("\"{}\"", name)}}};
}

const std::array<EulerSequence, 12>& EulerSequence::all(Turning turning) {
  constexpr auto list = [](Turning t) {
    constexpr Axis x = Axis::x, y = Axis::y, z = Axis::z;
    return std::array<EulerSequence, 12>{{{x, y, z, t},
                                          {x, z, y, t},
                                          {y, x, z, t},
                                          {y, z, x, t},
                                          {z, x, y, t},
                                          {z, y, x, t},
                                          {x, y, x, t},
                                          {x, z, x, t},
                                          {y, x, y, t},
                                          {y, z, y, t},
                                          {z, x, z, t},
                                          {z, y, z, t}}};
  };
  static constexpr auto intrinsic = list(Turning::intrinsic), extrinsic = list(Turning::extrinsic);
  return turning == Turning::intrinsic ? intrinsic : extrinsic;
}

std::string EulerSequence::name() const {
  constexpr std::string_view letters = "xyz";
  return {letters[static_cast<std::size_t>(first_)], letters[static_cast<std::size_t>(second_)],
          letters[static_cast<std::size_t>(third_)]};
}

Rotation resal_frame(double precession, double nutation) {
  return Rotation::about_z(precession) * Rotation::about_x(nutation);
}

ResalFrame resal_frame(const Rotation& c_ij) {
  const EulerAngles euler = euler_angles(c_ij, EulerSequence::euler_313()).angles;
  return {resal_frame(euler.first, euler.second), euler.third};
}

}  // namespace linkwright
