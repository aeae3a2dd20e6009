#include <algorithm>
#include <fmt/format.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/length_unit.hpp"
#include "linkwright/files/number_text.hpp"
#include "linkwright/planar/path_crank.hpp"
#include "report.hpp"
#include "text_table.hpp"

namespace linkwright::cli {

std::string crank_words(const PathAnswer& answer) {
  const TaskFamily& given = answer.given;
  if (given.points.empty()) return "";
  const int decimals = std::min(length_decimals(given.frame().scale), 9);
  TextTable table({"#", "ground pivot", "moving pivot", "length", "arm to the point"});
  for (std::size_t i = 0; i < given.points.size(); ++i) {
    const Dyad crank = given.frame().to_user(crank_link(given.points[i].dyad));
    const auto center = given.frame().finite_user_point(crank.center),
               circle = given.frame().finite_user_point(crank.circle);
    const auto text = [&](const std::optional<Point>& p) { return p ? pivot_text(*p, decimals) : "at infinity"; };
    const auto distance = [&](const std::optional<Point>& p, Point q) {
      return p ? rounded_text(std::abs(*p - q), decimals) : "–";
    };
    table.add_row({fmt::format("{}", i + 1), text(center), text(circle), center ? distance(circle, *center) : "–",
                   distance(circle, given.frame().origin)});
  }
  return "\nCranks of all five positions, moving pivots in position 1:\n" + table.text();
}

namespace {

std::string fit_table(const Problem& problem, const PathAnswer& answer) {
  bool has_tolerance = false;
  for (std::size_t i = 0; i < answer.task.points.size(); ++i)
    has_tolerance = has_tolerance || answer.task.tolerance_at(i);
  const auto length = [&](double value) {
    return fmt::format("{}{}{}", significant_text(value, 4), problem.length_unit.empty() ? "" : " ",
                       problem.length_unit);
  };
  std::vector<std::string> head = {"#",        "rms", "of the diagonal", "largest", "<at point", "between points",
                                   "full turn"};
  if (has_tolerance) head.emplace_back("within tolerance");
  TextTable table(head);
  for (std::size_t i = 0; i < answer.linkages.size(); ++i) {
    const FourBarSolution& found = answer.linkages[i];
    if (!found.fit || !found.path) continue;
    const CurveError& error = found.fit->error;
    std::vector<std::string> row = {fmt::format("{}", i + 1),
                                    length(error.rms),
                                    significant_text(100 * error.rms_over_diagonal, 3) + " %",
                                    length(error.max),
                                    fmt::format("{}", error.max_at + 1),
                                    length(error.excursion),
                                    found.path->full_turn ? "yes" : "no"};
    if (has_tolerance)
      row.push_back(found.fit->outside.empty() ? "yes"
                                               : fmt::format("{} point{} not", found.fit->outside.size(),
                                                             found.fit->outside.size() == 1 ? "" : "s"));
    table.add_row(row);
  }
  const CrankTiming timing = answer.task.near_timing();
  if (timing != CrankTiming::free)
    return "\n" +
           wrapped(
               fmt::format("How near the point is to each at the angles of the crank given ({}): root mean square "
                           "and largest distance, and how far the path strays between them from the polygon "
                           "through them:",
                           timing == CrankTiming::relative ? "from any datum, in either sense" : "from the x axis")) +
           table.text();
  return "\n" +
         wrapped(
             "How near the points lie to each path: root mean square and largest distance, and how far the "
             "path strays between them from the polygon through them:") +
         table.text();
}

}  // namespace

std::string path_table(const Problem& problem, const PathAnswer& answer) {
  if (answer.linkages.empty()) return "";
  if (answer.task.is_approximate()) return fit_table(problem, answer);
  const int decimals = decimals_for(answer.linkages);
  const bool is_timed = answer.task.is_timed();
  TextTable table({"#", "arm to input", "arm to output", "<full turn", "<order on circuit",
                   is_timed ? "cognate" : "crank turns", "<off by"});
  for (std::size_t i = 0; i < answer.linkages.size(); ++i) {
    const FourBarSolution& found = answer.linkages[i];
    if (!found.path) continue;
    const TimedPath& path = *found.path;
    const auto arm = [&](Point pivot) { return rounded_text(std::abs(path.point - pivot), decimals); };
    const std::string off = fmt::format("{}{}{}", significant_text(path.position_error, 2),
                                        problem.length_unit.empty() ? "" : " ", problem.length_unit);
    table.add_row({fmt::format("{}", i + 1), arm(found.four_bar.input_moving), arm(found.four_bar.output_moving),
                   path.full_turn ? "yes" : "no",
                   !path.circuit_order   ? "–"
                   : *path.circuit_order ? "as listed"
                                         : "another",
                   is_timed ? "× " + significant_text(path.cognate_size, 4)
                            : rounded_text(degrees(std::abs(path.input.back())), 1) + "°",
                   found.report.defects.none() ? off : "–"});
  }
  return "\n" +
         wrapped(is_timed
                     ? "The point: its arms, the size of the cognate with the same path, and how far driving the crank "
                       "to the angles given found it off:"
                     : "The point: its arms, how far the crank turns from the first point to the last, and how far "
                       "driving it there found the point off:") +
         table.text();
}

}  // namespace linkwright::cli
