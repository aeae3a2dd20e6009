#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/pose.hpp"
#include "linkwright/planar/burmester_curve.hpp"
#include "linkwright/planar/four_bar_map.hpp"
#include "linkwright/planar/pose_conditions.hpp"
#include "linkwright/region/linkage_family.hpp"

namespace linkwright {

class LengthCheck;
struct PoseFit;

struct DyadPair {
  Dyad input, output;
};

/// The four-bars that a task leaves open, over two coordinates: what the map shows, the search climbs over and the
/// pointer picks from. The dyads are in the working frame, their circle points in position 1.
class FourBarFamily : public LinkageFamily {
 public:
  /// `frame`: in which the dyads are given; the axes as LinkageFamily has them.
  FourBarFamily(WorkingFrame frame, MapAxis input, MapAxis output)
      : LinkageFamily(std::move(input), std::move(output)), frame_(frame) {}

  [[nodiscard]] const WorkingFrame& frame() const { return frame_; }

  /// The pair of dyads at a map point; nothing where the family has none there. They may be sliders.
  [[nodiscard]] virtual std::optional<DyadPair> dyad_pair(MapPoint place) const = 0;
  /// The same, reusing those of the known dyads whose coordinates are the point's.
  [[nodiscard]] virtual std::optional<DyadPair> dyad_pair_reusing(MapPoint place, const DyadPair& /*known*/) const {
    return dyad_pair(place);
  }

  /// The dyad at a coordinate of an axis; nothing where the axis has none there, or where it depends on the other
  /// coordinate, too.
  [[nodiscard]] virtual std::optional<Dyad> dyad(Side /*side*/, double /*tau*/) const { return std::nullopt; }

  /// The pair at each cell of a map over these coordinates, which it outlives no more than the family: what the cells
  /// of a row or a column share is worked out once. May be called from several threads.
  using DyadPairsOfCells = std::function<std::optional<DyadPair>(std::size_t row, std::size_t column)>;
  [[nodiscard]] virtual DyadPairsOfCells dyad_pairs_of_cells(std::span<const double> input,
                                                             std::span<const double> output) const;

  /// What the coupler of `bars`, those at a place, is to visit, position 1 being the one in which they lie; user's
  /// frame or working frame, as the bars are.
  [[nodiscard]] virtual std::vector<PrescribedPose> user_poses(MapPoint place, const FourBar& bars) const = 0;
  [[nodiscard]] virtual std::vector<PrescribedPose> working_poses(MapPoint place, const FourBar& bars) const = 0;

  /// The dyads at coordinates of an axis, no_dyad() where there is none; empty where they depend on the other
  /// coordinate.
  [[nodiscard]] virtual std::vector<Dyad> dyads(Side /*side*/, std::span<const double> /*coordinates*/) const {
    return {};
  }

  /// Dyads along the axis close enough to draw their points as curves, by rising τ; none where they depend on the other
  /// coordinate.
  [[nodiscard]] virtual std::vector<Dyad> polygon(Side side) const = 0;

  /// There are near poses beside the exact ones: said once, by whoever sets the family up, before anything asks it.
  virtual void has_near_poses() const {}
  /// Of linkages that were fitted to near poses: how that at a place was; null where there is none, and of others.
  [[nodiscard]] virtual const PoseFit* fit_at(MapPoint /*place*/) const { return nullptr; }

  [[nodiscard]] std::span<const Measure> measures() const override { return planar_measures; }
  [[nodiscard]] CellAt cells(bool respect_direction) const override;
  [[nodiscard]] MapPivots pivots(const RegionMap& map) const override;

  [[nodiscard]] std::optional<LinkageOutput> output(MapPoint place) const override;
  /// Of bars (user's frame) known already.
  [[nodiscard]] virtual LinkageOutput output_of(MapPoint place, const FourBar& bars) const;
  [[nodiscard]] std::shared_ptr<const FourBarCells> four_bar_cells(const RegionMap& map) const override;

 protected:
  /// arcs_within() of grounded links that depend on their own coordinate alone.
  [[nodiscard]] std::vector<AxisArc> arcs_of_dyads(Side side, const PivotWindows& windows,
                                                   const std::function<std::optional<Dyad>(double tau)>& dyad_at) const;

