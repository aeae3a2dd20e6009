#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <vector>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/label.hpp"
#include "linkwright/files/number_text.hpp"
#include "linkwright/files/task_label.hpp"
#include "report.hpp"
#include "text_table.hpp"

namespace linkwright::cli {
namespace {

using Found = std::vector<SphericalSolution>;

constexpr int angle_decimals = 2, axis_decimals = 4;

std::string cone_kind_words(const SphericalAnswer& answer) {
  if (!answer.given.curve) return "";
  return wrapped(fmt::format("Cone of moving axes: {}. Each of its axes is that of a dyad with one fixed axis.",
                             label(answer.given.curve->kind())));
}

std::string spherical_map_words(const Problem& problem, const SphericalAnswer& answer) {
  if (answer.counts.pairs == 0) return "";
  const RegionCounts& counts = answer.counts;
  const std::int64_t without = counts.types[static_cast<std::size_t>(LinkageType::degenerate)];
  const std::int64_t whole = counts.pairs - without;
  std::string text = fmt::format("The solution region of {} × {} pairs of dyads holds {} {}", answer.region.rows(),
                                 answer.region.columns(), grouped_text(whole),
                                 whole == 1 ? "spherical four-bar" : "spherical four-bars");
  if (without > 0)
    text += fmt::format(" and {} {} with a link of no length", grouped_text(without), without == 1 ? "pair" : "pairs");
  text += fmt::format(". {} {} free of defects; {} {}: {}.", grouped_text(counts.defect_free),
                      counts.defect_free == 1 ? "is" : "are", grouped_text(answer.meeting_requirements),
                      answer.meeting_requirements == 1 ? "meets the requirements" : "meet the requirements",
                      requirement_words(answer.requirements, linkages(problem.task), problem.length_unit));
  return wrapped(text);
}

std::string axis_text(Vector3 axis) {
  const auto number = [](double coordinate) { return fmt::format("{:>7}", rounded_text(coordinate, axis_decimals)); };
  return fmt::format("{} {} {}", number(axis.x), number(axis.y), number(axis.z));
}

/// Three and five positions: the dyads that there are.
std::string dyad_list(const SphericalAnswer& answer) {
  const auto& points = answer.given.points;
  if (points.empty()) return "";
  TextTable table({"#", "fixed axis (x, y, z)", "moving axis, position 1", "angle", "multiplicity", "condition"});
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SphericalDyad& dyad = points[i].dyad;
    table.add_row({fmt::format("{}", i + 1), axis_text(dyad.fixed_axis), axis_text(dyad.moving_axis),
                   angle_text(dyad.angle(), angle_decimals), fmt::format("{}", points[i].multiplicity),
                   significant_text(points[i].condition, 2)});
  }
  return "\nDyads of all positions:\n" + table.text();
}

/// Five positions that no linkage passes as required: what relaxing one of them comes to.
std::string relaxed_words(const SphericalMotionAnswer& answer) {
  if (answer.relaxed.empty()) return "";
  std::string text =
      "\nAlternatives, nearest first: four-bars through four of the positions that meet the requirements.\n";
  for (const RelaxedOrientation& way : answer.relaxed) {
    const std::string start = fmt::format("  Relax orientation {}: ", way.orientation + 1);
    if (!way.linkage) {
      text += wrapped(start + (way.reason ? way.reason->message : "nothing was found."), 4);
      continue;
    }
    const DefectReport& report = way.linkage->report;
    text += wrapped(
        fmt::format("{}the nearest four-bar{} is off by {}° ({}, γ {}).", start,
                    answer.requirements.no_defects ? " free of defects" : "",
                    significant_text(degrees(way.error.angle), 3), short_label(report.type), task_gamma(report)),
        4);
  }
  return text;
}

std::string best_spherical_heading(const SphericalAnswer& answer) {
  const SynthesisOptions& options = answer.options;
  if (const auto front = front_heading(answer)) return *front;
  if (options.at) return "The linkage there:\n";
  return best_heading("linkages", options.objective);
}

std::vector<std::string> angle_cells(const SphericalSolution& found) {
  const DefectReport& report = found.report;
  std::vector<std::string> cells = {std::string(short_label(report.type)), drive_text(report),
                                    report.defects.none() ? angle_text(report.sweep, 1) : "–", task_gamma(report),
                                    full_turn_gamma(report)};
  for (const double angle : {found.angles.ground, found.angles.input, found.angles.coupler, found.angles.output})
    cells.push_back(angle_text(angle, angle_decimals));
  return cells;
}

/// `first`: heads the column that names each.
std::string angle_table(const Found& all, const std::string& first, const std::vector<std::string>& names) {
  TextTable table({first, "<type", "<drive", "turns", "γ", "γ turn", "ground", "input", "coupler", "output"});
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::vector<std::string> row = angle_cells(all[i]);
    row.insert(row.begin(), names[i]);
    table.add_row(std::move(row));
  }
  return table.text();
}

