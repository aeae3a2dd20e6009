#include "pair_answer.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <utility>
#include <vector>

#include "analyses/analyses.hpp"
#include "function/generator_search.hpp"
#include "linkage_search.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/count_text.hpp"
#include "linkwright/core/tolerance.hpp"
#include "linkwright/region/cell_judge.hpp"
#include "linkwright/spherical/spherical_task_family.hpp"
#include "picked_place.hpp"
#include "planar/chosen_length.hpp"
#include "planar/fitted_motion_family.hpp"
#include "planar/fitted_path_family.hpp"
#include "planar/function_family.hpp"
#include "planar/path_drive.hpp"
#include "planar/path_family.hpp"
#include "planar/pivot_search.hpp"
#include "reason.hpp"
#include "region_count.hpp"
#include "spherical/spherical_function_family.hpp"
#include "warnings.hpp"

namespace linkwright {
namespace {

// Refers to the answer.
template <class KindAnswer>
auto making_of(const KindAnswer& answer) {
  using Solution = typename decltype(answer.linkages)::value_type;
  return Making<Solution>{[&answer](MapPoint place) { return linkage_at(answer, place); },
                          [](const Cell& cell, const Solution& made) {
                            return cell.type == made.report.type && cell.defects == made.report.defects &&
                                   !is_unconfirmed(made);
                          }};
}

// No defects, then the larger least transmission angle, then the smaller coordinate.
template <class Solution>
bool is_better_linkage(const Solution& a, const Solution& b) {
  if (a.report.defects.none() != b.report.defects.none()) return a.report.defects.none();
  const double angle = a.report.min_transmission_angle, other = b.report.min_transmission_angle;
  return angle != other ? angle > other : a.input.coordinate < b.input.coordinate;
}

// Of a few dyads: every pair as a four-bar, the better driver first named, best first.
template <class KindAnswer>
auto all_pairs(const KindAnswer& answer) {
  const std::vector<double> places = answer.family()->samples(Side::input, 0, Spacing::coordinate);
  decltype(answer.linkages) pairs;
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t j = i + 1; j < places.size(); ++j) {
      auto one = linkage_at(answer, {places[i], places[j]}), other = linkage_at(answer, {places[j], places[i]});
      if (one && other) pairs.push_back(is_better_linkage(*other, *one) ? *other : *one);
    }
  std::sort(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) { return is_better_linkage(a, b); });
  return pairs;
}

// Every linkage, where there are a few.
std::vector<FourBarSolution> all_pairs(const PathAnswer& answer) {
  std::vector<FourBarSolution> all;
  for (const MapPoint place : answer.given.paths->few_places())
    if (auto found = linkage_at(answer, place)) all.push_back(*std::move(found));
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return is_better_linkage(a, b); });
  return all;
}

// What turning the crank shows of a path, which knows the pivots and the point alone.
void drive_path(FourBarSolution& found, const PathFamily& family, std::span<const PrescribedPose> crank_poses) {
  const bool is_clean = found.report.defects.none();
  if (!is_clean && !family.is_timed()) return;  // out of order its crank goes to and fro
  TimedPath& path = *found.path;
  const double near = tolerance::point_met * family.frame().scale;
  const PathDrive drive = drive_along_path(found.four_bar, path.point, crank_poses, near);
  path.position_error = drive.position_error;
  path.timing_error = drive.timing_error;
  found.verified_by_driving =
      found.verified_by_driving && drive.passes == is_clean && (!is_clean || drive.turns_fully == path.full_turn);
}

template <class Solution, class Family>
void measure_generated(Solution& found, const Family& family) {
  const MapPoint place{found.input.coordinate, found.output.coordinate};
  found.function = family.error_of(found.four_bar, place);
  found.residual_derivatives = family.rate_residual(place);
  if (found.report.defects.none())
    found.verified_by_driving = found.verified_by_driving && found.function->reaches_pairs &&
                                found.function->precision_error <= tolerance::pair_met;
}

