#include "picked_place.hpp"

#include <array>
#include <fmt/format.h>
#include <string>
#include <tuple>
#include <vector>

#include "linkwright/region/requirement_filter.hpp"
#include "region_count.hpp"

namespace linkwright {
namespace {

// Its end is a place of an axis too: where the axis is closed, the same as its beginning.
bool is_on_axis(const LinkageFamily& family, Side side, double coordinate) {
  const MapAxis& axis = family.axis(side);
  const double there = axis.layers > 0 ? axis.onto(coordinate) : coordinate;
  return there >= 0 && there <= axis.coordinate_length();
}

bool is_on_axes(const LinkageFamily& family, MapPoint place) {
  return is_on_axis(family, Side::input, place.input) && is_on_axis(family, Side::output, place.output);
}

/// How many places of the other axis were looked at, where none of them has a linkage with this coordinate. A place of
/// a curve has its grounded link: there it is not the axis that has a gap.
std::optional<std::size_t> gap_at(const LinkageFamily& family, const Findings& found, Side side, double coordinate) {
  constexpr int looked_at = 256;
  const MapAxis& axis = family.axis(side);
  if (axis.is_discrete() || axis.quantity == AxisQuantity::curve_coordinate) return std::nullopt;
  const std::vector<double> here = {coordinate},
                            along = family.samples(side == Side::input ? Side::output : Side::input, looked_at,
                                                   Spacing::coordinate);
  RegionMap line;
  family.classify(line, side == Side::input ? here : along, side == Side::input ? along : here,
                  found.requirements.respect_direction, found.options.region);
  for (std::size_t cell = 0; cell < along.size(); ++cell)
    if (line.type(cell) != LinkageType::degenerate) return std::nullopt;
  return along.size();
}

std::string why_nothing(const LinkageFamily& family, const Findings& found, MapPoint place) {
  for (const auto& [side, coordinate, words] :
       {std::tuple(Side::input, place.input, "first"), std::tuple(Side::output, place.output, "second")})
    if (const auto count = gap_at(family, found, side, coordinate))
      return fmt::format(
          "{:g} lies in a gap of the {} axis: none of {} places looked at along the other has a linkage there.",
          coordinate, words, *count);
  return "no linkage of the task has these coordinates, a hinge is at infinity, a link has no length, or both grounded "
         "links are the same.";
}

Notice nothing_there(const LinkageFamily& family, const Findings& found, MapPoint place) {
  const double rows = family.axis(Side::input).coordinate_length(),
               columns = family.axis(Side::output).coordinate_length();
  const std::string where = fmt::format("({:g}, {:g})", place.input, place.output);
  return {"nothing_there",
          is_on_axes(family, place)
              ? fmt::format("There is no linkage at {} of the solution region: {}", where,
                            why_nothing(family, found, place))
              : fmt::format("{} is off the solution region: its axes run over [0, {:g}] and [0, {:g}].", where, rows,
                            columns),
          {{"input", place.input}, {"output", place.output}, {"rows", rows}, {"columns", columns}}};
}

Notice linkage_there(MapPoint place, const std::vector<RequirementKind>& failed) {
  std::string names;
  for (const RequirementKind kind : failed) names += fmt::format("{}{}", names.empty() ? "" : ", ", key(kind));
  return {"picked",
          fmt::format("The linkage at ({:g}, {:g}) of the solution region {}.", place.input, place.output,
                      failed.empty() ? "meets all requirements" : "does not meet " + names),
          {{"input", place.input}, {"output", place.output}, {"fails", names}}};
}

}  // namespace

std::optional<std::vector<RequirementKind>> failures_at(const LinkageFamily& family, const Findings& found,
                                                        MapPoint place) {
  if (!is_on_axes(family, place)) return std::nullopt;
  RegionMap cell;
  family.classify(cell, std::array{place.input}, std::array{place.output}, found.requirements.respect_direction,
                  found.options.region);
  measure_added(cell, family, found);
  if (cell.type(0) == LinkageType::degenerate) return std::nullopt;
  const RequirementFilter filter = filter_of(family, cell, found.requirements);
  return kinds_of(filter.failures(0, 0), filter.kinds());
}

void state_what_is_there(Findings& found, const LinkageFamily& family, std::size_t listed) {
  const MapPoint place = *found.options.at;
  found.status = listed == 0 ? SolutionStatus::no_solution : SolutionStatus::solved;
  found.reason = listed == 0 ? nothing_there(family, found, place) : linkage_there(place, found.fails.front());
}

}  // namespace linkwright
