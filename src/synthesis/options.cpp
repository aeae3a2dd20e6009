#include "linkwright/synthesis/options.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "analyses/analyses.hpp"
#include "core/number_check.hpp"

namespace linkwright {
namespace {

void check_point(Point point, const std::string& place, std::vector<Error>& found) {
  check_number(point.real(), "x", place, found);
  check_number(point.imag(), "y", place, found);
}

void check_start(const FitStart& start, const std::string& place, std::vector<Error>& found) {
  check_point(start.bars.input_fixed, place + ".input.center_point", found);
  check_point(start.bars.input_moving, place + ".input.circle_point", found);
  check_point(start.bars.output_fixed, place + ".output.center_point", found);
  check_point(start.bars.output_moving, place + ".output.circle_point", found);
  if (start.point) check_point(*start.point, place + ".point", found);
  if (!start.pose) return;
  check_point(start.pose->origin, place + ".pose", found);
  check_angle(start.pose->angle, "theta_deg", place + ".pose.theta_deg", found);
}

}  // namespace

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
                     fmt::format("the number of chains or arms to try lies between 1 and {}; {} is usual",
                                 SynthesisOptions::max_effort, SynthesisOptions{}.effort),
                     {{"most", SynthesisOptions::max_effort}, {"usual", SynthesisOptions{}.effort}}});
  if (const auto& margin = options.fit.grashof_margin; margin && !(*margin >= 0 && *margin < 1))
    found.push_back({"grashof_margin_range", "options.fit.grashof_margin",
                     "a Grashof margin is a share of the diagonal, from 0 to below 1; 0.003 is usual, null allows any "
                     "linkage"});
  if (options.fit.starts.size() > FitWishes::most_starts)
    found.push_back({"fit_starts_count",
                     "options.fit.starts",
                     fmt::format("at most {} linkages to begin with belong here", FitWishes::most_starts),
                     {{"most", static_cast<double>(FitWishes::most_starts)}}});
  for (std::size_t k = 0; k < options.fit.starts.size(); ++k)
    check_start(options.fit.starts[k], fmt::format("options.fit.starts[{}]", k), found);
  const auto check_length = [&](const std::optional<double>& length, const char* place) {
    if (length && !(*length > 0 && std::isfinite(*length)))
      found.push_back({"length_of_line", place, "a length greater than 0 belongs here, or null"});
  };
  check_length(options.line.deviation, "options.deviation");
  check_length(options.line.stroke, "options.stroke");
  for (Error& mistake : mistakes_in_analyses(options)) found.push_back(std::move(mistake));
  return found;
}

namespace {

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

// What belongs to a linkage to begin with.
std::vector<Error> mistakes_in_starts(const std::vector<FitStart>& starts, bool of_poses) {
  for (std::size_t k = 0; k < starts.size(); ++k) {
    const std::string place = fmt::format("options.fit.starts[{}]", k);
    if (!starts[k].point && !of_poses)
      return {{"start_without_point", place, "a linkage to begin with needs \"point\", which traces its path"}};
    if (starts[k].point && of_poses)
      return {{"start_point_of_paths", place + ".point", "\"point\" belongs to linkages of a path; remove it"}};
    if (starts[k].pose && !of_poses)
      return {{"start_pose_of_poses", place + ".pose", "\"pose\" belongs to linkages past near poses; remove it"}};
  }
  return {};
}

}  // namespace

std::vector<Error> mistakes_in(const Task& task, const Requirements& requirements, const SynthesisOptions& options) {
  if (auto of_analyses = mistakes_in_analyses(task, requirements, options); !of_analyses.empty()) return of_analyses;
  if (options.pareto)
    if (auto of_pareto = mistakes_in_pareto(task, *options.pareto); !of_pareto.empty()) return of_pareto;
  const LinkageClass& asked = linkages(task);
  if (std::find(asked.objectives.begin(), asked.objectives.end(), options.objective) == asked.objectives.end())
    return {foreign_objective(options.objective, asked)};
  if (output_kind(task) != OutputKind::line && options.line != LineMeasuring{})
    return {
        {"line_options", "options", "\"deviation\", \"stroke\" and \"measure\" belong to straight lines; remove them"}};
  const auto* path = std::get_if<PathTask>(&task);
  const auto* motion = std::get_if<MotionTask>(&task);
  const bool fits_poses = motion != nullptr && motion->is_fitted();
  if (options.fit != FitWishes{} && !fits_poses && (path == nullptr || !path->is_approximate()))
    return {{"fit_options", "options.fit",
             "\"fit\" belongs to paths that pass near points, and to near poses with fewer than four exact positions; "
             "remove it"}};
  if (auto of_starts = mistakes_in_starts(options.fit.starts, fits_poses); !of_starts.empty()) return of_starts;
  if (fits_poses && options.fit.grashof_margin != FitWishes{}.grashof_margin)
    return {{"fit_of_paths", "options.fit.grashof_margin",
             "a Grashof margin belongs to closed paths that pass near points; remove it"}};
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
