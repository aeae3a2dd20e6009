// Paths that pass near published points, motions past published poses, and maps of pivots: error and time, by effort.

#include <benchmark/benchmark.h>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "linkwright/approximate/curve_fit.hpp"
#include "linkwright/approximate/pivot_fits.hpp"
#include "linkwright/approximate/pose_fit.hpp"
#include "linkwright/approximate/timed_fit.hpp"
#include "linkwright/core/angle.hpp"
#include "support/curve_case.hpp"

namespace linkwright::bench::fit_bench {
namespace {

void add(const std::string& title, const std::function<void(benchmark::State&)>& run) {
  benchmark::RegisterBenchmark(title.c_str(), run)->Unit(benchmark::kMillisecond);
}

CurveFitOptions one_thread(FitEffort effort = FitEffort::standard) {
  CurveFitOptions options;
  options.effort = effort;
  options.threads = 1;
  return options;
}

/// A row of the table: bench/fits.py reads the published figures from the target's file.
struct Row {
  const char* name;
  const char* target;
  bool timed = false;     ///< the input turns by equal steps all the way round
  double max_length = 0;  ///< user's unit; 0: the default
};
constexpr Row rows[] = {{"kk18t", "kk18t", true},
                        {"kk18", "kk18t"},
                        {"mkh2", "mkh2"},
                        {"mkh3", "mkh3"},
                        {"yu1", "yu1"},
                        {"yu2", "yu2"},
                        {"tri24", "tri24"},
                        {"mcgarva", "mcgarva"},
                        {"ullah", "ullah"},
                        {"gait13", "gait13"},
                        {"ell10_60", "ell10", false, 60},
                        {"ell10_80", "ell10", false, 80},
                        {"wu3_open", "wu3_open"},
                        {"slice11", "slice11"},
                        {"diag10", "diag10"}};

CurveFits fit(const Row& row, const CurveTarget& target, const CurveFitOptions& options) {
  if (!row.timed) return fit_curve(target, options);
  CurveTiming timing;
  const auto count = static_cast<double>(target.points.size());
  for (std::size_t k = 0; k < target.points.size(); ++k)
    timing.input.push_back(two_pi * static_cast<double>(k) / count);
  return fit_timed_curve(target, timing, options);
}

void fit_row(benchmark::State& state, const Row& row, FitEffort effort) {
  const CurveTarget target = testing::curve_case(row.target).target;
  CurveFitOptions options = one_thread(effort);
  if (row.max_length > 0) options.max_length = row.max_length / target.diagonal();
  double error = 0;
  for (auto _ : state) error = fit(row, target, options).fits.at(0).error.sum_of_squares;
  state.counters["sum_of_squares"] = error;
}

// The example, with what it requires.
void fit_knife(benchmark::State& state, FitEffort effort) {
  constexpr bool throws = true, has_comments = true;
  std::ifstream file(LINKWRIGHT_EXAMPLES_DIR "/flying_knife.json");
  const auto json = nlohmann::json::parse(file, nullptr, throws, has_comments);
  CurveTarget target;
  target.closed = true;
  CurveTiming timing;
  for (const auto& point : json.at("task").at("points")) {
    target.points.emplace_back(point.at("x"), point.at("y"));
    timing.input.push_back(radians(point.at("input_deg").get<double>()));
  }
  const auto& limits = json.at("requirements");
  CurveFitOptions options = one_thread(effort);
  options.max_length = limits.at("max_length").get<double>() / target.diagonal();
  options.min_transmission_angle = radians(limits.at("min_transmission_angle_deg").get<double>());
  const auto& x = limits.at("ground_pivots_within").at("x");
  const auto& y = limits.at("ground_pivots_within").at("y");
  options.windows.ground = Box{x.at(0), x.at(1), y.at(0), y.at(1)};
  double error = 0;
  for (auto _ : state) error = fit_timed_curve(target, timing, options).fits.at(0).error.sum_of_squares;
  state.counters["sum_of_squares"] = error;
}

void fit_all_poses(benchmark::State& state, const std::string& name, FitEffort effort) {
  const PoseTarget target = testing::pose_case(name);
  PoseFitOptions options;
  options.effort = effort;
  options.max_link_ratio = 20;
  options.threads = 1;
  double error = 0;
  for (auto _ : state) error = fit_poses(target, options).fits.at(0).error.rms;
  state.counters["rms"] = error;
}

// A map of places of the input's pivot: a lattice, and then place by place.
std::vector<Point> places_around(const CurveTarget& target, int count) {
  std::vector<Point> places;
  for (int i = 0; i < count; ++i)
    for (int k = 0; k < count; ++k)
      places.push_back(target.points.front() +
                       3 * target.diagonal() * Point{(i + 0.5) / count - 0.5, (k + 0.5) / count - 0.5});
  return places;
}

void lay_lattice(benchmark::State& state, const CurveTarget& target) {
  const std::vector<Point> lattice = places_around(target, 24);
  for (auto _ : state) benchmark::DoNotOptimize(PivotFits(target, one_thread(), lattice, {}));
}

void fit_at_pivot(benchmark::State& state, const CurveTarget& target) {
  const PivotFits fits(target, one_thread(), places_around(target, 24), {});
  const std::vector<Point> places = places_around(target, 10);
  for (auto _ : state)
    for (const Point place : places) benchmark::DoNotOptimize(fits.at(place));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(places.size()));
}

void fit_from_pivot(benchmark::State& state, const CurveTarget& target, bool both) {
  CurveFitOptions options = one_thread();
  const FourBar bars = fit_curve(target, options).fits.at(0).linkage().bars;
  options.input_pivot = bars.input_fixed;
  if (both) options.output_pivot = bars.output_fixed;
  double error = 0;
  for (auto _ : state) error = fit_curve(target, options).fits.at(0).error.sum_of_squares;
  state.counters["sum_of_squares"] = error;
}

void register_pivots(const std::string& name) {
  const CurveTarget target = testing::curve_case(name).target;
  const std::string title = "fit_pivots/" + name + "/";
  add(title + "lattice", [=](benchmark::State& state) { lay_lattice(state, target); });
  add(title + "100_places", [=](benchmark::State& state) { fit_at_pivot(state, target); });
  add(title + "given_pivot", [=](benchmark::State& state) { fit_from_pivot(state, target, false); });
  add(title + "given_pivots", [=](benchmark::State& state) { fit_from_pivot(state, target, true); });
}

const bool registered = [] {
  for (const FitEffort effort : {FitEffort::quick, FitEffort::standard, FitEffort::deep}) {
    const std::string of_effort = "/" + std::string(name(effort));
    for (const char* const target : {"poses_hsieh1", "poses_tailgate8"})
      add("fit_poses/" + std::string(target) + of_effort,
          [=](benchmark::State& state) { fit_all_poses(state, target, effort); });
    if (effort == FitEffort::deep) continue;
    add("fit/flying_knife" + of_effort, [=](benchmark::State& state) { fit_knife(state, effort); });
    for (const Row& row : rows)
      add("fit/" + std::string(row.name) + of_effort, [=](benchmark::State& state) { fit_row(state, row, effort); });
  }
  for (const char* const target : {"mkh2", "yu1"}) register_pivots(target);
  return true;
}();

}  // namespace
}  // namespace linkwright::bench::fit_bench
