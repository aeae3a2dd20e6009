#include "report.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <vector>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/label.hpp"
#include "linkwright/files/length_unit.hpp"
#include "linkwright/files/number_text.hpp"
#include "linkwright/files/task_label.hpp"
#include "text_table.hpp"

namespace linkwright::cli {
namespace {

/// ": 4 Burmester points", where it is they that the task asks for.
std::string point_count(const FourBarAnswer& answer) {
  const std::size_t count = answer.given.points.size();
  if (answer.given.curve || (count == 0 && !answer.given.has_no_dyads)) return "";
  return count == 0 ? ": no Burmester point" : fmt::format(": {} Burmester point{}", count, count == 1 ? "" : "s");
}

std::string crank_count(const PathAnswer& answer) {
  const std::size_t count = answer.given.points.size();
  if (answer.task.form() != PathForm::cranks || answer.given.curve || (count == 0 && !answer.given.has_no_dyads))
    return "";
  return count == 0 ? ": no crank" : fmt::format(": {} crank{}", count, count == 1 ? "" : "s");
}

std::string heading(const Problem& problem, const std::string& points) {
  const std::string title = problem.title.empty() ? "Untitled task" : printable(problem.title);
  std::string text = fmt::format("{}: {}{}", title, task_label(problem.task), points);
  if (!problem.length_unit.empty()) text += ", lengths in " + spoken_unit(printable(problem.length_unit));
  return wrapped(text);
}

/// What the two curves of a task are called.
struct CurveNames {
  std::string_view both = "Both Burmester curves, of circle points and of centre points", circle = "Circle-point curve",
                   center = "centre-point curve";
};
constexpr CurveNames crank_curves = {
    "Both curves of the cranks, of their ground pivots and of where the point is seen "
    "from them",
    "Curve of the point seen from the cranks", "of their ground pivots"};
constexpr CurveNames coupler_curves = {"Both curves of the coupler, of its pivots on the input and on the output",
                                       "Curve of pivots on the input", "of pivots on the output"};

std::string curve_words(const FourBarAnswer& answer, const CurveNames& names) {
  if (!answer.given.curve) return "";
  const std::string_view circle = label(answer.given.curve->kind()), center = label(answer.given.curve->center_kind());
  std::string text = circle == center ? fmt::format("{}: {}", names.both, circle)
                                      : fmt::format("{}: {}; {}: {}", names.circle, circle, names.center, center);
  if (const auto kappa = answer.given.curve->kappa()) text += fmt::format(" (κ = {})", significant_text(*kappa, 3));
  return wrapped(text + ".");
}

/// Where the four-bars lie that are counted.
std::string map_words(const MotionAnswer& answer) {
  const MapAxis& axis = answer.family()->axis(Side::output);
  if (answer.task.is_fitted()) return "The list of the nearest linkages";
  if (axis.quantity == AxisQuantity::nothing) return "What is given";
  const bool is_plane = axis.quantity == AxisQuantity::center_x || axis.quantity == AxisQuantity::circle_x;
  const std::string_view map = is_plane             ? "The solution region of {} × {} places of the pivot"
                               : axis.is_discrete() ? "The solution region of {} × {} dyads"
                                                    : "The solution region of {} × {} pairs of dyads";
  return fmt::format(fmt::runtime(map), answer.region.rows(), answer.region.columns());
}

std::string map_words(const FunctionAnswer& answer) { return function_map_words(*answer.family(), answer.region); }

std::string map_words(const PathAnswer& answer) {
  const auto of = [&](std::string_view what) {
    return fmt::format("The solution region of {} × {} {}", answer.region.rows(), answer.region.columns(), what);
  };
  switch (answer.task.form()) {
    case PathForm::cranks:
      return of("cranks");
    case PathForm::arms:
      return of("arms");
    case PathForm::ground_pivot:
    case PathForm::other_pivot:
      return of("places of the pivot");
    case PathForm::nearest:
      return answer.task.map == NearestMap::pivots ? of("places of the pivot")
                                                   : "The nearest paths: the solution region";
    case PathForm::curve_of_arms:
      return fmt::format("The solution region of {} input links and {} linkages of each", answer.region.rows(),
                         answer.region.columns());
    default:
      return "What is given";
  }
}

/// Pairs of one curve always make something; elsewhere a cell may have no dyads at all.
std::string degenerate_words(const FourBarFamily& family, std::int64_t count) {
  if (count == 0) return "";
  if (family.is_symmetric()) return fmt::format(" and {} sliders or zero links", grouped_text(count));
  return fmt::format(", and none in {} {}", grouped_text(count), count == 1 ? "cell" : "cells");
}

std::string counts_words(const Problem& problem, const FourBarAnswer& answer, const std::string& map) {
  const RegionCounts& counts = answer.counts;
  const std::int64_t degenerate = counts.types[static_cast<std::size_t>(LinkageType::degenerate)];
  const auto four_bars = [](std::int64_t count) {
    return grouped_text(count) + (count == 1 ? " four-bar" : " four-bars");
  };
  std::string text = fmt::format("{} holds {}", map, four_bars(counts.pairs - degenerate));
  text += degenerate_words(*answer.given.family, degenerate);
  text += fmt::format(". {} {} free of defects", four_bars(counts.defect_free), counts.defect_free == 1 ? "is" : "are");
  text += fmt::format("; {} {}: {}.", grouped_text(answer.meeting_requirements),
                      answer.meeting_requirements == 1 ? "meets the requirements" : "meet the requirements",
                      requirement_words(answer.requirements, linkages(problem.task), problem.length_unit,
                                        answer.given.reference_position()));
  return wrapped(text);
}

std::string heading_of_best(const FourBarAnswer& answer) {
  if (answer.options.at) return "The linkage there:\n";
  if (const auto front = front_heading(answer)) return *front;
  return best_heading("linkages", answer.options.objective);
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

/// The position in which linkages are given.
std::string first_pose(const FourBarAnswer& answer) {
  if (answer.linkages.front().function) return "at the first pair";
  return fmt::format("in position {}", answer.given.reference_position());
}

std::string pivot_table(const FourBarAnswer& answer, int decimals) {
  const std::vector<FourBarSolution>& linkages = answer.linkages;
  TextTable table({"#", "input: fixed pivot", "moving pivot", "output: fixed pivot", "moving pivot"});
  for (std::size_t i = 0; i < linkages.size(); ++i) {
    const FourBar& bars = linkages[i].four_bar;
    table.add_row({fmt::format("{}", i + 1), pivot_text(bars.input_fixed, decimals),
                   pivot_text(bars.input_moving, decimals), pivot_text(bars.output_fixed, decimals),
                   pivot_text(bars.output_moving, decimals)});
  }
  return fmt::format("Pivots (x, y), moving pivots as they lie {}:\n", first_pose(answer)) + table.text();
}

std::string score_words(const SynthesisOptions& options, const FourBarSolution& found, int decimals) {
  const CurveError error = found.fit ? found.fit->error : CurveError{};
  switch (options.objective) {
    case Objective::link_ratio:
      return rounded_text(found.lengths.longest() / found.lengths.shortest(), 3);
    case Objective::size:
      return rounded_text(found.lengths.longest(), decimals);
    case Objective::path_error:
      return options.fit.measure == FitMeasure::least_largest ? significant_text(error.max, 4) + " (largest)"
                                                              : significant_text(error.rms, 4) + " (root mean square)";
    case Objective::near_error:
      return significant_text(found.near ? found.near->error.rms : 0, 4) + " (root mean square)";
    case Objective::structural_error:
      return significant_text(degrees(found.function ? found.function->max_structural_error.value_or(0) : 0), 3) + "°";
    default:
      break;
  }
  return rounded_text(degrees(found.report.min_transmission_angle), 2) + "°";
}

std::string why_the_best(const Problem& problem, const FourBarAnswer& answer, int decimals) {
  if (answer.options.at) return wrapped(answer.reason.message);
  if (answer.options.pareto) return "";
  const auto& linkages = answer.linkages;
  const Objective objective = answer.options.objective;
  const auto score = [&](std::size_t i) {
    const auto by_analysis = analysis_score(answer, i, problem.length_unit);
    return by_analysis ? *by_analysis : score_words(answer.options, linkages[i], decimals);
  };
  std::string text = fmt::format("Linkage 1 has the {}, {}", superlative(objective), score(0));
  if (linkages.size() > 1) text += fmt::format("; linkage 2 follows with {}", score(1));
  const auto limits = limits_touched(answer.requirements, linkages[0], problem.length_unit);
  return wrapped(fmt::format("{}. It {}", text, held_back_words(limits)));
}

std::string check_words(const FourBarAnswer& answer) {
  double worst = 0;
  std::optional<double> worst_of_derivatives;
  bool all_driven = true;
  for (const FourBarSolution& found : answer.linkages) {
    worst = std::max(worst, found.residual);
    worst_of_derivatives = std::max(worst_of_derivatives, found.residual_derivatives);
    all_driven = all_driven && found.verified_by_driving;
  }
  const bool are_functions = answer.linkages.front().function.has_value();
  const std::string of_derivatives = worst_of_derivatives ? fmt::format(", and their derivatives vanish to {}",
                                                                        significant_text(*worst_of_derivatives, 2))
                                                          : "";
  const std::string kept =
      are_functions ? fmt::format("In simulation over the range, {}", precision_words(answer))
                    : fmt::format("The grounded links keep their lengths over the positions to a relative {}{}",
                                  significant_text(worst, 2), of_derivatives);
  return wrapped(fmt::format("{}; {}.", kept,
                             all_driven ? "simulation of the motion verified every linkage listed"
                             : answer.options.at
                                 ? "simulation of the motion disagrees with the table: rounding decides what "
                                   "the linkage does there"
                                 : "simulation of the motion disagrees with the table, which is a bug: please "
                                   "report it"));
}

std::string linkages_words(const Problem& problem, const FourBarAnswer& answer) {
  if (answer.linkages.empty()) return "";
  const int decimals = decimals_for(answer.linkages);
  const std::string errors = function_error_words(answer) + pose_error_words(problem, answer);
  return "\n" + heading_of_best(answer) + dimension_table(answer.linkages, decimals) + "\n" +
         (errors.empty() ? "" : errors + "\n") + pivot_table(answer, decimals) + "\n" +
         why_the_best(problem, answer, decimals) + check_words(answer);
}

std::string nothing_words(const Problem& problem, const FourBarAnswer& answer) {
  if (!answer.linkages.empty() || (answer.options.best == 0 && !answer.options.at)) return "";
  std::string text = "\n" + wrapped(answer.reason.message);
  if (answer.options.at) return text;
  for (std::size_t i = 0; i < answer.relax.size(); ++i) {
    if (i == 0 && !answer.relax[i].value && !answer.relax[i].box)
      continue;  // the reason says what dropping it would leave
    text += wrapped("  " + relaxation_words(answer.relax[i], problem.length_unit), 4);
  }
  return text;
}

/// Reported with the free parameters.
bool is_chosen_length(const Notice& notice) { return notice.code == "chosen_length"; }

std::string warnings_words(const Findings& answer) {
  const std::string inside = found_inside_text(answer);
  std::string text = inside.empty() ? "" : wrapped("Note: " + inside, 6);
  for (const Notice& warning : answer.warnings)
    if (!is_chosen_length(warning)) text += wrapped("Note: " + warning.message, 6);
  return text;
}

/// Three positions: what was chosen for the task, where it left a length open.
std::string chosen_words(const FourBarAnswer& answer) {
  const auto& warnings = answer.warnings;
  const auto found = std::find_if(warnings.begin(), warnings.end(), is_chosen_length);
  if (found == warnings.end() || found->values.size() < 3) return "";
  const auto* side = std::get_if<std::string>(&found->values[0].value);
  const auto* length = std::get_if<double>(&found->values[1].value);
  const auto* tried = std::get_if<double>(&found->values[2].value);
  if (side == nullptr || length == nullptr || tried == nullptr) return "";
  return fmt::format(
      "; the length {1} of the {0} link was chosen, the best of {2:g} tried (give a length to get another)", *side,
      significant_text(*length, 4), *tried);
}

/// What the task leaves open: of three positions and of functions, where it depends on what is given.
std::string free_words(const MotionAnswer& answer) {
  if (!answer.family() || !answer.task.given) return "";
  const std::string chosen = chosen_words(answer);
  const std::string_view shown = std::holds_alternative<SideLengths>(*answer.task.given)
                                     ? "the directions of the grounded links in position 1"
                                 : std::holds_alternative<SideAngle>(*answer.task.given)
                                     ? "the direction of the input link and the length of the output link"
                                     : "the positions of the dyads on their curve";
  return wrapped(chosen.empty() ? fmt::format("2 parameters are free, the axes of the solution region: {}.", shown)
                                : fmt::format("3 parameters are free, 2 of them the axes of the solution region: {}{}.",
                                              shown, chosen));
}

std::string free_words(const FunctionAnswer& answer) { return function_free_words(answer.family(), answer.task); }

/// How many linkages stand at a place, and which of them a cell shows.
std::string layer_words(const PathTask& task) {
  const auto is_plain = [](const PathPoint& point) { return point.is_plain(); };
  const auto plain = std::count_if(task.points.begin(), task.points.end(), is_plain);
  return fmt::format(
      "At each place the elbow can stand in {} ways, with {} to each; a cell shows the best linkage of its "
      "place.",
      std::size_t{1} << plain, task.pivots.count() == 2 ? "one linkage" : "one or three linkages");
}

std::string arm_free_words(const PathTask& task) {
  constexpr std::string_view two = "2 parameters are free, the axes of the solution region: ";
  switch (task.form()) {
    case PathForm::ground_pivot:
      return fmt::format("{}the place of the input link's ground pivot, which leaves one arm to the point. {}", two,
                         layer_words(task));
    case PathForm::other_pivot:
      return fmt::format("{}the place of the {} link's ground pivot.", two, task.pivots.input ? "output" : "input");
    case PathForm::curve_of_arms:
      return "1 parameter is free, the rows of the solution region: the position of the input link on its curve. Its "
             "columns are the linkages to each: the elbow can stand in two ways, with one or three linkages to each.";
    case PathForm::few:
      return "No parameter is free.";
    case PathForm::nearest:
      if (task.map == NearestMap::pivots)
        return fmt::format("{}the place of the input link's ground pivot, at each the nearest path from there.", two);
      return "The rows of the solution region are the nearest paths that were found, its columns the three four-bars "
             "that trace each.";
    default:
      return fmt::format("{}the lengths of the {} and of the arm from it to the point. {}", two,
                         task.pivots.input ? "crank" : "output link", layer_words(task));
  }
}

std::string free_words(const PathAnswer& answer) {
  if (!answer.family()) return "";
  if (answer.task.form() != PathForm::cranks) return wrapped(arm_free_words(answer.task));
  if (!answer.given.curve) return "";
  return wrapped(
      "2 parameters are free, the axes of the solution region: the positions of the crank and of its "
      "cognate's crank on their curve.");
}

/// The map is spoken of only where there is one.
template <class KindAnswer>
std::string counts_of(const Problem& problem, const KindAnswer& answer) {
  return answer.counts.pairs == 0 ? "" : counts_words(problem, answer, map_words(answer));
}

std::string report_of_kind(const Problem& problem, const MotionAnswer& answer) {
  return heading(problem, point_count(answer)) + curve_words(answer, {}) + free_words(answer) +
         counts_of(problem, answer) + warnings_words(answer) + dyad_words(answer) +
         pair_words(answer, "Their pairs as four-bars, the first dyad the input link, best first:\n") +
         linkages_words(problem, answer) + near_table(problem, answer) + nothing_words(problem, answer) +
         ways_out_words(problem, answer);
}

std::string report_of_kind(const Problem& problem, const FunctionAnswer& answer) {
  return heading(problem, point_count(answer)) + curve_words(answer, coupler_curves) + free_words(answer) +
         counts_of(problem, answer) + warnings_words(answer) + dyad_words(answer) +
         pair_words(answer, "All linkages that satisfy the five precision points, best first:\n") +
         linkages_words(problem, answer) + nothing_words(problem, answer);
}

std::string report_of_kind(const Problem& problem, const PathAnswer& answer) {
  return heading(problem, crank_count(answer)) + curve_words(answer, crank_curves) + free_words(answer) +
         counts_of(problem, answer) + warnings_words(answer) + crank_words(answer) +
         pair_words(answer, answer.task.form() == PathForm::cranks
                                ? "All linkages, by their own crank and their cognate's, best first:\n"
                                : "All linkages, best first:\n") +
         linkages_words(problem, answer) + path_table(problem, answer) + nothing_words(problem, answer);
}

std::string report_of_kind(const Problem& problem, const SphericalMotionAnswer& answer) {
  return heading(problem, "") + warnings_words(answer) + spherical_report(problem, answer);
}

std::string report_of_kind(const Problem& problem, const SphericalFunctionAnswer& answer) {
  return heading(problem, "") + function_free_words(answer.family(), answer.task) + warnings_words(answer) +
         spherical_function_report(problem, answer);
}

std::string report_of_kind(const Problem& problem, const StraightLineAnswer& answer) {
  return heading(problem, "") + warnings_words(answer) + straight_line_report(problem, answer);
}

std::string report_of_kind(const Problem& problem, const SixBarAnswer& answer) {
  return heading(problem, "") + warnings_words(answer) + six_bar_report(problem, answer);
}

}  // namespace

std::optional<std::string> front_heading(const Findings& found) {
  if (!found.options.pareto || found.options.at) return std::nullopt;
  const auto words = [](Objective objective) {
    std::string text(name(objective));
    std::replace(text.begin(), text.end(), '_', ' ');
    return text;
  };
  return wrapped(fmt::format(
      "Linkages that no other beats in both {} and {}: {} on the map; some of them:", words((*found.options.pareto)[0]),
      words((*found.options.pareto)[1]), grouped_text(static_cast<std::int64_t>(found.pareto.size()))));
}

std::string best_heading(std::string_view what, Objective objective) {
  const std::string_view over = objective == Objective::min_transmission_angle ? " over the task (γ)" : "";
  return fmt::format("Best {}, {}{} first:\n", what, superlative(objective), over);
}

std::string report(const Problem& problem, const Answer& answer) {
  Problem shown = problem;
  shown.length_unit = printable(shown.length_unit);
  return std::visit([&](const auto& of_kind) { return report_of_kind(shown, of_kind); }, answer) +
         tolerance_table(shown, findings(answer)) + loads_table(findings(answer));
}

}  // namespace linkwright::cli
