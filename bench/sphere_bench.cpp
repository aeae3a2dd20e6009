// The region kernel of spherical four-bars, and a task from its orientations to its map.

#include <benchmark/benchmark.h>
#include <chrono>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>

#include "bench_task.hpp"
#include "linkwright/core/parallel.hpp"
#include "linkwright/spherical/spherical_family.hpp"
#include "linkwright/spherical/spherical_map.hpp"

namespace linkwright::bench {
namespace {

std::vector<PrescribedOrientation> folding_wing() {
  const auto json = nlohmann::json::parse(std::ifstream(LINKWRIGHT_DATA_DIR "/spherical/folding-wing-4.json"));
  std::vector<PrescribedOrientation> orientations;
  for (const auto& q : json.at("input").at("orientations"))
    orientations.push_back({*UnitQuaternion::of(q.at(0), {q.at(1), q.at(2), q.at(3)}), {}});
  return orientations;
}

SphericalAxis wing_axis(int samples) {
  const auto orientations = folding_wing();
  const AxisCurve curve(orientation_conditions(orientations));
  std::vector<SphericalDyad> dyads;
  for (const double at : curve.samples(samples, Spacing::coordinate)) dyads.push_back(curve.dyad(at));
  return SphericalAxis(std::move(dyads), orientations);
}

void recompute_sphere(benchmark::State& state, int samples, RegionOptions options) {
  const SphericalAxis axis = wing_axis(samples);
  RegionMap map;
  classify_pairs(map, axis, axis, options);  // the memory is there then
  const auto begin = std::chrono::steady_clock::now();
  for (auto _ : state) classify_pairs(map, axis, axis, options);
  const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - begin;
  state.counters["ns_per_mechanism"] =
      taken.count() / (static_cast<double>(samples) * samples * static_cast<double>(state.iterations()));
}

// Conditions, cone, dyads, map: what a turned orientation asks for.
void sphere_to_map(benchmark::State& state) {
  const auto orientations = folding_wing();
  RegionMap map;
  for (auto _ : state) {
    const auto curve = std::make_shared<const AxisCurve>(orientation_conditions(orientations));
    const SphericalCurveFamily family(orientations, curve);
    const auto places = family.samples(Side::input, 400, Spacing::coordinate);
    family.classify(map, places, places, true, {1, Simd::automatic});
  }
}

bool register_sphere() {
  for (const Simd simd : {Simd::scalar, Simd::baseline, Simd::avx2, Simd::avx512}) {
    if (!is_supported(simd)) continue;
    for (const int samples : {100, 316, 1000, 3162, 10'000})
      for (int threads = 1; threads <= std::min(2, available_threads()); ++threads)
        benchmark::RegisterBenchmark(
            fmt::format("sphere_region/folding_wing/{}/threads:{}/{}", name(simd), threads, samples).c_str(),
            recompute_sphere, samples, RegionOptions{threads, simd})
            ->UseRealTime();
  }
  benchmark::RegisterBenchmark("sphere_task_to_map/400", sphere_to_map)->UseRealTime()->Unit(benchmark::kMillisecond);
  return true;
}

[[maybe_unused]] const bool sphere_registered = register_sphere();

}  // namespace

std::string dump_sphere(int samples) {
  const SphericalAxis axis = wing_axis(samples);
  RegionMap map;
  classify_pairs(map, axis, axis);
  const RegionCounts counts = map.counts();
  const nlohmann::json json = {{"fixed", axis.fixed},
                               {"moving", axis.moving},
                               {"half_sine", axis.half_sine},
                               {"half_cosine", axis.half_cosine},
                               {"senses", axis.admissible_directions},
                               {"wide", axis.at_least_half_turn},
                               {"counts",
                                {{"types", counts.types},
                                 {"order", counts.order},
                                 {"branch", counts.branch},
                                 {"circuit", counts.circuit},
                                 {"defect_free", counts.defect_free}}}};
  return json.dump();
}

}  // namespace linkwright::bench
