#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "arm_solver.hpp"
#include "path_family.hpp"

namespace linkwright {

/// The four-bars whose coupler point passes places, one link of which is settled before the other: at each place of the
/// map stands an arm (ArmChoice). To each there are several, in layers: for every way in which its elbow can stand at
/// the points without an angle the further dyads, of five positions three at most, or the one with a given ground
/// pivot. A place of the map stands for the best of them: one that meets the requirements, or one without defects.
class ArmFamily : public PathFamily {
 public:
  /// Of a task without mistakes, of any form but PathForm::cranks; requirements with default lengths filled in.
  ArmFamily(ArmTask task, std::shared_ptr<const ArmChoice> choice, const Requirements& requirements,
            Objective objective);

  [[nodiscard]] bool is_timed() const override;

  [[nodiscard]] double axis_value(Side side, double coordinate) const override;
  /// With the layer where the map has layers.
  [[nodiscard]] std::span<const Measure> measures() const override;
  [[nodiscard]] CellAt cells(bool respect_direction) const override;
  /// With the layer, as its linkage.
  [[nodiscard]] MapPivots pivots(const RegionMap& map) const override;
  [[nodiscard]] OutputOfCells outputs_of(const RegionMap& map) const override;

  /// The coordinates of the pair have its layer.
  [[nodiscard]] std::optional<DyadPair> dyad_pair(MapPoint place) const override;
  [[nodiscard]] std::vector<PrescribedPose> user_poses(MapPoint place, const FourBar& bars) const override;
  [[nodiscard]] std::vector<PrescribedPose> working_poses(MapPoint place, const FourBar& bars) const override;
  [[nodiscard]] std::vector<Dyad> polygon(Side /*side*/) const override { return {}; }

  [[nodiscard]] std::vector<PrescribedPose> crank_poses(MapPoint place, const FourBar& bars) const override;
  [[nodiscard]] std::optional<double> rate_residual(MapPoint place) const override;

  [[nodiscard]] std::vector<Cell> all_at(MapPoint place, bool respect_direction) const override;
  [[nodiscard]] std::string elbows_at(MapPoint place) const override;

 private:
  [[nodiscard]] std::optional<ArmAtPlace> arm_at(MapPoint place) const { return choice_->at(layers_.without(place)); }
  [[nodiscard]] MapPoint shown_at(const RegionMap& map, std::size_t row, std::size_t column) const;
  [[nodiscard]] std::vector<std::optional<ArmLinkage>> best_of(std::span<const MapPoint> places, bool respect_direction,
                                                               Simd simd) const;
  [[nodiscard]] std::optional<ArmMotion> motion_at(MapPoint place) const;
  void fill(RegionMap& map, std::span<const double> input, std::span<const double> output, bool respect_direction,
            const RegionOptions& options, const Progress& progress) const override;

  ArmTask task_;
  std::shared_ptr<const ArmChoice> choice_;
  ArmLayers layers_;
  bool respect_direction_;  ///< of the requirements
  ArmWishes wishes_;
};

/// As task_family(), of a task of any form but PathForm::cranks.
[[nodiscard]] TaskFamily family_of_arms(const PathTask& task, const Requirements& requirements, Objective objective);

}  // namespace linkwright
