#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "path_family.hpp"

namespace linkwright {

/// The four-bars whose coupler point passes places at given angles of the crank: rows of their map are cranks, columns
/// the cranks of their cognates, both from the curve of all cranks, or from the few that five positions leave.
class TimedPathFamily : public PathFamily {
 public:
  /// `task` without mistakes; `cranks`: the dyads of its crank_poses(), each of which depends on its own coordinate
  /// alone.
  TimedPathFamily(const PathTask& task, std::shared_ptr<const FourBarFamily> cranks);

  [[nodiscard]] bool has_cognates() const override { return true; }
  [[nodiscard]] bool is_timed() const override { return true; }

  /// The same of all linkages.
  [[nodiscard]] std::vector<PrescribedPose> crank_poses(MapPoint /*place*/, const FourBar& /*bars*/) const override {
    return user_poses_;
  }
  [[nodiscard]] std::optional<double> rate_residual(MapPoint place) const override;

  /// Input: the crank; output likewise; both carry their axis' coordinate.
  [[nodiscard]] std::optional<DyadPair> dyad_pair(MapPoint place) const override;
  [[nodiscard]] DyadPairsOfCells dyad_pairs_of_cells(std::span<const double> input,
                                                     std::span<const double> output) const override;
  [[nodiscard]] std::optional<Dyad> dyad(Side side, double tau) const override;
  [[nodiscard]] std::vector<PrescribedPose> user_poses(MapPoint place, const FourBar& bars) const override;
  [[nodiscard]] std::vector<PrescribedPose> working_poses(MapPoint place, const FourBar& bars) const override;
  [[nodiscard]] std::vector<double> samples(Side side, int count, Spacing spacing) const override;
  /// Input: the cranks along their curve; output: none, for it depends on the crank.
  [[nodiscard]] std::vector<Dyad> polygon(Side side) const override;
  /// Of the cranks; output links depend on them.
  [[nodiscard]] std::optional<AxisArcs> arcs_within(Side side, const PivotWindows& windows) const override;

 private:
  void fill(RegionMap& map, std::span<const double> input, std::span<const double> output, bool respect_direction,
            const RegionOptions& options, const Progress& progress) const override;

  std::shared_ptr<const FourBarFamily> cranks_;
  std::vector<PrescribedPose> user_poses_, working_poses_;  ///< of the body that turns with the crank
  std::vector<HomogeneousMatrix> derivative_rows_;
};

/// As task_family(), of a timed task.
[[nodiscard]] TaskFamily family_of_timed(const PathTask& task);

}  // namespace linkwright
