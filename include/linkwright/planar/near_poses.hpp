#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "linkwright/approximate/pose_fit.hpp"
#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/planar/motion_task.hpp"
#include "linkwright/region/cell_measure.hpp"

namespace linkwright {

class FourBarFamily;

/// How near a four-bar carries its body to the near poses of its task, user's unit.
struct NearMiss {
  /// Where the linkage is when its body is nearest to a pose of the task.
  struct Nearest {
    std::size_t pose = 0;  ///< of the task, exact and near ones counted together, from 0
    bool is_near = false;
    double input = 0;  ///< turn of the input from position 1, radians
    Pose body;
    double position_error = 0, angle_error = 0;  ///< from the pose: a distance, and radians ≥ 0
  };

  PoseFitError error;                ///< its max_at is a pose of the task, from 0
  std::vector<Nearest> at;           ///< in the order of the poses
  std::vector<std::size_t> outside;  ///< poses of the task, from 0, that are farther off than their tolerance
  bool in_order = false;             ///< driving meets all poses in their order, and no dead point of the input
  bool at_length_limit = false;      ///< longer links may come nearer; of linkages that were searched for
};

/// The poses of a task some of which are near.
class NearPoses {
 public:
  /// `task`: without mistakes, some poses near.
  explicit NearPoses(const MotionTask& task);

  [[nodiscard]] const PoseTarget& target() const { return target_; }

  /// Of a linkage that carries a body, which lies at `body` as the bars lie: states in turn, driven through.
  [[nodiscard]] std::optional<NearMiss> miss_of(const FourBar& bars, const Pose& body) const;
  /// The same of a fit.
  [[nodiscard]] NearMiss miss_of(const PoseFit& fit) const;
  /// Root mean square error at the near poses, of the configurations nearest to each; infinite where the linkage passes
  /// the exact ones – `exact`, in the first of which the bars lie – without defects, and all of them not.
  [[nodiscard]] double error_of(const FourBar& bars, const std::vector<PrescribedPose>& exact,
                                bool respect_direction) const;
  /// By what all tolerances are to be multiplied that the fit keeps them.
  [[nodiscard]] double tolerance_factor(const PoseFit& fit) const;
  [[nodiscard]] bool has_tolerance() const;

 private:
  PoseTarget target_;
  std::vector<TaskPlace> places_;
  std::vector<NearPose::Tolerance> tolerance_;  ///< one to each pose
};

/// Of the linkages of a family; both are kept.
[[nodiscard]] std::shared_ptr<const CellMeasure> near_error_measure(std::shared_ptr<const NearPoses> near,
                                                                    std::shared_ptr<const FourBarFamily> family);

}  // namespace linkwright
