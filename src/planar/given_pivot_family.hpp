#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "linkwright/planar/four_bar_family.hpp"
#include "three_pose_dyads.hpp"

namespace linkwright {

/// A straight line of pivots as an axis of a map: all of it, half of the samples within `spread` of `middle`.
struct PivotRange {
  double middle = 0;  ///< place on the line
  double spread = 1;  ///< > 0

  /// The place at a coordinate in [0, 1]; both ends of the axis are at infinity.
  [[nodiscard]] double at(double coordinate) const;
  /// The coordinate of a place.
  [[nodiscard]] double coordinate_of(double place) const;
};

/// Three positions and both grounded links: one linkage, driven by the input.
class GivenPivotsFamily : public ProductFamily {
 public:
  /// Poses in the user's frame; dyads in `frame`.
  GivenPivotsFamily(const WorkingFrame& frame, std::vector<PrescribedPose> poses, const DyadPair& links);

  [[nodiscard]] std::optional<Dyad> dyad(Side side, double tau) const override;

 private:
  DyadPair links_;
};

/// Three positions and one grounded link: the other has its pivot of a kind anywhere in the plane. The map is that
/// plane: rows run along y (the axis of Side::input), columns along x, whichever link is the one given.
class PivotPlaceFamily : public MotionFamily {
 public:
  /// Poses in the user's frame; `known`, the link of side `given`, in `frame`. `open`: which pivot of the other link is
  /// looked for.
  PivotPlaceFamily(const WorkingFrame& frame, std::vector<PrescribedPose> poses,
                   std::shared_ptr<const ThreePoseDyads> dyads, Side given, const Dyad& known, PivotKind open);

  [[nodiscard]] std::optional<DyadPair> dyad_pair(MapPoint place) const override;
  [[nodiscard]] double axis_value(Side side, double tau) const override;
  [[nodiscard]] std::vector<Dyad> polygon(Side /*side*/) const override { return {}; }
  void fill(RegionMap& map, std::span<const double> input, std::span<const double> output, bool respect_direction,
            const RegionOptions& options, const Progress& progress) const override;

 private:
  [[nodiscard]] std::optional<Dyad> open_dyad(MapPoint place) const;

  std::shared_ptr<const ThreePoseDyads> dyads_;
  Side given_;
  Dyad known_;
  PivotKind open_;
  std::array<PivotRange, 2> ranges_;  ///< of x and y, working frame
};

/// Three positions and a line with a pivot of a kind of each grounded link: all four-bars over the places of both on
/// it.
class PivotsOnLineFamily : public ProductFamily {
 public:
  /// Poses and line in the user's frame.
  PivotsOnLineFamily(const WorkingFrame& frame, std::vector<PrescribedPose> poses,
                     std::shared_ptr<const ThreePoseDyads> dyads, PivotKind kind, const DirectedLine& line);

  [[nodiscard]] bool is_symmetric() const override { return true; }
  [[nodiscard]] std::optional<Dyad> dyad(Side side, double tau) const override;
  /// Along the line from its point, user's unit.
  [[nodiscard]] double axis_value(Side side, double tau) const override;

 private:
  std::shared_ptr<const ThreePoseDyads> dyads_;
  PivotKind kind_;
  DirectedLine line_;  ///< working frame
  PivotRange range_;
};

}  // namespace linkwright
