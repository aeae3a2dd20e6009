#pragma once

/// All tolerances: pure numbers, each with the reason for its size.
namespace linkwright::tolerance {

/// |w| of a unit homogeneous vector in the working frame below which a point counts as at infinity:
/// a pivot 1e9 task lengths away leaves 7 digits of a position.
inline constexpr double infinity = 1e-9;

/// A Grashof excess Tᵢ, or a link, below this share of the perimeter is zero: a change point, a degenerate link.
/// Pivots computed through two rotations carry 1e-13; four orders of room.
inline constexpr double change_point = 1e-9;

/// A diagonal short of a dead point by less than this share of the perimeter lies at it: the diagonal, and dead points'
/// input angles brought back to diagonals, carry a few 1e-16.
inline constexpr double dead_point = 1e-14;

/// |sin μ| below which velocities are noise: sin² μ carries the diagonal's 1e-16, which leaves it two digits here.
inline constexpr double dead_point_sine = 1e-7;

/// Smallest singular value σ of the loop Jacobian (lengths over the perimeter) below which strands of the configuration
/// curve cannot be told apart: they are some σ apart, and loop closure to 1e-15 leaves them uncertain by 1e-15 / σ.
inline constexpr double crossing_strands = 1e-6;

/// The same of six-bars, by the radius (radians) of the ball in which there is one strand only: σ over four times the
/// largest column, and so well below σ itself.
inline constexpr double crossing_strands_radius = 1e-7;

/// Smallest singular value of the condition rows relative to the largest below which they are dependent:
/// rows of unit size carry rounding of a few 1e-16.
inline constexpr double dependent_rows = 1e-14;

/// Condition of the rows above which the answer is given with a warning: 7 digits are left in the dyads.
inline constexpr double ill_conditioned = 1e9;

/// Coefficient of a cubic of orthonormal rows below which it is zero (rounding of a 3×3 determinant: a few 1e-16,
/// magnified by the conditioning of real tasks).
inline constexpr double vanishing_coefficient = 1e-10;

/// |κ| below which the two branches of a focal cubic meet: a node. κ carries 1e-13, and less in proportion as
/// the coefficients that it depends on vanish.
inline constexpr double node = 1e-11;

/// Distance of the poses' poles from one point, over the characteristic length, below which dyads are computed in
/// the pole-centred frame: rounding of the conditions, 1e-16, shows in a grounded link of that length as 1e-16 over its
/// square.
inline constexpr double near_common_pole = 1e-3;

/// Change of a grounded link's length over the positions, as a share of it, above which it is none: seven digits, as
/// ill_conditioned leaves. Ordinary tasks keep twelve.
inline constexpr double side_link_length = 1e-6;

/// Relative distance of a translation's rotation |q| below which the poses only translate.
inline constexpr double pure_translation = 1e-11;

/// Two solutions closer than this (angle between unit vectors) are one of multiplicity two: where they meet, rounding
/// parts them by its root, 1e-8, and conditions of real tasks take two digits more.
inline constexpr double double_point = 1e-6;

/// Second singular value of the unit-row dyad system below which a point has a whole line of partners.
inline constexpr double line_of_partners = 1e-8;

/// Two poses closer than this (position over characteristic length, angle in radians) are the same pose.
inline constexpr double repeated_pose = 1e-12;

/// Two linkages closer than this share of the characteristic length in all four pivots are one.
inline constexpr double same_linkage = 1e-6;

/// Orthogonality error ‖AᵀA − E‖ above which a matrix given as a rotation is a mistake: six printed digits pass.
inline constexpr double orthogonality = 1e-6;

/// Orthogonality error of a correctly rounded rotation, at most: 9 elements of half an ulp of 1, twice; room for 4.
inline constexpr double orthogonal_to_rounding = 4e-15;

/// Distance to gimbal lock below which an attitude is taken to be locked: matrices and quaternions of locked attitudes
/// came out up to 4.7e-16 away (960 000 of them).
inline constexpr double gimbal_lock = 5e-16;

/// Distance to gimbal lock below which the two angles that blur into each other have lost half of their digits.
inline constexpr double near_gimbal_lock = 1e-7;

/// An angle of turn (radians), or the angle that a turn is short of π, that counts as none: products of rotation
/// matrices leave a few ulps of 1 behind.
inline constexpr double no_turn = 1e-15;

/// Sine of the angle between two lines below which they are parallel: the feet of their common normal are its inverse
/// away, where rounding has cost as much as is lost by taking them for parallel.
inline constexpr double parallel_lines = 1e-8;

/// Share of a matrix given as the derivative of a rotation that no rotation has, above which it is a mistake: six
/// printed digits pass.
inline constexpr double derivative_defect = 1e-5;

}  // namespace linkwright::tolerance
