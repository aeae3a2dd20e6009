#include "linkwright/planar/synthesis.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <span>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/count_text.hpp"
#include "linkwright/planar/function_family.hpp"
#include "linkwright/planar/function_search.hpp"
#include "planar/linkage_search.hpp"
#include "planar/six_bar_answer.hpp"

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

// Side links of the map that rounding keeps from being any.
std::vector<Notice> left_out_warning(const Solution& solution) {
  const FourBarFamily& family = *solution.given.family;
  const std::span<const double> looked_at = solution.region.input_coordinates();
  if (!solution.given.curve || !family.is_symmetric()) return {};
  const auto count = std::count_if(looked_at.begin(), looked_at.end(), [&](double tau) {
    return !family.side_links({tau, tau}).has_value();
  });
  if (count == 0) return {};
  return {{"side_links_left_out",
           fmt::format(
               "Left out are {} of the {} side links looked at, so short or so far away that rounding changes their "
               "lengths over the positions by more than a millionth. Set the positions further "
               "off a turn about one pole, or off a mere shift.",
               grouped_text(count), grouped_text(static_cast<std::int64_t>(looked_at.size()))),
           {{"count", static_cast<double>(count)}, {"of", static_cast<double>(looked_at.size())}}}};
}

// Where rounding decides what a linkage does, it is no answer: counted, and said.
void leave_out_unconfirmed(Solution& solution) {
  std::int64_t& count = solution.left_out;
  if (!solution.pairs.empty()) {  // all there are, those of the list among them
    count = static_cast<std::int64_t>(std::erase_if(solution.pairs, is_unconfirmed));
    std::erase_if(solution.linkages, is_unconfirmed);
  }
  if (solution.requirements.no_defects)  // none in the working frame, where they were judged
    count += static_cast<std::int64_t>(
        std::erase_if(solution.linkages, [](const FourBarSolution& found) { return !found.report.defects.none(); }));
  count += static_cast<std::int64_t>(std::erase_if(solution.linkages, is_unconfirmed));
  count += static_cast<std::int64_t>(std::erase_if(solution.six_bars, [](const SixBarSolution& found) {
    return found.rating.drive.defects.none() && !found.verified_by_driving;
  }));
  if (count == 0) return;
  solution.given.warnings.push_back(
      {"linkages_left_out",
       fmt::format("Left out {} of the best: so near a change point, a dead point{}, or with so short a link, that "
                   "rounding decides "
                   "what they do, and driving them through the task confirmed no more.{}",
                   count == 1 ? "is one" : fmt::format("are {}", count),
                   solution.given.conditions.near_pole ? " or the positions' common pole" : "",
                   solution.given.conditions.near_pole ? " Set the positions further off a turn about one pole." : ""),
       {{"count", static_cast<double>(count)}}});
}

// Where the best by another measure stand at the edge of locking: what keeps them away from it, and what that leaves.
std::vector<Notice> locking_warning(const Solution& solution, const Progress& progress) {
  constexpr double edge = radians(1), best_of_all = radians(40), step = radians(5);
  const Requirements& asked = solution.requirements;
  if (solution.linkages.empty() || asked.min_transmission_angle > 0 || !asked.no_defects) return {};
  const auto is_discrete = [&](Side side) { return solution.given.family->axis(side).is_discrete(); };
  if (is_discrete(Side::input) && is_discrete(Side::output)) return {};
  const double angle = solution.linkages.front().report.min_transmission_angle;
  if (solution.options.objective == Objective::min_transmission_angle || angle >= edge) return {};
  Requirements wanted = asked;
  std::int64_t left = 0;
  for (wanted.min_transmission_angle = best_of_all; left == 0 && wanted.min_transmission_angle > edge;) {
    left = filter_of(*solution.given.family, solution.region, wanted).census(progress).meeting;
    if (progress.is_cancelled()) return {};
    if (left == 0) wanted.min_transmission_angle -= step;
  }
  Notice notice{
      "held_by_locking",
      fmt::format("The best linkage stands at the edge of locking: its transmission angle is {:.2g}°.", degrees(angle)),
      {{"angle", degrees(angle)}}};
  if (left > 0) {
    const double proposed = degrees(wanted.min_transmission_angle);
    notice.message += fmt::format(" Ask for a transmission angle of at least {:.0f}°: {} four-bars have it.", proposed,
                                  grouped_text(left));
    notice.values.push_back({"proposed", proposed});
    notice.values.push_back({"leaves", static_cast<double>(left)});
  }
  return {notice};
}

// The longest way along the curve from one of the rising coordinates to the next.
double longest_step(const BurmesterCurve::Run& run, std::span<const double> coordinates) {
  double longest = 0, before = 0;
  for (std::size_t i = 0, corner = 0; i < coordinates.size(); ++i) {
    while (corner + 1 < run.tau.size() && run.tau[corner] < coordinates[i]) ++corner;
    if (i > 0) longest = std::max(longest, run.length[corner] - before);
    before = run.length[corner];
  }
  return longest;
}

