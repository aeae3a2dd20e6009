#include "task_curve.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/tolerance.hpp"
#include "planar/degenerate_task.hpp"

namespace linkwright {
namespace {

// Same orientation modulo a whole turn.
bool are_parallel(const Pose& a, const Pose& b) {
  return std::abs(wrap_signed(a.angle - b.angle)) < tolerance::pure_translation;
}

// Tasks whose dyads are no curve, or a curve without four-bars: what it is, and what does the task instead.
std::optional<Notice> degeneracy_of(const PoseConditions& conditions, const BurmesterCurve& curve) {
  if (curve.kind() == CubicKind::every_point) return every_point_reason(conditions);
  if (conditions.only_translations) return only_translations_reason();
  return std::nullopt;
}

// What is hardly more than a turn about one pole is done by a hinge, but for a miss that is soon within tolerance.
Notice near_common_pole(const WorkingFrame& frame, const PoleFrame& view) {
  const Point pole = frame.to_user(view.frame.origin);
  const double deviation = frame.scale * view.deviation;
  return {"near_common_pole",
          fmt::format("The positions nearly share a pole, ({:.6g}, {:.6g}): a single hinge there suffices, with a "
                      "position error of at most {:.2g}. The four-bars that do it exactly are as small as that, or "
                      "have two pivots about as close to the pole. For a four-bar, choose positions that differ more "
                      "from a rotation about one point.",
                      pole.real(), pole.imag(), deviation),
          {{"x", pole.real()}, {"y", pole.imag()}, {"miss", deviation}}};
}

// Groups of parallel poses, in words: "1 and 3", "1, 2 and 4".
std::vector<std::string> parallel_groups(const std::vector<PrescribedPose>& poses) {
  std::vector<std::string> groups;
  std::vector<bool> is_grouped(poses.size(), false);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    std::vector<std::size_t> group = {i + 1};
    for (std::size_t j = i + 1; j < poses.size(); ++j) {
      if (is_grouped[i] || !are_parallel(poses[i].pose, poses[j].pose)) continue;
      group.push_back(j + 1);
      is_grouped[j] = true;
    }
    if (group.size() == 1) continue;
    const std::size_t last = group.back();
    group.pop_back();
    groups.push_back(fmt::format("{} and {}", fmt::join(group, ", "), last));
  }
  return groups;
}

}  // namespace

std::vector<Notice> pose_warnings(const std::vector<PrescribedPose>& poses, const PoseConditions& conditions) {
  std::vector<Notice> warnings;
  if (conditions.are_independent() && conditions.condition() > tolerance::ill_conditioned)
    warnings.push_back({"ill_conditioned",
                        fmt::format("The poses are so close together that round-off dominates (condition number "
                                    "{:.1e}); replace poses that lie close together by "
                                    "one pose with derivatives (direction of travel, curvature).",
                                    conditions.condition()),
                        {{"condition", conditions.condition()}}});
  if (conditions.near_pole) warnings.push_back(near_common_pole(conditions.frame, *conditions.near_pole));
  for (const auto& group : parallel_groups(poses))
    warnings.push_back({"parallel_poses",
                        fmt::format("Poses {} are parallel: their poles lie at infinity. This is fine.", group),
                        {{"poses", group}}});
  return warnings;
}

TaskCurve task_curve(const MotionTask& task) {
  TaskCurve found;
  found.pattern = pattern(task.poses);
  found.conditions = pose_conditions(task.poses);
  found.curve = std::make_shared<const BurmesterCurve>(found.conditions);
  found.degeneracy = degeneracy_of(found.conditions, *found.curve);
  if (!found.degeneracy) found.warnings = pose_warnings(task.poses, found.conditions);
  return found;
}

}  // namespace linkwright
