#include "four_bar_answer.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <span>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/count_text.hpp"
#include "linkwright/core/tolerance.hpp"
#include "linkwright/planar/chosen_length.hpp"
#include "linkwright/planar/function_family.hpp"
#include "pair_answer.hpp"
#include "picked_place.hpp"
#include "reason.hpp"
#include "region_count.hpp"
#include "warnings.hpp"

namespace linkwright {
namespace {

std::vector<Dyad> curve_samples(const TaskFamily& given, const SynthesisOptions& options) {
  std::vector<Dyad> dyads;
  if (!given.curve) return dyads;
  for (const double tau : given.curve->samples(options.region_samples, options.spacing))
    dyads.push_back(given.frame().to_user(given.curve->dyad(tau)));
  return dyads;
}

Error cancelled() { return {"cancelled", "", "stopped before the answer was complete"}; }

// What is found of a family of four-bars; false where it was cancelled.
template <class KindAnswer>
bool find_four_bars(KindAnswer& answer, const Progress& progress, const TaskWords& words) {
  const TaskFamily& given = answer.given;
  answer.samples = curve_samples(given, answer.options);
  if (!given.family) {
    answer.status = given.has_no_dyads ? SolutionStatus::no_solution : SolutionStatus::degenerate;
    answer.reason = given.degeneracy.value_or(Notice{});
    return true;
  }
  // What a length was chosen for is to be seen again.
  const int inside = given.chose_length ? ChosenLength::samples : 0;
  const CountedRegion counted =
      count_region(answer, *given.family, {answer.options.region_samples, answer.options.window, inside}, progress);
  warn_of_map(answer);
  if (nothing_meets_requirements(answer)) answer.missed_boxes = missed_boxes(*given.family, answer.requirements);
  if (!answer.options.at) {
    BestLinkages best = best_linkages(*given.family, making_of(answer), answer, counted, progress);
    answer.linkages = std::move(best.linkages);
    answer.left_out = best.left_out;
    warn_of_more(answer, best.beyond);
  }
  if (!given.points.empty() && !given.curve) answer.pairs = all_pairs(answer);
  if (progress.is_cancelled()) return false;
  if (answer.options.at)
    list_what_is_there(answer, *given.family,
                       [&](MapPoint place, const auto& /*failed*/) { return linkage_at(answer, place); });
  else
    state_reason(answer, words, reason_facts(answer));
  progress(1);
  return true;
}

// An answer of the kind, before anything is searched for.
template <class KindAnswer, class KindTask>
KindAnswer begin_answer(const KindTask& task, TaskFamily given, const Requirements& requirements,
                        const SynthesisOptions& options) {
  KindAnswer answer;
  answer.task = task;
  answer.pattern = given.pattern;
  answer.condition = given.conditions.condition();
  answer.characteristic_length = given.frame().scale;
  answer.warnings = given.warnings;
  answer.requirements = with_defaults(requirements, given);
  answer.options = with_turning_length(options, answer.characteristic_length);
  answer.given = std::move(given);
  return answer;
}

// The way from one share of `progress`, which must outlive it, to another.
Progress part_of(const Progress& progress, double from, double to) {
  return {[&progress, from, to](double done) { progress(from + (to - from) * done); }, progress.cancelled};
}

}  // namespace

// Five positions that no usable four-bar passes: which of them to free, and what its error becomes.
Result<Answer> solve_of_kind(const MotionTask& task, const Requirements& requirements, const SynthesisOptions& options,
                             const Progress& progress) {
  const bool five = position_count(task.poses) == 5;
  const double here = five ? 0.5 : 1;
  auto answer = begin_answer<MotionAnswer>(
      task, task_family(task, requirements, options.objective, {{}, progress.cancelled}), requirements, options);
  if (!find_four_bars(answer, part_of(progress, 0, here), {})) return cancelled();
  if (five && !answer.given.curve && answer.linkages.empty() && options.best > 0 && !options.at) {
    answer.relaxed = drop_one_position(task, requirements, {.region = options.region}, part_of(progress, here, 1));
    if (progress.is_cancelled()) return cancelled();
  }
  if (five) progress(1);
  return Answer(std::move(answer));
}

// The input is the task's, and so are the ground pivots: what is left to measure is the function.
Result<Answer> solve_of_kind(const FunctionTask& task, const Requirements& requirements,
                             const SynthesisOptions& options, const Progress& progress) {
  auto answer = begin_answer<FunctionAnswer>(task, task_family(task), requirements, options);
  if (!find_four_bars(answer, progress, function_words)) return cancelled();
  const auto& family = answer.given.functions;
  if (!family) return Answer(std::move(answer));
  if (!find_generators(answer, *family, progress)) return cancelled();
  return Answer(std::move(answer));
}

}  // namespace linkwright
