#include <algorithm>
#include <fmt/format.h>
#include <string>

#include "core/number_check.hpp"
#include "files/fields/forms.hpp"
#include "linkwright/files/nearest_name.hpp"
#include "problem_fields.hpp"
#include "vocabulary.hpp"

namespace linkwright {

static void fields(FieldVisitor& v, NearPose::Tolerance& tolerance) {
  v.object({.name = "pose_tolerance"}, [&](FieldVisitor& to) {
    to.given(Field("position", "Of the moving frame's origin."), tolerance.position, forms::length);
    to.given("angle_deg", tolerance.angle, forms::degrees);
  });
}

namespace {

constexpr std::size_t max_derivatives = 4;  // of five infinitesimally close positions, the most that are ever told

void derivative_fields(FieldVisitor& v, std::vector<PoseDerivative>& derivatives) {
  const List list = {.what = {"derivatives", "a list of derivatives [{\"x\": …, \"y\": …, \"theta\": …}, …]"},
                     .most_read = max_derivatives,
                     .code = "derivative_count_of_pose",
                     .sentence = "{count} derivatives are given; a pose has at most {most}, remove the others"};
  const Field field("derivatives",
                    "First, second, … derivatives by any parameter that increases along the task: the direction of "
                    "travel through the pose, then its curvature, ….");
  v.optional(field.written(!derivatives.empty()), derivatives, list);
}

void in_numbers(FieldVisitor& v, PrescribedPose& pose) {
  forms::coordinates(v, pose.pose.origin);
  v.required("theta_deg", pose.pose.angle, forms::degrees);
  derivative_fields(v, pose.derivatives);
}

/// The pose proper is made of all points.
void by_points(FieldVisitor& v, PrescribedPose& pose, BodyPoints& points) {
  const Wanted two_points = {"two_points", "two points of the body [[x, y], [x, y]]"};
  std::array<Point, 2> both = {points.first, points.second};
  v.required(Field("points").missing(two_points), both, List{.what = two_points, .most = 2, .is_of_length = true},
             forms::point);
  points = {both[0], both[1]};
  derivative_fields(v, pose.derivatives);
}

constexpr Object pose_object = {"pose", "Pose of the moving frame in the fixed frame; theta counts modulo 360."};
constexpr Object points_object = {
    "pose_by_points",
    "Where two points of the body lie; the moving frame has its origin in the first and its x axis toward the second. "
    "Distances that differ from pose to pose are told, and fitted by least squares."};

constexpr Object motion_pose_object = {"motion_pose",
                                       "Pose of the moving frame in the fixed frame; theta counts modulo 360. Passed "
                                       "exactly, or as near as a linkage can."};

/// A pose as a task lists it.
struct ListedPose {
  PrescribedPose pose;
  BodyPoints points;
  bool is_near = false;
  std::optional<NearPose::Tolerance> tolerance;
  std::optional<double> weight;
};

void near_fields(FieldVisitor& v, ListedPose& pose) {
  v.optional(Field("near", "As near as a linkage can, in its turn, instead of exactly.").written(pose.is_near),
             pose.is_near);
  v.given(Field("tolerance", "Near poses: how far off the body may be."), pose.tolerance);
  v.given(Field("weight", "Near poses: of the squared error; 1 where it is left out."), pose.weight,
          Number{.least = 0, .most = largest_coordinate});
  if (!pose.is_near && (pose.tolerance || pose.weight))
    v.mistake("not_near",
              "\"tolerance\" and \"weight\" belong to poses that are \"near\": true; mark this one, or "
              "leave them out",
              {});
  if (pose.is_near && !pose.pose.derivatives.empty())
    v.mistake("near_pose_with_derivatives",
              "a near pose has no derivatives: its direction of travel is free; leave them out, or pass it exactly",
              {});
}

/// Poses of a task, all in one of two ways; written in numbers.
struct PoseList {
  std::vector<ListedPose>& poses;
  bool some_near;  ///< may be
  std::optional<bool> are_by_points;

