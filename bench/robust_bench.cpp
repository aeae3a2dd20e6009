// Tolerances: the error of a linkage in four poses to first order, and samples of it, with the numbers and without.

#include <algorithm>
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "linkwright/analysis/position.hpp"
#include "linkwright/robust/tolerance_sampling.hpp"
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
    const Point along = (bars.output_circle - bars.input_circle) / lengths.coupler;
    all.push_back({bars, bars.input_circle + Point{1.2, 0.9} * along});
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
  put(linkages[0].bars.input_center, block.input_center);
  put(linkages[0].bars.output_center, block.output_center);
  for (std::size_t j = 0; j < positions; ++j) {
    put(linkages[j].bars.input_circle, block.input_circle[j]);
    put(linkages[j].bars.output_circle, block.output_circle[j]);
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

bool register_robust() {
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

}  // namespace
}  // namespace robust_bench
}  // namespace linkwright::bench
