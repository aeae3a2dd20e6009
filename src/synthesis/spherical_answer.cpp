#include "spherical_answer.hpp"

#include <algorithm>

#include "linkwright/spherical/spherical_function_family.hpp"
#include "linkwright/spherical/spherical_task_family.hpp"
#include "pair_answer.hpp"
#include "picked_place.hpp"
#include "reason.hpp"
#include "region_count.hpp"
#include "warnings.hpp"

namespace linkwright {
namespace {

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
  if (!given.points.empty()) answer.pairs = all_pairs(answer);
  if (answer.options.at) {
    list_what_is_there(answer, *given.family,
                       [&](MapPoint place, const auto& /*failed*/) { return linkage_at(answer, place); });
  } else {
    auto best = best_linkages(*given.family, making_of(answer), answer, counted, progress);
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
  if (!find_generators(answer, *family, progress)) return stopped();
  return Answer(std::move(answer));
}

}  // namespace linkwright