// The linkages of least structural error.
template <class KindAnswer, class Family>
auto least_error_linkages(const Family& family, const KindAnswer& answer, const Progress& progress) {
  GeneratorSearchOptions search;
  search.max_count = answer.options.best;
  search.window = answer.options.window;
  search.threads = answer.options.region.threads;
  search.added = answer.added;
  if (answer.inside)
    for (const auto& known : answer.linkages) search.starts.push_back(answer.point_of(known));
  decltype(answer.linkages) found;
  for (const RankedGenerator& ranked : best_generators(family, answer.requirements, search, progress))
    if (auto made = linkage_at(answer, ranked.place)) {
      made->local_optimum = true;
      found.push_back(*std::move(made));
    }
  return found;
}

// Five precision points: the few linkages there are, whatever their defects, best first; otherwise none.
template <class KindAnswer>
auto all_generators(const KindAnswer& answer) {
  const LinkageFamily& family = *answer.family();
  decltype(answer.linkages) found;
  if (family.axis(Side::input).quantity != AxisQuantity::burmester_point) return found;
  const double only = family.samples(Side::output, 0, Spacing::coordinate).front();
  for (const double place : family.samples(Side::input, 0, Spacing::coordinate))
    if (auto made = linkage_at(answer, {place, only})) found.push_back(*std::move(made));
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return is_better_linkage(a, b); });
  return found;
}

// What a task of a function adds to the linkages found: those of least error where they are asked for, all of five
// precision points, and how well each generates. False where it was cancelled.
template <class KindAnswer, class Family>
bool find_generators(KindAnswer& answer, const Family& family, const Progress& progress) {
  if (answer.options.objective == Objective::structural_error && !answer.options.at)
    answer.linkages = least_error_linkages(family, answer, progress);
  if (progress.is_cancelled()) return false;
  answer.pairs = all_generators(answer);
  for (auto* list : {&answer.linkages, &answer.pairs})
    for (auto& found : *list) measure_function(found, family);
  return true;
}

std::vector<Dyad> curve_samples(const FourBarAnswer& answer) {
  const TaskFamily& given = answer.given;
  std::vector<Dyad> dyads;
  if (!given.curve) return dyads;
  for (const double tau : given.curve->samples(answer.options.region_samples, answer.options.spacing))
    dyads.push_back(given.frame().to_user(given.curve->dyad(tau)));
  return dyads;
}
std::vector<SphericalDyad> curve_samples(const SphericalAnswer& answer) {
  const auto& curve = answer.given.curve;
  std::vector<SphericalDyad> dyads;
  if (!curve) return dyads;
  for (const double at : curve->samples(answer.options.region_samples, answer.options.spacing))
    dyads.push_back(curve->dyad(at));
  return dyads;
}

// What a length was chosen for is to be seen again.
int samples_inside(const TaskFamily& given) { return given.chose_length ? ChosenLength::samples : 0; }
int samples_inside(const SphericalTaskFamily& /*given*/) { return 0; }

void look_at_map(FourBarAnswer& answer) {
  warn_of_map(answer);
  if (nothing_meets_requirements(answer)) answer.missed_boxes = missed_boxes(*answer.given.family, answer.requirements);
}
void look_at_map(SphericalAnswer& /*answer*/) {}

template <class KindAnswer>
bool leaves_few(const KindAnswer& answer) {
  return !answer.given.points.empty() && !answer.given.curve;
}
// Of the nearest paths each linkage listed has the others that trace its path.
bool leaves_few(const PathAnswer& answer) {
  return !answer.task.is_approximate() && !answer.given.paths->few_places().empty();
}

template <class KindAnswer>
void list_there(KindAnswer& answer) {
  list_what_is_there(answer, *answer.given.family,
                     [&](MapPoint place, const auto& /*failed*/) { return linkage_at(answer, place); });
}