/// Three and five positions: every pair, where more of them are known than are listed.
std::string pair_list(const SphericalAnswer& answer) {
  if (answer.pairs.size() <= answer.linkages.size()) return "";
  const auto number = [](const SphericalDyad& dyad) { return static_cast<int>(dyad.coordinate) + 1; };
  std::vector<std::string> names;
  for (const SphericalSolution& pair : answer.pairs)
    names.push_back(fmt::format("{}–{}", number(pair.input), number(pair.output)));
  return "\nAll pairs as four-bars, best first:\n" + angle_table(answer.pairs, "pair", names);
}

std::string axis_table(const Found& all) {
  TextTable table({"#", "<link", "fixed axis (x, y, z)", "moving axis, position 1"});
  for (std::size_t i = 0; i < all.size(); ++i) {
    const SphericalFourBar& bars = all[i].four_bar;
    table.add_row({fmt::format("{}", i + 1), "input", axis_text(bars.input_fixed), axis_text(bars.input_moving)});
    table.add_row({"", "output", axis_text(bars.output_fixed), axis_text(bars.output_moving)});
  }
  return "Axes, unit vectors:\n" + table.text();
}

std::string spherical_score(Objective objective, const SphericalSolution& found) {
  return angle_text(objective == Objective::link_angle ? found.angles.shortest() : found.report.min_transmission_angle,
                    angle_decimals);
}

std::string why_it_is_best(const SphericalAnswer& answer) {
  if (answer.options.at) return wrapped(answer.reason.message);
  if (answer.options.pareto) return "";
  const Objective objective = answer.options.objective;
  const auto score = [&](std::size_t i) {
    const auto by_analysis = analysis_score(answer, i, "");
    return by_analysis ? *by_analysis : spherical_score(objective, answer.linkages[i]);
  };
  std::string text = fmt::format("Linkage 1 has the {}, {}", superlative(objective), score(0));
  if (answer.linkages.size() > 1) text += fmt::format("; linkage 2 follows with {}", score(1));
  return wrapped(
      fmt::format("{}. It {}", text, held_back_words(limits_touched(answer.requirements, answer.linkages[0]))));
}

std::string spherical_check_words(const SphericalAnswer& answer) {
  double worst = 0;
  std::optional<double> of_derivatives;
  bool all_driven = true;
  for (const SphericalSolution& found : answer.linkages) {
    worst = std::max(worst, found.residual);
    of_derivatives = std::max(of_derivatives, found.residual_derivatives);
    all_driven = all_driven && found.verified_by_driving;
  }
  const std::string derivatives =
      of_derivatives ? fmt::format(", and their derivatives vanish to {}", significant_text(*of_derivatives, 2)) : "";
  return wrapped(fmt::format("The grounded links keep their angles over the orientations (the cosines to {}){}; {}.",
                             significant_text(worst, 2), derivatives,
                             all_driven ? "simulation of the motion verified every linkage listed"
                             : answer.options.at
                                 ? "simulation of the motion disagrees with the table: rounding decides what the "
                                   "linkage does there"
                                 : "simulation of the motion disagrees with the table, which is a bug: please "
                                   "report it"));
}

