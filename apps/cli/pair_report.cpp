#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/label.hpp"
#include "linkwright/files/number_text.hpp"
#include "report.hpp"
#include "text_table.hpp"

namespace linkwright::cli {
namespace {

constexpr int condition_digits = 2;

std::string point_or_direction(Homogeneous point, const WorkingFrame& frame, int decimals) {
  if (is_at_infinity(frame.to_working(point)))
    return fmt::format("at infinity, {}°", rounded_text(degrees(std::atan2(point.y, point.x)), 1));
  return pivot_text({point.x / point.w, point.y / point.w}, decimals);
}

std::string length_or_slider(const Dyad& dyad, const WorkingFrame& frame, int decimals) {
  if (is_at_infinity(frame.to_working(dyad.center)) || is_at_infinity(frame.to_working(dyad.circle))) return "slider";
  const Point link = dyad.circle.vector() / dyad.circle.w - dyad.center.vector() / dyad.center.w;
  return rounded_text(std::abs(link), decimals);
}

/// Number of a grounded link or linkage from its place on the axis.
int number_at(double coordinate) { return static_cast<int>(std::floor(coordinate)) + 1; }

/// Both links have numbers of their own.
bool are_pairs(const FourBarAnswer& answer) {
  const auto has_number = [&](Side side) { return answer.family()->axis(side).quantity != AxisQuantity::nothing; };
  return has_number(Side::input) && has_number(Side::output);
}

std::string pair_name(const FourBarAnswer& answer, const FourBarSolution& found) {
  const int input = number_at(found.input.coordinate), output = number_at(found.output.coordinate);
  if (are_pairs(answer)) return fmt::format("{}–{}", input, output);
  const bool is_input = answer.family()->axis(Side::output).quantity == AxisQuantity::nothing;
  return fmt::format("{}", is_input ? input : output);
}

std::string pair_table(const FourBarAnswer& answer) {
  const int decimals = decimals_for(answer.pairs);
  TextTable table({are_pairs(answer) ? "pair" : "#", "<type", "<drive", "γ", "γ turn", "ratio", "ground", "input",
                   "coupler", "output"});
  for (const FourBarSolution& found : answer.pairs) {
    std::vector<std::string> cells = {pair_name(answer, found), std::string(short_label(found.report.type)),
                                      drive_text(found.report), task_gamma(found.report),
                                      full_turn_gamma(found.report)};
    for (std::string& cell : length_cells(found.lengths, decimals)) cells.push_back(std::move(cell));
    table.add_row(std::move(cells));
  }
  return table.text();
}

std::string reasons(const FourBarAnswer& answer) {
  std::string text;
  for (const FourBarSolution& found : answer.pairs) {
    const auto reason = defect_notice(found, answer.given);
    if (reason) text += wrapped(fmt::format("  {}: {}", pair_name(answer, found), reason->message), 6);
  }
  return text.empty() ? "" : "Why they fail:\n" + text;
}

std::string sliders_among(const FourBarAnswer& answer) {
  const std::size_t links = answer.given.points.size(), whole = links * (links - 1) / 2;
  if (links < 2 || answer.pairs.size() == whole) return "";
  return wrapped(fmt::format("{} of {} pairs {} no four-bar: a pivot lies at infinity, or a link has no length.",
                             whole - answer.pairs.size(), whole, whole - answer.pairs.size() == 1 ? "is" : "are"));
}

std::string length_words(double length, std::string_view unit) {
  const std::string number = significant_text(length, 3);
  return unit.empty() ? number : fmt::format("{} {}", number, unit);
}

std::string way_out_words(const RelaxedPosition& way, const Requirements& requirements, std::string_view unit) {
  const std::string start = fmt::format("  Relax position {}: ", way.pose + 1);
  if (!way.linkage) return wrapped(start + (way.reason ? way.reason->message : "nothing was found."), 4);
  const FourBarSolution& found = *way.linkage;
  return wrapped(
      fmt::format("{}the nearest four-bar{} is off by {} and {}° ({}, γ {}).", start,
                  requirements.no_defects ? " free of defects" : "", length_words(way.pose_error.distance, unit),
                  significant_text(degrees(way.pose_error.angle), 3), short_label(found.report.type),
                  task_gamma(found.report)),
      4);
}

}  // namespace

std::string dyad_words(const FourBarAnswer& answer) {
  const TaskFamily& given = answer.given;
  if (given.points.empty()) return "";
  const int decimals = std::min(length_decimals(given.frame().scale), 9);
  TextTable table({"#", "fixed pivot", "moving pivot", "length", "multiplicity", "condition"});
  for (std::size_t i = 0; i < given.points.size(); ++i) {
    const BurmesterPoint& point = given.points[i];
    const Dyad dyad = given.frame().to_user(point.dyad);
    table.add_row({fmt::format("{}", i + 1), point_or_direction(dyad.center, given.frame(), decimals),
                   point_or_direction(dyad.circle, given.frame(), decimals),
                   length_or_slider(dyad, given.frame(), decimals), fmt::format("{}", point.multiplicity),
                   significant_text(point.condition, condition_digits)});
  }
  return "\nDyads of all five positions, moving pivots in position 1:\n" + table.text();
}

std::string pair_words(const FourBarAnswer& answer, std::string_view heading) {
  const bool all_are_listed = answer.pairs.size() == answer.linkages.size();
  if (answer.pairs.empty() || (all_are_listed && answer.pairs.front().function)) return "";
  return fmt::format("\n{}", heading) + pair_table(answer) + sliders_among(answer) + reasons(answer);
}

std::string pose_error_words(const Problem& problem, const FourBarAnswer& answer) {
  if (!answer.given.relaxed || answer.linkages.empty()) return "";
  TextTable table({"#", "distance", "angle"});
  for (std::size_t i = 0; i < answer.linkages.size(); ++i) {
    const auto& error = answer.linkages[i].pose_error;
    table.add_row({fmt::format("{}", i + 1), error ? length_words(error->distance, problem.length_unit) : "–",
                   error ? significant_text(degrees(error->angle), 3) + "°" : "–"});
  }
  return "Position and orientation error at the relaxed position:\n" + table.text();
}

std::string ways_out_words(const Problem& problem, const MotionAnswer& answer) {
  if (answer.relaxed.empty()) return "";
  std::string text =
      "\nAlternatives, nearest first: four-bars through four of the positions that meet the requirements.\n";
  for (const RelaxedPosition& way : answer.relaxed)
    text += way_out_words(way, answer.requirements, problem.length_unit);
  return text +
         wrapped(fmt::format("With \"freed_pose\": {} in the task all such four-bars are shown, and what each misses.",
                             answer.relaxed.front().pose + 1));
}

std::string task_gamma(const DefectReport& report) {
  return report.defects.none() ? rounded_text(degrees(report.min_transmission_angle), 1) + "°" : "–";
}

std::string full_turn_gamma(const DefectReport& report) {
  return input_is_crank(report.type) ? rounded_text(degrees(report.min_transmission_angle_full_turn), 1) + "°" : "–";
}

std::string drive_text(const DefectReport& report) {
  if (report.defects.circuit()) return "no: circuit";
  if (report.defects.branch()) return "no: branch";
  return report.defects.order() ? "no: order" : std::string(name(report.sense));
}

std::vector<std::string> length_cells(const LinkLengths& lengths, int decimals) {
  return {rounded_text(lengths.longest() / lengths.shortest(), 2), rounded_text(lengths.ground, decimals),
          rounded_text(lengths.input, decimals), rounded_text(lengths.coupler, decimals),
          rounded_text(lengths.output, decimals)};
}

std::string pivot_text(Point pivot, int decimals) {
  return fmt::format("{}, {}", rounded_text(pivot.real(), decimals), rounded_text(pivot.imag(), decimals));
}

int decimals_for(const std::vector<FourBarSolution>& linkages) {
  double longest = 0;
  for (const FourBarSolution& found : linkages) longest = std::max(longest, found.lengths.longest());
  return std::min(length_decimals(longest), 9);
}

}  // namespace linkwright::cli
