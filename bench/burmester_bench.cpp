// Burmester points of five poses: many tasks at once, and one with care.

#include <benchmark/benchmark.h>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <random>

#include "bench_task.hpp"
#include "linkwright/planar/burmester_points.hpp"

namespace linkwright::bench {
namespace {

std::vector<FivePoses> random_tasks(int count) {
  std::mt19937_64 random(5);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * std::ldexp(static_cast<double>(random() >> 11), -53);
  };
  std::vector<FivePoses> tasks(static_cast<std::size_t>(count));
  for (FivePoses& poses : tasks)
    for (Pose& pose : poses) {
      const double x = uniform(-2, 2), y = uniform(-2, 2);
      pose = {{x, y}, uniform(-3, 3)};
    }
  return tasks;
}

void of_all(benchmark::State& state, int count, Simd simd) {
  const std::vector<FivePoses> tasks = random_tasks(count);
  std::vector<BurmesterDyads> dyads(tasks.size());
  time_tasks(state, count, [&] { burmester_points_of_all(tasks, dyads, simd); });
}

void one_by_one(benchmark::State& state, int count) {
  std::vector<std::vector<PrescribedPose>> tasks;
  for (const FivePoses& poses : random_tasks(count)) {
    tasks.emplace_back();
    for (const Pose& pose : poses) tasks.back().push_back({pose, {}});
  }
  time_tasks(state, count, [&] {
    for (const auto& poses : tasks) benchmark::DoNotOptimize(burmester_points(pose_conditions(poses)));
  });
}

bool register_all() {
  constexpr int some_tasks = 2000, many_tasks = 200'000;
  const auto add = [](const std::string& title, auto function, auto... arguments) {
    benchmark::RegisterBenchmark(title.c_str(), function, arguments...);
  };
  for (const Simd simd : {Simd::scalar, Simd::baseline, Simd::avx2, Simd::avx512})
    if (is_supported(simd))
      add(fmt::format("burmester_points/{}/{}", name(simd), some_tasks), of_all, some_tasks, simd);
  add(fmt::format("burmester_points/{}/{}", name(best_simd()), many_tasks), of_all, many_tasks, Simd::automatic);
  add("burmester_points/one_by_one", one_by_one, some_tasks);
  return true;
}

[[maybe_unused]] const bool registered = register_all();

}  // namespace

std::string dump_five(int count) {
  const std::vector<FivePoses> tasks = random_tasks(count);
  std::vector<BurmesterDyads> dyads(tasks.size());
  burmester_points_of_all(tasks, dyads);
  nlohmann::json json = nlohmann::json::array();
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    nlohmann::json poses = nlohmann::json::array(), roots = nlohmann::json::array();
    for (const Pose& pose : tasks[i]) poses.push_back({pose.origin.real(), pose.origin.imag(), pose.angle});
    for (int k = 0; k < dyads[i].count; ++k) {
      const auto& [center, circle, coordinate] = dyads[i].dyads[static_cast<std::size_t>(k)];
      roots.push_back({{circle.w, circle.x, circle.y}, {center.w, center.x, center.y}});
    }
    json.push_back(
        {{"poses", poses}, {"unit", dyads[i].frame.scale}, {"real", roots}, {"complex", dyads[i].complex_roots}});
  }
  return json.dump();
}

}  // namespace linkwright::bench
