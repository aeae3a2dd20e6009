#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "linkwright/algebra/directed_line.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/mechanism/linkage_output.hpp"
#include "linkwright/region/linkage_class.hpp"
#include "linkwright/straight_line/mixed_contacts.hpp"

namespace linkwright {

/// What is given of a linkage whose point is to run straight, beside the line: one of the cases of Han Jianyou et al.,
/// Modern Synthesis Theory and Methods of Linkages, ch. 9 to 11, and of what lies beyond. Lengths in the user's unit,
/// angles in radians. Where a case gives no ground pivots, the line's point is where the coupler point is; otherwise
/// any point of the line. Rays lead from the pole, their angles are counted from the pole tangent.
namespace straight_cases {

/// 9.2: both ground pivots; four points of contact. Axes: directions of the two grounded links.
struct FourPointPivots {
  Point input{}, output{};
  friend bool operator==(const FourPointPivots&, const FourPointPivots&) = default;
};
/// 9.2: the cubic of stationary curvature. Axes: rays of the two grounded links.
struct FourPointCubic {
  double pole_distance = 0;       ///< c, signed: from the pole to the point, along the line's right normal
  double point_ray = 0;           ///< ψC
  std::optional<double> cubic_n;  ///< N; nothing: infinite
  friend bool operator==(const FourPointCubic&, const FourPointCubic&) = default;
};
/// 9.3: Ball's point on the line of the output link. Axes: height of the pole, and of the output's ground pivot, off
/// the line, to the left.
struct BallPointOnSideLink {
  Point input_pivot{};
  friend bool operator==(const BallPointOnSideLink&, const BallPointOnSideLink&) = default;
};
/// 9.4. Axes: height of the point, and of the pole, off the ground link, to the right of the line's direction.
struct IsoscelesTrapezoid {
  double half_frame = 0;
  friend bool operator==(const IsoscelesTrapezoid&, const IsoscelesTrapezoid&) = default;
};
/// 9.5 with both ground pivots: the pole at the output's. No axes.
struct PoleAtGivenPivot {
  Point input{}, output{};
  double output_arm = 0;  ///< signed, along the pole tangent
  friend bool operator==(const PoleAtGivenPivot&, const PoleAtGivenPivot&) = default;
};
/// 9.5. Axes: ray of the point, ray of the input link.
struct PoleAtFixedPivot {
  double pole_distance = 0, output_arm = 0;
  friend bool operator==(const PoleAtFixedPivot&, const PoleAtFixedPivot&) = default;
};
/// 9.6: side links at right angles, the point on the line of the ground link. Axes: distance of the input's pivot,
/// length of the output link, both signed.
struct PoleAtFixedPivotBallPointOnFrame {
  double pole_distance = 0;
  friend bool operator==(const PoleAtFixedPivotBallPointOnFrame&, const PoleAtFixedPivotBallPointOnFrame&) = default;
};
/// 10.1: three linkages at each place. Axes: rays of two grounded links.
struct FivePoint {
  double pole_distance = 0, point_ray = 0;
  friend bool operator==(const FivePoint&, const FivePoint&) = default;
};
/// 10.2: the point at the inflection pole. Axes: rays of two grounded links.
struct FivePointInflectionPole {
  double pole_distance = 0;
  friend bool operator==(const FivePointInflectionPole&, const FivePointInflectionPole&) = default;
};
/// 10.3. Axes: ray of the point, ray of the input link.
struct FivePointSideLinkOnFrame {
  double pole_distance = 0;
  friend bool operator==(const FivePointSideLinkOnFrame&, const FivePointSideLinkOnFrame&) = default;
};
/// Beyond the book. Axes: ray of the point, ray of the input link.
struct SixPoint {
  double pole_distance = 0;
  friend bool operator==(const SixPoint&, const SixPoint&) = default;
};
/// Watt and its kin: grounded links at right angles to the line, the coupler along it, five points of contact. Only the
/// distance of the offsets counts: the datum of both is the foot of the point. Axes: lengths of the grounded links,
/// signed, to the left of the line.
struct ParallelSideLinks {
  double input_offset = 0, output_offset = 0;
  friend bool operator==(const ParallelSideLinks&, const ParallelSideLinks&) = default;
};

/// Ch. 11: contacts at places of the line, which add up to four points. Axes: lengths of the crank and of the point's
/// arm, from the crank's pin to the point. The linkage is given as it lies at the first contact.
struct MixedContacts {
  Point input_pivot{};
  std::vector<PlacedContact> contacts;  ///< by rising s
  double coupler_angle = 0;             ///< from the point, seen from the pin, to the output's moving pivot; 0: a λ
  friend bool operator==(const MixedContacts&, const MixedContacts&) = default;
};
/// 11.4: the λ with equal links, in the middle of its stroke. Axis: the crank's range, where none is given.
struct SymmetricLambdas {
  double stroke = 0;
  std::optional<double> crank_range;
  friend bool operator==(const SymmetricLambdas&, const SymmetricLambdas&) = default;
};

/// What is wanted of a linkage instead of what is given: all cases above are looked over. No axes.
struct Search {
  double stroke = 0;     ///< its middle at the line's point
  double deviation = 0;  ///< half the width of the strip in which the point is to stay
  friend bool operator==(const Search&, const Search&) = default;
};

}  // namespace straight_cases

/// In the order of the contract's table.
using StraightLineCase =
    std::variant<straight_cases::FourPointPivots, straight_cases::FourPointCubic, straight_cases::BallPointOnSideLink,
                 straight_cases::IsoscelesTrapezoid, straight_cases::PoleAtGivenPivot, straight_cases::PoleAtFixedPivot,
                 straight_cases::PoleAtFixedPivotBallPointOnFrame, straight_cases::FivePoint,
                 straight_cases::FivePointInflectionPole, straight_cases::FivePointSideLinkOnFrame,
                 straight_cases::SixPoint, straight_cases::ParallelSideLinks, straight_cases::MixedContacts,
                 straight_cases::SymmetricLambdas, straight_cases::Search>;

/// Key in files: "four_point_pivots", …; both cases with the pole at a pivot have one.
[[nodiscard]] std::string_view name(const StraightLineCase& of);

/// Points that path and line have in common at least, where the linkage lies.
[[nodiscard]] int promised_contact(const StraightLineCase& of);

/// A point of a four-bar's coupler that is to run along a line.
struct StraightLineTask {
  static constexpr const LinkageClass& linkages = straight_line_linkages;
  static constexpr OutputKind output = OutputKind::line;

  LineAtAngle line;
  StraightLineCase given;

  [[nodiscard]] bool is_search() const { return std::holds_alternative<straight_cases::Search>(given); }
  friend bool operator==(const StraightLineTask&, const StraightLineTask&) = default;
};

/// What lengths of the task are measured by, user's unit: the pole's distance, the distance of the ground pivots, …
[[nodiscard]] double size_of(const StraightLineTask& task);

/// The caller's mistakes: numbers out of range, pivots that coincide, a point on the pole tangent. Places `task.…`.
[[nodiscard]] std::vector<Error> mistakes_in(const StraightLineTask& task);

}  // namespace linkwright
