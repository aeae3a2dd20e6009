#include "spherical_answer.hpp"

#include <algorithm>

#include "function_answer.hpp"
#include "linkwright/spherical/spherical_function_family.hpp"
#include "linkwright/spherical/spherical_function_search.hpp"
#include "linkwright/spherical/spherical_task_family.hpp"
#include "picked_place.hpp"
#include "reason.hpp"
#include "region_count.hpp"
#include "searched_spherical.hpp"
#include "warnings.hpp"

namespace linkwright {
namespace {

// Of a few dyads: every pair as a four-bar, the better driver first named, best first.
std::vector<SphericalSolution> pairs_of_points(const SphericalAnswer& answer) {
  const SearchedSphericalFourBars search(answer);
  const std::vector<double> places = answer.given.family->samples(Side::input, 0, Spacing::coordinate);
  std::vector<SphericalSolution> pairs;
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t j = i + 1; j < places.size(); ++j) {
      auto one = search.make({places[i], places[j]}), other = search.make({places[j], places[i]});
      if (one && other) pairs.push_back(is_better_linkage(*other, *one) ? *other : *one);
    }
  std::sort(pairs.begin(), pairs.end(), is_better_linkage<SphericalSolution>);
  return pairs;
}

ReasonFacts reason_facts(const SphericalAnswer& answer) {
  return {answer.given.has_directions, "No pair of dyads makes a four-bar: in every pair a link has no length.", "",
          is_complete(*answer.given.family)};
}

// What is found of a family; false where it was cancelled.
template <class KindAnswer>
bool find_spherical(KindAnswer& answer, const TaskWords& words, const Progress& progress) {
  const SphericalTaskFamily& given = answer.given;
  if (given.curve)
    for (const double at : given.curve->samples(answer.options.region_samples, answer.options.spacing))
      answer.samples.push_back(given.curve->dyad(at));
  if (!given.family) {
    answer.status = given.has_no_dyads ? SolutionStatus::no_solution : SolutionStatus::degenerate;
    answer.reason = given.degeneracy.value_or(Notice{});
    return true;
  }
  const CountedRegion counted =
      count_region(answer, *given.family, {answer.options.region_samples, answer.options.window}, progress);
  if (!given.points.empty()) answer.pairs = pairs_of_points(answer);
  const SearchedSphericalFourBars search(answer);
  if (answer.options.at) {
    list_what_is_there(answer, *given.family,
                       [&](MapPoint place, const auto& /*failed*/) { return search.make(place); });
  } else {
    auto best = best_linkages(search, answer, counted.maps(answer.region), progress);
    answer.linkages = std::move(best.linkages);
    answer.left_out = best.left_out;
    warn_of_more(answer, best.beyond);
    state_reason(answer, words, reason_facts(answer));
  }
  progress(1);
  return !progress.is_cancelled();
}

Error stopped() { return {"cancelled", "", "stopped before the answer was complete"}; }

template <class KindAnswer, class KindTask>
KindAnswer begin_spherical(const KindTask& task, const Requirements& requirements, const SynthesisOptions& options) {
  KindAnswer answer;
  answer.task = task;
  answer.given = task_family(task);
  answer.pattern = answer.given.pattern;
  answer.condition = answer.given.conditions.condition();
  answer.warnings = answer.given.warnings;
  answer.requirements = with_default_angles(requirements);
  answer.options = options;
  return answer;
}

}  // namespace

Result<Answer> solve_of_kind(const SphericalMotionTask& task, const Requirements& requirements,
                             const SynthesisOptions& options, const Progress& progress) {
  auto answer = begin_spherical<SphericalMotionAnswer>(task, requirements, options);
  if (!find_spherical(answer, spherical_words, progress)) return stopped();
  const bool five = position_count(task.orientations) == 5 && !answer.given.curve;
  if (five && answer.linkages.empty() && options.best > 0 && !options.at) {
    answer.relaxed = drop_one_orientation(task, requirements, options.region, progress);
    if (progress.is_cancelled()) return stopped();
  }
  return Answer(std::move(answer));
}

Result<Answer> solve_of_kind(const SphericalFunctionTask& task, const Requirements& requirements,
                             const SynthesisOptions& options, const Progress& progress) {
  auto answer = begin_spherical<SphericalFunctionAnswer>(task, requirements, options);
  if (!find_spherical(answer, spherical_function_words, progress)) return stopped();
  const auto& family = answer.given.functions;
  if (!family) return Answer(std::move(answer));
  const SearchedSphericalFourBars search(answer);
  if (!find_generators(
          answer, *family, [&](MapPoint place) { return search.make(place); }, progress))
    return stopped();
  return Answer(std::move(answer));
}

}  // namespace linkwright
