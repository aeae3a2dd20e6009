#include "answer.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <vector>

#include "linkwright/core/angle.hpp"
#include "linkwright/io/label.hpp"
#include "linkwright/io/number_text.hpp"
#include "requirement_words.hpp"
#include "text_table.hpp"

namespace linkwright::cli {
namespace {

double gamma_deg(double worst_cosine) { return degrees(std::acos(std::min(1.0, std::abs(worst_cosine)))); }

std::string task_gamma(const DefectReport& report) {
  return report.defects.none() ? rounded_text(gamma_deg(report.worst_transmission_cosine), 1) + "°" : "–";
}

std::string full_turn_gamma(const DefectReport& report) {
  return input_is_crank(report.type) ? rounded_text(gamma_deg(report.worst_transmission_cosine_full_turn), 1) + "°"
                                     : "–";
}

/// The sense in which it is driven, or the defect that forbids it.
std::string drive_text(const DefectReport& report) {
  if (report.defects.circuit()) return "no: circuit";
  if (report.defects.branch()) return "no: branch";
  return report.defects.order() ? "no: order" : std::string(name(report.sense));
}

std::string heading(const Problem& problem, const Solution& solution) {
  const std::string title = problem.title.empty() ? "Untitled task" : printable(problem.title);
  std::string text = fmt::format("{}: four positions ({})", title, solution.given.pattern);
  if (!problem.length_unit.empty()) text += ", lengths in " + printable(problem.length_unit);
  return wrapped(text);
}

std::string curve_words(const Solution& solution) {
  if (!solution.given.curve) return "";
  const std::string_view circle = label(solution.given.curve->kind()),
                         center = label(solution.given.curve->center_kind());
  std::string text = circle == center
                         ? fmt::format("Both Burmester curves, of circle points and of centre points: {}", circle)
                         : fmt::format("Circle-point curve: {}; centre-point curve: {}", circle, center);
  if (const auto kappa = solution.given.curve->kappa()) text += fmt::format(" (κ = {})", significant_text(*kappa, 3));
  return wrapped(text + ".");
}

std::string counts_words(const Problem& problem, const Solution& solution) {
  const RegionCounts& counts = solution.counts;
  if (counts.pairs == 0) return "";
  const std::int64_t degenerate = counts.types[static_cast<std::size_t>(LinkageType::degenerate)];
  std::string text = fmt::format("The region of {0} × {0} pairs of side links holds {1} four-bars",
                                 solution.region.rows(), grouped_text(counts.pairs - degenerate));
  if (degenerate > 0) text += fmt::format(" and {} sliders or zero links", grouped_text(degenerate));
  text += fmt::format(". {} four-bars are free of defects", grouped_text(counts.defect_free));
  text += fmt::format("; {} {}: {}.", grouped_text(solution.meeting_requirements),
                      solution.meeting_requirements == 1 ? "meets the requirements" : "meet the requirements",
                      requirement_words(solution.requirements, problem.length_unit));
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

int decimals_for(const std::vector<FourBarSolution>& linkages) {
  double longest = 0;
  for (const FourBarSolution& found : linkages) longest = std::max(longest, found.lengths.longest());
  return std::min(length_decimals(longest), 9);
}

std::string dimension_table(const std::vector<FourBarSolution>& linkages, int decimals) {
  TextTable table({"#", "<type", "<drive", "γ", "γ turn", "ratio", "ground", "input", "coupler", "output"});
  for (std::size_t i = 0; i < linkages.size(); ++i) {
    const FourBarSolution& found = linkages[i];
    const LinkLengths& lengths = found.lengths;
    table.add_row({fmt::format("{}", i + 1), std::string(short_label(found.report.type)), drive_text(found.report),
                   task_gamma(found.report), full_turn_gamma(found.report),
                   rounded_text(lengths.longest() / lengths.shortest(), 2), rounded_text(lengths.ground, decimals),
                   rounded_text(lengths.input, decimals), rounded_text(lengths.coupler, decimals),
                   rounded_text(lengths.output, decimals)});
  }
  return table.text();
}

std::string pivot_table(const std::vector<FourBarSolution>& linkages, int decimals) {
  TextTable table({"#", "input: fixed pivot", "moving pivot", "output: fixed pivot", "moving pivot"});
  const auto pivot = [&](Point p) {
    return fmt::format("{}, {}", rounded_text(p.real(), decimals), rounded_text(p.imag(), decimals));
  };
  for (std::size_t i = 0; i < linkages.size(); ++i) {
    const FourBar& bars = linkages[i].four_bar;
    table.add_row({fmt::format("{}", i + 1), pivot(bars.input_center), pivot(bars.input_circle),
                   pivot(bars.output_center), pivot(bars.output_circle)});
  }
  return "Pivots (x, y), moving pivots as they lie in position 1:\n" + table.text();
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
  return rounded_text(gamma_deg(found.report.worst_transmission_cosine), 2) + "°";
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
  if (limits.empty()) return wrapped(text + ". It touches no limit: none of them holds it back.");
  text += ". It lies at a limit that holds it back: ";
  for (std::size_t i = 0; i < limits.size(); ++i) text += (i == 0 ? "" : "; ") + limits[i];
  return wrapped(text + ".");
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
  const std::string of_derivatives = worst_of_derivatives ? fmt::format(", and their derivatives vanish to {}",
                                                                        significant_text(*worst_of_derivatives, 2))
                                                          : "";
  return wrapped(
      fmt::format("Side links keep their lengths over the positions to {} of themselves{}; {}.",
                  significant_text(worst, 2), of_derivatives,
                  all_driven ? "driving every linkage listed through the task confirmed the table"
                             : "driving did not confirm every linkage listed, which is our mistake: please report it"));
}

std::string linkages_words(const Problem& problem, const Solution& solution) {
  if (solution.linkages.empty()) return "";
  const int decimals = decimals_for(solution.linkages);
  return "\n" + best_heading(solution) + dimension_table(solution.linkages, decimals) + "\n" +
         pivot_table(solution.linkages, decimals) + "\n" + why_the_best(problem, solution, decimals) +
         check_words(solution);
}

std::string nothing_words(const Problem& problem, const Solution& solution) {
  if (!solution.linkages.empty() || solution.options.best == 0) return "";
  std::string text = "\n" + wrapped(solution.reason.message);
  for (const Relaxation& relaxation : solution.relax) {
    text += wrapped("  " + relaxation_words(relaxation, problem.length_unit), 4);
  }
  return text;
}

std::string warnings_words(const Solution& solution) {
  std::string text;
  for (const Notice& warning : solution.given.warnings) text += wrapped("Note: " + warning.message, 6);
  return text;
}

}  // namespace

std::string answer(const Problem& problem, const Solution& solution) {
  Problem shown = problem;
  shown.length_unit = printable(shown.length_unit);
  return heading(shown, solution) + curve_words(solution) + counts_words(shown, solution) + warnings_words(solution) +
         linkages_words(shown, solution) + nothing_words(shown, solution);
}

}  // namespace linkwright::cli