std::string no_spherical_words(const Problem& problem, const SphericalAnswer& answer) {
  if (answer.options.best == 0 && !answer.options.at) return "";
  std::string text = "\n" + wrapped(answer.reason.message);
  if (answer.options.at) return text;
  for (std::size_t i = 0; i < answer.relax.size(); ++i)
    if (i > 0 || answer.relax[i].value)  // of the first the reason says what dropping it would leave
      text += wrapped("  " + relaxation_words(answer.relax[i], problem.length_unit), 4);
  return text;
}

std::string found_words(const SphericalAnswer& answer) {
  return "\n" + best_spherical_heading(answer) + spherical_table(answer.linkages) + "\n" + axis_table(answer.linkages) +
         "\n" + why_it_is_best(answer) + spherical_check_words(answer);
}

/// To which side the links of a triple rocker swing; empty for other types.
std::string triple_rocker_words(TripleRockerKind kind) {
  constexpr std::array<std::string_view, 5> names = {"", "00", "0π", "π0", "ππ"};
  if (kind == TripleRockerKind::none) return "";
  const bool input_away = kind == TripleRockerKind::pi_zero || kind == TripleRockerKind::pi_pi;
  const bool output_towards = kind == TripleRockerKind::zero_pi || kind == TripleRockerKind::pi_pi;
  return fmt::format(
      " Sub-class {}: the input swings on the side {} the output's fixed axis, the output on the side {} the input's.",
      names[static_cast<std::size_t>(kind)], input_away ? "away from" : "towards",
      output_towards ? "towards" : "away from");
}

std::string spherical_type_words(const StoredSphericalAnalysis& analysis) {
  const std::string text = fmt::format("Type: {}", label(analysis.type));
  if (analysis.type == LinkageType::change_point)
    return wrapped(text + ". All four axes can lie in one plane, where the linkage may change its assembly mode.");
  return wrapped(text + (is_grashof(analysis.type) ? " (Grashof: a link turns fully with respect to the others)."
                                                   : " (not Grashof: no link turns fully with respect to the others)." +
                                                         triple_rocker_words(analysis.triple_rocker)));
}

std::string spherical_range_words(const StoredSphericalAnalysis& analysis) {
  const AngleRange& range = analysis.input_range;
  if (range.is_full_turn())
    return wrapped(analysis.dead_points.empty()
                       ? "The input turns fully; it has no dead points."
                       : "The input turns fully, through dead points where all axes lie in one plane.");
  return wrapped(
      fmt::format("The input rocks from {} to {} ({}), measured about its fixed axis from the arc between "
                  "the fixed axes.",
                  angle_text(range.from), angle_text(range.to), angle_text(range.to - range.from)));
}

std::string spherical_dead_points(const StoredSphericalAnalysis& analysis) {
  if (analysis.dead_points.empty()) return "";
  TextTable table({"dead point:", "input", "output", "<coupler and output link"});
  for (const SphericalDeadPoint& dead : analysis.dead_points)
    table.add_row({"", angle_text(wrap_signed(dead.configuration.input_angle)),
                   angle_text(wrap_signed(dead.configuration.output_angle)), dead.extended ? "stretched" : "folded"});
  return table.text();
}

std::string ratio_words(const StoredSphericalAnalysis& analysis) {
  if (!analysis.velocity_ratio) return "The position given is a dead point: the velocity ratio is undefined there.\n";
  std::string text = fmt::format("The output turns {} times as fast as the input in the position given",
                                 rounded_text(*analysis.velocity_ratio, 3));
  if (!analysis.velocity_ratios) return wrapped(text + ".");  // unbounded next to dead points
  return wrapped(fmt::format("{}, {} to {} over the turn.", text, rounded_text(analysis.velocity_ratios->least, 3),
                             rounded_text(analysis.velocity_ratios->most, 3)));
}

