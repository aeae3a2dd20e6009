#include "pose_reader.hpp"

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

}  // namespace

std::optional<PrescribedPose> read_pose(const JsonValue& value, Mistakes& mistakes, OtherMembers others) {
  const JsonObject object = object_of(value, mistakes, {"x", "y", "theta_deg", "derivatives"}, others);
  const auto x = object.require_number("x");
  const auto y = object.require_number("y");
  const auto theta = object.require_number("theta_deg");
  std::optional<std::vector<PoseDerivative>> derivatives(std::in_place);
  if (const auto found = object.find("derivatives")) derivatives = read_derivatives(*found, mistakes, others);
  if (!x || !y || !theta || !derivatives) return std::nullopt;
  return PrescribedPose{.pose = {{*x, *y}, radians(*theta)}, .derivatives = *std::move(derivatives)};
}

namespace {

/// The poses, and whether every one could be read.
bool read_poses(const JsonValue& value, Mistakes& mistakes, std::vector<PrescribedPose>& poses) {
  if (value.json().is_array() && value.json().size() > most_positions_looked_at) {
    value.mistake("pose_count",
                  fmt::format("{} poses are given; five positions are the most that can be solved, remove the others",
                              value.json().size()),
                  {{"count", value.json().size()}});
    return false;
  }
  bool complete = true;
  const bool is_list = value.for_each({"poses", "a list of poses"}, [&](const JsonValue& item) {
    const auto pose = read_pose(item, mistakes, OtherMembers::refused);
    if (pose) poses.push_back(*pose);
    complete = complete && pose.has_value();
  });
  return is_list && complete;
}

}  // namespace

bool read_poses(const JsonObject& task, Mistakes& mistakes, std::vector<PrescribedPose>& poses) {
  const auto found = task.require(
      "poses",
      {"poses_in_full", "a list of poses {\"x\": …, \"y\": …, \"theta_deg\": …}, some of them with \"derivatives\""});
  return found && read_poses(*found, mistakes, poses);
}

}  // namespace linkwright
