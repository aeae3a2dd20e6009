#include <algorithm>
#include <cmath>
#include <utility>

#include "planar/candidate.hpp"

namespace linkwright {

double change_point_margin(const FourBar& bars) {
  const GrashofExcesses t = grashof_excesses(bars.lengths());
  return std::min({std::abs(t.t1), std::abs(t.t2), std::abs(t.t3)}) / bars.lengths().perimeter();
}

Hill OrderedAxes::hill(std::function<std::optional<double>(double, double)> score_at, MapPoint around) const {
  AxisStretch first = family_.axis(Side::input).stretch_around(around.input),
              second = family_.axis(Side::output).stretch_around(around.output);
  if (swapped_) std::swap(first, second);
  return {std::move(score_at), first, second};
}

Candidate climbed(const CellEvaluator& evaluator, const Candidate& start, const Ascent& ascent,
                  const Progress& progress) {
  const double least_margin = std::min(buildable_margin, change_point_margin(start.bars));
  DyadPair known = start.links;
  const auto allowed = [&](MapPoint place) -> std::optional<Candidate> {
    const auto found = evaluator.candidate(place, known);
    if (found) known = found->links;
    if (!found || found->report.type != start.report.type) return std::nullopt;
    if (change_point_margin(found->bars) < least_margin) return std::nullopt;
    return found;
  };
  const FourBarFamily& family = evaluator.family();
  const OrderedAxes axes(family);
  const auto score_at = [&](double first, double second) -> std::optional<double> {
    const auto found = allowed(axes.place({first, second}));
    return found ? ascent.score(*found) : std::nullopt;
  };
  const auto score = ascent.score(start);
  if (!score) return start;
  const auto step = [&](Side side) { return family.axis(side).is_discrete() ? 0.0 : ascent.first_step; };
  constexpr int turns = HillClimbOptions{}.max_evaluations;
  const HillTop top =
      climb_hill(axes.hill(score_at, start.place), axes.coordinates(start.place), *score,
                 {axes.both(step(Side::input), step(Side::output)), ascent.resolution, turns, ascent.across}, progress);
  Candidate best = allowed(axes.place(top.place)).value_or(start);
  best.local_optimum = top.end == SearchEnd::settled;
  return best;
}

}  // namespace linkwright
