#pragma once

#include <array>
#include <benchmark/benchmark.h>
#include <ctime>
#include <string>
#include <string_view>

#include "linkwright/planar/four_bar_map.hpp"
#include "linkwright/planar/motion_task.hpp"

namespace linkwright::bench {

/// The tasks that are timed: a curve of two branches, one of a single branch, and the gallery's tailgate.
inline constexpr std::array<std::string_view, 3> task_names = {"landing_gear", "drawer_hinge", "tailgate"};

[[nodiscard]] MotionTask task_named(std::string_view name);

/// A task's Burmester curve, sampled: both axes of its region.
struct SampledTask {
  DyadAxis axis;
  double unit;  ///< characteristic length, user's unit
};
[[nodiscard]] SampledTask sampled(std::string_view name, int samples);

/// The axis and the kernel's counts over it as JSON, for the peers (bench/peers).
[[nodiscard]] std::string dump(std::string_view name, int samples);

/// The folding wing's axis and the kernel's counts over it as JSON, for the peer.
[[nodiscard]] std::string dump_sphere(int samples);

/// The indicator's line, axes and estimates of all linkages of its map as JSON, for the peer.
[[nodiscard]] std::string dump_lines(int samples);

/// A linkage in four positions, its tolerances, and how far its samples are off in each as JSON, for the peer.
[[nodiscard]] std::string dump_tolerances(int samples);

/// Of the dough mixer the points, the pivot and, by places evenly over its map, how many linkages meet the points in
/// order; of the walking leg the points, the pivots and the real four-bars between them: as JSON, for the peers.
[[nodiscard]] std::string dump_path(int samples);

/// Linkages of the tailgate's map in their positions, what acts on them, and the largest forces of the hand as JSON,
/// for the peer.
[[nodiscard]] std::string dump_loads(int samples);

/// Random tasks of five poses and their Burmester points (circle, centre; working frame) as JSON, for PHCpack.
[[nodiscard]] std::string dump_five(int count);

/// Random tasks of five orientations and their dyads (fixed, moving axis) as JSON, for PHCpack.
[[nodiscard]] std::string dump_five_orientations(int count);

/// Points of the closed paths that are drawn at random, and the types of their linkages, as JSON, for the peer.
[[nodiscard]] std::string dump_curves();

/// As ns_per_task, the processor's time, as the peer's is: on a machine that others use, too, the clock on the wall
/// says little.
template <class Body>
void time_tasks(benchmark::State& state, int count, const Body& body) {
  const std::clock_t begin = std::clock();
  for (auto _ : state) body();
  const double taken = 1e9 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  state.counters["ns_per_task"] = taken / (static_cast<double>(count) * static_cast<double>(state.iterations()));
}

/// Milliseconds of the processor that a body takes.
template <class Body>
[[nodiscard]] double processor_ms(const Body& body) {
  const std::clock_t begin = std::clock();
  body();
  return 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

}  // namespace linkwright::bench
