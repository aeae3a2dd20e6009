#pragma once

#include <array>
#include <optional>
#include <vector>

#include "linkwright/algebra/directed_line.hpp"
#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/planar/pose_conditions.hpp"

namespace linkwright {

/// What two conditions leave of the dyad's direction.
enum class DirectionFreedom {
  free,         ///< to each arm (length and direction) 0, 1 or 2 dyads
  of_length,    ///< the motion from position 1 to another is a pure translation: the length leaves at most two
                ///< directions, and to each of them a circle (or a line) of centres
  only_shifts,  ///< all poses are parallel: at most one arm, and any centre
};

/// Directions in [from, to], radians, counter-clockwise from `from` in [0, 2π); a full turn where to − from = 2π.
struct DirectionArc {
  double from = 0, to = 0;
};

/// The dyads of a task of three positions, finite or mixed: two conditions Zᵀ M C = 0, which leave a dyad two
/// parameters. With the arm ρ = z − C = R e^{iβ} in position 1, fixed to moving pivot, each condition is a circle of
/// centres,
///
///     Re q |C|² + (b̄ − a + q ρ)·C + k + Re(b ρ) = 0,
///
/// and two circles meet in at most two points (docs/theory/three_poses.md; the circles are those of G. N. Sandor,
/// A. G. Erdman, Advanced Mechanism Design, 1984). Working frame throughout.
class ThreePoseDyads {
 public:
  /// `conditions` has two rows.
  explicit ThreePoseDyads(const PoseConditions& conditions);

  [[nodiscard]] DirectionFreedom freedom() const { return freedom_; }

  /// The centre of a circle point, and the reverse, finite or not; nothing where a line or the plane of them will do.
  [[nodiscard]] std::optional<Homogeneous> center_of(Homogeneous circle) const;
  [[nodiscard]] std::optional<Homogeneous> circle_of(Homogeneous center) const;

  /// The dyad with this pivot; nothing where its other pivot is any point of a line, or of the plane.
  [[nodiscard]] std::optional<Dyad> dyad_with(PivotKind kind, Homogeneous pivot) const;

  /// DirectionFreedom::free: the dyad with this arm on sheet 0 or 1, the sign of a root. Each sheet is continuous in
  /// the arm where it is real, and both meet where the root vanishes. Nothing: not real, at infinity, or the
  /// directions are not free.
  [[nodiscard]] std::optional<Dyad> dyad(Point arm, int sheet) const;

  /// The directions β in which a grounded link of this length has real dyads, by rising `from`; of_length: arcs of no
  /// width, one or two.
  [[nodiscard]] std::vector<DirectionArc> directions(double length) const;

  /// DirectionFreedom::of_length: the length that goes with a direction β. Nothing where there is none, or where any
  /// would do (a motion that starts with a translation prescribes the direction alone).
  [[nodiscard]] std::optional<double> length_of(double beta) const;

  /// DirectionFreedom::of_length: the dyad with this arm at `turn` in [0, 1) round the circle (or along the line, from
  /// end to end) of its centres. Nothing where the arm is none of the task's, or the circle is not real.
  [[nodiscard]] std::optional<Dyad> dyad_round(Point arm, double turn) const;

  /// Dyads whose centre lies on one line and whose circle point lies on another (or the same), at most two, without
  /// those at infinity. Nothing where more than two would do.
  [[nodiscard]] std::optional<std::vector<Dyad>> dyads_on_lines(const DirectedLine& of_centers,
                                                                const DirectedLine& of_circles) const;

  /// Largest |Zᵀ M C| over the conditions for unit Z and C.
  [[nodiscard]] double residual(const Dyad& dyad) const;

 private:
  /// One condition by its parts.
  struct Terms {
    double k = 0;
    Point a{}, b{}, q{};
  };
  /// square |C|² + normal·C + constant = 0.
  struct Circle {
    double square = 0;
    Point normal{};
    double constant = 0;
  };
  [[nodiscard]] static Terms terms_of(const HomogeneousMatrix& row);
  [[nodiscard]] static Circle circle_of_centers(const Terms& terms, Point arm);
  void choose_rows(const PoseConditions& conditions);
  /// Where the line normal·C + constant = 0 meets the circle: a μ² + b μ + c = 0.
  struct Chord {
    Point normal{};
    double constant = 0, a = 0, b = 0, c = 0;
  };
  [[nodiscard]] Chord chord(Point arm) const;
  [[nodiscard]] std::vector<DirectionArc> fixed_directions(double length) const;

  std::array<HomogeneousMatrix, 2> rows_{};
  Terms line_, circle_;  ///< another basis of the two: Re q = 0 in the first
  DirectionFreedom freedom_ = DirectionFreedom::free;
};

}  // namespace linkwright
