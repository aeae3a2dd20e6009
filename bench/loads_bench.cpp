// Loads: what the forces of the hand add to a map, at the positions alone and over the travel, by cases; what a search
// pays for a linkage, and a report.

#include <array>
#include <benchmark/benchmark.h>
#include <cstdint>
#include <filesystem>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <span>

#include "analyses/loads/loads_analysis.hpp"
#include "bench_task.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/loads/load_report.hpp"
#include "linkwright/planar/task_family.hpp"
#include "linkwright/synthesis/solve.hpp"
#include "loads/cell_loads.hpp"

namespace linkwright::bench {
namespace loads_bench {
namespace {

Problem tailgate_struts() {
  return *read_problem_file(std::filesystem::path(LINKWRIGHT_EXAMPLES_DIR) / "tailgate_struts.json");
}

// The tailgate on struts, the first `cases` of its cases, pins without friction.
Loads loads_of(int stations, int cases) {
  Loads loads = *tailgate_struts().options.loads;
  loads.stations = stations;
  loads.cases.resize(static_cast<std::size_t>(cases));
  for (LoadCase& of : loads.cases) of.counts_for = {};
  loads.pins.reset();
  return loads;
}

struct ClassifiedMap {
  TaskFamily given;
  RegionMap map;

  explicit ClassifiedMap(int samples)
      : given(task_family(std::get<MotionTask>(tailgate_struts().task), {}, Objective::hand_force)) {
    const auto along = [&](Side side) { return given.family->samples(side, samples, Spacing::coordinate); };
    given.family->classify(map, along(Side::input), along(Side::output), true, {.threads = 1});
  }
  // Those that have forces.
  [[nodiscard]] std::vector<std::size_t> whole_cells() const {
    std::vector<std::size_t> found;
    for (std::size_t cell = 0; cell < map.rows() * map.columns(); ++cell)
      if (map.type(cell) != LinkageType::degenerate && map.defects(cell).none()) found.push_back(cell);
    return found;
  }
  [[nodiscard]] PlanarOutput output(std::size_t cell) const {
    return std::get<PlanarOutput>(*given.family->output(
        {map.input_coordinates()[cell / map.columns()], map.output_coordinates()[cell % map.columns()]}));
  }
};

// ns_per_task: of all cells of the map; ns_per_linkage: of those that have forces.
void load_map(benchmark::State& state, const Loads& loads, std::span<const Measure> asked) {
  constexpr int samples = 400;
  ClassifiedMap of(samples);
  const AddedMeasures added = load_measures(*of.given.family, loads);
  const auto fill = added.find(measures::hand_force)->together->rows_of(of.map, asked);
  time_tasks(state, samples * samples, [&] { of.map.add(asked, fill); });
  state.counters["ns_per_linkage"] =
      state.counters["ns_per_task"] * samples * samples / static_cast<double>(of.whole_cells().size());
}

void hand_map(benchmark::State& state, int stations, int cases) {
  constexpr std::array hand = {measures::max_open_force, measures::max_close_force, measures::hand_force};
  load_map(state, loads_of(stations, cases), hand);
}

// As pages have it: pins with friction, their forces, four cases.
void whole_map(benchmark::State& state) {
  constexpr std::array all = {measures::max_open_force, measures::max_close_force, measures::hand_force,
                              measures::hold_open, measures::max_pin_force};
  load_map(state, *tailgate_struts().options.loads, all);
}

// One linkage after the other, everything that a search may ask.
void search_look(benchmark::State& state) {
  ClassifiedMap of(60);
  const Loads loads = *tailgate_struts().options.loads;
  const auto cells = of.whole_cells();
  std::size_t next = 0;
  time_tasks(state, 1, [&] {
    CellLoads cell(loads, of.output(cells[next++ % cells.size()]), CellLook::search);
    benchmark::DoNotOptimize(cell.read_out(ReadOut::hand_force));
  });
}

void report(benchmark::State& state) {
  ClassifiedMap of(60);
  const Loads loads = *tailgate_struts().options.loads;
  const auto cells = of.whole_cells();
  std::size_t next = 0;
  time_tasks(state, 1, [&] {
    const PlanarOutput output = of.output(cells[next++ % cells.size()]);
    benchmark::DoNotOptimize(load_report(loads, output.positions.front().bars, poses_of(output)));
  });
}

bool register_loads() {
  for (const int stations : {4, 13})
    for (const int cases : {1, 3})
      benchmark::RegisterBenchmark(fmt::format("load_map/stations:{}/cases:{}", stations, cases).c_str(), hand_map,
                                   stations, cases)
          ->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("load_map/all", whole_map)->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("loads/search_look", search_look)->Unit(benchmark::kMicrosecond);
  benchmark::RegisterBenchmark("loads/report", report)->Unit(benchmark::kMicrosecond);
  return true;
}

[[maybe_unused]] const bool loads_registered = register_loads();

// The linkages of a map in their positions, what acts on them, and their largest opening forces at the positions.
std::string dumped(int samples) {
  using nlohmann::json;
  const auto pair = [](Point p) { return json{p.real(), p.imag()}; };
  ClassifiedMap of(samples);
  Loads loads = loads_of(4, 1);
  loads.input.reset();
  loads.output.reset();
  loads.extra.clear();
  loads.springs.clear();
  const AddedMeasures added = load_measures(*of.given.family, loads);
  added.add_to(of.map, *of.given.family, {}, false);
  const auto forces = of.map.values(measures::max_open_force);
  json file = {{"weight", loads.body->mass * loads.gravity->acceleration},
               {"center", pair(loads.body->center)},
               {"handle", pair(loads.handle->point)}};
  const auto task = std::get<MotionTask>(tailgate_struts().task);
  for (const PrescribedPose& pose : task.poses)
    file["poses"].push_back({pose.pose.origin.real(), pose.pose.origin.imag(), pose.pose.angle});
  for (const std::size_t cell : of.whole_cells()) {
    const PlanarOutput output = of.output(cell);
    const FourBar& first = output.positions.front().bars;
    const bool turns_back = of.map.drive_sense(cell / of.map.columns(), cell % of.map.columns()) == DriveSense::cw;
    file["linkages"].push_back({pair(first.input_fixed), pair(first.output_fixed), pair(first.input_moving),
                                pair(first.output_moving), turns_back ? -1 : 1});
    file["forces"].push_back(forces[cell]);
  }
  return file.dump();
}

}  // namespace
}  // namespace loads_bench

std::string dump_loads(int samples) { return loads_bench::dumped(samples); }
}  // namespace linkwright::bench
