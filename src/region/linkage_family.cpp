#include "linkwright/region/linkage_family.hpp"

#include <algorithm>

#include "linkwright/mechanism/defects.hpp"
#include "linkwright/region/axis_arcs.hpp"

namespace linkwright {

double LinkageFamily::axis_value(Side /*side*/, double coordinate) const { return coordinate; }

std::vector<double> LinkageFamily::samples(Side side, int count, Spacing /*spacing*/) const {
  const MapAxis& along = axis(side);
  std::vector<double> coordinates;
  if (along.is_discrete()) {
    for (const CurveBranch& branch : along.branches) coordinates.push_back((branch.from + branch.to) / 2);
    return coordinates;
  }
  for (int i = 0; i < count && along.coordinate_length() > 0; ++i)
    coordinates.push_back(along.coordinate_length() * (i + 0.5) / count);
  return coordinates;
}

std::optional<Cell> driven(Cell cell, const DefectReport& report) {
  if (report.type == LinkageType::degenerate) return std::nullopt;
  cell.type = report.type;
  cell.hill = static_cast<std::size_t>(report.type);
  cell.defects = report.defects;
  cell.values[0] = versine_of_angle(report.min_transmission_angle);
  cell.values[1] = versine_of_angle(report.min_transmission_angle_full_turn);
  return cell;
}

std::optional<Cell> LinkageFamily::cell(MapPoint place, bool respect_direction) const {
  return cells(respect_direction)(place, [](const Cell&) { return true; });
}

AxisStretch LinkageFamily::stretch_around(Side side, MapPoint place) const {
  return axis(side).stretch_around(side == Side::input ? place.input : place.output);
}

double LinkageFamily::distance(const Pivots& one, const Pivots& other) const {
  const auto farthest = [](const Hinges& of_one, const Hinges& of_other, bool backwards) {
    double distance = 0;
    for (std::size_t i = 0; i < of_one.size(); ++i)
      distance = std::max(distance, norm(of_one[i] - of_other[backwards ? of_other.size() - 1 - i : i]));
    return distance;
  };
  const auto named = [&](bool backwards) {
    return std::max(farthest(one.ground, other.ground, backwards), farthest(one.moving, other.moving, backwards));
  };
  return std::min(named(false), named(true));
}

std::vector<double> samples_within(const LinkageFamily& family, Side side, const std::optional<MapWindow>& window,
                                   int count, Spacing spacing) {
  if (!window || family.axis(side).is_discrete()) return family.samples(side, count, spacing);
  const auto [low, high] = window->of(side);
  std::vector<double> coordinates;
  for (int i = 0; i < count; ++i) coordinates.push_back(low + (high - low) * (i + 0.5) / count);
  return coordinates;
}

LinkageFamily::OutputOfCells LinkageFamily::outputs_of(const RegionMap& map) const {
  return [this, &map](std::size_t row, std::size_t column) {
    return output({map.input_coordinates()[row], map.output_coordinates()[column]});
  };
}

std::shared_ptr<const FourBarCells> LinkageFamily::four_bar_cells(const RegionMap& /*map*/) const { return nullptr; }
std::shared_ptr<const SphericalCells> LinkageFamily::spherical_cells(const RegionMap& /*map*/) const { return nullptr; }

bool is_within(const LinkageFamily& family, const std::optional<MapWindow>& window, MapPoint point) {
  const auto holds = [&](Side side, double coordinate) {
    if (family.axis(side).is_discrete()) return true;
    const auto arcs = arcs_of(family.axis(side), window->of(side));
    const double folded = family.axis(side).onto(coordinate);
    return std::any_of(arcs.begin(), arcs.end(), [&](const AxisArc& arc) {
      return (coordinate >= arc.from && coordinate <= arc.to) || (folded >= arc.from && folded <= arc.to);
    });
  };
  return !window || (holds(Side::input, point.input) && holds(Side::output, point.output));
}

}  // namespace linkwright