  void visit(FieldVisitor& v, std::size_t i) {
    if (i == poses.size()) poses.emplace_back();
    ListedPose& listed = poses[i];
    const auto in_way = [&](FieldVisitor& to, bool way) {
      if (are_by_points.value_or(way) != way)
        to.mistake(
            "mixed_poses",
            "some poses are given by \"points\" and others by \"x\", \"y\", \"theta_deg\"; give all of them in one "
            "way",
            {});
      are_by_points = are_by_points.value_or(way);
    };
    const std::array alternatives = {
        Alternative{{"points"},
                    points_object,
                    [&](FieldVisitor& to) {
                      in_way(to, true);
                      by_points(to, listed.pose, listed.points);
                    }},
        Alternative{{"x"}, some_near ? motion_pose_object : pose_object, [&](FieldVisitor& to) {
                      in_way(to, false);
                      in_numbers(to, listed.pose);
                      if (some_near) near_fields(to, listed);
                    }}};
    v.object({}, [&](FieldVisitor& to) { to.one_of(1, alternatives, {}); });
  }
};

/// Near ones among the exact.
std::vector<ListedPose> listed_poses(const std::vector<PrescribedPose>& poses, const std::vector<NearPose>& near) {
  std::vector<ListedPose> all;
  std::size_t next = 0;
  for (std::size_t exact = 0; exact <= poses.size(); ++exact) {
    for (; next < near.size() && (near[next].after <= exact || exact == poses.size()); ++next)
      all.push_back({{near[next].pose, {}}, {}, true, near[next].tolerance, near[next].weight});
    if (exact < poses.size()) all.push_back({poses[exact], {}, false, {}, {}});
  }
  return all;
}

bool have_directions(const std::vector<BodyPoints>& points) {
  return std::none_of(points.begin(), points.end(), [](const BodyPoints& p) { return p.first == p.second; });
}

}  // namespace

static void fields(FieldVisitor& v, PoseDerivative& derivative) {
  const Object described = {"derivative",
                            "x and y in the user's length, theta in radians, per power of the parameter."};
  v.object(described, [&](FieldVisitor& to) {
    forms::coordinates(to, derivative.origin);
    to.required("theta", derivative.angle, forms::coordinate);
  });
}

void fields(FieldVisitor& v, PrescribedPose& pose) {
  v.object(pose_object, [&](FieldVisitor& to) { in_numbers(to, pose); });
}

namespace {

constexpr Wanted poses_missing = {
    "poses_in_full", "a list of poses {\"x\": …, \"y\": …, \"theta_deg\": …}, some of them with \"derivatives\""};

/// The member; false where it was not read in full.
bool visit_listed(FieldVisitor& v, const List& described, PoseList& all) {
  return v.member(Field("poses").missing(poses_missing), true, [&](FieldVisitor& to) {
    to.list(described, all.poses.size(), [&](FieldVisitor& item, std::size_t i) { all.visit(item, i); });
  });
}

/// By points, unless their own mistakes say why there are no poses.
void take_points(const PoseList& all, std::vector<PrescribedPose>& poses, std::vector<BodyPoints>& points) {
  if (all.are_by_points != true) return;
  points.clear();
  for (const ListedPose& listed : all.poses) points.push_back(listed.points);
  if (!have_directions(points)) return;
  const std::vector<Pose> proper = poses_of_points(points);
  for (std::size_t i = 0; i < poses.size(); ++i) poses[i].pose = proper[i];
}

}  // namespace

void pose_fields(FieldVisitor& v, std::vector<PrescribedPose>& poses, std::vector<BodyPoints>& points) {
  const List list = {.what = {"poses", "a list of poses"},
                     .most_read = most_positions_looked_at,
                     .code = "pose_count",
                     .sentence =
                         "{count} poses are given; five positions are the most that can be solved, remove the "
                         "others",
                     .on_lines = true,
                     .name = "poses",
                     .about = "All in numbers, or all by the same two points of the body."};
  std::vector<ListedPose> listed = listed_poses(poses, {});
  PoseList all{listed, false, std::nullopt};
  const bool is_complete = visit_listed(v, list, all);
  poses.clear();
  for (const ListedPose& one : listed) poses.push_back(one.pose);
  if (is_complete) take_points(all, poses, points);
}

void motion_pose_fields(FieldVisitor& v, MotionTask& task) {
  const List list = {.what = {"poses", "a list of poses"},
                     .most_read = MotionTask::most_near + most_positions_looked_at,
                     .code = "motion_pose_count",
                     .sentence = "{count} poses are given; {most} are the most that are read, remove the others",
                     .on_lines = true,
                     .name = "motion_poses",
                     .about = "All in numbers, or all by the same two points of the body."};
  std::vector<ListedPose> listed = listed_poses(task.poses, task.near);
  PoseList all{listed, true, std::nullopt};
  const bool is_complete = visit_listed(v, list, all);
  task.poses.clear();
  task.near.clear();
  for (const ListedPose& one : listed) {
    if (one.is_near)
      task.near.push_back({one.pose.pose, task.poses.size(), one.tolerance, one.weight});
    else
      task.poses.push_back(one.pose);
  }
  if (is_complete) take_points(all, task.poses, task.points);
}

void fields(FieldVisitor& v, LineAtAngle& line) {
  Point point = line.point;
  double angle = line.angle;
  v.object({.name = "line"}, [&](FieldVisitor& to) {
    to.required("point", point, forms::point);
    to.required("direction_deg", angle, forms::degrees);
  });
  line = {point, angle};
}

}  // namespace linkwright
