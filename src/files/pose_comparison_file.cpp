#include "linkwright/files/pose_comparison_file.hpp"

#include <cmath>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/csv_table.hpp"

namespace linkwright {
namespace {

void tell_largest(PoseComparison& compared) {
  double position = -1, angle = -1;
  for (const NearMiss::Nearest& at : compared.miss.at) {
    if (!at.is_near || !(compared.target.weight(at.pose) > 0)) continue;
    if (at.position_error > position) {
      position = at.position_error;
      compared.position_max_at = at.pose;
    }
    if (at.angle_error > angle) {
      angle = at.angle_error;
      compared.angle_max_at = at.pose;
    }
  }
}

}  // namespace

Result<NearPoses> compared_poses(const MotionTask& task) {
  MotionTask compared;
  compared.near = task.near;
  compared.turning_length = task.turning_length;
  for (const PrescribedPose& pose : task.poses) {
    if (task.near.empty())
      compared.near.push_back({pose.pose, 0, {}, {}});
    else
      compared.poses.push_back({pose.pose, {}});
  }
  if (compared.near.empty())
    return Error{"too_few_near_poses",
                 "task.poses",
                 "no poses were given, and a linkage is compared with three or more; add poses",
                 {{"count", 0}}};
  if (auto mistakes = mistakes_in(compared); !mistakes.empty()) return mistakes;
  return NearPoses(compared);
}

Result<NearPoses> compared_poses(const std::vector<Pose>& poses, std::optional<double> turning_length) {
  MotionTask task;
  task.turning_length = turning_length;
  for (const Pose& pose : poses) task.near.push_back({pose, 0, {}, {}});
  return compared_poses(task);
}

Result<PoseComparison> compare_with_poses(const StoredLinkage& linkage, const std::optional<Pose>& body,
                                          const NearPoses& poses) {
  if (!body && linkage.poses.empty())
    return Error{"no_body", "",
                 "nothing says where the body is as the linkage lies; give \"poses\": [{\"x\": …, \"y\": …, "
                 "\"theta_deg\": …}] beside it in the file, or --body x,y,theta_deg"};
  const Pose lies = body.value_or(linkage.poses.empty() ? Pose{} : linkage.poses.front().pose);
  if (!is_finite(lies.origin) || !std::isfinite(lies.angle))
    return Error{"body_not_finite", "", "where the body is, is told by three finite numbers: x, y and theta_deg"};
  const auto fit = compare_with_poses(linkage.four_bar, lies, poses.target());
  if (!fit)
    return Error{"linkage_stands", "",
                 "the linkage cannot be moved: a link has no length, or the links lie in one line"};
  PoseComparison compared{poses.miss_of(*fit), 0, 0, fit->drive, poses.target(), fit->bars};
  tell_largest(compared);
  return compared;
}

std::string comparison_table(const PoseComparison& comparison) {
  MotionTable table{
      {"pose", "x", "y", "theta_deg", "body_x", "body_y", "body_theta_deg", "distance", "angle_deg", "input_deg"}, {}};
  for (const NearMiss::Nearest& at : comparison.miss.at) {
    const Pose& wanted = comparison.target.poses[at.pose];
    for (const double value : {static_cast<double>(at.pose + 1), wanted.origin.real(), wanted.origin.imag(),
                               degrees(wanted.angle), at.body.origin.real(), at.body.origin.imag(),
                               degrees(at.body.angle), at.position_error, degrees(at.angle_error), degrees(at.input)})
      table.values.push_back(value);
  }
  return csv_text(table);
}

}  // namespace linkwright
