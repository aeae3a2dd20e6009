#include "picked_place.hpp"

#include <array>
#include <fmt/format.h>
#include <string>

#include "linkwright/region/requirement_filter.hpp"
#include "region_count.hpp"

namespace linkwright {
namespace {

// Its end is a place of an axis too: where the axis is closed, the same as its beginning.
bool is_on_axis(const LinkageFamily& family, Side side, double coordinate) {
  return coordinate >= 0 && coordinate <= family.axis(side).coordinate_length();
}

bool is_on_axes(const LinkageFamily& family, MapPoint place) {
  return is_on_axis(family, Side::input, place.input) && is_on_axis(family, Side::output, place.output);
}

Notice nothing_there(const LinkageFamily& family, MapPoint place) {
  const double rows = family.axis(Side::input).coordinate_length(),
               columns = family.axis(Side::output).coordinate_length();
  const std::string where = fmt::format("({:g}, {:g})", place.input, place.output);
  return {"nothing_there",
          is_on_axes(family, place)
              ? fmt::format("There is no linkage at {} of the solution region: a hinge is at infinity, a link has no "
                            "length, or both grounded links are the same.",
                            where)
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
  const unsigned bits = filter.failures(0, 0);
  std::vector<RequirementKind> failed;
  for (std::size_t k = 0; k < filter.kinds().size(); ++k)
    if ((bits >> k & 1) != 0) failed.push_back(filter.kinds()[k]);
  return failed;
}

void state_what_is_there(Findings& found, const LinkageFamily& family, std::size_t listed) {
  const MapPoint place = *found.options.at;
  found.status = listed == 0 ? SolutionStatus::no_solution : SolutionStatus::solved;
  found.reason = listed == 0 ? nothing_there(family, place) : linkage_there(place, found.fails.front());
}

}  // namespace linkwright
