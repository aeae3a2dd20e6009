#include "linkwright/synthesis/options.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace linkwright {

SynthesisOptions with_turning_length(SynthesisOptions options, double characteristic_length) {
  if (options.tolerances && !options.tolerances->turning_length)
    options.tolerances->turning_length = characteristic_length;
  return options;
}

std::vector<Error> mistakes_in(const SynthesisOptions& options) {
  std::vector<Error> found;
  if (options.region_samples < SynthesisOptions::min_samples || options.region_samples > SynthesisOptions::max_samples)
    found.push_back({"samples_range",
                     "options.region_samples",
                     fmt::format("the region takes {} to {} samples a side; {} is usual", SynthesisOptions::min_samples,
                                 SynthesisOptions::max_samples, SynthesisOptions{}.region_samples),
                     {{"low", SynthesisOptions::min_samples},
                      {"high", SynthesisOptions::max_samples},
                      {"usual", SynthesisOptions{}.region_samples}}});
  if (options.best < 0 || options.best > SynthesisOptions::max_best)
    found.push_back({"best_range",
                     "options.best",
                     fmt::format("the number of linkages to return lies between 0 and {}", SynthesisOptions::max_best),
                     {{"most", SynthesisOptions::max_best}}});
  if (options.window)
    for (const auto& [low, high] : {options.window->input, options.window->output})
      if (!(std::isfinite(low) && std::isfinite(high) && low < high))
        found.push_back(
            {"window_range", "options.window", "each interval of the window is [low, high] in τ with low below high"});
  if (options.box)
    for (Error& mistake : mistakes_in_search_box(*options.box)) found.push_back(std::move(mistake));
  if (options.seed < 0 || options.seed > SynthesisOptions::max_seed)
    found.push_back(
        {"seed_range",
         "options.seed",
         fmt::format("a seed is a whole number from 0 to {}; any of them will do", SynthesisOptions::max_seed),
         {{"most", SynthesisOptions::max_seed}}});
  if (options.effort < 1 || options.effort > SynthesisOptions::max_effort)
    found.push_back({"effort_range",
                     "options.effort",
                     fmt::format("the number of chains to try lies between 1 and {}; {} is usual",
                                 SynthesisOptions::max_effort, SynthesisOptions{}.effort),
                     {{"most", SynthesisOptions::max_effort}, {"usual", SynthesisOptions{}.effort}}});
  const auto check_length = [&](const std::optional<double>& length, const char* place) {
    if (length && !(*length > 0 && std::isfinite(*length)))
      found.push_back({"length_of_line", place, "a length greater than 0 belongs here, or null"});
  };
  check_length(options.line.deviation, "options.deviation");
  check_length(options.line.stroke, "options.stroke");
  if (options.tolerances)
    for (Error& mistake : mistakes_in(*options.tolerances)) found.push_back(std::move(mistake));
  return found;
}

