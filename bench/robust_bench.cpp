// Tolerances: the error of a linkage in four poses to first order, samples of it, with the numbers and without, and
// what they add to maps of every kind.

#include <algorithm>
#include <benchmark/benchmark.h>
#include <filesystem>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "bench_task.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/mechanism/position.hpp"
#include "linkwright/robust/tolerance_sampling.hpp"
#include "linkwright/synthesis/solve.hpp"
#include "robust/tolerance_error_kernel.hpp"

namespace linkwright::bench {
namespace robust_bench {
namespace {

constexpr int positions = 4;

// A crank-rocker and a point of its coupler.
std::vector<TracingFourBar> four_positions() {
  const LinkLengths lengths{3, 1, 2.6, 2.4};
  const FourBar frame{0, lengths.input, lengths.ground, lengths.ground + lengths.output};
  std::vector<TracingFourBar> all;
  for (int j = 0; j < positions; ++j) {
    const FourBar bars = placed(frame, assemble(lengths, 0.4 + 0.5 * j, Assembly::positive).value());
    const Point along = (bars.output_moving - bars.input_moving) / lengths.coupler;
    all.push_back({bars, bars.input_moving + Point{1.2, 0.9} * along});
  }
  return all;
}

Tolerances some_tolerances(int samples) {
  Tolerances tolerances{.length = LengthTolerances::all(0.01)};
  tolerances.samples = samples;
  return tolerances;
}

// Items: a sample in one position.
void sample(benchmark::State& state, Simd simd) {
  const PlanarOutput output = pose_output(four_positions(), 1);
  const Tolerances tolerances = some_tolerances(100'000);
  for (auto _ : state) benchmark::DoNotOptimize(sample_errors(output, tolerances, 1, simd).error);
  state.SetItemsProcessed(state.iterations() * tolerances.samples * positions);
}

void sample_drawn(benchmark::State& state, Simd simd) {
  const PlanarOutput output = pose_output(four_positions(), 1);
  const Tolerances tolerances = some_tolerances(1024);
  const ToleranceSampler sampler(tolerances, simd);
  for (auto _ : state) benchmark::DoNotOptimize(sampler.errors_of(output).error);
  state.SetItemsProcessed(state.iterations() * tolerances.samples * positions);
}

// Items: a linkage.
void tolerance_error(benchmark::State& state, Simd simd) {
  ToleranceErrorBlock block;
  block.positions = positions;
  block.variances = {1, 1, 1, 1, 1, 1};
  block.turning_length = 1;
  const auto linkages = four_positions();
  const auto put = [](Point p, double to[2][ToleranceErrorBlock::size]) {
    std::fill_n(to[0], ToleranceErrorBlock::size, p.real());
    std::fill_n(to[1], ToleranceErrorBlock::size, p.imag());
  };
  put(linkages[0].bars.input_fixed, block.input_fixed);
  put(linkages[0].bars.output_fixed, block.output_fixed);
  for (std::size_t j = 0; j < positions; ++j) {
    put(linkages[j].bars.input_moving, block.input_moving[j]);
    put(linkages[j].bars.output_moving, block.output_moving[j]);
    block.point[j][0] = linkages[j].point.real();
    block.point[j][1] = linkages[j].point.imag();
  }
  for (auto _ : state) {
    tolerance_error_kernel.for_simd(simd)(block);
    benchmark::DoNotOptimize(block.error[0]);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * ToleranceErrorBlock::size);
}

Problem example(const std::string& name) {
  Problem problem = *read_problem_file(std::filesystem::path(LINKWRIGHT_EXAMPLES_DIR) / (name + ".json"));
  Tolerances given;
  const bool on_sphere = name == "folding_wing";
  (on_sphere ? given.link_angle : given.driver) = 0.001;
  if (!on_sphere) given.length = LengthTolerances::all(0.1);
  using Kind = ToleranceLimit::Kind;
  const bool is_line = std::holds_alternative<StraightLineTask>(problem.task);
  given.limit = ToleranceLimit{is_line ? Kind::deviation : Kind::angle, is_line ? 1 : 0.01};
  problem.options.tolerances = given;
  return problem;
}

// Items: a cell of the map; of yields one that meets the requirements.
void measure_map(benchmark::State& state, const std::string& name, bool yields) {
  Problem problem = example(name);
  problem.options.region_samples = static_cast<int>(state.range(0));
  problem.options.region.threads = 1;
  problem.options.measure_yields = false;
  problem.options.best = 0;
  const Answer answer = solve(problem).value();
  const Findings& found = findings(answer);
  RegionMap map;
  const LinkageFamily& family =
      *std::visit([](const auto& of_kind) -> const LinkageFamily* { return of_kind.family(); }, answer);
  family.classify(map, found.region.input_coordinates(), found.region.output_coordinates(), true, {.threads = 1});
  const RequirementFilter filter = filter_of(family, map, found.requirements);
  std::int64_t cells = 0;
  for (auto _ : state) {
    if (!yields) {
      map.add(*found.added.find(measures::tolerance_error)->measure);
      cells += static_cast<std::int64_t>(map.rows() * map.columns());
      continue;
    }
    for (std::size_t row = 0; row < map.rows(); ++row)
      for (std::size_t column = 0; column < map.columns(); ++column) {
        if (!filter.passes(row, column)) continue;
        benchmark::DoNotOptimize(found.added.find(measures::yield)
                                     ->measure->at({map.input_coordinates()[row], map.output_coordinates()[column]}));
        ++cells;
      }
  }
  state.SetItemsProcessed(cells);
}

bool register_robust() {
  for (const char* name :
       {"tailgate", "latch", "flow_meter", "folding_wing", "straight_luffing_crane", "loader_bucket_chain"})
    for (const bool yields : {false, true})
      benchmark::RegisterBenchmark(fmt::format("tolerance_map/{}/{}", name, yields ? "yield" : "error").c_str(),
                                   measure_map, name, yields)
          ->Arg(std::string_view(name) == "loader_bucket_chain" ? 240 : 100)
          ->Unit(benchmark::kMillisecond);
  for (const Simd simd : {Simd::scalar, Simd::baseline, Simd::avx2, Simd::avx512}) {
    if (!is_supported(simd)) continue;
    const auto named = [&](const char* what) { return fmt::format("tolerances/{}/{}", what, name(simd)); };
    benchmark::RegisterBenchmark(named("error").c_str(), tolerance_error, simd);
    benchmark::RegisterBenchmark(named("samples").c_str(), sample, simd)->UseRealTime();
    benchmark::RegisterBenchmark(named("samples_drawn_once").c_str(), sample_drawn, simd);
  }
  return true;
}

[[maybe_unused]] const bool robust_registered = register_robust();

std::string dumped(int samples) {
  using nlohmann::json;
  const auto pair = [](Point p) { return json{p.real(), p.imag()}; };
  const auto linkages = four_positions();
  const FourBar& bars = linkages.front().bars;
  const LinkLengths lengths = bars.lengths();
  const Tolerances tolerances = some_tolerances(samples);
  const auto direction = [](Point from, Point to) { return (to - from) / std::abs(to - from); };
  json file = {
      {"samples", samples},
      {"tolerance", tolerances.length.input},
      {"turning_length", 1},
      {"input", lengths.input},
      {"coupler", lengths.coupler},
      {"output", lengths.output},
      {"input_center", pair(bars.input_fixed)},
      {"output_center", pair(bars.output_fixed)},
      {"arm", pair((linkages.front().point - bars.input_moving) / direction(bars.input_moving, bars.output_moving))},
      {"deviations", sample_errors(pose_output(linkages, 1), tolerances, 1).deviations}};
  for (const TracingFourBar& there : linkages)
    file["positions"].push_back(
        {{"input_direction", pair(direction(there.bars.input_fixed, there.bars.input_moving))},
         {"coupler_direction", pair(direction(there.bars.input_moving, there.bars.output_moving))},
         {"point", pair(there.point)},
         {"assembly", assembly_of(there.bars) == Assembly::positive ? 1 : -1}});
  return file.dump();
}

}  // namespace
}  // namespace robust_bench

std::string dump_tolerances(int samples) { return robust_bench::dumped(samples); }
}  // namespace linkwright::bench
