// Dyads of five orientations: many tasks at once, and one with care.

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <random>

#include "bench_task.hpp"
#include "linkwright/spherical/five_orientations.hpp"

namespace linkwright::bench {
namespace {

// Uniform over all attitudes.
std::vector<FiveOrientations> random_attitudes(int count) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  std::vector<FiveOrientations> tasks(static_cast<std::size_t>(count));
  for (FiveOrientations& task : tasks)
    for (UnitQuaternion& there : task) {
      const double w = normal(random), x = normal(random), y = normal(random), z = normal(random);
      there = *UnitQuaternion::of(w, {x, y, z});
    }
  return tasks;
}

void all_orientations(benchmark::State& state, int count, Simd simd) {
  const std::vector<FiveOrientations> tasks = random_attitudes(count);
  std::vector<SphericalDyads> dyads(tasks.size());
  time_tasks(state, count, [&] { five_orientation_dyads_of_all(tasks, dyads, simd); });
}

void orientations_one_by_one(benchmark::State& state, int count) {
  std::vector<std::vector<PrescribedOrientation>> tasks;
  for (const FiveOrientations& orientations : random_attitudes(count)) {
    tasks.emplace_back();
    for (const UnitQuaternion& there : orientations) tasks.back().push_back({there, {}});
  }
  time_tasks(state, count, [&] {
    for (const auto& orientations : tasks)
      benchmark::DoNotOptimize(five_orientation_dyads(orientation_conditions(orientations)));
  });
}

bool register_five_orientations() {
  constexpr int some_tasks = 2000, many_tasks = 50'000;
  const auto add = [](const std::string& title, auto function, auto... arguments) {
    benchmark::RegisterBenchmark(title.c_str(), function, arguments...);
  };
  for (const Simd simd : {Simd::scalar, Simd::baseline, Simd::avx2, Simd::avx512})
    if (is_supported(simd))
      add(fmt::format("five_orientations/{}/{}", name(simd), some_tasks), all_orientations, some_tasks, simd);
  add(fmt::format("five_orientations/{}/{}", name(best_simd()), many_tasks), all_orientations, many_tasks,
      Simd::automatic);
  add("five_orientations/one_by_one", orientations_one_by_one, some_tasks);
  return true;
}

[[maybe_unused]] const bool five_orientations_registered = register_five_orientations();

}  // namespace

std::string dump_five_orientations(int count) {
  const std::vector<FiveOrientations> tasks = random_attitudes(count);
  std::vector<SphericalDyads> dyads(tasks.size());
  five_orientation_dyads_of_all(tasks, dyads);
  nlohmann::json json = nlohmann::json::array();
  const auto list = [](Vector3 v) { return nlohmann::json{v.x, v.y, v.z}; };
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    nlohmann::json orientations = nlohmann::json::array(), roots = nlohmann::json::array();
    for (const UnitQuaternion& there : tasks[i])
      orientations.push_back({there.w(), there.v().x, there.v().y, there.v().z});
    for (int k = 0; k < dyads[i].count; ++k) {
      const SphericalDyad& dyad = dyads[i].dyads[static_cast<std::size_t>(k)];
      roots.push_back({list(dyad.fixed_axis), list(dyad.moving_axis)});
    }
    json.push_back({{"orientations", orientations}, {"real", roots}, {"complex", dyads[i].complex_roots}});
  }
  return json.dump();
}

}  // namespace linkwright::bench
