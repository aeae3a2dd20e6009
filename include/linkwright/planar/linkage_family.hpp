#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "linkwright/algebra/circular_cubic.hpp"
#include "linkwright/core/progress.hpp"
#include "linkwright/mechanism/dyad.hpp"
#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/pose.hpp"
#include "linkwright/planar/burmester_curve.hpp"
#include "linkwright/planar/pose_conditions.hpp"
#include "linkwright/region/hill_climb.hpp"
#include "linkwright/region/region_map.hpp"
#include "linkwright/region/requirement_filter.hpp"
#include "linkwright/region/requirements.hpp"

namespace linkwright {

class LengthCheck;

/// A place on the map, as a pair of coordinates τ.
struct RegionPlace {
  double input = 0, output = 0;  ///< of the driving and of the other side link, where each has an axis of its own
};

/// Part of a map: intervals of τ of the input and of the output side link. A discrete axis has no parts: its interval
/// is not looked at.
struct RegionWindow {
  std::array<double, 2> input{}, output{};
};

/// What the coordinate along an axis of a map stands for.
enum class AxisQuantity {
  curve_coordinate,  ///< place on a Burmester curve
  burmester_point,   ///< one of a few dyads; each fills a branch
  side_direction,    ///< direction of the side link in position 1, degrees
  side_length,       ///< length of the side link, user's unit
  output_scale,      ///< factor on the output's travel
  pair_output,       ///< output angle of one pair, degrees
  nothing,           ///< one place only
};
[[nodiscard]] std::string_view name(AxisQuantity quantity);

/// An axis of a map: branches by rising τ, each of length 1, or 0 where it is a single point.
struct FamilyAxis {
  AxisQuantity quantity = AxisQuantity::curve_coordinate;
  std::vector<CurveBranch> branches;

  [[nodiscard]] double coordinate_length() const { return branches.empty() ? 0 : branches.back().to; }
  /// The end of a branch is its beginning.
  [[nodiscard]] bool is_closed() const {
    return quantity == AxisQuantity::curve_coordinate || quantity == AxisQuantity::side_direction;
  }
  /// Every place of a branch is the same.
  [[nodiscard]] bool is_discrete() const {
    return quantity == AxisQuantity::burmester_point || quantity == AxisQuantity::nothing;
  }
};

/// The branch of an axis on which a coordinate lies.
[[nodiscard]] AxisStretch stretch_around(const FamilyAxis& axis, double tau);

struct SideLinks {
  Dyad input, output;
};

/// The four-bars that a task leaves open, over two coordinates: what the map shows, the search climbs over and the
/// pointer picks from. The dyads are in the working frame, their circle points in position 1.
class LinkageFamily {
 public:
  enum class Side { input, output };

  LinkageFamily(WorkingFrame frame, FamilyAxis input, FamilyAxis output)
      : frame_(frame), input_axis_(std::move(input)), output_axis_(std::move(output)) {}
  LinkageFamily(const LinkageFamily&) = delete;
  LinkageFamily& operator=(const LinkageFamily&) = delete;
  virtual ~LinkageFamily() = default;

  [[nodiscard]] const WorkingFrame& frame() const { return frame_; }
  [[nodiscard]] const FamilyAxis& axis(Side side) const { return side == Side::input ? input_axis_ : output_axis_; }

  /// Both axes carry the same dyads: (u, v) and (v, u) are the same bars, driven from the other side.
  [[nodiscard]] virtual bool is_symmetric() const { return false; }

  /// The side whose coordinate takes longer to change: a search over both changes it the less often.
  [[nodiscard]] virtual Side dearer_side() const { return Side::input; }

  /// The side links at a place; nothing where the family has none there. They may be sliders.
  [[nodiscard]] virtual std::optional<SideLinks> side_links(RegionPlace place) const = 0;
  /// The same; of side links known already those serve again whose coordinates are the place's.
  [[nodiscard]] virtual std::optional<SideLinks> side_links_beside(RegionPlace place,
                                                                   const SideLinks& /*known*/) const {
    return side_links(place);
  }

  /// The same at each cell of a map over these coordinates, which it outlives no more than the family: what the cells
  /// of a row or a column share is worked out once. May be called from several threads.
  using LinksOfCells = std::function<std::optional<SideLinks>(std::size_t row, std::size_t column)>;
  [[nodiscard]] virtual LinksOfCells links_of_cells(std::span<const double> input,
                                                    std::span<const double> output) const;

  /// What the coupler of `bars`, those at a place, is to visit, position 1 being the one in which they lie; user's
  /// frame or working frame, as the bars are.
  [[nodiscard]] virtual std::vector<PrescribedPose> user_poses(RegionPlace place, const FourBar& bars) const = 0;
  [[nodiscard]] virtual std::vector<PrescribedPose> working_poses(RegionPlace place, const FourBar& bars) const = 0;

