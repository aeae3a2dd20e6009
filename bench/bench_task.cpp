#include "bench_task.hpp"

#include <fstream>
#include <nlohmann/json.hpp>
#include <vector>

#include "linkwright/core/angle.hpp"
#include "linkwright/planar/burmester_curve.hpp"

namespace linkwright::bench {
namespace {

// Poses of the gallery's first tailgate: mm, degrees.
constexpr double tailgate[4][3] = {{0, 0, 0}, {-125, 75, -25}, {-220, 220, -52}, {-220, 450, -82}};

MotionTask task_of_data(std::string_view name) {
  std::ifstream file(std::string(LINKWRIGHT_DATA_DIR "/planar/").append(name) + ".json");
  const auto json = nlohmann::json::parse(file);
  MotionTask task;
  for (const auto& position : json.at("positions")) {
    const auto& pose = position.at(0);
    task.poses.push_back({{{pose.at(0).get<double>(), pose.at(1).get<double>()}, pose.at(2).get<double>()}, {}});
  }
  return task;
}

}  // namespace

MotionTask task_named(std::string_view name) {
  if (name != "tailgate") return task_of_data(name);
  MotionTask task;
  for (const auto& [x, y, degrees] : tailgate) task.poses.push_back({{{x, y}, radians(degrees)}, {}});
  return task;
}

SampledTask sampled(std::string_view name, int samples) {
  const MotionTask task = task_named(name);
  const PoseConditions conditions = pose_conditions(task.poses);
  const BurmesterCurve curve(conditions);
  std::vector<Dyad> dyads;
  for (const double tau : curve.samples(samples, Spacing::coordinate)) dyads.push_back(curve.dyad(tau));
  return {DyadAxis(std::move(dyads), conditions.frame.to_working(task.poses)), conditions.frame.scale};
}

std::string dump(std::string_view name, int samples) {
  const auto [axis, unit] = sampled(name, samples);
  RegionMap map;
  classify_pairs(map, axis, axis, unit);
  const RegionCounts counts = map.counts();
  const nlohmann::json json = {
      {"task", name},
      {"unit", unit},
      {"axis",
       {{"center_x", axis.center_x},
        {"center_y", axis.center_y},
        {"circle_x", axis.circle_x},
        {"circle_y", axis.circle_y},
        {"length", axis.length},
        {"arm_x", axis.arm_x},
        {"arm_y", axis.arm_y},
        {"senses", axis.admissible_directions},
        {"wide", axis.at_least_half_turn}}},
      {"counts",
       {{"types", counts.types},
        {"order", counts.order},
        {"branch", counts.branch},
        {"circuit", counts.circuit},
        {"defect_free", counts.defect_free}}},
  };
  return json.dump();
}

}  // namespace linkwright::bench
