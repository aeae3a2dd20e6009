#pragma once

#include <optional>
#include <string>
#include <vector>

#include "linkwright/planar/fitted_path.hpp"
#include "linkwright/planar/four_bar_family.hpp"
#include "linkwright/planar/path_task.hpp"
#include "linkwright/planar/task_family.hpp"
#include "linkwright/region/objective.hpp"
#include "linkwright/region/requirements.hpp"

namespace linkwright {

/// The four-bars that lead a point of their coupler along a path: the coupler's poses are others in each cell. The
/// input is named by the task: nothing is driven from the other side.
class PathFamily : public FourBarFamily {
 public:
  using FourBarFamily::FourBarFamily;

  [[nodiscard]] const LinkageClass& linkages() const override { return path_linkages; }

  /// The crank is given at all points, and each linkage has a cognate with the same path and timing.
  [[nodiscard]] virtual bool is_timed() const = 0;
  /// A body that turns with the crank of the bars at a place and is carried by the point, in all positions; user's
  /// frame, angles in the sense in which the crank passes them.
  [[nodiscard]] virtual std::vector<PrescribedPose> crank_poses(MapPoint place, const FourBar& bars) const = 0;
  /// The larger of both links' residuals (residual_of) over the conditions of the derivatives; nothing where no point
  /// has any.
  [[nodiscard]] virtual std::optional<double> rate_residual(MapPoint place) const = 0;

  /// All linkages at a place, those of several layers with the coordinates of theirs, the best first.
  [[nodiscard]] virtual std::vector<Cell> all_at(MapPoint place, bool respect_direction) const;
  /// On which side of the line from the arm's pivot to each point without an angle its elbow stands, "+" left as one
  /// looks along it to the point or "-", and by its number which of the further dyads: "+-++- 2". Empty where nothing
  /// is to be told.
  [[nodiscard]] virtual std::string elbows_at(MapPoint /*place*/) const { return {}; }

  /// How near the path of the linkage at a place passes to points that it is only to be near.
  [[nodiscard]] virtual std::optional<FittedPath> fitted_at(MapPoint /*place*/) const { return std::nullopt; }

  /// Where all linkages stand of a task that leaves but a few of them; otherwise nothing.
  [[nodiscard]] std::vector<MapPoint> few_places() const;

  [[nodiscard]] LinkageOutput output_of(MapPoint place, const FourBar& bars) const override;
  [[nodiscard]] std::optional<LinkageOutput> output_form() const override;
  /// None: rows of a map share no input link, and its cells no poses of the body.
  [[nodiscard]] std::shared_ptr<const FourBarCells> four_bar_cells(const RegionMap& map) const override;
};

/// As PathFamily::crank_poses(), of the coupler's poses, in the first of which the bars lie; in the sense of the task
/// where it has one (1 counter-clockwise, −1), otherwise in that in which the crank meets the points in order.
[[nodiscard]] std::vector<PrescribedPose> crank_poses_of(const FourBar& bars, std::vector<PrescribedPose> poses,
                                                         std::optional<double> sense);

/// What a path task says before its linkages are classified. Where its form is that of cranks `conditions`, `curve` and
/// `points` are those of the cranks as dyads; `derivative_rows` stays empty: PathFamily::rate_residual(). Requirements
/// and objective choose which of several linkages at a place stands for them. `task` without mistakes.
[[nodiscard]] TaskFamily task_family(const PathTask& task, const Requirements& requirements, Objective objective);

}  // namespace linkwright
