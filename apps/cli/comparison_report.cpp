#include <fmt/format.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/length_unit.hpp"
#include "linkwright/files/number_text.hpp"
#include "report.hpp"
#include "text_table.hpp"

namespace linkwright::cli {
namespace {

constexpr std::size_t most_told = 40;  // lines of a table

std::string more_words(std::size_t count, std::string_view rows) {
  if (count <= most_told) return "";
  return fmt::format("… and {} {} more; -o FILE.csv has all of them.\n", count - most_told, rows);
}

std::string way_words(const PoseComparison& comparison) {
  const CurveDrive& drive = comparison.drive;
  if (!drive.one_circuit) return "The poses belong to places that cannot be reached without disassembly.";
  if (!drive.in_order) return "The body does not pass the poses in their order.";
  if (!drive.input_drives) return "On the way the input meets a dead point.";
  return "The input drives the body past all of them in their order.";
}

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
  return text + more_words(comparison.path.at.size(), "points");
}

namespace {

std::string exact_words(const PoseComparison& comparison, const std::string& residual) {
  const std::size_t exact = comparison.target.exact.size();
  if (exact == 0) return "";
  return fmt::format(" At the {} exact one{} it is {} off at most; the errors are those at the others.", exact,
                     exact == 1 ? "" : "s", residual);
}

std::string outside_words(const NearMiss& miss) {
  if (miss.outside.empty()) return "";
  std::string poses;
  for (const std::size_t pose : miss.outside) poses += fmt::format("{}{}", poses.empty() ? "" : ", ", pose + 1);
  return fmt::format(" Out of tolerance at pose{} {}.", miss.outside.size() == 1 ? "" : "s", poses);
}

TextTable pose_table(const PoseComparison& comparison) {
  double extent = 0;
  for (const Pose& pose : comparison.target.poses)
    extent = std::max(extent, std::abs(pose.origin - comparison.target.poses.front().origin));
  const int decimals = length_decimals(std::max(extent, comparison.target.turning_length)) + 1;
  const auto placed = [&](const Pose& pose) {
    return fmt::format("{}, {}, {}°", rounded_text(pose.origin.real(), decimals),
                       rounded_text(pose.origin.imag(), decimals), rounded_text(degrees(pose.angle), 2));
  };
  TextTable table({"pose", "x, y, theta", "body there", "distance", "turn", "input turned by"});
  for (std::size_t j = 0; j < std::min(comparison.miss.at.size(), most_told); ++j) {
    const NearMiss::Nearest& at = comparison.miss.at[j];
    table.add_row({fmt::format("{}{}", at.pose + 1, at.is_near ? "" : " exact"), placed(comparison.target.poses[j]),
                   placed(at.body), significant_text(at.position_error, 4),
                   significant_text(degrees(at.angle_error), 3) + "°", rounded_text(degrees(at.input), 2) + "°"});
  }
  return table;
}

}  // namespace

std::string comparison_words(const PoseComparison& comparison, const std::string& length_unit) {
  const PoseFitError& error = comparison.miss.error;
  const std::string unit = length_unit.empty() ? "" : " " + printable(length_unit);
  const auto length = [&](double value) { return significant_text(value, 4) + unit; };
  const auto angle = [](double radians) { return significant_text(degrees(radians), 3) + "°"; };
  const std::string text = fmt::format(
      "Compared with {} poses: root mean square distance of the body's origin {}, largest {} at pose {}; root mean "
      "square turn {}, largest {} at pose {}. As one error, a turn by 1 radian counted as {}: root mean square {}, "
      "largest at pose {}.{}{} {}",
      comparison.miss.at.size(), length(error.position_rms), length(error.position_max), comparison.position_max_at + 1,
      angle(error.angle_rms), angle(error.angle_max), comparison.angle_max_at + 1,
      length(comparison.target.turning_length), length(error.rms), error.max_at + 1,
      exact_words(comparison, length(error.exact_residual)), outside_words(comparison.miss), way_words(comparison));
  return wrapped(text) + pose_table(comparison).text() + more_words(comparison.miss.at.size(), "poses");
}

}  // namespace linkwright::cli
