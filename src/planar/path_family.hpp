#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "linkwright/planar/four_bar_family.hpp"
#include "linkwright/planar/path_task.hpp"
#include "linkwright/planar/task_family.hpp"

namespace linkwright {

/// The four-bars whose coupler point passes places at given angles of the crank: rows of their map are cranks, columns
/// the cranks of their cognates, both from the curve of all cranks, or from the few that five positions leave. The
/// input is named by the task: nothing is driven from the other side.
class PathFamily : public FourBarFamily {
 public:
  /// `task` without mistakes; `cranks`: the dyads of its crank_poses(), each of which depends on its own coordinate
  /// alone.
  PathFamily(const PathTask& task, std::shared_ptr<const FourBarFamily> cranks);

  [[nodiscard]] const LinkageClass& linkages() const override { return path_linkages; }
  [[nodiscard]] bool has_cognates() const override { return true; }

  /// User's frame.
  [[nodiscard]] std::span<const PrescribedPose> crank_poses() const { return user_poses_; }
  /// The larger of both cranks' residuals (residual_of) over the conditions of the derivatives; nothing where no point
  /// has any.
  [[nodiscard]] std::optional<double> rate_residual(MapPoint place) const;

  /// Input: the crank; output likewise; both carry their axis' coordinate.
  [[nodiscard]] std::optional<DyadPair> dyad_pair(MapPoint place) const override;
  [[nodiscard]] DyadPairsOfCells dyad_pairs_of_cells(std::span<const double> input,
                                                     std::span<const double> output) const override;
  [[nodiscard]] std::optional<Dyad> dyad(Side side, double tau) const override;
  [[nodiscard]] std::vector<PrescribedPose> user_poses(MapPoint place, const FourBar& bars) const override;
  [[nodiscard]] std::vector<PrescribedPose> working_poses(MapPoint place, const FourBar& bars) const override;
  [[nodiscard]] LinkageOutput output_of(MapPoint place, const FourBar& bars) const override;
  [[nodiscard]] std::optional<LinkageOutput> output_form() const override;
  /// None: the coupler's poses are others in each cell.
  [[nodiscard]] std::shared_ptr<const FourBarCells> four_bar_cells(const RegionMap& map) const override;
  [[nodiscard]] std::vector<double> samples(Side side, int count, Spacing spacing) const override;
  /// Input: the cranks along their curve; output: none, for it depends on the crank.
  [[nodiscard]] std::vector<Dyad> polygon(Side side) const override;
  /// Of the cranks; output links depend on them.
  [[nodiscard]] std::optional<AxisArcs> arcs_within(Side side, const PivotWindows& windows) const override;

 private:
  [[nodiscard]] FourBarRow row_at(const Dyad& crank, const DyadAxis& cognates, bool respect_direction) const;
  void fill(RegionMap& map, std::span<const double> input, std::span<const double> output, bool respect_direction,
            const RegionOptions& options, const Progress& progress) const override;

  std::shared_ptr<const FourBarFamily> cranks_;
  std::vector<PrescribedPose> user_poses_, working_poses_;  ///< of the body that turns with the crank
  std::vector<HomogeneousMatrix> derivative_rows_;
};

/// What a path task says before its linkages are classified. `conditions`, `curve` and `points` are those of its cranks
/// as dyads; `derivative_rows` stays empty: PathFamily::rate_residual(). `task` without mistakes.
[[nodiscard]] TaskFamily task_family(const PathTask& task);

}  // namespace linkwright
