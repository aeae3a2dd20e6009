// Paths that pass near published points: error and time, by effort.

#include <benchmark/benchmark.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "linkwright/approximate/curve_fit.hpp"

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

const bool registered = [] {
  for (const char* const target : {"mkh2", "mkh3", "yu1", "yu2", "tri24", "gait13", "wu3_open"})
    for (const FitEffort effort : {FitEffort::quick, FitEffort::standard})
      benchmark::RegisterBenchmark(("fit/" + std::string(target) + "/" + std::string(name(effort))).c_str(),
                                   [=](benchmark::State& state) { fit(state, target, effort); })
          ->Unit(benchmark::kMillisecond);
  return true;
}();

}  // namespace
}  // namespace linkwright::bench::fit_bench
