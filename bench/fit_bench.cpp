// Paths that pass near published points, and motions past near poses: error and time, by effort.

#include <benchmark/benchmark.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "linkwright/approximate/curve_fit.hpp"
#include "linkwright/approximate/pivot_fits.hpp"
#include "linkwright/approximate/pose_fit.hpp"
#include "linkwright/core/angle.hpp"

namespace linkwright::bench::fit_bench {
namespace {

CurveTarget target_named(const std::string& name) {
  const auto json = nlohmann::json::parse(std::ifstream(LINKWRIGHT_DATA_DIR "/approximate/" + name + ".json"));
  CurveTarget target;
  for (const auto& point : json.at("points"))
    target.points.emplace_back(point[0].get<double>(), point[1].get<double>());
  target.closed = json.at("closed");
  return target;
}

void fit(benchmark::State& state, const std::string& name, FitEffort effort) {
  const CurveTarget target = target_named(name);
  CurveFitOptions options;
  options.effort = effort;
  options.threads = 1;
  double error = 0;
  for (auto _ : state) error = fit_curve(target, options).fits.front().error.sum_of_squares;
  state.counters["sum_of_squares"] = error;
}

PoseTarget poses_named(const std::string& name) {
  const auto json = nlohmann::json::parse(std::ifstream(LINKWRIGHT_DATA_DIR "/approximate/" + name + ".json"));
  PoseTarget target;
  target.turning_length = json.at("turning_length");
  target.exact = json.at("exact").get<std::vector<std::size_t>>();
  for (const auto& pose : json.at("poses"))
    target.poses.push_back({{pose[0].get<double>(), pose[1].get<double>()}, radians(pose[2].get<double>())});
  return target;
}

void fit_all_poses(benchmark::State& state, const std::string& name, FitEffort effort) {
  const PoseTarget target = poses_named(name);
  PoseFitOptions options;
  options.effort = effort;
  options.max_link_ratio = 20;
  options.threads = 1;
  double error = 0;
  for (auto _ : state) error = fit_poses(target, options).fits.front().error.rms;
  state.counters["rms"] = error;
}

const bool poses_registered = [] {
  for (const char* const target : {"poses_hsieh1", "poses_tailgate8"})
    for (const FitEffort effort : {FitEffort::quick, FitEffort::standard, FitEffort::deep})
      benchmark::RegisterBenchmark(("fit/" + std::string(target) + "/" + std::string(name(effort))).c_str(),
                                   [=](benchmark::State& state) { fit_all_poses(state, target, effort); })
          ->Unit(benchmark::kMillisecond);
  return true;
}();

// A map of places of the input's pivot: a lattice, and then place by place.
std::vector<Point> places_around(const CurveTarget& target, int count) {
  std::vector<Point> places;
  for (int i = 0; i < count; ++i)
    for (int k = 0; k < count; ++k)
      places.push_back(target.points.front() +
                       3 * target.diagonal() * Point{(i + 0.5) / count - 0.5, (k + 0.5) / count - 0.5});
  return places;
}

CurveFitOptions one_thread() {
  CurveFitOptions options;
  options.threads = 1;
  return options;
}

void lay_lattice(benchmark::State& state, const std::string& name) {
  const CurveTarget target = target_named(name);
  const std::vector<Point> lattice = places_around(target, 24);
  for (auto _ : state) benchmark::DoNotOptimize(PivotFits(target, one_thread(), lattice, {}));
}

void fit_at_pivot(benchmark::State& state, const std::string& name) {
  const CurveTarget target = target_named(name);
  const PivotFits fits(target, one_thread(), places_around(target, 24), {});
  const std::vector<Point> places = places_around(target, 10);
  for (auto _ : state)
    for (const Point place : places) benchmark::DoNotOptimize(fits.at(place));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(places.size()));
}

void fit_from_pivot(benchmark::State& state, const std::string& name, bool both) {
  const CurveTarget target = target_named(name);
  CurveFitOptions options = one_thread();
  const FourBar bars = fit_curve(target, options).fits.front().linkage().bars;
  options.input_pivot = bars.input_fixed;
  if (both) options.output_pivot = bars.output_fixed;
  double error = 0;
  for (auto _ : state) error = fit_curve(target, options).fits.front().error.sum_of_squares;
  state.counters["sum_of_squares"] = error;
}

const bool registered = [] {
  for (const char* const target : {"mkh2", "yu1"}) {
    const auto add = [&](const char* what, const auto& run) {
      benchmark::RegisterBenchmark(("fit/" + std::string(what) + "/" + target).c_str(), run)
          ->Unit(benchmark::kMillisecond);
    };
    add("lattice_of_pivots", [=](benchmark::State& state) { lay_lattice(state, target); });
    add("100_pivots", [=](benchmark::State& state) { fit_at_pivot(state, target); });
    add("given_pivot", [=](benchmark::State& state) { fit_from_pivot(state, target, false); });
    add("given_pivots", [=](benchmark::State& state) { fit_from_pivot(state, target, true); });
  }
  for (const char* const target : {"mkh2", "mkh3", "yu1", "yu2", "tri24", "gait13", "wu3_open"})
    for (const FitEffort effort : {FitEffort::quick, FitEffort::standard})
      benchmark::RegisterBenchmark(("fit/" + std::string(target) + "/" + std::string(name(effort))).c_str(),
                                   [=](benchmark::State& state) { fit(state, target, effort); })
          ->Unit(benchmark::kMillisecond);
  return true;
}();

}  // namespace
}  // namespace linkwright::bench::fit_bench
