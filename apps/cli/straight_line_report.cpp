#include <algorithm>
#include <fmt/format.h>
#include <vector>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/label.hpp"
#include "linkwright/files/number_text.hpp"
#include "report.hpp"
#include "text_table.hpp"

namespace linkwright::cli {
namespace {

using Lines = std::vector<StraightLineSolution>;

constexpr int line_digits = 4;

std::string with_unit(const std::string& number, std::string_view unit) {
  return unit.empty() ? number : fmt::format("{} {}", number, unit);
}

std::string map_of_lines_words(const Problem& problem, const StraightLineAnswer& answer) {
  if (!answer.lines)
    return wrapped(fmt::format("{} Requirements: {}.", answer.reason.message,
                               requirement_words(answer.requirements, linkages(problem.task), problem.length_unit)));
  const RegionCounts& counts = answer.counts;
  const std::int64_t without = counts.types[static_cast<std::size_t>(LinkageType::degenerate)];
  const int layers = answer.lines->layers();
  const auto rows = static_cast<std::int64_t>(answer.region.rows()) / layers;
  std::string text =
      fmt::format("The map of {} × {} places{} holds {} four-bars", rows, answer.region.columns(),
                  layers > 1 ? fmt::format(", {} layers,", layers) : "", grouped_text(counts.pairs - without));
  const std::span<const float> valid = answer.region.values(measures::valid);
  if (const auto sliders = std::count(valid.begin(), valid.end(), 2.0F); sliders > 0)
    text += fmt::format(" and {} linkages with a slider", grouped_text(sliders));
  return wrapped(fmt::format("{}; {} {}: {}.", text, grouped_text(answer.meeting_requirements),
                             answer.meeting_requirements == 1 ? "meets the requirements" : "meet the requirements",
                             requirement_words(answer.requirements, linkages(problem.task), problem.length_unit)));
}

std::string heading_of_lines(const StraightLineAnswer& answer) {
  if (answer.options.at) return answer.linkages.size() == 1 ? "The linkage there:\n" : "The linkages there:\n";
  if (auto front = front_heading(answer)) return *std::move(front);
  return fmt::format("Best linkages, {} first:\n", superlative(answer.options.objective));
}

std::string usable_text(const UsableLine& usable) { return significant_text(usable.length(), line_digits); }

std::string deviation_text(const StraightLineSolution& found, LineMeasure measure) {
  if (found.asks_stroke && !found.stroke) return "–";
  const StrokeReport& over = found.judged();
  return significant_text(measure == LineMeasure::strip ? over.parallel_line_deviation : over.max_deviation, 3);
}

std::string line_table(const StraightLineAnswer& answer) {
  const bool has_cases = answer.lines == nullptr, has_layers = !has_cases && answer.lines->layers() > 1;
  std::vector<std::string> head = {"#", "<type", "points", "tangent", "strip", "÷ longest", "γ", "uneven", "±e"};
  if (has_layers) head.insert(head.begin() + 1, "<layer");
  if (has_cases) head.insert(head.begin() + 1, "<case");
  TextTable table(head);
  for (std::size_t i = 0; i < answer.linkages.size(); ++i) {
    const StraightLineSolution& found = answer.linkages[i];
    const UsableLine& counted = found.counted(answer.options.line.measure);
    const StrokeReport& over = found.judged();
    std::vector<std::string> row = {
        fmt::format("{}", i + 1),
        std::string(short_label(found.type)),
        fmt::format("{}", found.contact.points),
        usable_text(found.usable),
        usable_text(found.usable_strip),
        significant_text(counted.length() / found.linkage.longest(), 3),
        angle_text(over.min_transmission_angle, 1),
        over.drive ? significant_text(over.drive->nonuniformity(over.to - over.from), 2) : "–",
        deviation_text(found, answer.options.line.measure)};
    if (has_layers) row.insert(row.begin() + 1, std::string(answer.lines->layer_name(found.place.layer)));
    if (has_cases) row.insert(row.begin() + 1, std::string(name(found.task.given)));
    table.add_row(std::move(row));
  }
  return table.text();
}

std::string column_words(const StraightLineAnswer& answer) {
  const bool by_strip = answer.options.line.measure == LineMeasure::strip;
  const std::string share = answer.options.line.deviation
                                ? significant_text(*answer.options.line.deviation, line_digits)
                                : std::string("1/10 000 of the longest link or arm");
  return wrapped(fmt::format(
      "points: of path and line in common; tangent, strip: usable length within ±{} of the line, or of the best line "
      "parallel to it; ÷ longest: {} over the longest link or arm; γ: least transmission angle, uneven: (fastest − "
      "slowest) / mean velocity and ±e: largest deviation from that line, over {}.",
      share, by_strip ? "strip" : "tangent",
      !answer.lines || answer.lines->stroke() ? "the stroke, – where the point turns back before its ends"
                                              : "that length"));
}

std::string line_dimensions(const Lines& all, int decimals) {
  TextTable table({"#", "ground", "input", "coupler", "output", "point to input", "to output"});
  for (std::size_t i = 0; i < all.size(); ++i) {
    const LinkLengths& lengths = all[i].lengths;
    table.add_row({fmt::format("{}", i + 1), rounded_text(lengths.ground, decimals),
                   rounded_text(lengths.input, decimals), rounded_text(lengths.coupler, decimals),
                   rounded_text(lengths.output, decimals), rounded_text(all[i].point_to_input(), decimals),
                   rounded_text(all[i].point_to_output(), decimals)});
  }
  return "Lengths:\n" + table.text();
}

std::string line_pivots(const Lines& all, int decimals) {
  TextTable table({"#", "input: fixed pivot", "moving pivot", "output: fixed pivot", "moving pivot", "point"});
  for (std::size_t i = 0; i < all.size(); ++i) {
    const FourBar& bars = all[i].linkage.bars;
    table.add_row({fmt::format("{}", i + 1), pivot_text(bars.input_fixed, decimals),
                   pivot_text(bars.input_moving, decimals), pivot_text(bars.output_fixed, decimals),
                   pivot_text(bars.output_moving, decimals), pivot_text(all[i].linkage.point, decimals)});
  }
  return "Pivots (x, y), as the linkage lies with its point on the line:\n" + table.text();
}

// The other linkages of the best one's curve.
std::string cognate_words(const StraightLineSolution& found, int decimals) {
  if (found.cognates.empty()) return "";
  TextTable table({"<type", "ground", "input", "coupler", "output", "input: fixed pivot", "output: fixed pivot", "γ"});
  for (const StraightLineCognate& other : found.cognates) {
    const FourBar& bars = other.linkage.bars;
    const LinkLengths lengths = bars.lengths();
    table.add_row({std::string(short_label(other.type)), rounded_text(lengths.ground, decimals),
                   rounded_text(lengths.input, decimals), rounded_text(lengths.coupler, decimals),
                   rounded_text(lengths.output, decimals), pivot_text(bars.input_fixed, decimals),
                   pivot_text(bars.output_fixed, decimals), angle_text(other.over_usable.min_transmission_angle, 1)});
  }
  return "Linkages whose point traces the same path as that of linkage 1 (its cognates):\n" + table.text() + "\n";
}

std::string line_check_words(const StraightLineAnswer& answer) {
  double worst = 0;
  bool all_driven = true;
  for (const StraightLineSolution& found : answer.linkages) {
    worst = std::max(worst, found.residual / found.linkage.longest());
    all_driven = all_driven && found.verified_by_driving;
  }
  return wrapped(fmt::format(
      "The points lie on the line to {} of the longest link; {}.", significant_text(worst, 2),
      all_driven ? "assembled anew at 17 places of its stroke, every linkage listed comes out where its path has it"
                 : "assembling a linkage anew disagrees with its path: rounding decides what it does there"));
}

std::string found_lines_words(const Problem& problem, const StraightLineAnswer& answer) {
  double longest = 0;
  for (const StraightLineSolution& found : answer.linkages) longest = std::max(longest, found.linkage.longest());
  const int decimals = length_decimals(longest);
  std::string best;
  if (answer.options.at) {
    best = wrapped(answer.reason.message);
  } else if (answer.search) {
    best = wrapped(
        "Their places on the maps of their cases are in the result file, each with the task of its map: solve that to "
        "see what lies around.");
  } else {
    const StraightLineSolution& first = answer.linkages.front();
    const UsableLine& usable = first.counted(answer.options.line.measure);
    best = wrapped(fmt::format(
        "Linkage 1 runs straight to ±{} over {}, from s = {} to {} of its line; its place on the map is ({}, {}).",
        with_unit(significant_text(first.deviation, 3), problem.length_unit),
        with_unit(usable_text(usable), problem.length_unit), significant_text(usable.from, line_digits),
        significant_text(usable.to, line_digits), significant_text(first.place.at[0], 6),
        significant_text(first.place.at[1], 6)));
  }
  return "\n" + heading_of_lines(answer) + line_table(answer) + column_words(answer) + "\n" +
         line_dimensions(answer.linkages, decimals) + "\n" + line_pivots(answer.linkages, decimals) + "\n" +
         cognate_words(answer.linkages.front(), decimals) + best + line_check_words(answer);
}

std::string no_lines_words(const Problem& problem, const StraightLineAnswer& answer) {
  if (answer.search || (answer.options.best == 0 && !answer.options.at)) return "";  // of a search it is told first
  std::string text = "\n" + wrapped(answer.reason.message);
  if (answer.options.at) return text;
  for (std::size_t i = 0; i < answer.relax.size(); ++i)
    if (i > 0 || answer.relax[i].value || answer.relax[i].box)
      text += wrapped("  " + relaxation_words(answer.relax[i], problem.length_unit), 4);
  return text;
}

}  // namespace

std::string straight_line_report(const Problem& problem, const StraightLineAnswer& answer) {
  return map_of_lines_words(problem, answer) +
         (answer.linkages.empty() ? no_lines_words(problem, answer) : found_lines_words(problem, answer));
}

}  // namespace linkwright::cli
