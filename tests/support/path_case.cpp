#include "support/path_case.hpp"

#include <fstream>

#include "linkwright/core/angle.hpp"

namespace linkwright::testing {
namespace {

Point point_of(const nlohmann::json& json) { return {json[0], json[1]}; }

}  // namespace

PathTask path_task(const nlohmann::json& json) {
  PathTask task;
  for (const auto& point : json.at("points")) {
    PathPoint prescribed{{point.at("x"), point.at("y")}, {}, {}, {}};
    if (point.contains("input_deg")) prescribed.input = radians(point.at("input_deg").get<double>());
    if (point.contains("theta_deg")) prescribed.angle = radians(point.at("theta_deg").get<double>());
    if (point.contains("derivatives"))
      for (const auto& d : point.at("derivatives")) {
        prescribed.derivatives.push_back({{d.at("x"), d.at("y")}, {}, {}});
        if (d.contains("input")) prescribed.derivatives.back().input = d.at("input").get<double>();
        if (d.contains("theta")) prescribed.derivatives.back().angle = d.at("theta").get<double>();
      }
    task.points.push_back(prescribed);
  }
  if (!json.contains("given")) return task;
  const auto& pivots = json.at("given").at("ground_pivots");
  if (pivots.contains("input")) task.pivots.input = point_of(pivots.at("input"));
  if (pivots.contains("output")) task.pivots.output = point_of(pivots.at("output"));
  return task;
}

PathCase path_case(const std::string& name) {
  auto json = nlohmann::json::parse(std::ifstream(LINKWRIGHT_DATA_DIR "/path/" + name + ".json"));
  PathTask task = json.contains("task") ? path_task(json["task"]) : PathTask{};
  return {name, std::move(json), std::move(task)};
}

FourBar bars_of(const nlohmann::json& linkage) {
  const auto &input = linkage.at("input"), &output = linkage.at("output");
  return {point_of(input.at("center_point")), point_of(input.at("circle_point")), point_of(output.at("center_point")),
          point_of(output.at("circle_point"))};
}

PathTask timed_points(const std::vector<std::array<double, 3>>& points) {
  PathTask task;
  for (const auto& [x, y, input_deg] : points) task.points.push_back({{x, y}, radians(input_deg), {}, {}});
  return task;
}

}  // namespace linkwright::testing