  /// What people read at a coordinate (degrees, user's length, …): τ itself unless the quantity is another.
  [[nodiscard]] virtual double axis_value(Side side, double tau) const;

  /// `count` coordinates along an axis; a discrete one has one to each branch, whatever is asked.
  [[nodiscard]] virtual std::vector<double> samples(Side side, int count, Spacing spacing) const;

  /// Dyads along the axis close enough to draw their points as curves, by rising τ; none where they depend on the other
  /// coordinate.
  [[nodiscard]] virtual std::vector<Dyad> polygon(Side side) const = 0;

  /// The map over these coordinates.
  void classify(RegionMap& map, std::span<const double> input, std::span<const double> output, bool respect_direction,
                const RegionOptions& options = {}, const Progress& progress = {}) const {
    fill(map, input, output, respect_direction, options, progress);
  }

 private:
  virtual void fill(RegionMap& map, std::span<const double> input, std::span<const double> output,
                    bool respect_direction, const RegionOptions& options, const Progress& progress) const = 0;

  WorkingFrame frame_;
  FamilyAxis input_axis_, output_axis_;
};

/// Coordinates along an axis: family.samples(), within a window evenly in τ.
[[nodiscard]] std::vector<double> samples_within(const LinkageFamily& family, LinkageFamily::Side side,
                                                 const std::optional<RegionWindow>& window, int count, Spacing spacing);

/// True where no window leaves the place out.
[[nodiscard]] bool is_within(const LinkageFamily& family, const std::optional<RegionWindow>& window, RegionPlace place);

/// The four-bar of a pair of side links; nothing where a pivot is at infinity.
[[nodiscard]] std::optional<FourBar> four_bar_of(const SideLinks& links);

/// A map of the family under requirements whose lengths are set. Refers to both, which must outlive it.
[[nodiscard]] RequirementFilter filter_of(const LinkageFamily& family, const RegionMap& map,
                                          const Requirements& requirements);

/// The family of a motion task: every four-bar is to visit the same poses.
class MotionFamily : public LinkageFamily {
 public:
  /// `poses`: the task's, user's frame.
  MotionFamily(WorkingFrame frame, std::vector<PrescribedPose> poses, FamilyAxis input, FamilyAxis output);

  [[nodiscard]] std::vector<PrescribedPose> user_poses(RegionPlace /*place*/, const FourBar& /*bars*/) const override {
    return user_poses_;
  }
  [[nodiscard]] std::vector<PrescribedPose> working_poses(RegionPlace /*place*/,
                                                          const FourBar& /*bars*/) const override {
    return working_poses_;
  }

 protected:
  [[nodiscard]] std::span<const PrescribedPose> working_poses() const { return working_poses_; }

 private:
  std::vector<PrescribedPose> user_poses_, working_poses_;
};

/// Each side link depends on its own coordinate alone.
class ProductFamily : public MotionFamily {
 public:
  using MotionFamily::MotionFamily;

  /// Nothing where the axis has no dyad there.
  [[nodiscard]] virtual std::optional<Dyad> dyad(Side side, double tau) const = 0;

  [[nodiscard]] std::optional<SideLinks> side_links(RegionPlace place) const override;
  [[nodiscard]] std::optional<SideLinks> side_links_beside(RegionPlace place, const SideLinks& known) const override;
  /// Evenly in τ; a place without a dyad is left out.
  [[nodiscard]] std::vector<Dyad> polygon(Side side) const override;

 private:
  void fill(RegionMap& map, std::span<const double> input, std::span<const double> output, bool respect_direction,
            const RegionOptions& options, const Progress& progress) const override;
  [[nodiscard]] RegionAxis region_axis(Side side, std::span<const double> coordinates, bool respect_direction) const;
};

/// Four positions: both side links from the same Burmester curve.
class CurveFamily : public ProductFamily {
 public:
  CurveFamily(const WorkingFrame& frame, std::vector<PrescribedPose> poses,
              std::shared_ptr<const BurmesterCurve> curve);

  [[nodiscard]] bool is_symmetric() const override { return true; }
  [[nodiscard]] std::optional<Dyad> dyad(Side side, double tau) const override;
  [[nodiscard]] std::vector<double> samples(Side side, int count, Spacing spacing) const override;
  [[nodiscard]] std::vector<Dyad> polygon(Side side) const override;

 private:
  std::shared_ptr<const BurmesterCurve> curve_;
  std::shared_ptr<const LengthCheck> lengths_;
};

/// A few dyads, any two of which make a four-bar: the i-th fills the branch [i, i + 1).
class PointFamily : public ProductFamily {
 public:
  PointFamily(const WorkingFrame& frame, std::vector<PrescribedPose> poses, std::vector<Dyad> dyads);

  [[nodiscard]] bool is_symmetric() const override { return true; }
  [[nodiscard]] std::optional<Dyad> dyad(Side side, double tau) const override;

 private:
  std::vector<Dyad> dyads_;
};

}  // namespace linkwright