// What the map skips where a long stretch of the curve lies between two of its samples.
std::vector<Notice> skipped_stretch_warning(const Solution& solution) {
  // Radians run by both points together: a whole way to infinity and back is π. Evenly drawn tasks stay below 2.4.
  constexpr double long_stretch = 3, long_beside_others = 20, short_side = 0.1;
  const BurmesterCurve* curve = solution.given.curve.get();
  const std::span<const double> looked_at = solution.region.input_coordinates();
  if (curve == nullptr || solution.options.window || solution.options.spacing == Spacing::arc_length) return {};
  const BurmesterCurve::Run run = curve->run(short_side);
  if (run.tau.empty()) return {};
  const double usual = run.length.back() / static_cast<double>(looked_at.size());
  const double longest = longest_step(run, looked_at);
  if (!(longest > long_stretch && longest > long_beside_others * usual)) return {};
  return {{"stretch_between_samples",
           "A long stretch of the curve of side links lies between two of its samples: the map does not show it, and "
           "good linkages may lie there. Choose \"spacing\": \"arc_length\" to see it.",
           {}}};
}

// No defects, then the larger least transmission angle, then the smaller coordinate.
bool is_better(const FourBarSolution& a, const FourBarSolution& b) {
  if (a.report.defects.none() != b.report.defects.none()) return a.report.defects.none();
  const double angle = a.report.min_transmission_angle, other = b.report.min_transmission_angle;
  return angle != other ? angle > other : a.input.coordinate < b.input.coordinate;
}

std::string percent(std::int64_t part, std::int64_t whole) {
  const double share = 100 * static_cast<double>(part) / static_cast<double>(whole);
  if (part < whole && share > 99) return "over 99 %";
  return share < 1 ? "under 1 %" : fmt::format("{:.0f} %", share);
}

/// How a kind of task is spoken of.
struct TaskWords {
  std::string_view four_bars = "four-bars that pass through all poses";
  std::string_view lock = "lock between two poses (branch)";
  std::string_view ways_out = "Try another order of the poses, {}allow a defect (no_defects: false), or move a pose.";
};

constexpr TaskWords function_words = {
    "four-bars that generate all pairs", "lock between two pairs (branch)",
    "Try other ranges of the dials, fewer or other pairs, or allow a defect (no_defects: false)."};

Notice nothing_defect_free(const Solution& solution, const TaskWords& words) {
  const RegionCounts& counts = solution.counts;
  const bool directed =
      solution.requirements.respect_direction && solution.given.pattern.find("PP") != std::string::npos;
  const std::int64_t whole = counts.pairs - counts.types[static_cast<std::size_t>(LinkageType::degenerate)];
  std::vector<std::string> causes;
  const auto blame = [&](std::int64_t cells, std::string_view what) {
    if (cells > 0) causes.push_back(fmt::format("{} {}", percent(cells, whole), what));
  };
  blame(counts.circuit, "need taking apart (circuit)");
  blame(counts.branch - counts.circuit, words.lock);
  blame(counts.order, directed ? "visit them in another order, or against a direction" : "visit them in another order");
  return {"none_defect_free",
          fmt::format("None of the {} ({}) is free of defects: {}. ", words.four_bars, grouped_text(whole),
                      fmt::join(causes, ", ")) +
              fmt::format(fmt::runtime(words.ways_out),
                          directed ? "turn a direction round or let none count (respect_direction: false), " : ""),
          {{"count", static_cast<double>(whole)}}};
}

Notice nothing_left(const Solution& solution) {
  const std::int64_t free = solution.counts.defect_free;
  Notice notice{"none_left",
                fmt::format("None of the four-bars free of defects ({}) meets all requirements.", grouped_text(free)),
                {{"count", static_cast<double>(free)}}};
  for (const MissedBox& missed : solution.missed_boxes) notice.message += " " + missed_box_text(missed);
  if (!solution.relax.empty()) {
    const Relaxation& dearest = solution.relax.front();
    notice.message += fmt::format(" {} costs most: without it {} would be left.", key(dearest.requirement),
                                  grouped_text(dearest.only_this));
  } else if (solution.relax_together) {
    notice.message += " " + joint_relaxation_text(*solution.relax_together);
  }
  return notice;
}

