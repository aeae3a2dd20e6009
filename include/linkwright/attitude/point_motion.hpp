#pragma once

#include "linkwright/attitude/angular_motion.hpp"
#include "linkwright/attitude/displacement.hpp"

namespace linkwright {

/// Position, velocity and acceleration of a point, by coordinates in one frame (user's length, and unit of time).
struct PointMotion {
  Vector3 position{}, velocity{}, acceleration{};
};

/// A body, its frame j, in general motion against frame i; everything in i.
struct BodyMotion {
  Rotation attitude;      ///< C_ij
  AngularMotion angular;  ///< ω and ε of j against i, in i
  PointMotion origin;     ///< of the origin of j

  /// Takes coordinates in j to coordinates in i.
  [[nodiscard]] Displacement pose() const { return {attitude, origin.position}; }
};

/// The five parts of the acceleration of a point that moves in a moving body, in frame i. Their sum is the
/// acceleration.
struct AccelerationParts {
  Vector3 of_origin{};    ///< a_O
  Vector3 tangential{};   ///< ε × r, with r = C ρ from the origin of the body to the point
  Vector3 centripetal{};  ///< ω × (ω × r)
  Vector3 coriolis{};     ///< 2 ω × C ρ̇
  Vector3 relative{};     ///< C ρ̈

  /// The acceleration of the point, frame i.
  [[nodiscard]] Vector3 sum() const;
};

/// A point r of a body that turns about the origin: v = ω × r, a = ε × r + ω × (ω × r), all in one frame. (Han Jianyou
/// et al., Modern Synthesis Theory and Methods of Linkages, 2013, section 1.2.3.)
[[nodiscard]] PointMotion motion_about_fixed_point(const AngularMotion& angular, Vector3 r);

/// The motion in i of a point that stays at ρ in the body (coordinates in j): r = r_O + C ρ, v = v_O + ω × C ρ,
/// a = a_O + ε × C ρ + ω × (ω × C ρ). (The book's section 1.4.)
[[nodiscard]] PointMotion point_motion(const BodyMotion& body, Vector3 rho_j);

/// The motion in i of a point that moves in the body by ρ(t) (coordinates in j, derivatives as seen from j):
/// v = v_O + ω × C ρ + C ρ̇ and the acceleration of acceleration_parts(). (The book's section 1.4.)
[[nodiscard]] PointMotion point_motion(const BodyMotion& body, const PointMotion& rho_j);

/// The parts of that acceleration: a_O + ε × C ρ + ω × (ω × C ρ) + 2 ω × C ρ̇ + C ρ̈.
[[nodiscard]] AccelerationParts acceleration_parts(const BodyMotion& body, const PointMotion& rho_j);

/// The motion of body k in i of those of body j in i and of k in j.
[[nodiscard]] BodyMotion operator*(const BodyMotion& ij, const BodyMotion& jk);

/// The motion of frame i seen from frame j, in j.
[[nodiscard]] BodyMotion inverse(const BodyMotion& ij);

}  // namespace linkwright
