#include <algorithm>
#include <fmt/format.h>
#include <string>

#include "files/fields/forms.hpp"
#include "linkwright/files/nearest_name.hpp"
#include "problem_fields.hpp"
#include "vocabulary.hpp"

namespace linkwright {
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

/// Poses of a task, all in one of two ways; written in numbers.
struct PoseList {
  std::vector<PrescribedPose>& poses;
  std::vector<BodyPoints>& points;
  std::optional<bool> are_by_points;

  void visit(FieldVisitor& v, std::size_t i) {
    if (i == poses.size()) poses.emplace_back();
    const auto in_way = [&](FieldVisitor& to, bool way) {
      if (are_by_points.value_or(way) != way)
        to.mistake(
            "mixed_poses",
            "some poses are given by \"points\" and others by \"x\", \"y\", \"theta_deg\"; give all of them in one "
            "way",
            {});
      are_by_points = are_by_points.value_or(way);
    };
    const std::array alternatives = {Alternative{{"points"},
                                                 points_object,
                                                 [&](FieldVisitor& to) {
                                                   in_way(to, true);
                                                   points.resize(poses.size());
                                                   by_points(to, poses[i], points[i]);
                                                 }},
                                     Alternative{{"x"}, pose_object, [&](FieldVisitor& to) {
                                                   in_way(to, false);
                                                   in_numbers(to, poses[i]);
                                                 }}};
    v.object({}, [&](FieldVisitor& to) { to.one_of(1, alternatives, {}); });
  }
};

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

void pose_fields(FieldVisitor& v, std::vector<PrescribedPose>& poses, std::vector<BodyPoints>& points) {
  const Wanted missing = {"poses_in_full",
                          "a list of poses {\"x\": …, \"y\": …, \"theta_deg\": …}, some of them with \"derivatives\""};
  const List list = {.what = {"poses", "a list of poses"},
                     .most_read = most_positions_looked_at,
                     .code = "pose_count",
                     .sentence =
                         "{count} poses are given; five positions are the most that can be solved, remove the "
                         "others",
                     .on_lines = true,
                     .name = "poses",
                     .about = "All in numbers, or all by the same two points of the body."};
  PoseList all{poses, points, std::nullopt};
  const bool is_complete = v.member(Field("poses").missing(missing), true, [&](FieldVisitor& to) {
    to.list(list, poses.size(), [&](FieldVisitor& item, std::size_t i) { all.visit(item, i); });
  });
  if (!is_complete || all.are_by_points != true || !have_directions(points)) return;  // the task's own mistakes say why
  const std::vector<Pose> proper = poses_of_points(points);
  for (std::size_t i = 0; i < poses.size(); ++i) poses[i].pose = proper[i];
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
