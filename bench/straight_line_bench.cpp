// Linkages with a point that runs straight: the geometry of a place of the map of each case, what its straight line is
// worth, quickly and exactly, whole maps, and the search.

#include <algorithm>
#include <benchmark/benchmark.h>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "bench_task.hpp"
#include "kinds/straight_line/straight_line_kind.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/parallel.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/straight_line/straight_line_search.hpp"
#include "straight_line/line_cases.hpp"
#include "straight_line/line_estimate.hpp"

namespace linkwright::bench {
namespace straight_line_bench {
namespace {

using namespace straight_cases;

struct LineTask {
  std::string name;
  StraightLineTask task;
  LineMeasuring measuring{};
  std::optional<MapWindow> window{};

  [[nodiscard]] StraightLineFamily family() const { return {task, measuring, window}; }
};

LineTask example(const std::string& name) {
  const Problem problem = *read_problem_file(std::filesystem::path(LINKWRIGHT_EXAMPLES_DIR) / (name + ".json"));
  return {name, std::get<StraightLineTask>(problem.task), problem.options.line, problem.options.window};
}

// A task of each case: an example where there is one, otherwise the numbers of a file of data/straight_line.
const std::vector<LineTask>& line_tasks() {
  static const std::vector<LineTask> tasks = [] {
    const LineAtAngle level{};
    return std::vector<LineTask>{
        example("straight_indicator"),
        example("straight_luffing_crane"),
        {"c92a", {level, FourPointCubic{1, radians(50), 1.7}}},
        {"c93a", {level, BallPointOnSideLink{{-1.5, -2}}}},
        {"c94a", {level, IsoscelesTrapezoid{1}}},
        {"c95", {level, PoleAtFixedPivot{1, 0.6}}},
        {"c96a", {level, PoleAtFixedPivotBallPointOnFrame{3}}},
        {"c101a", {level, FivePoint{1, radians(57)}}},
        {"c102a", {LineAtAngle({}, radians(10)), FivePointInflectionPole{1.5}}},
        {"c103a", {level, FivePointSideLinkOnFrame{1}}},
        example("straight_stage"),
        example("straight_watt_suspension"),
        {"lam_pp_pp", {LineAtAngle({0, 4}, 0), MixedContacts{{}, {{1, 2, -1}, {3, 2, -1}}, 0}}},
        {"lam_p_p_p_p",
         {LineAtAngle({0, 4}, 0), MixedContacts{{}, {{0.5, 1, -1}, {1.5, 1, -1}, {2.5, 1, -1}, {3.5, 1, -1}}, 0.7}}},
        example("straight_walking_leg")};
  }();
  return tasks;
}

// Coordinates of a map as the engine takes them.
std::vector<LineAxisValue> axis_values(const LineTask& of, Side side, int samples) {
  const StraightLineFamily family = of.family();
  const LineAxis axis = axes_of(of.task)[static_cast<std::size_t>(side)];
  std::vector<LineAxisValue> values;
  for (const double coordinate : family.samples(side, samples, Spacing::coordinate)) {
    if (side == Side::input && coordinate >= 1) break;  // the next layer has the same
    const double read = family.axis_value(side, coordinate);
    values.push_back(line_axis_value(axis, is_angle(axis.quantity) ? radians(read) : read));
  }
  return values;
}

// By layers, as a map takes them.
template <class Take>
void for_each_design(const LineTask& of, int samples, const Take& take) {
  const auto rows = axis_values(of, Side::input, samples), columns = axis_values(of, Side::output, samples);
  for (int layer = 0; layer < layers_of(of.task.given); ++layer)
    for (const LineAxisValue row : rows)
      for (const LineAxisValue column : columns)
        take(designs_at(of.task, row, column)[static_cast<std::size_t>(layer)]);
}

std::vector<TracingFourBar> four_bars(const LineTask& of, int samples) {
  std::vector<TracingFourBar> found;
  for_each_design(of, samples, [&](const LineDesign& design) {
    if (design.kind == DesignKind::four_bar) found.push_back(design.linkage);
  });
  return found;
}

// The processor's time, of one thread: others use the machine, too.
class Stopwatch {
 public:
  [[nodiscard]] double nanoseconds() const { return 1e9 * static_cast<double>(std::clock() - begin_) / CLOCKS_PER_SEC; }

