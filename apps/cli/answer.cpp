#include "answer.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <vector>

#include "four_bar_columns.hpp"
#include "function_words.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/label.hpp"
#include "linkwright/files/number_text.hpp"
#include "linkwright/files/task_label.hpp"
#include "linkwright/planar/chosen_length.hpp"
#include "pair_words.hpp"
#include "requirement_words.hpp"
#include "six_bar_words.hpp"
#include "text_table.hpp"

namespace linkwright::cli {
namespace {

/// ": 4 Burmester points", where it is they that the task asks for.
std::string point_count(const Solution& solution) {
  const std::size_t count = solution.given.points.size();
  if (solution.given.curve || (count == 0 && !solution.given.has_no_dyads)) return "";
  return count == 0 ? ": no Burmester point" : fmt::format(": {} Burmester point{}", count, count == 1 ? "" : "s");
}

std::string heading(const Problem& problem, const Solution& solution) {
  const std::string title = problem.title.empty() ? "Untitled task" : printable(problem.title);
  std::string text = fmt::format("{}: {}{}", title, task_label(problem.task), point_count(solution));
  if (!problem.length_unit.empty()) text += ", lengths in " + printable(problem.length_unit);
  return wrapped(text);
}

std::string curve_words(const Problem& problem, const Solution& solution) {
  if (!solution.given.curve) return "";
  const bool of_couplers = std::holds_alternative<FunctionTask>(problem.task);
  const std::string_view circle = label(solution.given.curve->kind()),
                         center = label(solution.given.curve->center_kind());
  const std::string_view both = of_couplers ? "Both curves of the coupler, of its pivots on the input and on the output"
                                            : "Both Burmester curves, of circle points and of centre points",
                         first = of_couplers ? "Curve of pivots on the input" : "Circle-point curve",
                         second = of_couplers ? "of pivots on the output" : "centre-point curve";
  std::string text = circle == center ? fmt::format("{}: {}", both, circle)
                                      : fmt::format("{}: {}; {}: {}", first, circle, second, center);
  if (const auto kappa = solution.given.curve->kappa()) text += fmt::format(" (κ = {})", significant_text(*kappa, 3));
  return wrapped(text + ".");
}

/// Where the four-bars lie that are counted.
std::string map_words(const Problem& problem, const Solution& solution) {
  const std::size_t rows = solution.region.rows(), columns = solution.region.columns();
  const MapAxis& across = solution.given.family->axis(Side::output);
  if (std::holds_alternative<FunctionTask>(problem.task)) {
    if (solution.given.family->axis(Side::input).is_discrete()) return "The map of all linkages";
    return across.is_discrete()
               ? fmt::format("The curve of couplers at {} places", rows)
               : fmt::format("The map of {} places of the coupler × {} values of the free number", rows, columns);
  }
  if (across.is_discrete()) return fmt::format("The board of {} × {} side links", rows, columns);
  return fmt::format("The region of {} × {} pairs of side links", rows, columns);
}

/// Pairs of one curve always make something; elsewhere a place may have no side links at all.
std::string degenerate_words(const FourBarFamily& family, std::int64_t count) {
  if (count == 0) return "";
  if (family.is_symmetric()) return fmt::format(" and {} sliders or zero links", grouped_text(count));
  return fmt::format(", and none at {} {}", grouped_text(count), count == 1 ? "place" : "places");
}

std::string counts_words(const Problem& problem, const Solution& solution) {
  const RegionCounts& counts = solution.counts;
  if (counts.pairs == 0) return "";
  const std::int64_t degenerate = counts.types[static_cast<std::size_t>(LinkageType::degenerate)];
  const auto four_bars = [](std::int64_t count) {
    return grouped_text(count) + (count == 1 ? " four-bar" : " four-bars");
  };
  std::string text = fmt::format("{} holds {}", map_words(problem, solution), four_bars(counts.pairs - degenerate));
  text += degenerate_words(*solution.given.family, degenerate);
  text += fmt::format(". {} {} free of defects", four_bars(counts.defect_free), counts.defect_free == 1 ? "is" : "are");
  text += fmt::format("; {} {}: {}.", grouped_text(solution.meeting_requirements),
                      solution.meeting_requirements == 1 ? "meets the requirements" : "meet the requirements",
                      requirement_words(solution.requirements, problem.length_unit, solution.given.told_position()));
  return wrapped(text);
}

std::string best_heading(const Solution& solution) {
  switch (solution.options.objective) {
    case Objective::link_ratio:
      return "Best linkages, smallest link ratio first:\n";
    case Objective::size:
      return "Best linkages, smallest longest link first:\n";
    case Objective::structural_error:
      return "Best linkages, smallest structural error first:\n";
    case Objective::min_transmission_angle:
      break;
  }
  return "Best linkages, largest least transmission angle over the task (γ) first:\n";
}

std::string dimension_table(const std::vector<FourBarSolution>& linkages, int decimals) {
  TextTable table({"#", "<type", "<drive", "γ", "γ turn", "ratio", "ground", "input", "coupler", "output"});
  for (std::size_t i = 0; i < linkages.size(); ++i) {
    const DefectReport& report = linkages[i].report;
    std::vector<std::string> cells = {fmt::format("{}", i + 1), std::string(short_label(report.type)),
                                      drive_text(report), task_gamma(report), full_turn_gamma(report)};
    for (std::string& cell : length_cells(linkages[i].lengths, decimals)) cells.push_back(std::move(cell));
    table.add_row(std::move(cells));
  }
  return table.text();
}

/// Where linkages are told.
std::string first_pose(const Solution& solution) {
  if (solution.linkages.front().function) return "at the first pair";
  return fmt::format("in position {}", solution.given.told_position());
}

std::string pivot_table(const Solution& solution, int decimals) {
  const std::vector<FourBarSolution>& linkages = solution.linkages;
  TextTable table({"#", "input: fixed pivot", "moving pivot", "output: fixed pivot", "moving pivot"});
  for (std::size_t i = 0; i < linkages.size(); ++i) {
    const FourBar& bars = linkages[i].four_bar;
    table.add_row({fmt::format("{}", i + 1), pivot_text(bars.input_center, decimals),
                   pivot_text(bars.input_circle, decimals), pivot_text(bars.output_center, decimals),
                   pivot_text(bars.output_circle, decimals)});
  }
  return fmt::format("Pivots (x, y), moving pivots as they lie {}:\n", first_pose(solution)) + table.text();
}

std::string score_words(Objective objective, const FourBarSolution& found, int decimals) {
  switch (objective) {
    case Objective::link_ratio:
      return rounded_text(found.lengths.longest() / found.lengths.shortest(), 3);
    case Objective::size:
      return rounded_text(found.lengths.longest(), decimals);
    case Objective::structural_error:
      return significant_text(degrees(found.function ? found.function->max_structural_error.value_or(0) : 0), 3) + "°";
    case Objective::min_transmission_angle:
      break;
  }
  return rounded_text(degrees(found.report.min_transmission_angle), 2) + "°";
}

std::string why_the_best(const Problem& problem, const Solution& solution, int decimals) {
  const auto& linkages = solution.linkages;
  const Objective objective = solution.options.objective;
  constexpr std::array<std::string_view, 4> superlatives = {"largest least transmission angle", "smallest link ratio",
                                                            "smallest longest link", "smallest structural error"};
  const std::string_view what = superlatives[static_cast<std::size_t>(objective)];
  std::string text = fmt::format("Linkage 1 has the {}, {}", what, score_words(objective, linkages[0], decimals));
  if (linkages.size() > 1)
    text += fmt::format("; linkage 2 follows with {}", score_words(objective, linkages[1], decimals));
  const auto limits = limits_touched(solution.requirements, linkages[0], problem.length_unit);
  return wrapped(fmt::format("{}. It {}", text, held_back_words(limits)));
}

std::string check_words(const Solution& solution) {
  double worst = 0;
  std::optional<double> worst_of_derivatives;
  bool all_driven = true;
  for (const FourBarSolution& found : solution.linkages) {
    worst = std::max(worst, found.residual);
    worst_of_derivatives = std::max(worst_of_derivatives, found.residual_derivatives);
    all_driven = all_driven && found.verified_by_driving;
  }
  const bool are_functions = solution.linkages.front().function.has_value();
  const std::string of_derivatives = worst_of_derivatives ? fmt::format(", and their derivatives vanish to {}",
                                                                        significant_text(*worst_of_derivatives, 2))
                                                          : "";
  const std::string kept = are_functions
                               ? fmt::format("Driven through the range, {}", precision_words(solution))
                               : fmt::format("Side links keep their lengths over the positions to {} of themselves{}",
                                             significant_text(worst, 2), of_derivatives);
  return wrapped(
      fmt::format("{}; {}.", kept,
                  all_driven ? "driving every linkage listed through the task confirmed the table"
                             : "driving did not confirm every linkage listed, which is our mistake: please report it"));
}

std::string linkages_words(const Problem& problem, const Solution& solution) {
  if (solution.linkages.empty()) return "";
  const int decimals = decimals_for(solution.linkages);
  const std::string errors = function_error_words(solution) + miss_words(problem, solution);
  return "\n" + best_heading(solution) + dimension_table(solution.linkages, decimals) + "\n" +
         (errors.empty() ? "" : errors + "\n") + pivot_table(solution, decimals) + "\n" +
         why_the_best(problem, solution, decimals) + check_words(solution);
}

std::string nothing_words(const Problem& problem, const Solution& solution) {
  if (!solution.linkages.empty() || solution.options.best == 0) return "";
  std::string text = "\n" + wrapped(solution.reason.message);
  for (std::size_t i = 0; i < solution.relax.size(); ++i) {
    if (i == 0 && !solution.relax[i].value && !solution.relax[i].box)
      continue;  // the reason says what dropping it would leave
    text += wrapped("  " + relaxation_words(solution.relax[i], problem.length_unit), 4);
  }
  return text;
}

/// Told with the free numbers.
bool is_chosen_length(const Notice& notice) { return notice.code == "chosen_length"; }

std::string warnings_words(const Solution& solution) {
  std::string text;
  for (const Notice& warning : solution.given.warnings)
    if (!is_chosen_length(warning)) text += wrapped("Note: " + warning.message, 6);
  return text;
}

/// Three positions: what was chosen for the task, where it left a length open.
std::string chosen_words(const Solution& solution) {
  const auto& warnings = solution.given.warnings;
  const auto found = std::find_if(warnings.begin(), warnings.end(), is_chosen_length);
  if (found == warnings.end() || found->values.size() < 2) return "";
  const auto* side = std::get_if<std::string>(&found->values[0].value);
  const auto* length = std::get_if<double>(&found->values[1].value);
  if (side == nullptr || length == nullptr) return "";
  return fmt::format("; the {}'s length {} was chosen, the best of {} tried (give a length to see another)", *side,
                     significant_text(*length, 4), ChosenLength::rungs);
}

/// What the task leaves open: of three positions and of functions, where it depends on what is given.
std::string free_words(const Problem& problem, const Solution& solution) {
  if (!solution.given.family) return "";
  if (const auto* function = std::get_if<FunctionTask>(&problem.task)) {
    if (position_count(function->pairs) == 5) return "";
    return wrapped(function->free ? "2 numbers are free, and the map shows both: the coupler's place on its curve and "
                                    "the number left free."
                                  : "1 number is free: the coupler's place on its curve.");
  }
  const auto* motion = std::get_if<MotionTask>(&problem.task);
  if (motion == nullptr || !motion->given) return "";
  const std::string chosen = chosen_words(solution);
  const std::string_view shown = std::holds_alternative<SideLengths>(*motion->given)
                                     ? "the directions of the side links in position 1"
                                 : std::holds_alternative<SideAngle>(*motion->given)
                                     ? "the direction of the input side link and the length of the output"
                                     : "the places of the side links on their curve";
  return wrapped(chosen.empty() ? fmt::format("2 numbers are free, and the map shows both: {}.", shown)
                                : fmt::format("3 numbers are free, and the map shows 2 of them: {}{}.", shown, chosen));
}

}  // namespace

std::string answer(const Problem& problem, const Solution& solution) {
  Problem shown = problem;
  shown.length_unit = printable(shown.length_unit);
  if (std::holds_alternative<SixBarTask>(problem.task))
    return heading(shown, solution) + warnings_words(solution) + six_bar_answer(shown, solution);
  return heading(shown, solution) + curve_words(shown, solution) + free_words(shown, solution) +
         counts_words(shown, solution) + warnings_words(solution) + side_link_words(solution) +
         pair_words(shown, solution) + linkages_words(shown, solution) + nothing_words(shown, solution) +
         ways_out_words(shown, solution);
}

}  // namespace linkwright::cli
