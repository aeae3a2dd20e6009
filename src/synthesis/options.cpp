#include "linkwright/synthesis/options.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace linkwright {

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
  return found;
}

std::vector<Error> mistakes_in(const Task& task, const SynthesisOptions& options) {
  const LinkageClass& asked = linkages(task);
  if (std::find(asked.objectives.begin(), asked.objectives.end(), options.objective) == asked.objectives.end())
    return {foreign_objective(options.objective, asked)};
  if (!std::holds_alternative<StraightLineTask>(task) && options.line != LineMeasuring{})
    return {
        {"line_options", "options", "\"deviation\", \"stroke\" and \"measure\" belong to straight lines; remove them"}};
  const auto* six_bar = std::get_if<SixBarTask>(&task);
  if (options.at && six_bar != nullptr && !six_bar->chain)
    return {{"place_of_search", "options.at",
             "six-bars that are searched for have no solution region; give the chain, or drop the place"}};
  const auto* line = std::get_if<StraightLineTask>(&task);
  if (options.at && line != nullptr && std::holds_alternative<straight_cases::Search>(line->given))
    return {{"place_of_search", "options.at",
             "linkages of a search come from many maps; take the place to the task of one of them, or drop it"}};
  if (options.objective != Objective::structural_error) return {};
  const WantedFunction* wanted = wanted_function(task);
  if (wanted != nullptr && wanted->function) return {};
  return {{"objective_of_function", "options.objective",
           "a structural error belongs to a task with a named \"function\"; choose another objective"}};
}

}  // namespace linkwright
