#include "linkwright/spherical/spherical_family.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/spherical_defects.hpp"
#include "spherical/spherical_cells.hpp"

namespace linkwright {
namespace {

MapAxis axis_of_points(std::size_t count) {
  MapAxis axis{AxisQuantity::burmester_point, {}};
  for (std::size_t i = 0; i < count; ++i)
    axis.branches.push_back({"point", static_cast<double>(i), static_cast<double>(i + 1)});
  return axis;
}

}  // namespace

SphericalFourBar four_bar_of(const SphericalDyadPair& links) {
  return with_short_links(
      {links.input.fixed_axis, links.input.moving_axis, links.output.moving_axis, links.output.fixed_axis});
}

Pivots pivots_of(const SphericalFourBar& bars) {
  return {{bars.input_fixed, bars.output_fixed}, {bars.input_moving, bars.output_moving}};
}

SphericalFourBar spherical_four_bar_of(const Pivots& pivots) {
  return {pivots.ground[0], pivots.moving[0], pivots.moving[1], pivots.ground[1]};
}

namespace {

// Before it is known what it does in the orientations of the task.
Cell still_spherical_cell(MapPoint place, const SphericalFourBar& bars) {
  constexpr double not_known = std::numeric_limits<double>::quiet_NaN();
  const LinkAngles angles = bars.angles();
  Cell cell;
  cell.type = linkage_type(angles);
  cell.values = {not_known, not_known, versine_of_angle(angles.shortest()),
                 versine_of_angle(angles.longest())};  // spherical_measures
  cell.place = place;
  cell.pivots = pivots_of(bars);
  cell.change_point_margin = change_point_margin(angles);
  return cell;
}

}  // namespace

LinkageFamily::CellAt SphericalFamily::cells(bool respect_direction) const {
  return [this, respect_direction, known = std::optional<SphericalDyadPair>()](
             MapPoint place, const auto& is_worth_it) mutable -> std::optional<Cell> {
    const auto links = known ? dyad_pair_reusing(place, *known) : dyad_pair(place);
    if (!links) return std::nullopt;
    known = links;
    const SphericalFourBar bars = four_bar(*links);
    Cell cell = still_spherical_cell(place, bars);
    if (cell.type == LinkageType::degenerate || !is_worth_it(cell)) return std::nullopt;
    return driven(std::move(cell), find_defects(bars, orientations(place, bars), respect_direction));
  };
}

double SphericalFamily::distance(const Pivots& one, const Pivots& other) const {
  // 1 − |cos| of the largest angle.
  const auto farthest = [](const SphericalFourBar& a, const SphericalFourBar& b) {
    const auto apart = [](Vector3 p, Vector3 q) { return 1 - std::abs(dot(p, q)); };
    return std::max({apart(a.input_fixed, b.input_fixed), apart(a.input_moving, b.input_moving),
                     apart(a.output_fixed, b.output_fixed), apart(a.output_moving, b.output_moving)});
  };
  const SphericalFourBar a = spherical_four_bar_of(one), b = spherical_four_bar_of(other);
  return std::sqrt(std::max(0.0, 2 * std::min(farthest(a, b), farthest(a, b.swapped()))));
}

std::optional<LinkageOutput> SphericalFamily::output(MapPoint place) const {
  const auto links = dyad_pair(place);
  return links ? std::optional(output_of(place, four_bar(*links))) : std::nullopt;
}

LinkageOutput SphericalFamily::output_of(MapPoint place, const SphericalFourBar& bars) const {
  return spherical_output(SphericalOutput::Kind::orientation, bars, orientations(place, bars));
}

SphericalProductFamily::SphericalProductFamily(std::vector<PrescribedOrientation> orientations, MapAxis input,
                                               MapAxis output)
    : SphericalFamily(std::move(input), std::move(output)), orientations_(std::move(orientations)) {}

std::optional<SphericalDyadPair> SphericalProductFamily::dyad_pair(MapPoint place) const {
  const auto input = dyad(place.input), output = dyad(place.output);
  if (!input || !output) return std::nullopt;
  return SphericalDyadPair{*input, *output};
}

std::optional<SphericalDyadPair> SphericalProductFamily::dyad_pair_reusing(MapPoint place,
                                                                           const SphericalDyadPair& known) const {
  const auto input = known.input.coordinate == place.input ? std::optional(known.input) : dyad(place.input);
  const auto output = known.output.coordinate == place.output ? std::optional(known.output) : dyad(place.output);
  if (!input || !output) return std::nullopt;
  return SphericalDyadPair{*input, *output};
}

std::vector<SphericalDyad> SphericalProductFamily::dyads(std::span<const double> coordinates) const {
  std::vector<SphericalDyad> found;
  found.reserve(coordinates.size());
  for (const double coordinate : coordinates) found.push_back(dyad(coordinate).value_or(no_spherical_dyad(coordinate)));
  return found;
}

GroundedLinkPivots SphericalProductFamily::pivots_at(double coordinate) const {
  const auto found = dyad(coordinate);
  return found ? GroundedLinkPivots{found->fixed_axis, found->moving_axis} : GroundedLinkPivots{};
}

MapPivots SphericalProductFamily::pivots(const RegionMap& map) const {
  const auto hinges_at = [&](std::span<const double> coordinates) {
    std::vector<GroundedLinkPivots> hinges;
    for (const double coordinate : coordinates) hinges.push_back(pivots_at(coordinate));
    return hinges;
  };
  return {hinges_at(map.input_coordinates()), hinges_at(map.output_coordinates()), {}};
}

std::shared_ptr<const SphericalCells> SphericalProductFamily::spherical_cells(const RegionMap& map) const {
  const auto along = [&](std::span<const double> coordinates) {
    std::vector<std::optional<SphericalDyad>> found;
    for (const double coordinate : coordinates) found.push_back(dyad(coordinate));
    return found;
  };
  return std::make_shared<const SphericalCells>(
      SphericalCells{orientations_, along(map.input_coordinates()), along(map.output_coordinates())});
}

std::optional<AxisArcs> SphericalProductFamily::arcs_within(Side side, const PivotWindows& windows) const {
  return AxisArcs{arcs_with_borders(side, windows, {}), axis(side).is_discrete()};
}

std::vector<AxisArc> SphericalProductFamily::arcs_with_borders(Side side, const PivotWindows& windows,
                                                               std::vector<double> borders) const {
  std::vector<double> knots;
  for (const SphericalDyad& corner : polygon(side)) knots.push_back(corner.coordinate);
  return linkwright::arcs_within(
      axis(side), std::move(knots), windows, [&](double coordinate) { return pivots_at(coordinate); },
      std::move(borders));
}

void SphericalProductFamily::fill(RegionMap& map, std::span<const double> input, std::span<const double> output,
                                  bool respect_direction, const RegionOptions& options,
                                  const Progress& progress) const {
  const SphericalAxis rows(dyads(input), orientations_, respect_direction);
  const bool square = input.size() == output.size() && std::equal(input.begin(), input.end(), output.begin());
  if (square) return classify_pairs(map, rows, rows, options, progress);
  constexpr bool drives = false;
  classify_pairs(map, rows, SphericalAxis(dyads(output), orientations_, respect_direction, drives), options, progress);
}

SphericalCurveFamily::SphericalCurveFamily(std::vector<PrescribedOrientation> orientations,
                                           std::shared_ptr<const AxisCurve> curve)
    : SphericalProductFamily(std::move(orientations), {AxisQuantity::curve_coordinate, curve->branches()},
                             {AxisQuantity::curve_coordinate, curve->branches()}),
      curve_(std::move(curve)) {}

std::optional<SphericalDyad> SphericalCurveFamily::dyad(double coordinate) const {
  return curve_->coordinate_length() > 0 ? std::optional(curve_->dyad(coordinate)) : std::nullopt;
}

std::vector<double> SphericalCurveFamily::samples(Side /*side*/, int count, Spacing spacing) const {
  return curve_->samples(count, spacing);
}

std::vector<SphericalDyad> SphericalCurveFamily::polygon(Side /*side*/) const { return curve_->polygon(); }

std::optional<AxisArcs> SphericalCurveFamily::arcs_within(Side side, const PivotWindows& windows) const {
  std::vector<double> borders;
  bool are_all = true;
  const auto meet = [&](const std::optional<PivotWindow>& window, const CubicForm& form, auto moving_axis_of) {
    if (!window) return;
    const Cone& cone = std::get<Cone>(*window);
    const auto lines = lines_at_angle(form, cone.axis, cone.half_angle);
    are_all &= lines.has_value();
    if (!lines) return;
    for (const Vector3 line : *lines)
      if (const auto coordinate = curve_->coordinate_of(moving_axis_of(line))) borders.push_back(*coordinate);
  };
  const OrientationConditions seen_from_body = inverted(curve_->conditions());
  meet(windows.ground, moving_axis_form(seen_from_body),
       [&](Vector3 fixed) { return fixed_axis_of(fixed, seen_from_body); });
  meet(windows.moving, curve_->cone().form(), [](Vector3 moving) { return moving; });
  return AxisArcs{arcs_with_borders(side, windows, std::move(borders)), are_all};
}

SphericalPointFamily::SphericalPointFamily(std::vector<PrescribedOrientation> orientations,
                                           std::vector<SphericalDyad> dyads)
    : SphericalProductFamily(std::move(orientations), axis_of_points(dyads.size()), axis_of_points(dyads.size())),
      dyads_(std::move(dyads)) {}

std::optional<SphericalDyad> SphericalPointFamily::dyad(double coordinate) const {
  if (!(coordinate >= 0 && coordinate < static_cast<double>(dyads_.size()))) return std::nullopt;
  return dyads_[static_cast<std::size_t>(coordinate)];
}

}  // namespace linkwright