 private:
  WorkingFrame frame_;
};

/// Its hinges.
[[nodiscard]] Pivots pivots_of(const FourBar& bars);
/// The bars of four hinges.
[[nodiscard]] FourBar four_bar_of(const Pivots& pivots);
/// The four-bar of a pair of dyads; nothing where a pivot is at infinity.
[[nodiscard]] std::optional<FourBar> four_bar_of(const DyadPair& links);

/// The family of a motion task: every four-bar is to visit the same poses.
class MotionFamily : public FourBarFamily {
 public:
  /// `poses`: the task's, user's frame.
  MotionFamily(WorkingFrame frame, std::vector<PrescribedPose> poses, MapAxis input, MapAxis output);

  [[nodiscard]] const LinkageClass& linkages() const override { return *linkages_; }
  void has_near_poses() const override { linkages_ = &near_motion_linkages; }

  [[nodiscard]] std::vector<PrescribedPose> user_poses(MapPoint /*place*/, const FourBar& /*bars*/) const override {
    return user_poses_;
  }
  [[nodiscard]] std::vector<PrescribedPose> working_poses(MapPoint /*place*/, const FourBar& /*bars*/) const override {
    return working_poses_;
  }

 protected:
  [[nodiscard]] std::span<const PrescribedPose> working_poses() const { return working_poses_; }

 private:
  std::vector<PrescribedPose> user_poses_, working_poses_;
  mutable const LinkageClass* linkages_ = &planar_linkages;
};

/// Each dyad depends on its own coordinate alone.
class ProductFamily : public MotionFamily {
 public:
  using MotionFamily::MotionFamily;

  [[nodiscard]] std::optional<Dyad> dyad(Side side, double tau) const override = 0;
  [[nodiscard]] std::optional<DyadPair> dyad_pair(MapPoint place) const override;
  [[nodiscard]] std::optional<DyadPair> dyad_pair_reusing(MapPoint place, const DyadPair& known) const override;
  [[nodiscard]] std::vector<Dyad> dyads(Side side, std::span<const double> coordinates) const override;
  [[nodiscard]] DyadPairsOfCells dyad_pairs_of_cells(std::span<const double> input,
                                                     std::span<const double> output) const override;
  [[nodiscard]] MapPivots pivots(const RegionMap& map) const override;
  [[nodiscard]] std::optional<AxisArcs> arcs_within(Side side, const PivotWindows& windows) const override;
  /// Evenly in τ; a place without a dyad is left out.
  [[nodiscard]] std::vector<Dyad> polygon(Side side) const override;

 protected:
  /// User's frame; nothing at infinity, and where there is no dyad.
  [[nodiscard]] GroundedLinkPivots pivots_at(Side side, double tau) const;

 private:
  [[nodiscard]] std::vector<GroundedLinkPivots> pivots_of(const std::vector<Dyad>& links) const;
  void fill(RegionMap& map, std::span<const double> input, std::span<const double> output, bool respect_direction,
            const RegionOptions& options, const Progress& progress) const override;
};

/// Four positions: both dyads from the same Burmester curve.
class CurveFamily : public ProductFamily {
 public:
  /// Poses in the user's frame; `curve` in `frame`.
  CurveFamily(const WorkingFrame& frame, std::vector<PrescribedPose> poses,
              std::shared_ptr<const BurmesterCurve> curve);

  [[nodiscard]] bool is_symmetric() const override { return true; }
  [[nodiscard]] std::optional<Dyad> dyad(Side side, double tau) const override;
  [[nodiscard]] std::vector<double> samples(Side side, int count, Spacing spacing) const override;
  [[nodiscard]] std::vector<Dyad> polygon(Side side) const override;
  /// In closed form: where a curve meets the sides of a box.
  [[nodiscard]] std::optional<AxisArcs> arcs_within(Side side, const PivotWindows& windows) const override;

 private:
  std::shared_ptr<const BurmesterCurve> curve_;
  std::shared_ptr<const LengthCheck> lengths_;
};

/// A few dyads, any two of which make a four-bar: the i-th fills the branch [i, i + 1).
class PointFamily : public ProductFamily {
 public:
  /// Poses in the user's frame; `dyads` in `frame`, each with the coordinate index + ½.
  PointFamily(const WorkingFrame& frame, std::vector<PrescribedPose> poses, std::vector<Dyad> dyads);

  [[nodiscard]] bool is_symmetric() const override { return true; }
  [[nodiscard]] std::optional<Dyad> dyad(Side side, double tau) const override;

 private:
  std::vector<Dyad> dyads_;
};

}  // namespace linkwright
