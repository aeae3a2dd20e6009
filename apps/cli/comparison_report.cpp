#include <fmt/format.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/length_unit.hpp"
#include "linkwright/files/number_text.hpp"
#include "report.hpp"
#include "text_table.hpp"

namespace linkwright::cli {
namespace {

// What keeps its input from passing the points.
std::string way_words(const PathComparison& comparison) {
  const CurveDrive& drive = comparison.drive;
  if (!drive.one_circuit) return "The points belong to places that cannot be reached without disassembly.";
  if (!drive.in_order) return "The path does not pass the points in their turn.";
  if (!drive.input_drives) return "On the way the input meets a dead point.";
  if (comparison.target.closed && !drive.full_turn) return "The input does not turn fully.";
  return "The input drives the point past all of them in turn.";
}

}  // namespace

std::string comparison_words(const PathComparison& comparison, const std::string& length_unit) {
  const CurveError& error = comparison.path.error;
  const std::string unit = length_unit.empty() ? "" : " " + printable(length_unit);
  const auto length = [&](double value) { return significant_text(value, 4) + unit; };
  const int decimals = length_decimals(comparison.target.diagonal()) + 1;
  TextTable table({"point", "x, y", "path there", "distance", "input turned by"});
  constexpr std::size_t most_told = 40;
  for (std::size_t j = 0; j < std::min(comparison.path.at.size(), most_told); ++j) {
    const FittedPath::Nearest& at = comparison.path.at[j];
    const auto place = [&](Point p) {
      return fmt::format("{}, {}", rounded_text(p.real(), decimals), rounded_text(p.imag(), decimals));
    };
    table.add_row({fmt::format("{}", at.point + 1), place(comparison.target.points[j]), place(at.place),
                   significant_text(at.distance, 4), rounded_text(degrees(at.input), 2) + "°"});
  }
  std::string text = wrapped(fmt::format(
      "Compared with {} points{}: root mean square distance {} ({} % of their diagonal), largest {} at point {}. "
      "Between "
      "the points the path strays {} from the polygon through them, and is {} times as long. {}",
      comparison.path.at.size(), comparison.path.timed ? " at the angles of the crank given" : "", length(error.rms),
      significant_text(100 * error.rms_over_diagonal, 3), length(error.max), error.max_at + 1, length(error.excursion),
      significant_text(error.path_length_ratio, 4), way_words(comparison)));
  text += table.text();
  if (comparison.path.at.size() > most_told)
    text += fmt::format("… and {} points more; -o FILE.csv has all of them.\n", comparison.path.at.size() - most_told);
  return text;
}

}  // namespace linkwright::cli
