#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <vector>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/count_text.hpp"
#include "linkwright/files/label.hpp"
#include "linkwright/files/number_text.hpp"
#include "report.hpp"
#include "text_table.hpp"

namespace linkwright::cli {
namespace {

constexpr int error_digits = 3;
// A parameter is worth tightening from this share of the variance on, and does not matter up to the other.
constexpr double worth_tightening = 0.25, does_not_matter = 0.01;

std::string with_unit(double length, std::string_view unit) {
  const std::string number = significant_text(length, error_digits);
  return unit.empty() ? number : fmt::format("{} {}", number, unit);
}

std::string error_text(const ToleranceReport& report, double error, std::string_view unit) {
  return report.of_angle ? significant_text(degrees(error), error_digits) + "°" : with_unit(error, unit);
}

std::string percent(double share, int digits = 3) { return significant_text(100 * share, digits) + " %"; }

// Nothing is certain of what was never seen: shares next to 1 keep the digits in which they differ from it.
std::string yield_text(const CountedShare& yield) {
  return yield.share < 0.99 ? percent(yield.share) : percent(yield.share, 5);
}

std::string yield_cell(const ToleranceReport& report) {
  return report.sampled.yield ? yield_text(*report.sampled.yield) : "–";
}

std::string half_tolerance_text(double tolerance, bool is_angle, std::string_view unit) {
  return "± " + (is_angle ? significant_text(degrees(tolerance), error_digits) + "°" : with_unit(tolerance, unit));
}

std::string limit_text(const ToleranceLimit& limit, std::string_view unit) {
  switch (limit.kind) {
    case ToleranceLimit::Kind::angle:
      return significant_text(degrees(limit.value), error_digits) + "°";
    case ToleranceLimit::Kind::deviation:
      return with_unit(limit.value, unit) + " of the line";
    case ToleranceLimit::Kind::position:
      break;
  }
  return with_unit(limit.value, unit);
}

std::string_view distribution_words(ToleranceDistribution distribution) {
  switch (distribution) {
    case ToleranceDistribution::uniform:
      return "evenly spread";
    case ToleranceDistribution::truncated_normal:
      return "normal, cut off at the tolerances";
    case ToleranceDistribution::normal:
      break;
  }
  return "normal, half tolerance = 3σ";
}

std::string lengths_text(const LengthTolerances& of, std::string_view unit) {
  if (of == LengthTolerances::all(of.input))
    return of.input > 0 ? fmt::format("lengths ± {}", with_unit(of.input, unit)) : "";
  std::string text;
  for (const auto& [name, half] :
       {std::pair("input", of.input), std::pair("coupler", of.coupler), std::pair("output", of.output),
        std::pair("fixed pivots", of.ground_pivots), std::pair("point", of.point)})
    if (half > 0) text += fmt::format("{}{} ± {}", text.empty() ? "" : ", ", name, with_unit(half, unit));
  return text;
}

std::string given_words(const Tolerances& of, std::string_view unit) {
  std::vector<std::string> given;
  if (auto lengths = lengths_text(of.length, unit); !lengths.empty()) given.push_back(std::move(lengths));
  if (of.clearance > 0) given.push_back(fmt::format("clearance {}", with_unit(of.clearance, unit)));
  if (of.link_angle > 0) given.push_back(fmt::format("link angles {}", half_tolerance_text(of.link_angle, true, "")));
  if (of.driver > 0) given.push_back(fmt::format("driver {}", half_tolerance_text(of.driver, true, "")));
  std::string text;
  for (const std::string& part : given) text += (text.empty() ? "" : ", ") + part;
  return fmt::format("{}; {}", text, distribution_words(of.distribution));
}

std::string_view error_words(const Task& task) {
  switch (output_kind(task)) {
    case OutputKind::line:
      return "largest 3σ off the line over the stroke";
    case OutputKind::angle:
      return "root mean square of the output's angle over the pairs";
    case OutputKind::turn:
      return "root mean square of the body's turn over the orientations";
    case OutputKind::point:
      return "root mean square of the point's place over the points";
    default:
      return "root mean square over the positions, turns counted by the turning length";
  }
}

std::string main_cause(const ToleranceReport& report) {
  if (report.shares.empty()) return "–";
  return fmt::format("{} {}", percent(report.shares.front().share, 2),
                     dimension_label(report.shares.front().parameter));
}

}  // namespace

std::string tolerance_table(const Problem& problem, const Findings& found) {
  if (!found.options.tolerances || found.tolerance.empty()) return "";
  const bool of_lines = output_kind(problem.task) == OutputKind::line;
  std::vector<std::string> heads = {"#", "error", "sampled", "worst case", "yield", "<most by"};
  if (of_lines) heads.insert(heads.begin() + 2, "line realigned");
  TextTable table(heads);
  bool some_beyond = false;
  for (std::size_t i = 0; i < found.tolerance.size(); ++i) {
    const std::string number = fmt::format("{}", i + 1);
    if (!found.tolerance[i]) {
      std::vector<std::string> row(heads.size(), "–");
      row.front() = number;
      table.add_row(row);
      continue;
    }
    const ToleranceReport& report = *found.tolerance[i];
    const auto error = [&](double value) { return error_text(report, value, problem.length_unit); };
    some_beyond = some_beyond || report.beyond_first_order;
    std::vector<std::string> row = {number,
                                    error(report.error) + (report.beyond_first_order ? " *" : ""),
                                    report.sampled.assembled() > 0 ? error(report.sampled.error) : "–",
                                    error(report.worst_case),
                                    yield_cell(report),
                                    main_cause(report)};
    if (of_lines) row.insert(row.begin() + 2, report.error_realigned ? error(*report.error_realigned) : "–");
    table.add_row(row);
  }
  const Tolerances& given = *found.options.tolerances;
  std::string text = "\n" +
                     wrapped(fmt::format("Tolerances: {}. Error: {}.", given_words(given, problem.length_unit),
                                         error_words(problem.task))) +
                     table.text();
  if (some_beyond) text += wrapped("* Beyond the first order: the sampled error is the one that counts.");
  return text;
}

std::optional<std::string> analysis_score(const Findings& found, std::size_t place, std::string_view unit) {
  if (!is_of_analysis(found.options.objective) || found.options.objective == Objective::near_error) return std::nullopt;
  if (measure_of(found.options.objective) != measures::tolerance_error && found.options.objective != Objective::yield)
    return load_score(found, place);
  if (place >= found.tolerance.size() || !found.tolerance[place]) return "–";
  const ToleranceReport& report = *found.tolerance[place];
  return found.options.objective == Objective::yield ? yield_cell(report)
                                                     : error_text(report, report.listed_error(), unit);
}

namespace {

std::string yield_sentence(const ToleranceReport& report, const Tolerances& given, std::string_view unit) {
  const SampledErrors& sampled = report.sampled;
  const std::string failed = sampled.not_assembled == 0
                                 ? "all of them assemble"
                                 : fmt::format("{} do not assemble", grouped_text(sampled.not_assembled));
  const std::string made =
      fmt::format("Of {} sampled linkages (seed {}) {}", grouped_text(sampled.samples), given.seed, failed);
  if (!sampled.yield)
    return wrapped(made + ". Give a \"limit\" in the tolerances to have the share of good ones counted.");
  return wrapped(fmt::format("{}; {} stay within {} in all positions: a yield between {} and {} with 95 % certainty.",
                             made, yield_text(*sampled.yield), limit_text(*given.limit, unit),
                             percent(sampled.yield->low, 5), percent(sampled.yield->high, 5)));
}

std::string contribution_table(const ToleranceReport& report, std::string_view unit) {
  const std::size_t positions = report.shares.empty() ? 0 : report.shares.front().per_position.size();
  constexpr std::size_t most_columns = 5;
  std::vector<std::string> heads = {"<made", "tolerance", "share"};
  for (std::size_t j = 0; j < positions && positions <= most_columns; ++j) heads.push_back(fmt::format("in {}", j + 1));
  TextTable table(heads);
  for (const ParameterShare& share : report.shares) {
    std::vector<std::string> row = {dimension_label(share.parameter),
                                    half_tolerance_text(share.tolerance, share.is_angle, unit),
                                    percent(share.share, 2)};
    for (std::size_t j = 0; j < positions && positions <= most_columns; ++j)
      row.push_back(percent(share.per_position[j], 2));
    table.add_row(row);
  }
  return "\nShares of the variance of the error (clearance within its link):\n" + table.text();
}

std::string names_of(const std::vector<ParameterShare>& shares, double from, double to) {
  std::string text;
  for (const ParameterShare& share : shares)
    if (share.share >= from && share.share < to) text += (text.empty() ? "" : "; ") + dimension_label(share.parameter);
  return text;
}

std::string advice(const ToleranceReport& report) {
  const std::string tighten = names_of(report.shares, worth_tightening, 2),
                    loosen = names_of(report.shares, -1, does_not_matter);
  std::string text;
  if (!tighten.empty()) text += wrapped(fmt::format("Tighten first: {}.", tighten));
  if (tighten.empty()) text += wrapped("No single dimension stands out: tightening one of them helps little.");
  if (!loosen.empty())
    text += wrapped(fmt::format("Loosen (less than {} of the variance): {}.", percent(does_not_matter), loosen));
  return text;
}

std::string allocation_table(const ToleranceReport& report, const Tolerances& given, std::string_view unit) {
  if (!report.allocation) return "";
  TextTable table({"<made", "now", "cheapest"});
  for (const ParameterTolerance& of : *report.allocation) {
    const auto now = std::find_if(report.shares.begin(), report.shares.end(),
                                  [&](const ParameterShare& share) { return share.parameter == of.parameter; });
    table.add_row({dimension_label(of.parameter),
                   now == report.shares.end() ? "–" : half_tolerance_text(now->tolerance, now->is_angle, unit),
                   half_tolerance_text(of.tolerance, of.is_angle, unit)});
  }
  return fmt::format("\nThe same error at the least cost, where a tolerance T costs T^−{}:\n",
                     significant_text(given.cost_exponent.value_or(0), error_digits)) +
         table.text();
}

}  // namespace

std::string tolerance_words(const Problem& problem, const Findings& found, std::size_t place) {
  const ToleranceReport& report = *found.tolerance[place];
  const Tolerances& given = *found.options.tolerances;
  const std::string_view unit = problem.length_unit;
  const auto error = [&](double value) { return error_text(report, value, unit); };
  std::string text = wrapped(fmt::format("Tolerances: {}.", given_words(given, unit)));
  if (report.sampled.assembled() == 0)
    text += wrapped(
        fmt::format("Error: {} to first order ({}). Worst case {}. No linkage made so assembles in all positions.",
                    error(report.error), error_words(problem.task), error(report.worst_case)));
  else
    text += wrapped(fmt::format(
        "Error: {} to first order, {} of the samples ({}). Worst case {}; mean + 3σ of the "
        "largest error {}; signal to noise {} dB.",
        error(report.error), error(report.sampled.error), error_words(problem.task), error(report.worst_case),
        error(report.sampled.mean_plus_3_sigma()), significant_text(report.signal_to_noise(), error_digits)));
  if (report.error_realigned)
    text += wrapped(fmt::format("Where the line is laid anew in each linkage made: {}; mean + 3σ {}.",
                                error(*report.error_realigned),
                                error(report.sampled_realigned ? report.sampled_realigned->mean_plus_3_sigma() : 0)));
  if (report.beyond_first_order)
    text += wrapped(
        "The tolerances are too coarse, or a dead point too near, for the first order: the sampled error is "
        "the one that counts.");
  text += yield_sentence(report, given, unit);
  if (!report.shares.empty()) text += contribution_table(report, unit) + advice(report);
  return text + allocation_table(report, given, unit);
}

}  // namespace linkwright::cli