 private:
  std::clock_t begin_ = std::clock();
};

// The rows' and columns' directions are there: the linkages alone.
void line_geometry(benchmark::State& state, const LineTask& of) {
  constexpr int samples = 200;
  const auto rows = axis_values(of, Side::input, samples), columns = axis_values(of, Side::output, samples);
  const int layers = layers_of(of.task.given);
  const Stopwatch watch;
  for (auto _ : state)
    for (int layer = 0; layer < layers; ++layer)
      for (const LineAxisValue row : rows)
        for (const LineAxisValue column : columns)
          benchmark::DoNotOptimize(designs_at(of.task, row, column)[static_cast<std::size_t>(layer)]);
  state.counters["ns_per_cell"] = watch.nanoseconds() / (static_cast<double>(layers) * rows.size() * columns.size() *
                                                         static_cast<double>(state.iterations()));
}

void line_estimates(benchmark::State& state, const LineTask& of, Simd simd) {
  const std::vector<TracingFourBar> linkages = four_bars(of, 100);
  std::vector<LineEstimate> estimates(linkages.size());
  const LineEstimateTask task = estimate_task(of.family(), simd);
  const Stopwatch watch;
  for (auto _ : state) estimate_lines(linkages, task, estimates);
  state.counters["ns_per_linkage"] =
      watch.nanoseconds() / (static_cast<double>(linkages.size()) * static_cast<double>(state.iterations()));
}

// What is asked of one linkage exactly; over linkages of the map, evenly.
template <class Question>
void exact_measures(benchmark::State& state, const LineTask& of, const Question& question) {
  constexpr std::size_t count = 100;
  std::vector<TracingFourBar> linkages;
  const std::vector<TracingFourBar> all = four_bars(of, 100);
  for (std::size_t i = 0; i < count; ++i) linkages.push_back(all[i * all.size() / count]);
  const Stopwatch watch;
  for (auto _ : state)
    for (const TracingFourBar& linkage : linkages) question(linkage);
  state.counters["us_per_linkage"] =
      1e-3 * watch.nanoseconds() / (static_cast<double>(linkages.size()) * static_cast<double>(state.iterations()));
}

// As the climb of a map does: only as far as the deviation lets it.
void exact_stroke(benchmark::State& state, const LineTask& of) {
  exact_measures(state, of, [&](const TracingFourBar& linkage) {
    const double deviation = of.measuring.deviation_of(linkage);
    PathLimits limits;
    limits.max_deviation = 1.000001 * deviation;
    const auto path = StraightPath::of(linkage, of.task.line.direction, limits);
    if (!path) return;
    const UsableLine usable = path->usable(deviation);
    benchmark::DoNotOptimize(path->stroke_figures(usable.from, usable.to));
  });
}

// The longest strip of the whole path.
void exact_strip(benchmark::State& state, const LineTask& of) {
  exact_measures(state, of, [&](const TracingFourBar& linkage) {
    const auto path = StraightPath::of(linkage, of.task.line.direction);
    if (path) benchmark::DoNotOptimize(path->usable_strip(of.measuring.deviation_of(linkage)));
  });
}

void line_map(benchmark::State& state, const LineTask& of, int samples, int threads) {
  const StraightLineFamily family = of.family();
  const auto input = family.samples(Side::input, samples, Spacing::coordinate),
             output = family.samples(Side::output, samples, Spacing::coordinate);
  RegionMap map;
  family.classify(map, input, output, true, {threads, Simd::automatic});  // the memory is there then
  const auto begin = std::chrono::steady_clock::now();
  const Stopwatch watch;
  for (auto _ : state) family.classify(map, input, output, true, {threads, Simd::automatic});
  const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - begin;
  const double cells = static_cast<double>(input.size()) * output.size() * static_cast<double>(state.iterations());
  state.counters["ns_per_cell"] = taken.count() / cells;
  state.counters["processor_ns_per_cell"] = watch.nanoseconds() / cells;
}

void line_search(benchmark::State& state, int threads) {
  const Problem problem = *read_problem_file(std::filesystem::path(LINKWRIGHT_EXAMPLES_DIR) / "straight_search.json");
  const auto& task = std::get<StraightLineTask>(problem.task);
  StraightLineSearchOptions options;
  options.threads = threads;
  for (auto _ : state)
    benchmark::DoNotOptimize(search_straight_lines(task.line, std::get<Search>(task.given),
                                                   with_default_length(problem.requirements, task), options));
}

template <class Function, class... Arguments>
benchmark::internal::Benchmark* add(const std::string& name, Function function, Arguments... arguments) {
  return benchmark::RegisterBenchmark(name.c_str(), function, arguments...)
      ->UseRealTime()
      ->Unit(benchmark::kMillisecond);
}

bool register_lines() {
  const int most_threads = std::min(2, available_threads());
  for (const LineTask& task : line_tasks()) {
    add("line_geometry/" + task.name, line_geometry, task);
    for (const Simd simd : {Simd::scalar, Simd::baseline, Simd::avx2, Simd::avx512})
      if (is_supported(simd))
        add(fmt::format("line_estimate/{}/{}", task.name, name(simd)), line_estimates, task, simd);
    add("line_stroke/" + task.name, exact_stroke, task);
    add("line_strip/" + task.name, exact_strip, task);
    for (const int samples : {50, 100, 200, 400}) {
      if (samples != 200 && task.name != "straight_indicator") continue;
      for (int threads = 1; threads <= most_threads; ++threads)
        add(fmt::format("line_map/{}/threads:{}/{}", task.name, threads, samples), line_map, task, samples, threads);
    }
  }
  for (int threads = 1; threads <= most_threads; ++threads)
    add(fmt::format("line_search/threads:{}", threads), line_search, threads);
  return true;
}

[[maybe_unused]] const bool lines_registered = register_lines();

}  // namespace
}  // namespace straight_line_bench

std::string dump_lines(int samples) {
  namespace here = straight_line_bench;
  const here::LineTask of = here::example("straight_indicator");
  const auto& given = std::get<straight_cases::FourPointPivots>(of.task.given);
  const auto linkages = here::four_bars(of, samples);
  std::vector<LineEstimate> estimates(linkages.size());
  estimate_lines(linkages, estimate_task(of.family()), estimates);
  const auto pair = [](Point p) { return nlohmann::json{p.real(), p.imag()}; };
  const auto angles = [&](Side side) {
    nlohmann::json list;
    for (const LineAxisValue& value : here::axis_values(of, side, samples)) list.push_back(value.value);
    return list;
  };
  const auto column = [&](double LineEstimate::*number) {
    nlohmann::json list;  // null of what is infinite
    for (const LineEstimate& estimate : estimates) list.push_back(estimate.*number);
    return list;
  };
  const nlohmann::json json = {{"point", pair(of.task.line.point)},
                               {"direction", pair(of.task.line.direction)},
                               {"input", pair(given.input)},
                               {"output", pair(given.output)},
                               {"deviation", *of.measuring.deviation},
                               {"first", angles(Side::input)},
                               {"second", angles(Side::output)},
                               {"estimates",
                                {{"usable_stroke", column(&LineEstimate::usable_stroke)},
                                 {"usable_strip", column(&LineEstimate::usable_strip)},
                                 {"min_transmission_sine", column(&LineEstimate::min_transmission_sine)},
                                 {"velocity_nonuniformity", column(&LineEstimate::velocity_nonuniformity)},
                                 {"contact_coefficient", column(&LineEstimate::contact_coefficient)}}}};
  return json.dump();
}

}  // namespace linkwright::bench
