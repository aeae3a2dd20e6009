#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "linkwright/planar/four_bar_family.hpp"
#include "three_pose_dyads.hpp"

namespace linkwright {

/// The dyads of three positions whose grounded link has one length R, along an axis of a map. Working frame.
///
/// In general the branches are sheet_1 and sheet_2, on both of which the direction of the grounded link in position 1
/// is β = 2π (τ mod 1). Where the motion from position 1 to another is a pure translation, β has one or two values: the
/// branches are direction_1 and direction_2, and τ mod 1 runs round the circle of the centres that are left.
class DyadsOfLength {
 public:
  /// `length` > 0, working frame.
  DyadsOfLength(std::shared_ptr<const ThreePoseDyads> dyads, double length);

  [[nodiscard]] double length() const { return length_; }
  [[nodiscard]] const MapAxis& axis() const { return axis_; }
  /// There is no dyad of this length at all.
  [[nodiscard]] bool is_empty() const { return arcs_.empty(); }

  /// β at τ, radians.
  [[nodiscard]] double side_direction(double tau) const;
  /// Nothing where the direction has no real dyad.
  [[nodiscard]] std::optional<Dyad> dyad(double tau) const;
  /// Degrees where the quantity is a direction, τ otherwise.
  [[nodiscard]] double axis_value(double tau) const;
  /// Evenly over the directions that have real dyads, the same on both sheets: with small turns these are few.
  [[nodiscard]] std::vector<double> samples(int count) const;
  /// To be drawn as curves: closer toward the ends of the directions, where both sheets meet with all speed.
  [[nodiscard]] std::vector<Dyad> polygon() const;

 private:
  std::shared_ptr<const ThreePoseDyads> dyads_;
  double length_;
  std::vector<DirectionArc> arcs_;
  MapAxis axis_;
};

/// Three positions and the lengths of both grounded links: all four-bars over the two directions β₁, β₂; up to four to
/// a pair of directions, in the four quadrants of the map.
class SideLengthsFamily : public ProductFamily {
 public:
  /// Poses and lengths in the user's frame.
  SideLengthsFamily(const WorkingFrame& frame, std::vector<PrescribedPose> poses,
                    const std::shared_ptr<const ThreePoseDyads>& dyads, double input_length, double output_length);

  [[nodiscard]] bool is_symmetric() const override { return input_.length() == output_.length(); }
  [[nodiscard]] double axis_value(Side side, double tau) const override { return of(side).axis_value(tau); }
  [[nodiscard]] std::optional<Dyad> dyad(Side side, double tau) const override { return of(side).dyad(tau); }
  [[nodiscard]] std::vector<double> samples(Side side, int count, Spacing spacing) const override;
  [[nodiscard]] std::vector<Dyad> polygon(Side side) const override { return of(side).polygon(); }

 private:
  SideLengthsFamily(const WorkingFrame& frame, std::vector<PrescribedPose> poses, DyadsOfLength input,
                    DyadsOfLength output);
  [[nodiscard]] const DyadsOfLength& of(Side side) const { return side == Side::input ? input_ : output_; }

  DyadsOfLength input_, output_;
};

/// Three positions, the angle γ between the grounded links and the length R₁ of the input: all four-bars over the
/// input's place (as for given lengths) and the output's length R₂ = R₁ tan(π/2 · (τ mod 1)); the output's direction is
/// β + γ. Its branches are sheet_1 and sheet_2, and, where the angle is one of lines, sheet_1_opposite and
/// sheet_2_opposite for β + γ + π. Where the motion from position 1 to another is a pure translation, R₂ follows from
/// the direction: the branches are direct (and opposite), and τ mod 1 runs round the circle of the centres.
class SideAngleFamily : public MotionFamily {
 public:
  /// Poses and length in the user's frame; angle in radians.
  SideAngleFamily(const WorkingFrame& frame, std::vector<PrescribedPose> poses,
                  const std::shared_ptr<const ThreePoseDyads>& dyads, double angle, bool directed, double input_length);

  [[nodiscard]] std::optional<DyadPair> dyad_pair(MapPoint place) const override;
  [[nodiscard]] double axis_value(Side side, double tau) const override;
  [[nodiscard]] std::vector<double> samples(Side side, int count, Spacing spacing) const override;
  [[nodiscard]] std::vector<Dyad> polygon(Side side) const override;
  /// Of the input; the output depends on it.
  [[nodiscard]] std::optional<AxisArcs> arcs_within(Side side, const PivotWindows& windows) const override;
  [[nodiscard]] std::optional<std::vector<AxisArc>> output_arcs_within(double input,
                                                                       const PivotWindows& windows) const override;
  void fill(RegionMap& map, std::span<const double> input, std::span<const double> output, bool respect_direction,
            const RegionOptions& options, const Progress& progress) const override;

 private:
  SideAngleFamily(const WorkingFrame& frame, std::vector<PrescribedPose> poses,
                  std::shared_ptr<const ThreePoseDyads> dyads, double angle, bool directed, DyadsOfLength input);
  [[nodiscard]] std::optional<Dyad> output_at(double input_direction, double tau) const;
  /// Working frame.
  [[nodiscard]] double output_length(double tau) const;

  std::shared_ptr<const ThreePoseDyads> dyads_;
  DyadsOfLength input_;
  double angle_;
};

}  // namespace linkwright