std::string met_words(const StoredSphericalAnalysis& analysis) {
  const std::size_t given = analysis.linkage.orientations.size();
  if (given < 2) return "";
  const std::string missed = missed_words(analysis.linkage);
  return missed.empty() ? wrapped(fmt::format("It meets all {} orientations of the file.", given)) : missed;
}

std::string own_axes(const SphericalFourBar& bars) {
  TextTable table({"<axis", "x, y, z"});
  table.add_row({"input, fixed", axis_text(bars.input_fixed)});
  table.add_row({"input, moving", axis_text(bars.input_moving)});
  table.add_row({"output, moving", axis_text(bars.output_moving)});
  table.add_row({"output, fixed", axis_text(bars.output_fixed)});
  return table.text();
}

std::string generator_counts(const Problem& problem, const SphericalFunctionAnswer& answer) {
  const RegionCounts& counts = answer.counts;
  if (counts.pairs == 0) return "";
  const std::int64_t whole = counts.pairs - counts.types[static_cast<std::size_t>(LinkageType::degenerate)];
  return wrapped(fmt::format("{} holds {} spherical four-bars. {} are free of defects; {} meet the requirements: {}.",
                             function_map_words(*answer.family(), answer.region), grouped_text(whole),
                             grouped_text(counts.defect_free), grouped_text(answer.meeting_requirements),
                             requirement_words(answer.requirements, linkages(problem.task), problem.length_unit)));
}

}  // namespace

std::string spherical_table(const std::vector<SphericalSolution>& all) {
  std::vector<std::string> numbers;
  for (std::size_t i = 0; i < all.size(); ++i) numbers.push_back(fmt::format("{}", i + 1));
  return angle_table(all, "#", numbers);
}

std::string spherical_report(const Problem& problem, const SphericalMotionAnswer& answer) {
  return cone_kind_words(answer) + spherical_map_words(problem, answer) + dyad_list(answer) + pair_list(answer) +
         (answer.linkages.empty() ? no_spherical_words(problem, answer) : found_words(answer)) + relaxed_words(answer);
}

std::string spherical_words(const StoredSphericalAnalysis& analysis, std::string_view drive) {
  const std::string title =
      analysis.linkage.title.empty() ? "Spherical four-bar linkage" : printable(analysis.linkage.title);
  const LinkAngles& angles = analysis.angles;
  TextTable table({"ground", "input", "coupler", "output"});
  table.add_row({angle_text(angles.ground, 3), angle_text(angles.input, 3), angle_text(angles.coupler, 3),
                 angle_text(angles.output, 3)});
  return wrapped(title + (drive == "output" ? ", driven by the file's output link (called input here)"
                                            : ", driven by its input link")) +
         "Angles of the links:\n" + table.text() + "Axes, unit vectors:\n" + own_axes(analysis.linkage.four_bar) +
         spherical_type_words(analysis) + spherical_range_words(analysis) + spherical_dead_points(analysis) +
         transmission_words(analysis, analysis.min_transmission_angle) + ratio_words(analysis) + met_words(analysis);
}

std::string spherical_function_report(const Problem& problem, const SphericalFunctionAnswer& answer) {
  std::string text = generator_counts(problem, answer);
  if (!answer.pairs.empty())
    text += "\nAll linkages that satisfy the five precision points, best first:\n" + spherical_table(answer.pairs);
  if (answer.linkages.empty()) return text + "\n" + wrapped(answer.reason.message);
  const std::string errors = function_error_words(answer);
  return text + "\n" + best_spherical_heading(answer) + spherical_table(answer.linkages) +
         (errors.empty() ? "" : "\n" + errors) + "\n" + wrapped("Linkages listed: " + precision_words(answer) + ".");
}

}  // namespace linkwright::cli
