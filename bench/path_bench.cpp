// Paths: maps over pairs of cranks beside the map of the poses that the cranks have, over arms and over places of a
// pivot; four-bars between two pivots.

#include <array>
#include <benchmark/benchmark.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "bench_task.hpp"
#include "linkwright/core/angle.hpp"
#include "planar/five_point_four_bars.hpp"
#include "planar/path_family.hpp"

namespace linkwright::bench::path_bench {
namespace {

PathTask path_named(const std::string& name) {
  const auto json = nlohmann::json::parse(std::ifstream(LINKWRIGHT_DATA_DIR "/path/" + name + ".json")).at("task");
  PathTask task;
  for (const auto& point : json.at("points")) {
    PathPoint read;
    read.point = {point.at("x"), point.at("y")};
    if (point.contains("input_deg")) read.input = radians(point.at("input_deg").get<double>());
    if (point.contains("theta_deg")) read.angle = radians(point.at("theta_deg").get<double>());
    task.points.push_back(read);
  }
  if (!json.contains("given")) return task;
  const auto& pivots = json.at("given").at("ground_pivots");
  const auto pivot = [&](const char* side) {
    return pivots.contains(side) ? std::optional(Point{pivots.at(side)[0], pivots.at(side)[1]}) : std::nullopt;
  };
  task.pivots = {pivot("input"), pivot("output")};
  return task;
}

// As while a point is dragged: the memory is there already.
void time_map(benchmark::State& state, const FourBarFamily& family, int samples, int threads) {
  const auto input = family.samples(Side::input, samples, Spacing::coordinate),
             output = family.samples(Side::output, samples, Spacing::coordinate);
  RegionOptions options;
  options.threads = threads;
  RegionMap map;
  time_tasks(state, samples * samples, [&] { family.classify(map, input, output, true, options); });
}

void map_of_path(benchmark::State& state, const std::string& name, int samples, int threads) {
  const TaskFamily given = task_family(path_named(name), Requirements{}, Objective::min_transmission_angle);
  time_map(state, *given.family, samples, threads);
}
// The dyads of the poses that the cranks have, as four-bars.
void map_of_its_poses(benchmark::State& state, const std::string& name, int samples, int threads) {
  const MotionTask poses{angled_poses(path_named(name)), {}, {}, {}, {}};
  time_map(state, *task_family(poses, Requirements{}, Objective::min_transmission_angle).family, samples, threads);
}

void between_pivots(benchmark::State& state) {
  const PathTask task = path_named("walking_leg_pivots_five");
  std::array<Point, 5> places;
  for (std::size_t j = 0; j < places.size(); ++j) places[j] = task.points[j].point;
  int ends = 0, real = 0;
  for (auto _ : state) {
    const auto found = five_point_four_bars(places, *task.pivots.input, *task.pivots.output);
    ends = found.ends;
    real = static_cast<int>(found.real.size());
  }
  state.counters["ends"] = ends;
  state.counters["real"] = real;
}

constexpr int one_thread = 1, whole = 400, dragged = 100;

BENCHMARK_CAPTURE(map_of_its_poses, film_claw, "film_claw_timed", whole, one_thread)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(map_of_path, timed_film_claw, "film_claw_timed", whole, one_thread)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(map_of_path, arms_of_mixer, "dough_mixer_five_points", whole, one_thread)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(map_of_path, arms_of_mixer_on_all_cores, "dough_mixer_five_points", whole, 0)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(map_of_path, arms_of_mixer_dragged, "dough_mixer_five_points", dragged, 0)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(map_of_path, pivots_of_feeder, "feeder_three_poses_two_points", whole, one_thread)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(between_pivots)->Unit(benchmark::kMillisecond);

nlohmann::json json_of(Point point) { return {point.real(), point.imag()}; }

nlohmann::json points_of(const PathTask& task) {
  auto points = nlohmann::json::array();
  for (const PathPoint& point : task.points) points.push_back(json_of(point.point));
  return points;
}

nlohmann::json arms_of_mixer(int samples) {
  const PathTask task = path_named("dough_mixer_five_points");
  const TaskFamily given = task_family(task, Requirements{}, Objective::min_transmission_angle);
  nlohmann::json places = nlohmann::json::array(), counts = places;
  for (const double u : given.family->samples(Side::input, samples, Spacing::coordinate))
    for (const double v : given.family->samples(Side::output, samples, Spacing::coordinate)) {
      places.push_back({u, given.family->axis_value(Side::output, v)});
      counts.push_back(given.paths->all_at({u, v}, true).size());
    }
  return {{"points", points_of(task)}, {"pivot", json_of(*task.pivots.input)}, {"places", places}, {"counts", counts}};
}

nlohmann::json leg_between_pivots() {
  const PathTask task = path_named("walking_leg_pivots_five");
  std::array<Point, 5> places;
  for (std::size_t j = 0; j < places.size(); ++j) places[j] = task.points[j].point;
  auto real = nlohmann::json::array();
  for (const auto& found : five_point_four_bars(places, *task.pivots.input, *task.pivots.output).real)
    real.push_back({json_of(found.bars.input_moving), json_of(found.bars.output_moving)});
  return {{"points", points_of(task)},
          {"pivots", {json_of(*task.pivots.input), json_of(*task.pivots.output)}},
          {"real", real}};
}

}  // namespace
}  // namespace linkwright::bench::path_bench

namespace linkwright::bench {

std::string dump_path(int samples) {
  return nlohmann::json{{"arms", path_bench::arms_of_mixer(samples)}, {"between", path_bench::leg_between_pivots()}}
      .dump();
}

}  // namespace linkwright::bench