// Where several stand at a place, all that meet the requirements after the one that the map shows.
void list_there(PathAnswer& answer) {
  list_there<PathAnswer>(answer);
  const PathFamily& family = *answer.given.paths;
  const MapPoint place = *answer.options.at;
  if (answer.linkages.empty() || place.input >= family.axis(Side::input).coordinate_length()) return;
  const CellJudge judge(answer.requirements, family.linkages(), family.measures());
  for (const Cell& cell : family.all_at(place, answer.requirements.respect_direction)) {
    const bool is_listed = cell.place.input == answer.linkages.front().input.coordinate;
    auto found = is_listed || !judge.passes(cell) ? std::nullopt : linkage_at(answer, cell.place);
    if (!found) continue;
    answer.linkages.push_back(*std::move(found));
    answer.fails.emplace_back();
  }
}

// What is found of a family of pairs; false where it was cancelled.
template <class KindAnswer>
bool find_pairs(KindAnswer& answer, const TaskWords& words, const Progress& progress) {
  const auto& given = answer.given;
  answer.samples = curve_samples(answer);
  if (!given.family) {
    answer.status = given.has_no_dyads ? SolutionStatus::no_solution : SolutionStatus::degenerate;
    answer.reason = given.degeneracy.value_or(Notice{});
    return true;
  }
  const LinkageFamily& family = *given.family;
  const CountedRegion counted = count_region(
      answer, family, {answer.options.region_samples, answer.options.window, samples_inside(given)}, progress);
  look_at_map(answer);
  if (leaves_few(answer)) answer.pairs = all_pairs(answer);
  if (answer.options.at) {
    list_there(answer);
  } else {
    auto best = best_linkages(family, making_of(answer), answer, counted, progress);
    answer.linkages = std::move(best.linkages);
    answer.left_out = best.left_out;
    warn_of_more(answer, best.beyond);
    state_reason(answer, words, reason_facts(answer));
  }
  progress(1);
  return !progress.is_cancelled();
}

Error cancelled() { return {"cancelled", "", "stopped before the answer was complete"}; }

void set_wishes(FourBarAnswer& answer, const Requirements& requirements, const SynthesisOptions& options) {
  answer.characteristic_length = answer.given.frame().scale;
  answer.requirements = with_defaults(requirements, answer.given);
  answer.options = with_task_defaults(options, answer.characteristic_length);
}
void set_wishes(SphericalAnswer& answer, const Requirements& requirements, const SynthesisOptions& options) {
  answer.requirements = with_default_angles(requirements);
  answer.options = options;
}

template <class KindAnswer, class KindTask, class Given>
KindAnswer begin_pairs(const KindTask& task, Given given, const Requirements& requirements,
                       const SynthesisOptions& options) {
  KindAnswer answer;
  answer.task = task;
  answer.pattern = given.pattern;
  answer.condition = given.conditions.condition();
  answer.warnings = given.warnings;
  answer.given = std::move(given);
  set_wishes(answer, requirements, options);
  return answer;
}

// Nothing passes all five positions: which of them to free is to be said.
template <class KindAnswer>
bool wants_relaxed(const KindAnswer& answer, int positions) {
  return positions == 5 && !answer.given.curve && answer.linkages.empty() && answer.options.best > 0 &&
         !answer.options.at;
}

// The input is the task's, and so are the ground pivots: what is left to measure is the function.
template <class KindAnswer>
Result<Answer> generators(KindAnswer answer, const TaskWords& words, const Progress& progress) {
  if (!find_pairs(answer, words, progress)) return cancelled();
  if (const auto& family = answer.given.functions; family && !find_generators(answer, *family, progress))
    return cancelled();
  return Answer(std::move(answer));
}

Notice about_search(const PivotSearchResult& found) {
  const auto [x, y] = std::pair(found.pivot.real(), found.pivot.imag());
  const std::string looked_at =
      fmt::format("{} places in the box, with {} arms", grouped_text(found.places), grouped_text(found.arms));
  Notice notice{
      "pivot_searched",
      fmt::format("The input's ground pivot was searched for: of {} the best, moved to where small steps find "
                  "nothing better, is ({:.6g}, {:.6g}). Everything below is of this place, and complete "
                  "there; other places may have better linkages. Give it as ground pivot to keep it.",
                  looked_at, x, y),
      {{"x", x},
       {"y", y},
       {"places", static_cast<double>(found.places)},
       {"arms", static_cast<double>(found.arms)},
       {"meeting", static_cast<double>(found.meeting)}}};
  if (found.meets) return notice;
  notice.code = "pivot_not_found";
  notice.message = fmt::format(
      "The input's ground pivot was searched for: of {} none has a linkage that meets all "
      "requirements, which proves nothing of the others. Everything below is of ({:.6g}, "
      "{:.6g}), which comes close. Enlarge the box, or look at more (\"effort\").",
      looked_at, x, y);
  return notice;
}

