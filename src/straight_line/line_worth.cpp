#include "linkwright/straight_line/line_worth.hpp"

#include "linkwright/mechanism/linkage_type.hpp"
#include "linkwright/planar/four_bar_family.hpp"

namespace linkwright {

LineWorth LineWorth::of(const StrokeFigures& over, double deviation) {
  const double length = over.to - over.from;
  return {length, deviation, over.min_transmission_angle,
          over.drive ? over.drive->nonuniformity(length) : std::numeric_limits<double>::infinity()};
}

std::array<double, straight_line_measures.size()> measured_line(const TracingFourBar& linkage, const LineWorth& worth) {
  constexpr double not_known = std::numeric_limits<double>::quiet_NaN();
  const double longest = linkage.longest();
  return {not_known,
          not_known,
          worth.deviation,
          worth.usable / longest,
          versine_of_angle(worth.min_transmission_angle),
          worth.velocity_nonuniformity,
          not_known,
          worth.usable,
          longest / linkage.shortest(),
          longest,
          1.0};
}

Cell line_cell(const TracingFourBar& linkage, const LineWorth& worth) {
  const LinkLengths lengths = linkage.bars.lengths();
  Cell cell;
  cell.type = linkage_type(lengths);
  const auto values = measured_line(linkage, worth);
  std::copy(values.begin(), values.end(), cell.values.begin());
  cell.pivots = pivots_of(linkage.bars);
  cell.change_point_margin = change_point_margin(lengths);
  cell.hill = static_cast<std::size_t>(cell.type);
  return cell;
}

}  // namespace linkwright
