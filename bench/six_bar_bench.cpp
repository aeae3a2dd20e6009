// Six-bars of the loader's bucket: the map of a given chain, each cell driven through, and the search for a chain.

#include <benchmark/benchmark.h>
#include <filesystem>

#include "linkwright/files/problem_file.hpp"
#include "linkwright/planar/six_bar_family.hpp"
#include "linkwright/planar/six_bar_synthesis.hpp"

namespace linkwright::bench::six_bar_bench {
namespace {

Problem example(const char* name) {
  return *read_problem_file(std::filesystem::path(LINKWRIGHT_EXAMPLES_DIR) / (std::string(name) + ".json"));
}

// Cells per second. Of 4-3 each row has a curve of links 5 of its own; 1-3 after 0-3 does not fall into dyads.
void map_of_chain(benchmark::State& state, BodyPair link_4, BodyPair link_5) {
  const int samples = static_cast<int>(state.range(0));
  RegionOptions options;
  options.threads = static_cast<int>(state.range(1));
  SixBarTask task = std::get<SixBarTask>(example("loader_bucket_chain").task);
  task.added = {link_4, link_5};
  const auto family = ChainFamily::of(task);
  const auto first = family->samples(Side::input, samples, Spacing::coordinate),
             second = family->samples(Side::output, samples, Spacing::coordinate);
  RegionMap map;
  for (auto _ : state) family->classify(map, first, second, true, options);
  state.SetItemsProcessed(state.iterations() * samples * samples);
}
void sizes_and_threads(benchmark::internal::Benchmark* bench) {
  bench->ArgNames({"samples", "threads"})->Unit(benchmark::kMillisecond)->UseRealTime();
  for (const int samples : {50, 100, 200})
    for (const int threads : {1, 2}) bench->Args({samples, threads});
}
BENCHMARK_CAPTURE(map_of_chain, watt_1_by_0_2_and_1_3, BodyPair{0, 2}, BodyPair{1, 3})->Apply(sizes_and_threads);
BENCHMARK_CAPTURE(map_of_chain, watt_1_by_0_2_and_4_3, BodyPair{0, 2}, BodyPair{4, 3})->Apply(sizes_and_threads);
BENCHMARK_CAPTURE(map_of_chain, stephenson_2_by_0_3_and_1_3, BodyPair{0, 3}, BodyPair{1, 3})->Apply(sizes_and_threads);

// Chains per second: drawn, glanced at, the promising six-bars driven, the best of all refined.
void search_chains(benchmark::State& state) {
  constexpr int chains = 200'000;
  const Problem problem = example("loader_bucket");
  const auto& task = std::get<SixBarTask>(problem.task);
  SixBarSearchOptions options;
  options.effort = chains;
  for (auto _ : state) benchmark::DoNotOptimize(search_six_bars(task, problem.requirements, {}, options));
  state.SetItemsProcessed(state.iterations() * chains);
}
BENCHMARK(search_chains)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace linkwright::bench::six_bar_bench
