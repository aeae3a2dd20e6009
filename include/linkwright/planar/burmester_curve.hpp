#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "linkwright/algebra/circular_cubic.hpp"
#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/planar/pose_conditions.hpp"
#include "linkwright/region/map_axis.hpp"

namespace linkwright {

/// Longest side of a polygon that looks smooth at some zoom, in characteristic lengths of a task.
inline constexpr double drawn_side = 0.025;

/// All dyads that satisfy three pose conditions, in order: the circle-point curve with, to each of its points,
/// the partner on the centre-point curve (L. Burmester, Lehrbuch der Kinematik, 1888). Working frame throughout.
///
/// The circle-point curve's own branches come first. A component of the centre-point curve that belongs to a
/// single circle point (where the conditions leave a whole line of centres) follows as a branch `center_line`,
/// so that the list of dyads is complete for both curves. A component of the circle-point curve may likewise
/// share one centre.
class BurmesterCurve {
 public:
  /// `conditions` has three rows. Rank below three gives kind every_point and no branches.
  explicit BurmesterCurve(const PoseConditions& conditions);

  /// Of the circle-point curve.
  [[nodiscard]] CubicKind kind() const { return solving_.circle_curve.kind(); }
  /// Of the centre-point curve, which may be of another kind where one of them is reducible.
  [[nodiscard]] CubicKind center_kind() const { return solving_.center_curve.kind(); }
  /// Of the circle-point curve (CircularCubic::kappa).
  [[nodiscard]] std::optional<double> kappa() const { return solving_.circle_curve.kappa(); }
  /// By rising τ, those of the circle-point curve first; none where every point is a circle point.
  [[nodiscard]] const std::vector<CurveBranch>& branches() const { return branches_; }
  /// As the working frame shows them; where the poses nearly share a pole, the dyads are more exact.
  [[nodiscard]] const CircularCubic& circle_curve() const { return circle_curve_; }
  [[nodiscard]] const CircularCubic& center_curve() const { return center_curve_; }

  /// End of the range of τ: a whole number of branches; 0 where every point is a circle point.
  [[nodiscard]] double coordinate_length() const { return branches_.empty() ? 0 : branches_.back().to; }

  /// The dyad at τ (taken modulo coordinate_length()), polished to |Zᵀ M C| ≈ 1e-16, unit vectors.
  [[nodiscard]] Dyad dyad(double tau) const;

  /// τ of a circle point; nothing where every point is one.
  [[nodiscard]] std::optional<double> coordinate_of(Homogeneous circle) const;

  /// `count` coordinates: τᵢ = length·(i + ½)/count, or the same in arc length.
  [[nodiscard]] std::vector<double> samples(int count, Spacing spacing) const;

  /// Coordinates, by rising τ, and the length run up to each over all branches: a polygon with sides of at most
  /// `longest_side` (radians); between its corners the length can be interpolated linearly, exactly to the eye where
  /// they are as short as by default. A branch without length has no entry. Excursions of the curve to infinity are in
  /// it however short they are in τ; any other that is shorter than 1/256 of a branch may be passed over.
  struct ArcLengthTable {
    std::vector<double> tau, length;
  };
  [[nodiscard]] ArcLengthTable arc_length_table(double longest_side = 2e-3) const;

  /// Dyads along all branches, by rising τ, each branch closed by its first dyad again (its coordinate just short of
  /// the branch's end), so dense that the two unit vectors together run at most `longest_side` (radians) from one to
  /// the next.
  [[nodiscard]] std::vector<Dyad> polygon(double longest_side) const;

  /// Centre points that belong to a circle point, and the reverse: null vector of the conditions.
  [[nodiscard]] Homogeneous center_of(Homogeneous circle) const;
  [[nodiscard]] Homogeneous circle_of(Homogeneous center) const;

  /// τ of all dyads whose centre point (or circle point) lies on a line of the working frame, given by its coordinates:
  /// at most three on an irreducible curve, a touching one included. A component that lies in the line, or to which one
  /// such point belongs as a whole, adds none, but for the place where it meets the rest.
  [[nodiscard]] std::vector<double> coordinates_of_centers_on(Homogeneous line) const;
  [[nodiscard]] std::vector<double> coordinates_of_circles_on(Homogeneous line) const;

  /// Largest |Zᵀ M C| over the conditions for unit Z and C; where the poses nearly share a pole, in the pole-centred
  /// frame.
  [[nodiscard]] double residual(const Dyad& dyad) const;

 private:
  struct PartnerLine {
    Homogeneous circle, from, to;  ///< centres from·cos πt + to·sin πt
  };
  /// The curves in the frame in which dyads are computed.
  struct SolvingFrame {
    SolvingFrame(const PoseConditions& asked, const std::vector<HomogeneousMatrix>& rows);
    std::array<HomogeneousMatrix, 3> conditions;
    PlaneCubic circle_cubic, center_cubic;
    CircularCubic circle_curve, center_curve;
  };
  [[nodiscard]] Homogeneous to_solving_frame(Homogeneous working) const;
  [[nodiscard]] Homogeneous to_working(Homogeneous seen) const;
  [[nodiscard]] std::vector<Dyad> dyads_at_infinity() const;
  void find_partner_lines();
  [[nodiscard]] std::array<Homogeneous, 2> solving_points_of(Homogeneous line) const;
  [[nodiscard]] std::vector<double> evenly_by_length(int count) const;
  template <class Visit>
  void walk(int first_sides, double longest_side, const Visit& visit) const;

  std::optional<WorkingFrame> pole_frame_;  ///< PoseConditions::near_pole; nothing: the working frame itself
  SolvingFrame solving_;
  CircularCubic circle_curve_, center_curve_;  ///< working frame
  std::vector<CurveBranch> branches_;
  std::vector<PartnerLine> partner_lines_;
};

/// A place worth marking on the curves of a task.
struct CurveMark {
  enum class Kind : std::uint8_t {
    pole,                ///< of two poses: on the centre-point curve, and as a circle point moved back to position 1
    node,                ///< the curve meets itself
    center_at_infinity,  ///< slider: the moving pivot runs on a straight line
    circle_at_infinity,  ///< slider: a guide of the body runs through the fixed pivot
    focus,               ///< singular foci of the two curves
  };
  Kind kind = Kind::pole;
  std::array<int, 2> poses{};           ///< of a pole, from 0
  std::vector<double> tau;              ///< dyads that have it as centre point, circle point or both; none for foci
  std::optional<Point> center, circle;  ///< on the fixed curve, on the moving curve in position 1; fixed frame
};
/// "pole", "node", …
[[nodiscard]] std::string_view name(CurveMark::Kind kind);

/// Poles by pose pairs, then nodes, points at infinity by τ, foci. `polygon`: the curve's, in its own frame, along
/// which points at infinity are looked for.
[[nodiscard]] std::vector<CurveMark> curve_marks(const std::vector<PrescribedPose>& poses, const BurmesterCurve& curve,
                                                 const WorkingFrame& frame, std::span<const Dyad> polygon);

}  // namespace linkwright