// Cells of the map meet the requirements, and yet no linkage is listed.
void explain_empty_list(Solution& solution) {
  if (solution.options.best == 0 || !solution.linkages.empty() || !solution.six_bars.empty()) return;
  const bool erased = solution.left_out > 0 && solution.reason.code == "searched";
  if (solution.reason.code != "solved" && !erased) return;
  solution.status = SolutionStatus::no_solution;
  const auto meeting = static_cast<double>(solution.meeting_requirements);
  if (solution.left_out > 0)
    solution.reason = {
        "none_confirmed",
        "What meets all requirements stands so near a change point or a dead point that rounding decides "
        "what it does: driving it through the task confirmed none. Ask for a transmission angle.",
        {{"count", meeting}}};
  else if (solution.options.objective == Objective::structural_error)
    solution.reason = {
        "none_reaches",
        fmt::format("Of the four-bars that meet all requirements ({}) none takes its input through the whole "
                    "range of the function. Shorten the range, or move the precision points.",
                    grouped_text(solution.meeting_requirements)),
        {{"count", meeting}}};
  else
    solution.reason = {
        "none_left",
        "What meets all requirements does so by rounding alone: it lies on the very edge of a limit. Relax "
        "one of them a little.",
        {{"count", meeting}}};
}

void judge(Solution& solution, const TaskWords& words) {
  const RegionCounts& counts = solution.counts;
  const std::int64_t whole = counts.pairs - counts.types[static_cast<std::size_t>(LinkageType::degenerate)];
  if (whole == 0) {
    solution.status = SolutionStatus::no_solution;
    const auto& warnings = solution.given.warnings;
    const bool some_left_out = std::any_of(warnings.begin(), warnings.end(),
                                           [](const Notice& warning) { return warning.code == "side_links_left_out"; });
    solution.reason = {
        "no_pair",
        fmt::format("No pair of side links makes a four-bar: in every pair a pivot is at infinity{} or a link has no "
                    "length.",
                    some_left_out ? ", a side link was left out" : ""),
        {}};
  } else if (counts.defect_free == 0 && solution.requirements.no_defects) {
    solution.reason = nothing_defect_free(solution, words);
  } else if (solution.meeting_requirements == 0) {
    solution.reason = nothing_left(solution);
  } else {
    solution.reason = {
        "solved",
        fmt::format("All {}: {}; free of defects: {}; meeting all requirements: {}.", words.four_bars,
                    grouped_text(whole), grouped_text(counts.defect_free), grouped_text(solution.meeting_requirements)),
        {{"count", static_cast<double>(whole)},
         {"defect_free", static_cast<double>(counts.defect_free)},
         {"meeting", static_cast<double>(solution.meeting_requirements)}}};
  }
}

}  // namespace

std::string_view name(SolutionStatus status) { return status_names[static_cast<std::size_t>(status)]; }

std::vector<Error> mistakes_in(const SynthesisOptions& options) {
  std::vector<Error> found;
  if (options.region_samples < SynthesisOptions::least_samples ||
      options.region_samples > SynthesisOptions::most_samples)
    found.push_back({"out_of_range", "options.region_samples",
                     fmt::format("the region takes {} to {} samples a side; 400 is usual",
                                 SynthesisOptions::least_samples, SynthesisOptions::most_samples)});
  if (options.best < 0 || options.best > SynthesisOptions::most_best)
    found.push_back(
        {"out_of_range", "options.best",
         fmt::format("the number of linkages to return lies between 0 and {}", SynthesisOptions::most_best)});
  if (options.window)
    for (const auto& [low, high] : {options.window->input, options.window->output})
      if (!(std::isfinite(low) && std::isfinite(high) && low < high))
        found.push_back(
            {"out_of_range", "options.window", "each interval of the window is [low, high] in τ with low below high"});
  if (options.box) append(found, mistakes_in_search_box(*options.box));
  if (options.seed < 0 || options.seed > SynthesisOptions::most_seed)
    found.push_back(
        {"out_of_range", "options.seed",
         fmt::format("a seed is a whole number from 0 to {}; any of them will do", SynthesisOptions::most_seed)});
  if (options.effort < 1 || options.effort > SynthesisOptions::most_effort)
    found.push_back({"out_of_range", "options.effort",
                     fmt::format("the number of chains to try lies between 1 and {}; {} is usual",
                                 SynthesisOptions::most_effort, SynthesisOptions{}.effort)});
  return found;
}

std::vector<Error> mistakes_in(const Task& task, const SynthesisOptions& options) {
  if (options.objective != Objective::structural_error) return {};
  const auto* function = std::get_if<FunctionTask>(&task);
  if (function != nullptr && function->function) return {};
  return {{"out_of_range", "options.objective",
           "a structural error belongs to a task with a named \"function\"; choose another objective"}};
}

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
  for (const auto& found : {left_out_warning(solution), skipped_stretch_warning(solution)})
    solution.given.warnings.insert(solution.given.warnings.end(), found.begin(), found.end());
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
  judge(solution, words);
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
  for (Notice& warning : locking_warning(*solved, progress)) solved->given.warnings.push_back(std::move(warning));
  return solved;
}

}  // namespace linkwright
