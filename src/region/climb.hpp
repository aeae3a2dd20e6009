#pragma once

#include <algorithm>
#include <concepts>
#include <functional>
#include <optional>
#include <type_traits>

#include "linkwright/analysis/linkage_type.hpp"
#include "linkwright/core/progress.hpp"
#include "region/ordered_axes.hpp"

namespace linkwright {

/// Judges any place of a map by the same rules as its cells; a class of linkages brings its own. A Candidate is a
/// linkage that meets the requirements: its place, its score (larger is better), its type, and whether it is the top of
/// its hill.
template <class Evaluator>
concept CandidateEvaluator = requires(const Evaluator& evaluator, typename Evaluator::Candidate candidate,
                                      MapPoint place) {
  { evaluator.family() } -> std::convertible_to<const LinkageFamily&>;
  /// Nothing where the linkage there does not meet the requirements, or none is there.
  { evaluator.candidate(place) } -> std::same_as<std::optional<typename Evaluator::Candidate>>;
  /// The same, where one near is known: what both have in common need not be computed again.
  { evaluator.candidate(place, candidate) } -> std::same_as<std::optional<typename Evaluator::Candidate>>;
  /// How far from another type, as a share of the linkage's size.
  { evaluator.change_point_margin(candidate) } -> std::convertible_to<double>;
  { candidate.place } -> std::convertible_to<MapPoint>;
  { candidate.score } -> std::convertible_to<double>;
  { candidate.type() } -> std::same_as<LinkageType>;
  { candidate.local_optimum } -> std::convertible_to<bool>;
};

/// A search stops where the type would depend on this share of the linkage's size: near a change point the numbers look
/// best and a workshop's tolerances decide what the linkage does.
inline constexpr double buildable_margin = 1e-3;

/// What a climb goes by.
template <class Candidate>
struct Ascent {
  MapPoint first_step;                                ///< in the coordinates
  double resolution = HillClimbOptions{}.resolution;  ///< shares of the first step
  /// Larger is better; nothing where a candidate is not allowed.
  std::function<std::optional<double>(const Candidate&)> score = [](const Candidate& c) { return c.score; };
  double across = HillClimbOptions{}.across;
};

/// Climbs from a linkage to the top of its hill (climb_hill), keeping branch, type and requirements.
template <CandidateEvaluator Evaluator, class Candidate = typename Evaluator::Candidate>
[[nodiscard]] Candidate climbed(const Evaluator& evaluator, const Candidate& start,
                                const std::type_identity_t<Ascent<Candidate>>& ascent, const Progress& progress = {}) {
  const double least_margin = std::min(buildable_margin, evaluator.change_point_margin(start));
  Candidate known = start;
  const auto allowed = [&](MapPoint place) -> std::optional<Candidate> {
    const auto found = evaluator.candidate(place, known);
    if (found) known = *found;
    if (!found || found->type() != start.type()) return std::nullopt;
    if (evaluator.change_point_margin(*found) < least_margin) return std::nullopt;
    return found;
  };
  const LinkageFamily& family = evaluator.family();
  const OrderedAxes axes(family);
  const auto score_at = [&](double first, double second) -> std::optional<double> {
    const auto found = allowed(axes.place({first, second}));
    return found ? ascent.score(*found) : std::nullopt;
  };
  const auto score = ascent.score(start);
  if (!score) return start;
  const auto step = [&](Side side) {
    if (family.axis(side).is_discrete()) return 0.0;
    return side == Side::input ? ascent.first_step.input : ascent.first_step.output;
  };
  constexpr int turns = HillClimbOptions{}.max_evaluations;
  const HillTop top =
      climb_hill(axes.hill(score_at, start.place), axes.coordinates(start.place), *score,
                 {axes.both(step(Side::input), step(Side::output)), ascent.resolution, turns, ascent.across}, progress);
  Candidate best = allowed(axes.place(top.place)).value_or(start);
  best.local_optimum = top.end == SearchEnd::settled;
  return best;
}

/// Of the same bars driven from either side the better: no defects, score, transmission angle, smaller coordinate.
template <class Candidate>
[[nodiscard]] Candidate better_driver(const Candidate& here, const Candidate& there) {
  if (here.report.defects.none() != there.report.defects.none()) return here.report.defects.none() ? here : there;
  if (here.score != there.score) return here.score > there.score ? here : there;
  const double angle = here.report.min_transmission_angle, other = there.report.min_transmission_angle;
  if (angle != other) return angle > other ? here : there;
  return here.place.input < there.place.input ? here : there;
}

/// The top of the hill on which the linkage of a place stands, to the last digit that counts. Nothing where it does not
/// meet the requirements or is at the top already.
template <CandidateEvaluator Evaluator>
[[nodiscard]] std::optional<MapPoint> improved_place(const Evaluator& evaluator, MapPoint start) {
  constexpr double first_step_share = 1.0 / 400;  // a cell of the usual map
  constexpr double fine = 1e-8;  // the numbers are an answer: nothing finer is told apart at a level top
  const auto foot = evaluator.candidate(start);
  if (!foot) return std::nullopt;
  const double step = first_step_share * longest_axis(evaluator.family());
  const auto top = climbed(evaluator, *foot, {{step, step}, fine});
  return top.score > foot->score ? std::optional<MapPoint>(top.place) : std::nullopt;
}

}  // namespace linkwright