// The way from one share of `progress`, which must outlive it, to another.
Progress part_of(const Progress& progress, double from, double to) {
  return {[&progress, from, to](double done) { progress(from + (to - from) * done); }, progress.cancelled};
}

// Of a linkage that was fitted, as it was; of others, as driving shows.
std::optional<NearMiss> miss_at(const TaskFamily& given, MapPoint place, const FourBar& bars) {
  if (const PoseFit* fit = given.family->fit_at(place)) return given.near->miss_of(*fit);
  return given.near->miss_of(bars, given.family->user_poses(place, bars).front().pose);
}

// A closed path is run all along.
void go_all_round(DefectReport& report) {
  if (!report.defects.none()) return;
  report.min_transmission_angle = report.min_transmission_angle_full_turn;
  report.sweep = two_pi;
}

}  // namespace

std::optional<FourBarSolution> linkage_at(const FourBarAnswer& answer, MapPoint place, bool verify) {
  return make_four_bar(answer.given, place, answer.requirements.respect_direction, verify);
}
std::optional<FourBarSolution> linkage_at(const MotionAnswer& answer, MapPoint place, bool verify) {
  auto found = linkage_at(static_cast<const FourBarAnswer&>(answer), place, verify);
  if (!found || !answer.given.near) return found;
  found->near = miss_at(answer.given, answer.point_of(*found), found->four_bar);
  const bool in_order = found->near && found->near->in_order;
  if (found->report.defects.none()) found->verified_by_driving = found->verified_by_driving && in_order;
  return found;
}
std::optional<FourBarSolution> linkage_at(const PathAnswer& answer, MapPoint place, bool verify) {
  auto found = linkage_at(static_cast<const FourBarAnswer&>(answer), place, verify);
  if (!found || !answer.given.paths) return found;
  const PathFamily& family = *answer.given.paths;
  const MapPoint there = answer.point_of(*found);  // with its layer
  const std::vector<PrescribedPose> crank_poses = family.crank_poses(there, found->four_bar);
  found->path = timed_path(found->four_bar, crank_poses);
  found->path->elbows = family.elbows_at(there);
  found->fit = family.fitted_at(there);
  if (found->fit && answer.task.closed) go_all_round(found->report);
  if (!family.is_timed()) found->path->cognate.reset();
  found->residual_derivatives = family.rate_residual(there);
  if (verify) drive_path(*found, family, crank_poses);
  return found;
}
std::optional<SphericalSolution> linkage_at(const SphericalAnswer& answer, MapPoint place, bool verify) {
  return make_spherical_four_bar(answer.given, place, answer.requirements.respect_direction, verify);
}

void measure_function(FourBarSolution& found, const FunctionFamily& family) { measure_generated(found, family); }
void measure_function(SphericalSolution& found, const SphericalFunctionFamily& family) {
  measure_generated(found, family);
}

