#include "pose_reader.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <utility>

#include "files/vocabulary.hpp"
#include "linkwright/core/angle.hpp"

namespace linkwright {
namespace {

constexpr std::size_t max_derivatives = 4;  // of five infinitesimally close positions, the most that are ever told

JsonObject object_of(const JsonValue& value, Mistakes& mistakes, std::initializer_list<std::string_view> known,
                     OtherMembers others) {
  return others == OtherMembers::refused ? JsonObject(value, mistakes, known) : JsonObject(value, mistakes, {});
}

std::optional<PoseDerivative> read_derivative(const JsonValue& value, Mistakes& mistakes, OtherMembers others) {
  const JsonObject object = object_of(value, mistakes, {"x", "y", "theta"}, others);
  const auto x = object.require_number("x");
  const auto y = object.require_number("y");
  const auto theta = object.require_number("theta");
  if (!x || !y || !theta) return std::nullopt;
  return PoseDerivative{{*x, *y}, *theta};
}

std::optional<std::vector<PoseDerivative>> read_derivatives(const JsonValue& value, Mistakes& mistakes,
                                                            OtherMembers others) {
  if (value.json().is_array() && value.json().size() > max_derivatives) {
    value.mistake("derivative_count_of_pose",
                  fmt::format("{} derivatives are given; a pose has at most {}, remove the others", value.json().size(),
                              max_derivatives),
                  {{"count", value.json().size()}, {"most", max_derivatives}});
    return std::nullopt;
  }
  std::vector<PoseDerivative> derivatives;
  bool complete = true;
  const bool is_list = value.for_each({"derivatives", "a list of derivatives [{\"x\": …, \"y\": …, \"theta\": …}, …]"},
                                      [&](const JsonValue& item) {
                                        const auto derivative = read_derivative(item, mistakes, others);
                                        if (derivative) derivatives.push_back(*derivative);
                                        complete = complete && derivative.has_value();
                                      });
  if (!is_list || !complete) return std::nullopt;
  return derivatives;
}

std::optional<std::vector<PoseDerivative>> read_derivatives_of(const JsonObject& pose, Mistakes& mistakes,
                                                               OtherMembers others) {
  const auto found = pose.find("derivatives");
  return found ? read_derivatives(*found, mistakes, others) : std::vector<PoseDerivative>{};
}

}  // namespace

std::optional<PrescribedPose> read_pose(const JsonValue& value, Mistakes& mistakes, OtherMembers others) {
  const JsonObject object = object_of(value, mistakes, {"x", "y", "theta_deg", "derivatives"}, others);
  const auto x = object.require_number("x");
  const auto y = object.require_number("y");
  const auto theta = object.require_number("theta_deg");
  const auto derivatives = read_derivatives_of(object, mistakes, others);
  if (!x || !y || !theta || !derivatives) return std::nullopt;
  return PrescribedPose{.pose = {{*x, *y}, radians(*theta)}, .derivatives = *derivatives};
}

namespace {

std::optional<BodyPoints> read_body_points(const JsonObject& pose) {
  const Wanted two_points{"two_points", "two points of the body [[x, y], [x, y]]"};
  const auto found = pose.require("points", two_points);
  if (!found) return std::nullopt;
  if (!found->json().is_array() || found->json().size() != 2) {
    found->wrong_type(two_points);
    return std::nullopt;
  }
  std::vector<Point> points;
  found->for_each(two_points, [&](const JsonValue& item) {
    if (const auto point = item.as_pair({"[x, y]"})) points.push_back(*point);
  });
  if (points.size() != 2) return std::nullopt;
  return BodyPoints{points[0], points[1]};
}

/// A pose by two points, whose pose proper is not known yet; false where it cannot be read.
bool read_by_points(const JsonValue& value, Mistakes& mistakes, std::vector<PrescribedPose>& poses,
                    std::vector<BodyPoints>& points) {
  const JsonObject object(value, mistakes, {"points", "derivatives"});
  const auto pair = read_body_points(object);
  auto derivatives = read_derivatives_of(object, mistakes, OtherMembers::refused);
  if (!pair || !derivatives) return false;
  points.push_back(*pair);
  poses.push_back({{}, *std::move(derivatives)});
  return true;
}

bool is_by_points(const JsonValue& value) { return value.is_object() && value.json().contains("points"); }

/// The poses, and whether every one could be read.
bool read_poses(const JsonValue& value, Mistakes& mistakes, std::vector<PrescribedPose>& poses,
                std::vector<BodyPoints>& points) {
  if (value.json().is_array() && value.json().size() > most_positions_looked_at) {
    value.mistake("pose_count",
                  fmt::format("{} poses are given; five positions are the most that can be solved, remove the others",
                              value.json().size()),
                  {{"count", value.json().size()}});
    return false;
  }
  bool complete = true;
  std::optional<bool> by_points;
  const bool is_list = value.for_each({"poses", "a list of poses"}, [&](const JsonValue& item) {
    const bool here = is_by_points(item);
    if (here != by_points.value_or(here)) {
      item.mistake("mixed_poses",
                   "some poses are given by \"points\" and others by \"x\", \"y\", \"theta_deg\"; give all of them "
                   "in one way");
      complete = false;
      return;
    }
    by_points = here;
    if (here) {
      complete = read_by_points(item, mistakes, poses, points) && complete;
    } else {
      const auto pose = read_pose(item, mistakes, OtherMembers::refused);
      if (pose) poses.push_back(*pose);
      complete = complete && pose.has_value();
    }
  });
  return is_list && complete;
}

bool have_directions(const std::vector<BodyPoints>& points) {
  return std::none_of(points.begin(), points.end(), [](const BodyPoints& p) { return p.first == p.second; });
}

}  // namespace

bool read_poses(const JsonObject& task, Mistakes& mistakes, std::vector<PrescribedPose>& poses,
                std::vector<BodyPoints>& points) {
  const auto found = task.require(
      "poses",
      {"poses_in_full", "a list of poses {\"x\": …, \"y\": …, \"theta_deg\": …}, some of them with \"derivatives\""});
  if (!found || !read_poses(*found, mistakes, poses, points)) return false;
  if (points.empty() || !have_directions(points)) return true;  // which the task's own mistakes say
  const std::vector<Pose> proper = poses_of_points(points);
  for (std::size_t i = 0; i < poses.size(); ++i) poses[i].pose = proper[i];
  return true;
}

}  // namespace linkwright
