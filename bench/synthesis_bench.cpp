// What comes before and around the region: the samples of the Burmester curve, and a task solved from end to end.

#include <benchmark/benchmark.h>

#include "bench_task.hpp"
#include "linkwright/synthesis/solve.hpp"

namespace linkwright::bench::synthesis_bench {
namespace {

void dyads(benchmark::State& state, std::string_view name) {
  constexpr int samples = 1000;
  const BurmesterCurve curve(pose_conditions(task_named(name).poses));
  const std::vector<double> coordinates = curve.samples(samples, Spacing::coordinate);
  for (auto _ : state)
    for (const double tau : coordinates) benchmark::DoNotOptimize(curve.dyad(tau));
  state.SetItemsProcessed(state.iterations() * samples);
}
BENCHMARK_CAPTURE(dyads, landing_gear, "landing_gear");
BENCHMARK_CAPTURE(dyads, drawer_hinge, "drawer_hinge");

// Everything that `linkwright solve` computes, with its default of 400 samples and ten linkages.
void solve(benchmark::State& state, std::string_view name) {
  const MotionTask task = task_named(name);
  for (auto _ : state) benchmark::DoNotOptimize(linkwright::solve({task}));
}
BENCHMARK_CAPTURE(solve, landing_gear, "landing_gear")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(solve, drawer_hinge, "drawer_hinge")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(solve, tailgate, "tailgate")->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace linkwright::bench::synthesis_bench