MotionAnswer begin_answer(const MotionTask& task, const Requirements& requirements, const SynthesisOptions& options,
                          const Progress& progress) {
  const Progress silent{{}, progress.cancelled};
  TaskFamily given = task.is_fitted() ? family_of_near(task, requirements, options.fit, options.region, silent)
                                      : task_family(task, requirements, options.objective, silent);
  const auto near_error = given.near_error;
  auto answer = begin_pairs<MotionAnswer>(task, std::move(given), requirements, options);
  answer.of_task = near_error;
  return answer;
}
FunctionAnswer begin_answer(const FunctionTask& task, const Requirements& requirements, const SynthesisOptions& options,
                            const Progress& /*progress*/) {
  return begin_pairs<FunctionAnswer>(task, task_family(task), requirements, options);
}
PathAnswer begin_answer(const PathTask& task, const Requirements& requirements, const SynthesisOptions& options,
                        const Progress& progress) {
  if (task.is_approximate())
    return begin_pairs<PathAnswer>(
        task, family_of_nearest(task, requirements, options.fit, options.region, {{}, progress.cancelled}),
        requirements, options);
  if (!task.seeks_pivot())
    return begin_pairs<PathAnswer>(task, task_family(task, requirements, options.objective), requirements, options);
  const PivotSearchResult found =
      search_for_pivot(task,
                       {requirements, options.objective, static_cast<std::uint64_t>(options.seed), options.effort,
                        options.region.threads, options.region.simd},
                       {{}, progress.cancelled});
  PathTask settled = task;
  settled.pivots.input = found.pivot;
  PathAnswer answer =
      begin_pairs<PathAnswer>(settled, task_family(settled, requirements, options.objective), requirements, options);
  answer.warnings.push_back(about_search(found));
  return answer;
}
SphericalMotionAnswer begin_answer(const SphericalMotionTask& task, const Requirements& requirements,
                                   const SynthesisOptions& options, const Progress& /*progress*/) {
  return begin_pairs<SphericalMotionAnswer>(task, task_family(task), requirements, options);
}
SphericalFunctionAnswer begin_answer(const SphericalFunctionTask& task, const Requirements& requirements,
                                     const SynthesisOptions& options, const Progress& /*progress*/) {
  return begin_pairs<SphericalFunctionAnswer>(task, task_family(task), requirements, options);
}

// Five positions that no usable four-bar passes: which of them to free, and what its error becomes.
Result<Answer> solve_of_kind(const MotionTask& task, const Requirements& requirements, const SynthesisOptions& options,
                             const Progress& progress) {
  const bool five = position_count(task.poses) == 5;
  const double here = five ? 0.5 : 1;
  MotionAnswer answer = begin_answer(task, requirements, options, progress);
  if (!find_pairs(answer, {}, part_of(progress, 0, here))) return cancelled();
  if (wants_relaxed(answer, position_count(task.poses))) {
    answer.relaxed = drop_one_position(task, requirements, {.region = options.region}, part_of(progress, here, 1));
    if (progress.is_cancelled()) return cancelled();
  }
  if (five) progress(1);
  return Answer(std::move(answer));
}

Result<Answer> solve_of_kind(const SphericalMotionTask& task, const Requirements& requirements,
                             const SynthesisOptions& options, const Progress& progress) {
  SphericalMotionAnswer answer = begin_answer(task, requirements, options, progress);
  if (!find_pairs(answer, spherical_words, progress)) return cancelled();
  if (wants_relaxed(answer, position_count(task.orientations))) {
    answer.relaxed = drop_one_orientation(task, requirements, options.region, progress);
    if (progress.is_cancelled()) return cancelled();
  }
  return Answer(std::move(answer));
}

Result<Answer> solve_of_kind(const FunctionTask& task, const Requirements& requirements,
                             const SynthesisOptions& options, const Progress& progress) {
  return generators(begin_answer(task, requirements, options, progress), function_words, progress);
}

Result<Answer> solve_of_kind(const PathTask& task, const Requirements& requirements, const SynthesisOptions& options,
                             const Progress& progress) {
  PathAnswer answer = begin_answer(task, requirements, options, progress);
  const TaskWords& words = task.is_approximate()               ? near_path_words
                           : task.timing() == PathTiming::none ? path_words
                                                               : timed_path_words;
  if (!find_pairs(answer, words, progress)) return cancelled();
  return Answer(std::move(answer));
}

Result<Answer> solve_of_kind(const SphericalFunctionTask& task, const Requirements& requirements,
                             const SynthesisOptions& options, const Progress& progress) {
  return generators(begin_answer(task, requirements, options, progress), spherical_function_words, progress);
}

}  // namespace linkwright
