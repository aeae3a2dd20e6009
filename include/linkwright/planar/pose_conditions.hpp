#pragma once

#include <optional>
#include <vector>

#include "linkwright/algebra/homogeneous.hpp"
#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/pose.hpp"

namespace linkwright {

/// The frame in which the solvers work: origin at the moving frame's origin in position 1, directions as in
/// the fixed frame, lengths divided by the characteristic length L = rms|a| / rms|1 − r| over the condition
/// rows (a typical pole distance), so that answers do not depend on where the drawing lies or how big it is.
struct WorkingFrame {
  Point origin{};
  double scale = 1;  ///< L, user's unit

  /// Between this frame and the one in which it is defined.
  [[nodiscard]] Point to_user(Point p) const { return origin + scale * p; }
  [[nodiscard]] Point to_working(Point p) const { return (p - origin) / scale; }
  /// Points at infinity keep their direction; the vectors are not normalised.
  [[nodiscard]] Homogeneous to_user(Homogeneous p) const;
  [[nodiscard]] Homogeneous to_working(Homogeneous p) const;
  [[nodiscard]] FourBar to_user(const FourBar& bars) const;
  /// Both points, neither vector normalised; the coordinate stays.
  [[nodiscard]] Dyad to_user(const Dyad& dyad) const;
  /// The finite point of a homogeneous one in the fixed frame; nothing where it is at infinity, which is judged in the
  /// working frame.
  [[nodiscard]] std::optional<Point> finite_user_point(Homogeneous user) const;
  /// Angles stay; derivatives of the origin are divided by the scale.
  [[nodiscard]] std::vector<PrescribedPose> to_working(const std::vector<PrescribedPose>& poses) const;
};

/// Pole-centred frame of poses that are nearly rotations about one pole: in the working frame little but round-off is
/// left of their differences, in this frame all of it.
struct PoleFrame {
  /// Within the working frame: origin at the point that the poses move least, lengths divided by the distance at which
  /// their poles lie from it (rms|a| / rms|1 − r|, a measured from there).
  WorkingFrame frame;
  std::vector<HomogeneousMatrix> rows;  ///< as PoseConditions::rows, in this frame
  double deviation = 0;                 ///< working frame: largest position error of a rotation about the pole
};

/// What the task asks of a dyad (circle point Z, centre point C, working frame): Zᵀ M C = 0 for every M.
/// With Z(t) = a + r z the moved circle point, the condition |Z(t) − C|² = const and its derivatives are
/// bilinear in the homogeneous Z and C; n positions, each counted with its multiplicity, give n − 1 of them.
struct PoseConditions {
  WorkingFrame frame;
  std::vector<HomogeneousMatrix>
      rows;  ///< orthonormal (as 9-vectors) basis of the conditions, by falling singular value
  std::vector<double> singular_values;
  int rank = 0;                    ///< rows that are independent to tolerance::dependent_rows
  bool only_translations = false;  ///< all poses are parallel
  /// Four positions with poles closer together than tolerance::near_common_pole, where that frame helps.
  std::optional<PoleFrame> near_pole;

  /// The rank is full.
  [[nodiscard]] bool are_independent() const { return rank == static_cast<int>(rows.size()); }
  /// Largest over smallest singular value, infinite or nearly so where they are dependent; above
  /// tolerance::ill_conditioned the poses are too close for the arithmetic.
  [[nodiscard]] double condition() const;
};

/// WorkingFrame::scale of poses, user's unit; 1 where they are all the same. At least two.
[[nodiscard]] double characteristic_length(const std::vector<PrescribedPose>& poses);

/// Conditions of any pattern of positions (docs/theory/planar.md, section 2). At least two positions.
[[nodiscard]] PoseConditions pose_conditions(const std::vector<PrescribedPose>& poses);

/// Those conditions alone that the derivatives of the poses set (user's unit), as orthonormal rows in `frame`; none
/// where no pose has derivatives.
[[nodiscard]] std::vector<HomogeneousMatrix> derivative_conditions(const std::vector<PrescribedPose>& poses,
                                                                   const WorkingFrame& frame);

/// Largest |Zᵀ M C| of a dyad, its points at unit length, over rows.
[[nodiscard]] double residual_of(const Dyad& dyad, const std::vector<HomogeneousMatrix>& rows);

}  // namespace linkwright
