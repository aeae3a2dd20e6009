#include "four_bar_columns.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/number_text.hpp"

namespace linkwright::cli {

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
