#pragma once

#include <limits>

/// All tolerances: pure numbers, each with the reason for its size.
namespace linkwright::tolerance {

/// Difference of the distances of two points of a body over the greatest of them below which they are equal: numbers
/// written with nine digits pass.
inline constexpr double equal_distances = 1e-8;

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

/// A correction onto a curve of configurations (radians), or the closure error left (over the perimeter), below which
/// the point is on it: two digits above what rounding leaves, many below the share of a reach that a step may be off.
inline constexpr double on_curve = 1e-13;

/// Closure of a four-bar's loop over the perimeter that cannot be asked to be less: four ulps of 1, a sum of three
/// links turned by angles of order one.
inline constexpr double loop_rounding = 4 * std::numeric_limits<double>::epsilon();

/// Error of a six-bar's loops over the reach of its strand: no correction need be shorter. Loops of up to six terms
/// carry 1e-15, and the corrections magnify it.
inline constexpr double loop_rounding_per_reach = 1e-14;

/// Closure error of a six-bar's loops, or a correction of its turns, at which Newton's method has nothing left to do:
/// nine ulps of 1.
inline constexpr double closed_to_rounding = 2e-15;

/// Closure error of a six-bar's loops above which Newton's method has failed: near singular configurations it stops
/// three digits above closed_to_rounding.
inline constexpr double closed = 1e-12;

/// Closure error (over the longest link) above which the added links do not fit their hinges: results written with six
/// digits and more pass.
inline constexpr double links_fit = 1e-6;

/// Newton's correction as a share of the unknowns after which no other is needed: it converges quadratically, so that
/// the next would be 1e-18, below rounding.
inline constexpr double last_newton_correction = 1e-9;

/// Turn of the driver (radians) below which Gauss and Newton have found the place nearest to a pose: they converge
/// linearly where it is missed, and the turn itself carries some 1e-15 of a whole one.
inline constexpr double nearest_turn = 1e-12;

/// Relative change of a distance between hinges of one body over a drive, above which the drive is unsound: each state
/// is corrected until Newton's method has nothing left to do, which leaves 1e-15.
inline constexpr double rigid_body = 1e-9;

/// Change of a sample's number (0 to 24) at which the secants that look for the least error of a pose have come to
/// rest: an ulp of the number is up to 4e-15, and a slope's rounding parts two of them by more.
inline constexpr double least_miss_place = 1e-13;

/// Transmission angle (radians) in a position of the task below which it stands at a dead point: there the angle comes
/// out as the root of rounding, 1e-8, and conditions of real tasks take two digits more. Which side of the dead point
/// it is on, and so whether that is a defect, only rounding has decided.
inline constexpr double dead_at_position = 1e-6;

/// Error at a pair (radians) of a generator that was driven, above which it has not brought the output there: close to
/// a dead point rounding of the input shows in the output as its root, 1e-8, with two digits for real tasks.
inline constexpr double pair_met = 1e-6;

/// Distance of a coupler point over the characteristic length, with the crank where it is to be, above which it is not
/// there: close to a dead point rounding of the crank shows in the point as its root, with two digits for real tasks.
inline constexpr double point_met = 1e-6;

/// An input angle this close to the end of the reach (radians) is the end: reach and angle carry 1e-15 each, of an arc
/// cosine and of the whole turns that bring the angle into the reach, and three digits of room.
inline constexpr double end_of_reach = 1e-12;

/// Vector product of the two rows of a four-bar's closure (links over the perimeter) below which all links lie in one
/// line: a linkage at a change point is given with ten digits, and the curve of its configurations crosses itself
/// there.
inline constexpr double collinear_links = 1e-9;

/// Radius of the way of the pole, or turn of the body, over the size of the motion below which there is none: terms of
/// the second order of a motion that was computed carry a few 1e-16, magnified by the linkage.
inline constexpr double vanishing_motion = 1e-12;

/// Coefficient of a path's deviation from a line over the sum of its terms' magnitudes below which it is zero: each
/// order of a four-bar's motion costs a digit of it, and six of them leave this many.
inline constexpr double vanishing_deviation = 1e-9;

/// Way of a coupler point over the longest link, by the way of the links' turns, below which the point rests: next to a
/// cusp the series of its path by the way along a line reaches no farther than the square of this.
inline constexpr double resting_point = 1e-4;

/// A link over the longest below which it has no length, and the task's size over the distance of a pivot below which
/// the pivot is at infinity: a linkage of a straight line carries 1e-13 beside its singular places, and nobody builds
/// links in a ratio of 10⁶.
inline constexpr double vanishing_link = 1e-6;
inline constexpr double sliding_pivot = 1e-6;

/// Distance of two contacts with a line over the size of the task below which they are one: of a multiple contact at
/// their mean they differ by its square, 1e-8, and what parts conditions of three such contacts has as many digits.
inline constexpr double double_contact = 1e-4;

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

/// Distance from the focus of a focal cubic, over its size, below which a point is the focus: its coordinates carry
/// 1e-16 of that size, and nearer the direction to it is noise.
inline constexpr double focus = 1e-14;

/// Coefficient of a Fourier series beside the largest below which it is zero: means of 16 samples carry a few 1e-16.
inline constexpr double vanishing_harmonic = 1e-14;

/// How far a grounded link that was computed may be off the line of those of a three-pose task, as a share of the
/// line's terms: it went through a coordinate and back, 1e-15, or was read with ten digits.
inline constexpr double arm_on_line = 1e-9;

/// Distance of the poses' poles from one point, over the characteristic length, below which dyads are computed in
/// the pole-centred frame: rounding of the conditions, 1e-16, shows in a grounded link of that length as 1e-16 over its
/// square.
inline constexpr double near_common_pole = 1e-3;

/// Distance over the characteristic length of two probes' centres below which all points of the body share one: the
/// conditions have rank 2 to dependent_rows, so centres carry its root, 1e-7, and room.
inline constexpr double shared_center = 1e-6;

/// Value of a condition (unit rows and points) below which a parallelogram satisfies it: the root of dependent_rows.
inline constexpr double parallelogram = 1e-7;

/// Coordinate of a shared centre over the characteristic length that is given as zero: it is printed with six digits,
/// and beside the length none of them would be seen.
inline constexpr double vanishing_coordinate = 1e-9;

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

/// Difference of two numbers over the larger of them below which they are the same (a ground link of no length, a
/// function that does not change): each carries 1e-16, so fewer than four digits of the difference would be left.
inline constexpr double no_difference = 1e-12;

/// Least distance of two input angles, modulo whole turns, that makes two precision points of them, radians: the
/// conditions of two so close leave seven digits, as ill_conditioned does. The ends of a dial closer than this are one
/// place, too: 360° printed with ten digits is a whole turn.
inline constexpr double repeated_input_angle = 1e-9;

/// A pole of the tangent this close (share of a half turn) beyond the end of a dial is on it: the tangent is 3e8 there,
/// beside which no dial has room for what lies between.
inline constexpr double tangent_pole = 1e-9;

/// A first derivative none of whose numbers is this large is zero, no direction: the inverse of the largest that is
/// taken seriously.
inline constexpr double smallest_direction = 1e-9;

/// Two linkages closer than this share of the characteristic length in all four pivots are one, and so are two hinges
/// of a chain closer than this share of its size.
inline constexpr double same_linkage = 1e-6;

/// Orthogonality error ‖AᵀA − E‖ above which a matrix given as a rotation is a mistake: six printed digits pass.
inline constexpr double orthogonality = 1e-6;

/// Orthogonality error of a correctly rounded rotation, at most: 9 elements of half an ulp of 1, twice; room for 4.
inline constexpr double orthogonal_to_rounding = 4e-15;

/// Orthogonality error above which a matrix is no rotation: some 10⁴ rotations multiplied, an ulp each, still are one.
inline constexpr double rotation_matrix = 1e-12;

/// Distance to gimbal lock below which an attitude is taken to be locked: matrices and quaternions of locked attitudes
/// came out up to 4.7e-16 away (960 000 of them).
inline constexpr double gimbal_lock = 5e-16;

/// Distance to gimbal lock below which the two angles that blur into each other have lost half of their digits.
inline constexpr double near_gimbal_lock = 1e-7;

/// An angle of turn (radians), or the angle that a turn is short of π, that counts as none: products of rotation
/// matrices leave a few ulps of 1 behind.
inline constexpr double no_turn = 1e-15;

/// A sliding along the instantaneous axis, in speeds of the body's point at the origin, that counts as none: an inner
/// product of rounded vectors at right angles leaves an ulp or two behind.
inline constexpr double no_slide = 1e-15;

/// Sine of the angle between two lines below which they are parallel: the feet of their common normal are its inverse
/// away, where rounding has cost as much as is lost by taking them for parallel.
inline constexpr double parallel_lines = 1e-8;

/// Distance of two parallel lines over the size of their points' coordinates below which they are one line: two
/// differences and a projection of coordinates carry a few ulps.
inline constexpr double coincident_lines = 1e-15;

/// Share of a matrix given as the derivative of a rotation that no rotation has, above which it is a mistake: six
/// printed digits pass.
inline constexpr double derivative_defect = 1e-5;

/// Coefficient of a cone of moving axes, over the size of the terms that make it up, below which it is zero: some forty
/// terms carry 1e-16 each.
inline constexpr double vanishing_cone = 1e-14;

/// Two orientations closer than this turn (radians) are the same orientation: a quaternion of unit length carries
/// 1e-16.
inline constexpr double repeated_orientation = 1e-12;

/// Smallest singular value of the conditions of orientations (unit rows) below which they share an axis: rows carry
/// 1e-16, those of small turns somewhat more.
inline constexpr double common_axis = 1e-13;

/// Pivot beside the largest below which the multiples of five orientations' minors have a relation that they ought not
/// to have, and more than lines in common: a dozen steps of an orthogonal elimination leave some 1e-15.
inline constexpr double dependent_minors = 1e-13;

/// Distance of two lines (sine), or of two conjugate complex lines from a real one, below which they are judged
/// together: eigenvalues part lines that coincide by the root of their rounding, 1e-7, three of them by 1e-5.
inline constexpr double nearly_double_line = 1e-4;

/// How far outside a window without width or height, over its longer side, a pivot counts as on it: a border met by
/// solving for it carries 1e-12, and nobody measures the ninth digit of a place.
inline constexpr double on_border = 1e-9;

/// Share of a coordinate that a pivot's carries in rounding: two rotations and the way back from the working frame
/// leave some 1e-14, with two digits of room.
inline constexpr double rounded_coordinate = 1e-12;

/// Distance (radians) of two meets of a line with a cubic, or imaginary part of one, below which the line touches it:
/// a double root carries the root of rounding, 1e-8.
inline constexpr double touching_line = 1e-7;

}  // namespace linkwright::tolerance
