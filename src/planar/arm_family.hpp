#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "arm_motion.hpp"
#include "arm_reach.hpp"
#include "core/function_ref.hpp"
#include "linkwright/region/cell_judge.hpp"
#include "path_family.hpp"

namespace linkwright {

/// What is given of points alone. The arm: the link with the given pivot (of both the input's), and the coupler from
/// there to the point.
struct ArmTask {
  WorkingFrame frame;
  std::vector<PathPoint> points;  ///< user's frame
  std::vector<PathJet> path;      ///< working frame, its origin being the first place
  Point pivot{};                  ///< working frame
  Side side = Side::input;        ///< of the arm
  std::optional<Point> other;     ///< the other link's ground pivot, where it is given, too
};

/// The four-bars whose coupler point passes places, a ground pivot being given with five positions, or both with three:
/// rows and columns of their map are the arms that reach all places (ArmReach). At each there are several, in layers:
/// for every way in which the elbow can stand at the places the further dyads, of five positions three at most. A place
/// of the map stands for the best of them: one that meets the requirements, or one without defects.
class ArmFamily : public PathFamily {
 public:
  /// `task`: untimed, without mistakes; requirements with default lengths filled in.
  ArmFamily(const PathTask& task, const Requirements& requirements, Objective objective);
  ArmFamily(ArmTask task, const Requirements& requirements, Objective objective);

  [[nodiscard]] bool is_timed() const override { return false; }

  [[nodiscard]] double axis_value(Side side, double coordinate) const override;
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
  class Solver;
  struct Found;
  struct Layer;

  using Take = FunctionRef<void(std::size_t tag, const Found& found)>;

  void add_all(Solver& solver, std::size_t tag, MapPoint place, const Take& take) const;
  void add_any(Solver& solver, std::size_t tag, MapPoint place, const Take& take) const;
  [[nodiscard]] std::vector<std::optional<Found>> best_of(std::span<const MapPoint> places, bool respect_direction,
                                                          Simd simd) const;
  [[nodiscard]] std::optional<ArmMotion> motion_at(MapPoint place) const;
  [[nodiscard]] bool is_repeated(const ElbowPattern& pattern) const;
  void fill(RegionMap& map, std::span<const double> input, std::span<const double> output, bool respect_direction,
            const RegionOptions& options, const Progress& progress) const override;

  ArmTask task_;
  ArmReach reach_;
  Requirements requirements_;
  CellJudge judge_;
  Rank rank_;
  bool only_in_order_;                                ///< the arm drives, and its order is required
  std::vector<std::array<std::size_t, 2>> repeated_;  ///< points at one place
};

/// Of an untimed task without mistakes. The frame's unit is the root of the mean square of the points' distances from
/// their centroid.
[[nodiscard]] ArmTask arm_task(const PathTask& task);

/// As task_family(), of a task without angles of the crank.
[[nodiscard]] TaskFamily family_of_arms(const PathTask& task, const Requirements& requirements, Objective objective);

}  // namespace linkwright
