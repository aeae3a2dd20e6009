#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "approximate/coupler_linkage.hpp"
#include "linkwright/mechanism/pose.hpp"

namespace linkwright {

/// A four-bar that carries a body, by the ten numbers that make its motions: fixed pivots a0 and b0, lengths of input
/// and output, and the moving pivots in the body's frame. Two dyads, either of which could be without the other.
struct BodyLinkage {
  Point a0{}, b0{};
  double a = 0, b = 0;
  Point za{}, zb{};

  [[nodiscard]] LinkLengths lengths() const {
    return {std::sqrt(std::norm(b0 - a0)), a, std::sqrt(std::norm(zb - za)), b};
  }
};

/// Pose of a body by its origin and the unit vector along its x axis: no angle, so no sine and no wrap.
struct BodyPose {
  Point origin{}, axis{1, 0};
};

[[nodiscard]] inline BodyPose body_pose(const Pose& pose) { return {pose.origin, direction(pose.angle)}; }
[[nodiscard]] inline Point carried(const BodyPose& pose, Point body) { return pose.origin + product(body, pose.axis); }

/// Radians in (−π, π] from one axis to the other.
[[nodiscard]] inline double turn_between(Point from, Point to) { return std::atan2(cross(from, to), dot(from, to)); }

/// A displacement of a body, or a direction of it: of the origin, and its turn times the turning length, so that all
/// three numbers are lengths.
struct BodyMove {
  Point origin{};
  double turn = 0;
};
[[nodiscard]] inline double dot(const BodyMove& a, const BodyMove& b) {
  return dot(a.origin, b.origin) + a.turn * b.turn;
}
[[nodiscard]] inline double square(const BodyMove& a) { return dot(a, a); }
[[nodiscard]] inline BodyMove operator+(const BodyMove& a, const BodyMove& b) {
  return {a.origin + b.origin, a.turn + b.turn};
}
[[nodiscard]] inline BodyMove operator*(double by, const BodyMove& a) { return {by * a.origin, by * a.turn}; }
[[nodiscard]] inline BodyMove cross(const BodyMove& a, const BodyMove& b) {
  const double x = a.origin.imag() * b.turn - a.turn * b.origin.imag();
  const double y = a.turn * b.origin.real() - a.origin.real() * b.turn;
  return {{x, y}, cross(a.origin, b.origin)};
}

/// From one pose to another.
[[nodiscard]] inline BodyMove move_between(const BodyPose& from, const BodyPose& to, double turning_length) {
  return {to.origin - from.origin, turning_length * turn_between(from.axis, to.axis)};
}
[[nodiscard]] inline BodyPose moved(const BodyPose& pose, const BodyMove& by, double turning_length) {
  return {pose.origin + by.origin, turned(LoopState{{1, 0}, pose.axis}, 0, by.turn / turning_length).u};
}

/// The two conditions (|w|² − l²)/(2l) = 0 of a body held by links, w = moving less fixed pivot, and their gradients by
/// the displacement of the body. The gradients of the poses that a linkage leaves, a curve, stand across it: also at
/// its dead points. first, second: an orthonormal basis of the two.
struct BodyHold {
  Point va, vb;  ///< w/l: unit vectors along the links where they close
  double fa, fb;
  BodyMove first, second;
  double first_length, share, second_length;  ///< gradient of b = share·(gradient of a) + second_length·second

  BodyHold(const BodyLinkage& linkage, const BodyPose& at, double turning_length) {
    const Point ra = product(linkage.za, at.axis), rb = product(linkage.zb, at.axis);
    va = (at.origin + ra - linkage.a0) / linkage.a;
    vb = (at.origin + rb - linkage.b0) / linkage.b;
    fa = 0.5 * linkage.a * (std::norm(va) - 1);
    fb = 0.5 * linkage.b * (std::norm(vb) - 1);
    const BodyMove by_a{va, cross(ra, va) / turning_length}, by_b{vb, cross(rb, vb) / turning_length};
    const double aa = square(by_a), bb = square(by_b);
    constexpr double least = 1e-10;  // where all pivots are in line the body has two freedoms for an instant
    first_length = std::sqrt(aa + 1e-300);
    share = linkwright::dot(by_a, by_b) / (aa + 1e-300);
    const BodyMove rest = by_b + (-share) * by_a;
    second_length = std::sqrt(std::max(square(rest), least * bb) + 1e-300);
    first = (1 / first_length) * by_a;
    second = (1 / second_length) * rest;
  }

