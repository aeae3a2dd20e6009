// The region kernel: every pair of grounded links of a task classified, all columns.

#include <benchmark/benchmark.h>
#include <chrono>
#include <fmt/format.h>

#include "bench_task.hpp"
#include "linkwright/core/parallel.hpp"
#include "linkwright/region/requirement_filter.hpp"

namespace linkwright::bench::region_bench {
namespace {

constexpr int some_samples = 1000;

// Times `body`, which classifies, reads or makes samples² mechanisms.
template <class Body>
void time_mechanisms(benchmark::State& state, int samples, const Body& body) {
  const auto begin = std::chrono::steady_clock::now();
  for (auto _ : state) body();
  const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - begin;
  const double mechanisms = static_cast<double>(samples) * samples * static_cast<double>(state.iterations());
  state.counters["ns_per_mechanism"] = taken.count() / mechanisms;
  state.counters["bytes_per_mechanism"] = static_cast<double>(four_bar_bytes_per_cell);
}

// As while a pose is dragged: the memory is there already.
RegionMap map_of(const SampledTask& task, const RegionOptions& options = {}) {
  RegionMap map;
  classify_pairs(map, task.axis, task.axis, task.unit, options);
  return map;
}

void recompute(benchmark::State& state, std::string_view name, int samples, RegionOptions options) {
  const SampledTask task = sampled(name, samples);
  RegionMap map = map_of(task, options);
  time_mechanisms(state, samples, [&] { classify_pairs(map, task.axis, task.axis, task.unit, options); });
}

// A first map: the system must find, and clear, its memory.
void make(benchmark::State& state, std::string_view name, int samples, RegionOptions options) {
  const SampledTask task = sampled(name, samples);
  time_mechanisms(state, samples, [&] { benchmark::DoNotOptimize(map_of(task, options)); });
}

void count(benchmark::State& state) {
  const SampledTask task = sampled("tailgate", some_samples);
  const RegionMap map = map_of(task);
  time_mechanisms(state, some_samples, [&] { benchmark::DoNotOptimize(map.counts()); });
}

void filter(benchmark::State& state) {
  const SampledTask task = sampled("tailgate", some_samples);
  const RegionMap map = map_of(task);
  Requirements requirements;
  requirements.min_transmission_angle = 0.5;
  requirements.max_length = 10 * task.unit;
  const RequirementFilter passing(map, requirements);
  time_mechanisms(state, some_samples, [&] { benchmark::DoNotOptimize(passing.census()); });
}

bool register_all() {
  const auto add = [](const std::string& title, auto function, auto... arguments) {
    benchmark::RegisterBenchmark(title.c_str(), function, arguments...)->UseRealTime();
  };
  for (const Simd simd : {Simd::scalar, Simd::baseline, Simd::avx2, Simd::avx512}) {
    if (!is_supported(simd)) continue;
    for (const std::string_view task : task_names)
      for (const int samples : {100, 316, 1000, 3162, 10'000})
        for (int threads = 1; threads <= std::min(2, available_threads()); ++threads)
          add(fmt::format("region/{}/{}/threads:{}/{}", task, name(simd), threads, samples), recompute, task, samples,
              RegionOptions{threads, simd});
  }
  for (const int samples : {100, 1000, 10'000})
    add(fmt::format("first_region/tailgate/{}/threads:1/{}", name(best_simd()), samples), make, "tailgate", samples,
        RegionOptions{1, Simd::automatic});
  add(fmt::format("counts/tailgate/{}", some_samples), count);
  add(fmt::format("filter/tailgate/{}", some_samples), filter);
  return true;
}

[[maybe_unused]] const bool registered = register_all();

}  // namespace
}  // namespace linkwright::bench::region_bench
