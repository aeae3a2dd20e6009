#include "linkwright/planar/task_family.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <string_view>

#include "curve_on_lines_family.hpp"
#include "instant_center.hpp"
#include "linkwright/planar/near_poses.hpp"
#include "linkwright/planar/relaxed_position.hpp"
#include "task_curve.hpp"
#include "three_pose_setup.hpp"

namespace linkwright {
namespace {

Notice about_line(std::string_view code, const PivotOnLine& asked, std::string_view message) {
  const std::string_view side = name(asked.side), pivot = name(asked.pivot),
                         curve = asked.pivot == PivotKind::ground ? "centre-point" : "circle-point";
  return {
      std::string(code),
      fmt::format(fmt::runtime(message), fmt::arg("side", side), fmt::arg("pivot", pivot), fmt::arg("curve", curve)),
      {{"side", std::string(side)}, {"pivot", std::string(pivot)}}};
}

// Few dyads have a pivot on a line: those links are one of them.
void keep_to_lines(TaskFamily& given, const MotionTask& task, const std::shared_ptr<const CurveFamily>& whole) {
  std::array<std::shared_ptr<const ProductFamily>, 2> families = {whole, whole};
  for (const PivotOnLine& asked : task.pivots_on) {
    const DirectedLine line{given.frame().to_working(asked.line.point), asked.line.direction};
    const auto found = dyads_on_line(given.conditions, *given.curve, asked.pivot, line);
    if (!found || found->empty()) {
      given.degeneracy =
          found ? about_line("no_dyad_on_line", asked,
                             "No dyad of these positions has its {pivot} pivot on the line given for the {side} link: "
                             "the {curve} curve meets it at infinity only. Move or turn the line.")
                : about_line("line_of_dyads", asked,
                             "The line given for the {pivot} pivot of the {side} link is part of the {curve} curve: "
                             "every point of it will do. Leave it out, or move it.");
      return;
    }
    families[asked.side == Side::input ? 0 : 1] =
        std::make_shared<const PointFamily>(given.frame(), task.poses, *found);
  }
  given.family = std::make_shared<const CurveOnLinesFamily>(given.frame(), task.poses, families[0], families[1]);
}

// Four positions: both grounded links from one Burmester curve.
TaskFamily family_of_curve(const MotionTask& task) {
  TaskCurve found = task_curve(task);
  TaskFamily given;
  given.pattern = std::move(found.pattern);
  given.derivative_rows = derivative_conditions(task.poses, found.conditions.frame);
  given.conditions = std::move(found.conditions);
  given.curve = std::move(found.curve);
  given.warnings = std::move(found.warnings);
  given.degeneracy = std::move(found.degeneracy);
  if (given.degeneracy) return given;
  auto whole = std::make_shared<const CurveFamily>(given.frame(), task.poses, given.curve);
  if (task.pivots_on.empty())
    given.family = std::move(whole);
  else
    keep_to_lines(given, task, whole);
  return given;
}

Notice too_few_points(std::size_t count) {
  if (count == 0)
    return {"no_burmester_point",
            "No real Burmester point: no dyad, and so no four-bar, passes exactly through these five positions. "
            "Relax one of them.",
            {}};
  return {"one_burmester_point",
          "Only one dyad passes exactly through these five positions, and a four-bar needs two. Relax one of them.",
          {}};
}

// Five positions: any two of at most four grounded links. Where two conditions say the same, what is left is a curve.
TaskFamily family_of_points(const MotionTask& task) {
  TaskFamily given;
  given.pattern = pattern(task.poses);
  given.conditions = pose_conditions(task.poses);
  given.derivative_rows = derivative_conditions(task.poses, given.frame());
  BurmesterPoints found = burmester_points(given.conditions);
  given.points = std::move(found.points);
  if (found.degeneracy && !found.curve) {
    given.degeneracy = std::move(found.degeneracy);
    return given;
  }
  given.warnings = pose_warnings(task.poses, given.conditions);
  if (found.curve) {
    given.warnings.push_back(*found.degeneracy);
    given.curve = std::move(found.curve);
    given.family = std::make_shared<CurveFamily>(given.frame(), task.poses, given.curve);
    return given;
  }
  given.warnings.insert(given.warnings.end(), found.warnings.begin(), found.warnings.end());
  if (given.points.size() < 2) {
    given.degeneracy = too_few_points(given.points.size());
    given.has_no_dyads = true;
    return given;
  }
  std::vector<Dyad> dyads;
  for (const BurmesterPoint& point : given.points) dyads.push_back(point.dyad);
  given.family = std::make_shared<PointFamily>(given.frame(), task.poses, std::move(dyads));
  return given;
}

// Three positions and the centre of the first turn are four positions, PP-P-P; in which sense the body turns there is
// not given.
TaskFamily family_of_center(const MotionTask& task, const InstantCenter& center) {
  TaskFamily given = family_of_curve({with_instant_center(task.poses, center), {}});
  given.pattern = pattern(task.poses);
  if (given.family) given.family = std::make_shared<CurveFamily>(given.frame(), task.poses, given.curve);
  return given;
}

// Three positions and what else is given, with what that takes to be set up.
template <class Given, class... Choosing>
TaskFamily family_of_given(const MotionTask& task, const Given& beside_poses, const Choosing&... choosing) {
  TaskFamily given;
  given.pattern = pattern(task.poses);
  given.conditions = pose_conditions(task.poses);
  given.derivative_rows = derivative_conditions(task.poses, given.frame());
  ThreePoseSetup setup = three_pose_setup(given.conditions, task.poses, beside_poses, choosing...);
  given.family = std::move(setup.family);
  given.degeneracy = std::move(setup.degeneracy);
  given.warnings = std::move(setup.notices);
  given.chose_length = setup.chose_length;
  if (!given.degeneracy)
    for (Notice& warning : pose_warnings(task.poses, given.conditions)) given.warnings.push_back(std::move(warning));
  return given;
}

void add_near_poses(TaskFamily& given, const MotionTask& task) {
  if (task.near.empty()) return;
  given.near = std::make_shared<const NearPoses>(task);
  if (!given.family) return;
  given.near_error = near_error_measure(given.near, given.family);
  given.family->has_near_poses();
}

void warn_of_points(TaskFamily& given, const MotionTask& task) {
  if (auto notice = points_notice(task.points)) given.warnings.push_back(*std::move(notice));
}

TaskFamily family_of_three(const MotionTask& task, const Requirements& requirements, Objective objective,
                           const Progress& progress) {
  const ThreePoseGiven given = task.given.value_or(SideLengths{});
  if (const auto* center = std::get_if<InstantCenter>(&given)) return family_of_center(task, *center);
  if (const auto* angle = std::get_if<SideAngle>(&given))
    return family_of_given(task, *angle, requirements, objective, progress);
  if (const auto* pivots = std::get_if<GivenPivots>(&given)) return family_of_given(task, *pivots);
  if (const auto* lines = std::get_if<PivotLines>(&given)) return family_of_given(task, *lines);
  return family_of_given(task, std::get<SideLengths>(given), requirements, objective, progress);
}

}  // namespace

TaskFamily task_family(const MotionTask& task, const Requirements& requirements, Objective objective,
                       const Progress& progress) {
  if (task.relaxed) {
    const RelaxedTask left = relaxed_task(task, *task.relaxed);
    TaskFamily given = task_family(left.task, requirements, objective, progress);
    given.relaxed = left.relaxed;
    warn_of_points(given, task);
    return given;
  }
  const int positions = position_count(task.poses);
  TaskFamily given = positions == 3   ? family_of_three(task, requirements, objective, progress)
                     : positions == 4 ? family_of_curve(task)
                                      : family_of_points(task);
  given.has_directions = std::any_of(task.poses.begin(), task.poses.end(),
                                     [](const PrescribedPose& pose) { return !pose.derivatives.empty(); });
  given.size = given.frame().scale;
  warn_of_points(given, task);
  add_near_poses(given, task);
  return given;
}

Requirements with_defaults(Requirements wanted, const TaskFamily& given) {
  return with_default_lengths(std::move(wanted), given.size);
}

}  // namespace linkwright
