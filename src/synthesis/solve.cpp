#include "linkwright/synthesis/solve.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <span>

#include "linkage_search.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/count_text.hpp"
#include "linkwright/planar/function_family.hpp"
#include "linkwright/planar/function_search.hpp"
#include "reason.hpp"
#include "six_bar_answer.hpp"
#include "warnings.hpp"

namespace linkwright {
namespace {

constexpr std::array<std::string_view, 3> status_names = {"solved", "no_solution", "degenerate"};

void append(std::vector<Error>& all, std::vector<Error> more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

// Those that are not told already.
void append_new(std::vector<Error>& all, const std::vector<Error>& more) {
  for (const Error& error : more)
    if (std::none_of(all.begin(), all.end(),
                     [&](const Error& known) { return known.code == error.code && known.place == error.place; }))
      all.push_back(error);
}

void map_region(Solution& solution, const Progress& progress) {
  const FourBarFamily& family = *solution.given.family;
  const SynthesisOptions& options = solution.options;
  const auto samples = [&](Side side) {
    return samples_within(family, side, options.window, options.region_samples, options.spacing);
  };
  family.classify(solution.region, samples(Side::input), samples(Side::output), solution.requirements.respect_direction,
                  options.region, progress);
  solution.counts = solution.region.counts();
}

std::vector<Dyad> curve_samples(const TaskFamily& given, const SynthesisOptions& options) {
  std::vector<Dyad> dyads;
  if (!given.curve) return dyads;
  for (const double tau : given.curve->samples(options.region_samples, options.spacing))
    dyads.push_back(given.frame().to_user(given.curve->dyad(tau)));
  return dyads;
}

// No defects, then the larger least transmission angle, then the smaller coordinate.
bool is_better(const FourBarSolution& a, const FourBarSolution& b) {
  if (a.report.defects.none() != b.report.defects.none()) return a.report.defects.none();
  const double angle = a.report.min_transmission_angle, other = b.report.min_transmission_angle;
  return angle != other ? angle > other : a.input.coordinate < b.input.coordinate;
}

}  // namespace

std::string_view name(SolutionStatus status) { return status_names[static_cast<std::size_t>(status)]; }

namespace {

// What would leave something where nothing is left.
void advise(Solution& solution, const RequirementFilter& filter, const RequirementCensus& census,
            const Progress& progress) {
  solution.relax = filter.relaxations(census, progress);
  if (solution.relax.empty()) solution.relax_together = census.joint_relaxation();
  solution.missed_boxes = missed_boxes(*solution.given.family, solution.requirements);
}

// Five positions: every pair of side links as a four-bar, the better driver first named, best first.
std::vector<FourBarSolution> all_pairs(const Solution& solution) {
  constexpr bool verify = true;
  const Requirements& wanted = solution.requirements;
  const std::vector<double> places = solution.given.family->samples(Side::input, 0, Spacing::coordinate);
  std::vector<FourBarSolution> pairs;
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t j = i + 1; j < places.size(); ++j) {
      auto one = make_four_bar(solution.given, {places[i], places[j]}, wanted.respect_direction, verify);
      auto other = make_four_bar(solution.given, {places[j], places[i]}, wanted.respect_direction, verify);
      if (one && other) pairs.push_back(is_better(*other, *one) ? *other : *one);
    }
  std::sort(pairs.begin(), pairs.end(), is_better);
  return pairs;
}

Result<Solution> solve_of_kind(const SixBarTask& task, const Requirements& requirements,
                               const SynthesisOptions& options, const Progress& progress) {
  return solve_six_bars(task, requirements, options, progress);
}

Error cancelled() { return {"cancelled", "", "stopped before the answer was complete"}; }

Result<Solution> solve_family(TaskFamily family, const Requirements& requirements, const SynthesisOptions& options,
                              const Progress& progress, const TaskWords& words = {}) {
  Solution solution;
  solution.given = std::move(family);
  const TaskFamily& given = solution.given;
  solution.requirements = with_defaults(requirements, given);
  solution.options = options;
  solution.samples = curve_samples(given, options);
  if (!given.family) {
    solution.status = given.has_no_dyads ? SolutionStatus::no_solution : SolutionStatus::degenerate;
    solution.reason = given.degeneracy.value_or(Notice{});
    return solution;
  }

  progress(0.1);
  map_region(solution, progress);
  warn_of_map(solution);
  progress(0.6);
  const RequirementFilter filter = filter_of(*given.family, solution.region, solution.requirements);
  const RequirementCensus census = filter.census(progress);
  solution.meeting_requirements = census.meeting;
  if (census.meeting == 0) advise(solution, filter, census, progress);
  progress(0.7);
  BestLinkages best = best_linkages(solution, filter, progress);
  solution.linkages = std::move(best.linkages);
  solution.left_out = best.left_out;
  if (!given.points.empty() && !given.curve) solution.pairs = all_pairs(solution);
  if (progress.is_cancelled()) return cancelled();
  state_reason(solution, words);
  progress(1);
  return solution;
}

// The way from one share of `progress`, which must outlive it, to another.
Progress part_of(const Progress& progress, double from, double to) {
  return {[&progress, from, to](double done) { progress(from + (to - from) * done); }, progress.cancelled};
}

// Five positions that no usable four-bar passes: which of them to free, and what its error becomes.
Result<Solution> solve_of_kind(const MotionTask& task, const Requirements& requirements,
                               const SynthesisOptions& options, const Progress& progress) {
  const bool five = position_count(task.poses) == 5;
  const double here = five ? 0.5 : 1;
  Result<Solution> solved = solve_family(task_family(task, requirements, options.objective), requirements, options,
                                         part_of(progress, 0, here));
  const bool wanting = solved && five && !solved->given.curve && solved->linkages.empty();
  if (wanting && options.best > 0) {
    solved->freed = nearest_relaxations(task, requirements, {.region = options.region}, part_of(progress, here, 1));
    if (progress.is_cancelled()) return cancelled();
  }
  if (solved && five) progress(1);
  return solved;
}

std::vector<FourBarSolution> generators(const FunctionFamily& family, const Solution& solution,
                                        const Progress& progress) {
  constexpr bool verify = true;
  GeneratorSearchOptions search;
  search.most = solution.options.best;
  search.window = solution.options.window;
  search.threads = solution.options.region.threads;
  std::vector<FourBarSolution> found;
  for (const RankedGenerator& ranked : best_generators(family, solution.requirements, search, progress))
    if (auto made = make_four_bar(solution.given, ranked.place, solution.requirements.respect_direction, verify)) {
      made->local_optimum = true;
      found.push_back(*std::move(made));
    }
  return found;
}

// Where driving a generator free of defects confirms it, it must also have brought the output to each pair.
void measure_function(FourBarSolution& found, const FunctionFamily& family) {
  constexpr double right = 1e-6;  // radians; close to a dead point rounding of the input shows this much
  found.function = family.error_of(found.four_bar, {found.input.coordinate, found.output.coordinate});
  if (found.report.defects.none())
    found.verified_by_driving =
        found.verified_by_driving && found.function->reaches_pairs && found.function->precision_error <= right;
}

// Five precision points: the few linkages there are, whatever their defects.
std::vector<FourBarSolution> all_generators(const Solution& solution) {
  constexpr bool verify = true;
  const FourBarFamily& family = *solution.given.family;
  std::vector<FourBarSolution> found;
  if (family.axis(Side::input).quantity != AxisQuantity::burmester_point) return found;
  const double only = family.samples(Side::output, 0, Spacing::coordinate).front();
  for (const double place : family.samples(Side::input, 0, Spacing::coordinate))
    if (auto made = make_four_bar(solution.given, {place, only}, solution.requirements.respect_direction, verify))
      found.push_back(*std::move(made));
  std::sort(found.begin(), found.end(), is_better);
  return found;
}

// The input is the task's, and so are the ground pivots: what is left to measure is the function.
Result<Solution> solve_of_kind(const FunctionTask& task, const Requirements& requirements,
                               const SynthesisOptions& options, const Progress& progress) {
  const TaskFamily given = task_family(task);
  const auto family = std::dynamic_pointer_cast<const FunctionFamily>(given.family);
  Result<Solution> solved = solve_family(given, requirements, options, progress, function_words);
  if (!solved || !family) return solved;
  if (options.objective == Objective::structural_error) solved->linkages = generators(*family, *solved, progress);
  if (progress.is_cancelled()) return cancelled();
  solved->pairs = all_generators(*solved);
  for (std::vector<FourBarSolution>* list : {&solved->linkages, &solved->pairs})
    for (FourBarSolution& found : *list) measure_function(found, *family);
  return solved;
}

}  // namespace

Result<Solution> solve(const Task& task, const Requirements& requirements, const SynthesisOptions& options,
                       const Progress& progress) {
  std::vector<Error> mistakes = mistakes_in(task);
  append(mistakes, mistakes_in(requirements));
  append_new(mistakes, mistakes_in(options));  // a six-bar's box may stand in both
  append(mistakes, mistakes_in(task, options));
  if (!mistakes.empty()) return mistakes;
  Result<Solution> solved =
      std::visit([&](const auto& of_kind) { return solve_of_kind(of_kind, requirements, options, progress); }, task);
  if (!solved) return solved;
  leave_out_unconfirmed(*solved);
  explain_empty_list(*solved);
  warn_of_locking(*solved, progress);
  return solved;
}

}  // namespace linkwright
