#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/label.hpp"
#include "linkwright/files/length_unit.hpp"
#include "linkwright/files/number_text.hpp"
#include "linkwright/infinitesimal/instant_analysis.hpp"
#include "linkwright/straight_line/line_measuring.hpp"
#include "linkwright/straight_line/straight_path.hpp"
#include "report.hpp"
#include "text_table.hpp"

namespace linkwright::cli {
namespace {

std::string lengths_words(const LinkageAnalysis& analysis) {
  const LinkLengths& lengths = analysis.lengths;
  const int decimals = std::min(length_decimals(lengths.longest()) + 1, 12);
  const std::string unit = printable(analysis.linkage.length_unit);
  TextTable table({"ground", "input", "coupler", "output", "longest / shortest"});
  table.add_row({rounded_text(lengths.ground, decimals), rounded_text(lengths.input, decimals),
                 rounded_text(lengths.coupler, decimals), rounded_text(lengths.output, decimals),
                 rounded_text(lengths.longest() / lengths.shortest(), 3)});
  return (unit.empty() ? std::string("Lengths:\n") : fmt::format("Lengths in {}:\n", spoken_unit(unit))) + table.text();
}

std::string type_words(const LinkageAnalysis& analysis) {
  std::string text = fmt::format("Type: {}", label(analysis.type));
  if (analysis.change_point != ChangePointKind::none) {
    text += fmt::format(" ({})", label(analysis.change_point));
    return wrapped(text + ". The links can lie in one line, where the linkage may change its assembly mode.");
  }
  return wrapped(text + (is_grashof(analysis.type)
                             ? " (Grashof: the shortest link turns fully with respect to the others)."
                             : " (not Grashof: no link turns fully with respect to the others)."));
}

std::string range_words(const LinkageAnalysis& analysis) {
  if (!analysis.input_ranges.empty() && analysis.input_ranges.front().is_full_turn()) {
    return analysis.dead_points.empty()
               ? "The input turns fully; it has no dead points.\n"
               : "The input turns fully, through dead points where all links lie in one line.\n";
  }
  std::string text = range_sentence(analysis.input_ranges) + ", measured from the ground link.";
  text.front() = 'T';
  return wrapped(text);
}

std::string dead_point_words(const LinkageAnalysis& analysis) {
  if (analysis.dead_points.empty()) return "";
  TextTable table({"dead point:", "input", "coupler", "output", "<coupler and output link"});
  for (const DeadPoint& dead_point : analysis.dead_points) {
    const Configuration& at = dead_point.configuration;
    table.add_row({"", angle_text(wrap_signed(at.input_angle)), angle_text(wrap_signed(at.coupler_angle)),
                   angle_text(wrap_signed(at.output_angle)), dead_point.extended ? "stretched" : "folded"});
  }
  return table.text();
}

std::string rate_words(const LinkageAnalysis& analysis) {
  if (!analysis.output_rates) return "";  // unbounded next to dead points
  return wrapped(fmt::format("The output turns {} to {} times as fast as the input.",
                             rounded_text(analysis.output_rates->least, 3),
                             rounded_text(analysis.output_rates->most, 3)));
}

std::string straight_words(const TracingFourBar& linkage, Point along) {
  const double deviation = LineMeasuring{}.deviation_of(linkage);
  PathLimits limits;
  limits.max_deviation = deviation;
  const auto path = StraightPath::of(linkage, along, limits);
  if (!path) return "";
  return fmt::format(", from which it stays within ±{} (1/10 000 of the longest link or arm) over {}",
                     significant_text(deviation, 3), significant_text(path->usable(deviation).length(), 4));
}

/// How the path of the file's point runs where the linkage lies.
std::string point_words(const StoredLinkage& stored) {
  if (!stored.point) return "";
  const TracingFourBar linkage{stored.four_bar, *stored.point};
  const auto path = analyze_instant(linkage.bars, {.point = linkage.point, .input_acceleration = 0}).point;
  const int decimals = length_decimals(linkage.longest());
  const std::string where = fmt::format("The point ({}, {})", rounded_text(linkage.point.real(), decimals),
                                        rounded_text(linkage.point.imag(), decimals));
  if (!path || path->contact_points == 0) return wrapped(where + " does not move as the linkage lies.");
  return wrapped(fmt::format("{} runs at {} from the x axis; its path has {} points in common with that tangent{}.",
                             where, angle_text(wrap_signed(std::arg(path->tangent))), path->contact_points,
                             straight_words(linkage, path->tangent)));
}

}  // namespace

std::string linkage_words(const LinkageAnalysis& analysis, std::string_view drive) {
  const std::string title = analysis.linkage.title.empty() ? "Four-bar linkage" : printable(analysis.linkage.title);
  const std::string driven =
      drive == "output" ? " driven by the file's output link (called input here)" : " driven by its input link";
  return wrapped(title + "," + driven) + lengths_words(analysis) + type_words(analysis) + range_words(analysis) +
         dead_point_words(analysis) + transmission_words(analysis, analysis.min_transmission_angle_full_turn) +
         rate_words(analysis) + point_words(analysis.linkage) + missed_words(analysis.linkage);
}

}  // namespace linkwright::cli
