#include "linkwright/approximate/timed_fit.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "approximate/coupler_linkage.hpp"
#include "approximate/fit_listing.hpp"
#include "approximate/fit_result.hpp"
#include "approximate/timed_search.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/parallel.hpp"
#include "linkwright/core/precondition.hpp"

namespace linkwright {
namespace {

void require_timing(const CurveTarget& target, const CurveTiming& timing) {
  require(timing.input.size() == target.points.size(), "an angle of the input belongs to each point");
  const double sense = timing.input[1] > timing.input[0] ? 1 : -1;
  for (std::size_t j = 1; j < timing.input.size(); ++j)
    require(sense * (timing.input[j] - timing.input[j - 1]) > 0, "angles of the input go one way");
  require(std::abs(timing.input.back() - timing.input.front()) < two_pi, "angles of the input are within a turn");
}

FirstRealisation choice_of(const CurveTiming& timing) {
  return timing.absolute ? FirstRealisation::timed_alone : FirstRealisation::best_timed;
}

CouplerLinkage in_scaled_frame(const CouplerLinkage& l, const ScaledTarget& target) {
  const double unit = 1 / target.radius;
  return {target.scaled(l.a0), target.scaled(l.b0), unit * l.a, unit * l.h, unit * l.b, unit * l.p};
}

// All but the datum is held.
TimedStart best_datum(const TimedTask& task, TimedStart start, bool absolute) {
  constexpr int datums = 72, iterations = 60;
  constexpr unsigned hold_linkage = TimedStart::hold_datum - 1;
  start.held = hold_linkage;
  TimedStart best = start;
  double least = std::numeric_limits<double>::infinity();
  const auto offer = [&](TimedStart& trial) {
    if (!place_states(task, trial)) return;
    evaluate(task, trial);
    if (!(trial.cost() < least)) return;
    least = trial.cost();
    best = trial;
  };
  if (absolute) {
    offer(start);
    return best;
  }
  for (const bool reversed : {false, true}) {
    for (int k = 0; k < datums; ++k) {
      start.reversed = reversed;
      start.datum = direction(two_pi * k / datums);
      offer(start);
    }
  }
  if (!best.states.empty()) improve(task, best, iterations);
  return best;
}

}  // namespace

CurveFits fit_timed_curve(const CurveTarget& target, const CurveTiming& timing, const CurveFitOptions& options,
                          const Progress& progress) {
  require_curve_target(target);
  require_timing(target, timing);
  const ScaledTarget scaled = scaled_target(target);
  TimedSearch search = search_timed(scaled, timing, scaled_limits(options, scaled), options, progress);
  const std::size_t found_count = search.minima.size();
  std::move(search.given.begin(), search.given.end(), std::back_inserter(search.minima));
  std::vector<FoundCurve> all(search.minima.size());
  parallel_for(all.size(), options.threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const TimedStart& start = search.minima[k];
      all[k] = {curve_fit_of(in_user_frame(start.linkage, scaled), start.states, target, options, choice_of(timing)),
                start.linkage, k >= found_count};
    }
  });
  CurveFits found = sorted_out(std::move(all), target, options);
  found.counts = {search.shapes, search.starts, found_count};
  found.cancelled = search.cancelled;
  return found;
}

std::optional<CurveFit> compare_with_timed_curve(const TracingFourBar& linkage, const CurveTarget& target,
                                                 const CurveTiming& timing, const CurveFitOptions& options) {
  require_curve_target(target);
  require_timing(target, timing);
  if (!can_move(linkage)) return std::nullopt;
  const CouplerLinkage as_it_lies = coupler_linkage(linkage);
  const LoopState state = loop_state(linkage);
  const ScaledTarget scaled = scaled_target(target);
  std::vector<Point> turns;
  for (const double input : timing.input) turns.push_back(direction(input));
  const TimedTask task{{scaled.points, scaled.weights, {}}, turns};
  TimedStart start;
  start.linkage = in_scaled_frame(as_it_lies, scaled);
  start.branch = cross(state.u, LoopGradient(as_it_lies, state).g) > 0 ? 1 : -1;
  const TimedStart best = best_datum(task, std::move(start), timing.absolute);
  if (best.states.empty()) return std::nullopt;
  return curve_fit_of(as_it_lies, best.states, target, options, FirstRealisation::timed_alone);
}

}  // namespace linkwright