  /// Components along first and second of the shortest displacement by which the two conditions change by −(a, b).
  [[nodiscard]] std::array<double, 2> closing(double a, double b) const {
    return {-a / first_length, -(b - share * a) / second_length};
  }
  /// Squared length of the shortest displacement that closes the links, to first order.
  [[nodiscard]] double square_to_close() const {
    const auto [one, other] = closing(fa, fb);
    return one * one + other * other;
  }
};

/// Brings bodies onto the poses that a linkage leaves.
class BodyClosing {
 public:
  BodyClosing(const BodyLinkage& linkage, double turning_length)
      : linkage_(linkage),
        per_a_(1 / linkage.a),
        per_b_(1 / linkage.b),
        per_turn_(1 / turning_length),
        longest_turn_(0.5 * turning_length),
        scale_(linkage.lengths().longest()) {}

  /// Newton's method by shortest displacements, as far as rounding lets it; false where it does not get there.
  [[nodiscard]] bool close(BodyPose& pose) const {
    constexpr double closed = 1e-15, closed_enough = 1e-12;  // displacement over the longest length
    constexpr double last_step = 1e-8;                       // its square is rounding
    constexpr int most_steps = 14;
    double before = std::numeric_limits<double>::infinity();
    for (int step = 0; step < most_steps; ++step) {
      const Point ra = product(linkage_.za, pose.axis), rb = product(linkage_.zb, pose.axis);
      const Point va = per_a_ * (pose.origin + ra - linkage_.a0), vb = per_b_ * (pose.origin + rb - linkage_.b0);
      const double fa = 0.5 * linkage_.a * (std::norm(va) - 1), fb = 0.5 * linkage_.b * (std::norm(vb) - 1);
      const double error = std::max(std::abs(fa), std::abs(fb));
      if (error <= closed * scale_ || (error <= closed_enough * scale_ && error > 0.5 * before)) return true;
      if (!std::isfinite(error)) return false;
      before = error;
      const double ta = per_turn_ * cross(ra, va), tb = per_turn_ * cross(rb, vb);
      const double aa = std::norm(va) + ta * ta, bb = std::norm(vb) + tb * tb, ab = linkwright::dot(va, vb) + ta * tb;
      constexpr double least = 1e-10;  // as BodyHold has it
      const double by_det = 1 / std::max(aa * bb - ab * ab, least * aa * bb);
      const double ka = by_det * (ab * fb - bb * fa), kb = by_det * (ab * fa - aa * fb);
      BodyMove by{ka * va + kb * vb, ka * ta + kb * tb};
      if (std::abs(by.turn) > longest_turn_) by = (longest_turn_ / std::abs(by.turn)) * by;
      const double turn = per_turn_ * by.turn;
      pose = {pose.origin + by.origin, turned(LoopState{{1, 0}, pose.axis}, 0, turn).u};
      if (std::norm(by.origin) + by.turn * by.turn <= last_step * last_step * scale_ * scale_) return true;
    }
    return false;
  }

 private:
  const BodyLinkage& linkage_;
  double per_a_, per_b_, per_turn_, longest_turn_, scale_;
};

/// The same linkage as one that traces the path of the body's origin, and its state.
[[nodiscard]] inline CouplerLinkage coupler_linkage(const BodyLinkage& l) {
  const Point along = l.zb - l.za;
  const double h = std::abs(along);
  return {l.a0, l.b0, l.a, h, l.b, product(-l.za, std::conj(along)) / h};
}
[[nodiscard]] inline LoopState loop_state(const BodyLinkage& l, const BodyPose& at) {
  const Point along = product(l.zb - l.za, at.axis);
  return {(carried(at, l.za) - l.a0) / l.a, along / std::abs(along)};
}
[[nodiscard]] inline BodyPose body_pose(const BodyLinkage& l, const LoopState& state) {
  const Point along = l.zb - l.za, axis = product(state.u, std::conj(along)) / std::abs(along);
  return {l.a0 + l.a * state.e - product(l.za, axis), axis};
}

/// cross(u, B − B0)/b, of the unit vector u along the coupler: the sine of the transmission angle, with a sign.
[[nodiscard]] inline double transmission_sine(const BodyLinkage& l, const BodyPose& at) {
  const Point along = product(l.zb - l.za, at.axis);
  return cross(along, carried(at, l.zb) - l.b0) / (std::sqrt(std::norm(along)) * l.b);
}

/// As it holds the body there.
[[nodiscard]] inline FourBar four_bar(const BodyLinkage& l, const BodyPose& at) {
  return {l.a0, carried(at, l.za), l.b0, carried(at, l.zb)};
}
/// The other link as the input.
[[nodiscard]] inline BodyLinkage swapped(const BodyLinkage& l) { return {l.b0, l.a0, l.b, l.a, l.zb, l.za}; }

/// By a four-bar that holds the body at a pose.
[[nodiscard]] inline BodyLinkage body_linkage(const FourBar& bars, const BodyPose& at) {
  const auto in_body = [&](Point p) { return product(p - at.origin, std::conj(at.axis)); };
  const LinkLengths lengths = bars.lengths();
  return {bars.input_fixed, bars.output_fixed,          lengths.input,
          lengths.output,   in_body(bars.input_moving), in_body(bars.output_moving)};
}

}  // namespace linkwright
