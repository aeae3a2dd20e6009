// Paths whose linkage is known: four-bars of a gallery, and random ones. How many of them are found again, how nearly,
// and in what time.

#include <algorithm>
#include <benchmark/benchmark.h>
#include <nlohmann/json.hpp>
#include <string>

#include "bench_task.hpp"
#include "linkwright/approximate/curve_fit.hpp"
#include "linkwright/mechanism/linkage_type.hpp"
#include "support/curve_case.hpp"
#include "support/curve_gallery.hpp"
#include "support/random_four_bar.hpp"

namespace linkwright::bench::fit_draws_bench {
namespace {

// Of random numbers that nothing was tuned by: stays as it is, whatever comes out.
constexpr std::uint64_t fresh = 20'261'129;
constexpr std::size_t drawn = 100;
constexpr int points_of_each = 48;

struct DrawnCurve {
  CurveTarget target;
  LinkageType type;
};

std::vector<DrawnCurve> drawn_curves(bool closed) {
  testing::RandomFourBars draw(fresh + (closed ? 0 : 1));
  std::vector<DrawnCurve> curves;
  while (curves.size() < drawn) {
    // A closed path is that of an input that turns fully; a part of a path, of any linkage.
    const TracingFourBar linkage =
        closed ? testing::drawn_linkage(draw, {LinkageType::crank_rocker, LinkageType::double_crank})
               : testing::drawn_linkage(draw);
    const double sweep = draw.uniform(1, 3);
    CurveTarget target = testing::traced_target(linkage, closed, points_of_each, sweep);
    constexpr double least_size = 0.05;  // of the linkage: an input at a dead point does not move at all
    if (target.diagonal() > least_size * linkage.longest())
      curves.push_back({std::move(target), linkage_type(linkage.bars.lengths())});
  }
  return curves;
}

struct Outcome {
  double error = 1;  ///< root mean square over the diagonal; nothing was found: 1
  double ms = 0;
};

Outcome outcome_of(const CurveTarget& target, FitEffort effort) {
  CurveFitOptions options;
  options.effort = effort;
  options.threads = 1;
  CurveFits found;
  const double ms = processor_ms([&] { found = fit_curve(target, options); });
  return {found.fits.empty() ? 1 : found.fits.front().error.rms_over_diagonal, ms};
}

void count(benchmark::State& state, std::vector<double> errors) {
  std::sort(errors.begin(), errors.end());
  state.counters["count"] = static_cast<double>(errors.size());
  for (const auto& [name, bound] : {std::pair("below_1e-9", 1e-9), {"below_1e-7", 1e-7}, {"below_1e-5", 1e-5}})
    state.counters[name] = static_cast<double>(std::lower_bound(errors.begin(), errors.end(), bound) - errors.begin());
  state.counters["median"] = errors[errors.size() / 2];
  state.counters["worst"] = errors.back();
}

void fit_drawn(benchmark::State& state, bool closed, FitEffort effort) {
  std::vector<double> errors;
  double sum = 0, worst = 0, cranks = 0, cranks_found = 0;
  for (auto _ : state)
    for (const DrawnCurve& curve : drawn_curves(closed)) {
      const Outcome outcome = outcome_of(curve.target, effort);
      errors.push_back(outcome.error);
      sum += outcome.ms;
      worst = std::max(worst, outcome.ms);
      if (curve.type != LinkageType::crank_rocker) continue;
      cranks += 1;
      if (outcome.error < 1e-9) cranks_found += 1;
    }
  state.counters["mean_ms"] = sum / static_cast<double>(errors.size());
  state.counters["worst_ms"] = worst;
  state.counters["crank_rockers"] = cranks;
  state.counters["crank_rockers_below_1e-9"] = cranks_found;
  count(state, std::move(errors));
}

void fit_of_gallery(benchmark::State& state, std::size_t index, FitEffort effort) {
  const CurveTarget target = testing::curve_gallery()[index].target;
  Outcome outcome;
  for (auto _ : state) outcome = outcome_of(target, effort);
  state.counters["rms_over_diagonal"] = outcome.error;
}

const bool registered = [] {
  const auto add = [](const std::string& title, const auto& run) {
    return benchmark::RegisterBenchmark(title.c_str(), run)->Unit(benchmark::kMillisecond)->Iterations(1);
  };
  const auto gallery = testing::curve_gallery();
  for (const FitEffort effort : {FitEffort::quick, FitEffort::standard, FitEffort::deep}) {
    const std::string of_effort = "/" + std::string(name(effort));
    for (std::size_t k = 0; k < gallery.size(); ++k)
      add("fit_gallery/" + gallery[k].id + of_effort,
          [=](benchmark::State& state) { fit_of_gallery(state, k, effort); });
    for (const bool closed : {true, false})
      add(std::string("fit_drawn/") + (closed ? "closed" : "parts") + of_effort,
          [=](benchmark::State& state) { fit_drawn(state, closed, effort); });
  }
  return true;
}();

}  // namespace
}  // namespace linkwright::bench::fit_draws_bench

namespace linkwright::bench {

std::string dump_curves() {
  auto curves = nlohmann::json::array();
  for (const auto& curve : fit_draws_bench::drawn_curves(true)) {
    auto points = nlohmann::json::array();
    for (const Point p : curve.target.points) points.push_back({p.real(), p.imag()});
    curves.push_back({{"type", name(curve.type)}, {"points", std::move(points)}});
  }
  return curves.dump();
}

}  // namespace linkwright::bench