namespace {

bool is_spherical(const Task& task) { return &linkages(task) == &spherical_linkages; }

ToleranceLimit::Kind limit_kind(const Task& task, ToleranceLimit::Kind asked) {
  switch (output_kind(task)) {
    case OutputKind::line:
      return ToleranceLimit::Kind::deviation;
    case OutputKind::angle:
    case OutputKind::turn:
      return ToleranceLimit::Kind::angle;
    default:
      return asked == ToleranceLimit::Kind::deviation ? ToleranceLimit::Kind::position : asked;
  }
}

std::vector<Error> mistakes_in(const Task& task, const Tolerances& tolerances) {
  std::vector<Error> found;
  if (is_spherical(task) && (tolerances.length != LengthTolerances{} || tolerances.clearance > 0))
    found.push_back({"lengths_of_sphere", tolerances.clearance > 0 ? "tolerances.clearance" : "tolerances.length",
                     "the links of a spherical linkage are arcs; give their tolerance as \"link_angle_deg\""});
  if (!is_spherical(task) && tolerances.link_angle > 0)
    found.push_back({"arcs_of_plane", "tolerances.link_angle_deg",
                     "the links of a planar linkage are lengths; give their tolerance as \"length\""});
  if (tolerances.limit && limit_kind(task, tolerances.limit->kind) != tolerances.limit->kind)
    found.push_back({"limit_of_task", "tolerances.limit",
                     "a limit is \"position\" or \"angle_deg\" for a body in the plane, \"angle_deg\" for a function "
                     "and about a centre, \"deviation\" for a straight line"});
  return found;
}

// What asks for tolerances, or for a limit of them.
std::vector<Error> mistakes_about_tolerances(const Task& task, const Requirements& wanted,
                                             const SynthesisOptions& options) {
  std::vector<Error> found;
  const auto check = [&](const char* place, bool asks_yield) {
    if (!options.tolerances)
      found.push_back({"no_tolerances", place, "give the \"tolerances\" with which the linkages are made"});
    else if (asks_yield && !options.tolerances->limit)
      found.push_back({"no_limit", place,
                       "a yield needs \"limit\" in the tolerances: the error up to which a "
                       "linkage is good"});
    else if (is_search(task))  // linkages that are searched for come from many maps, which are too many to be sampled
      found.push_back({"tolerances_of_search", place,
                       "linkages that are searched for are not ranked by tolerances; search first, then ask this of "
                       "the map of one of them"});
  };
  if (wanted.max_tolerance_error < Requirements::unlimited) check("requirements.max_tolerance_error", false);
  if (wanted.min_yield > 0) check("requirements.min_yield", true);
  if (options.objective == Objective::tolerance_error) check("options.objective", false);
  if (options.objective == Objective::yield) check("options.objective", true);
  for (const Objective objective : options.pareto.value_or(std::array<Objective, 2>{}))
    if (is_of_tolerances(objective)) check("options.pareto", objective == Objective::yield);
  return found;
}

std::vector<Error> mistakes_in_pareto(const Task& task, const std::array<Objective, 2>& objectives) {
  const LinkageClass& asked = linkages(task);
  for (const Objective objective : objectives)
    if (std::find(asked.objectives.begin(), asked.objectives.end(), objective) == asked.objectives.end()) {
      Error foreign = foreign_objective(objective, asked);
      foreign.place = "options.pareto";
      return {foreign};
    }
  if (objectives[0] == objectives[1])
    return {{"pareto_alike", "options.pareto", "two different objectives belong here"}};
  if (std::find(objectives.begin(), objectives.end(), Objective::structural_error) != objectives.end())
    return {{"pareto_of_map", "options.pareto",
             "a structural error is no property of the map; choose two objectives that are"}};
  if (is_search(task))
    return {{"pareto_of_search", "options.pareto",
             "linkages that are searched for come from many maps, which have no front in common; ask it of the map of "
             "one of them, or drop it"}};
  return {};
}

}  // namespace

std::vector<Error> mistakes_in(const Task& task, const Requirements& requirements, const SynthesisOptions& options) {
  std::vector<Error> of_tolerances = mistakes_about_tolerances(task, requirements, options);
  if (options.tolerances)
    for (Error& mistake : mistakes_in(task, *options.tolerances)) of_tolerances.push_back(std::move(mistake));
  if (!of_tolerances.empty()) return of_tolerances;
  if (options.pareto)
    if (auto of_pareto = mistakes_in_pareto(task, *options.pareto); !of_pareto.empty()) return of_pareto;
  const LinkageClass& asked = linkages(task);
  if (std::find(asked.objectives.begin(), asked.objectives.end(), options.objective) == asked.objectives.end())
    return {foreign_objective(options.objective, asked)};
  if (output_kind(task) != OutputKind::line && options.line != LineMeasuring{})
    return {
        {"line_options", "options", "\"deviation\", \"stroke\" and \"measure\" belong to straight lines; remove them"}};
  if (options.at && is_search(task))
    return {{"place_of_search", "options.at",
             output_kind(task) == OutputKind::line
                 ? "linkages of a search come from many maps; take the place to the task of one of them, or drop it"
                 : "six-bars that are searched for have no solution region; give the chain, or drop the place"}};
  if (options.objective != Objective::structural_error) return {};
  const WantedFunction* wanted = wanted_function(task);
  if (wanted != nullptr && wanted->function) return {};
  return {{"objective_of_function", "options.objective",
           "a structural error belongs to a task with a named \"function\"; choose another objective"}};
}

}  // namespace linkwright
