#include "linkwright/straight_line/straight_line_family.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/parallel.hpp"
#include "linkwright/planar/four_bar_family.hpp"
#include "linkwright/straight_line/straight_path.hpp"
#include "straight_line/line_cases.hpp"
#include "straight_line/line_estimate.hpp"

namespace linkwright {
namespace {

MapAxis axis_with_layers(const LineAxis& axis, const StraightLineCase& given, int layers) {
  MapAxis map_axis{axis.quantity, {}};
  for (int layer = 0; layer < layers; ++layer) {
    const std::string_view name = layers > 1 ? layer_name(given, layer) : linkwright::name(axis.quantity);
    map_axis.branches.push_back({std::string(name), static_cast<double>(layer), static_cast<double>(layer + 1)});
  }
  return map_axis;
}

// The linkages of a row as they are estimated, and where they go.
struct RowOfLinkages {
  std::vector<TracingFourBar> linkages;
  std::vector<std::size_t> columns;
  std::vector<LineEstimate> estimates;
};

void write_cell(const RegionMap::Cells& cells, std::size_t column, const TracingFourBar& linkage,
                const LineEstimate& estimate, LineMeasure measure) {
  cells.type[column] = static_cast<std::uint8_t>(linkage_type(linkage.bars.lengths()));
  auto values = measured_line(linkage, estimate.worth(measure));
  values[0] = estimate.usable_stroke;
  values[1] = estimate.usable_strip;
  values[6] = estimate.contact_coefficient;
  for (std::size_t i = 0; i < values.size(); ++i) cells.measures[i][column] = static_cast<float>(values[i]);
}

}  // namespace

StraightLineFamily::StraightLineFamily(StraightLineTask task, LineMeasuring measuring,
                                       const std::optional<MapWindow>& window)
    : LinkageFamily(axis_with_layers(axes_of(task)[0], task.given, layers_of(task.given)),
                    axis_with_layers(axes_of(task)[1], task.given, 1)),
      task_(std::move(task)),
      measuring_(measuring) {
  const auto axes = axes_of(task_);
  for (std::size_t i = 0; i < 2; ++i) {
    ranges_[i] = {axes[i].low, axes[i].high};
    if (!window || axes[i].quantity == AxisQuantity::nothing) continue;
    for (std::size_t end = 0; end < 2; ++end) {
      const double wanted = window->of(static_cast<Side>(i))[end];
      ranges_[i][end] = is_angle(axes[i].quantity) ? radians(wanted) : wanted;
    }
  }
}

int StraightLineFamily::layers() const { return layers_of(task_.given); }
std::string_view StraightLineFamily::layer_name(int layer) const { return linkwright::layer_name(task_.given, layer); }
int StraightLineFamily::contact() const { return promised_contact(task_.given); }

std::optional<std::array<double, 2>> StraightLineFamily::stroke() const {
  const auto* mixed = std::get_if<straight_cases::MixedContacts>(&task_.given);
  const double span = mixed ? mixed->contacts.back().s - mixed->contacts.front().s : 0;
  if (measuring_.stroke) return std::array{(span - *measuring_.stroke) / 2, (span + *measuring_.stroke) / 2};
  if (span > 0) return std::array{0.0, span};
  const auto* lambda = std::get_if<straight_cases::SymmetricLambdas>(&task_.given);
  return lambda ? std::optional(std::array{-lambda->stroke / 2, lambda->stroke / 2}) : std::nullopt;
}

Defects StraightLineFamily::defects(const TracingFourBar& linkage) const {
  const auto* mixed = std::get_if<straight_cases::MixedContacts>(&task_.given);
  if (!mixed) return {};
  constexpr bool respect_direction = true;
  const auto poses = contact_poses(linkage, task_.line, mixed->contacts);
  if (poses.empty()) return {Defects::branch_bit};  // to rounding the dyad lies stretched at a contact
  return find_defects(linkage.bars, poses, respect_direction).defects;
}

double StraightLineFamily::axis_value(Side side, double coordinate) const {
  const auto& [low, high] = ranges_[static_cast<std::size_t>(side)];
  const double share = side == Side::input ? coordinate - std::floor(coordinate) : coordinate;
  const double value = low + share * (high - low);
  return is_angle(axis(side).quantity) ? degrees(value) : value;
}

std::array<double, 2> StraightLineFamily::range(Side side) const {
  const auto& [low, high] = ranges_[static_cast<std::size_t>(side)];
  return is_angle(axis(side).quantity) ? std::array{degrees(low), degrees(high)} : std::array{low, high};
}

MapNumbers StraightLineFamily::place_of(MapPoint point) const {
  return {std::clamp(static_cast<int>(std::floor(point.input)), 0, layers() - 1),
          {axis_value(Side::input, point.input), axis_value(Side::output, point.output)}};
}

std::optional<MapPoint> StraightLineFamily::point_of(const MapNumbers& place) const {
  if (place.layer < 0 || place.layer >= layers()) return std::nullopt;
  std::array<double, 2> share{};
  for (std::size_t i = 0; i < 2; ++i) {
    if (axis(static_cast<Side>(i)).is_discrete()) continue;
    const auto [low, high] = range(static_cast<Side>(i));
    share[i] = (place.at[i] - low) / (high - low);
    if (!(share[i] >= 0 && share[i] <= 1)) return std::nullopt;
  }
  // The end of a layer is not the beginning of the next.
  const double end = std::nextafter(place.layer + 1.0, 0.0);
  return MapPoint{std::min(place.layer + share[0], end), share[1]};
}

LineDesign StraightLineFamily::design(MapPoint point) const {
  const MapNumbers place = place_of(point);
  const auto axes = axes_of(task_);
  const auto value = [&](std::size_t i) {
    return line_axis_value(axes[i], is_angle(axes[i].quantity) ? radians(place.at[i]) : place.at[i]);
  };
  return designs_at(task_, value(0), value(1))[static_cast<std::size_t>(place.layer)];
}

std::vector<double> StraightLineFamily::samples(Side side, int count, Spacing spacing) const {
  if (side == Side::output || axis(side).is_discrete()) return LinkageFamily::samples(side, count, spacing);
  std::vector<double> coordinates;
  for (int layer = 0; layer < layers(); ++layer)
    for (int i = 0; i < count; ++i) coordinates.push_back(layer + (i + 0.5) / count);
  return coordinates;
}

LinkageFamily::CellAt StraightLineFamily::cells(bool /*respect_direction*/) const {
  return [this, estimated = estimate_task(*this)](MapPoint place, const auto& is_worth_it) -> std::optional<Cell> {
    const LineDesign there = design(place);
    if (there.kind != DesignKind::four_bar) return std::nullopt;
    const TracingFourBar& linkage = there.linkage;
    Cell cell = line_cell(linkage, LineWorth::unknown());
    cell.place = place;
    cell.defects = defects(linkage);
    if (cell.type == LinkageType::degenerate || !is_worth_it(cell)) return std::nullopt;
    const auto line = exact_line(linkage, estimated, measuring_.deviation_of(linkage));
    if (!line) return std::nullopt;
    const auto values = measured_line(linkage, line->worth(measuring_.measure));
    std::copy(values.begin(), values.end(), cell.values.begin());
    return cell;
  };
}

MapPivots StraightLineFamily::pivots(const RegionMap& map) const {
  MapPivots found;
  found.of_cell = [this, &map](std::size_t row, std::size_t column) -> std::optional<Pivots> {
    const LineDesign found_there = design({map.input_coordinates()[row], map.output_coordinates()[column]});
    if (found_there.kind != DesignKind::four_bar) return std::nullopt;
    return pivots_of(found_there.linkage.bars);
  };
  return found;
}

namespace {

LinkageOutput output_over(const StraightPath& path, double from, double to, const DirectedLine& line, int places) {
  std::vector<TracingFourBar> positions;
  for (const StraightPath::State& state : path.states(from, to, places)) positions.push_back(state.linkage);
  constexpr bool realigned = false;
  return line_output(std::move(positions), line, realigned);
}

}  // namespace

std::optional<LinkageOutput> StraightLineFamily::output(MapPoint place) const {
  const LineDesign found = design(place);
  return found.kind == DesignKind::four_bar ? output_of(found.linkage, places_of_cell) : std::nullopt;
}

std::optional<LinkageOutput> StraightLineFamily::output_of(const TracingFourBar& linkage, int places) const {
  const DirectedLine& line = task_.line;
  if (const auto asked = stroke()) {
    const auto [from, to] = *asked;
    const double room = 1e-6 * (to - from);  // a path is traced both ways from where the linkage lies
    const auto path =
        StraightPath::of(linkage, line.direction, {.from = std::min(from, -room), .to = std::max(to, room)});
    if (path && path->reaches(from, to)) return output_over(*path, from, to, line, places);
  }
  const double deviation = measuring_.deviation_of(linkage);
  const bool is_strip = measuring_.measure == LineMeasure::strip;
  const auto path = StraightPath::of(linkage, line.direction, {.max_deviation = (is_strip ? 2.1 : 1.1) * deviation});
  if (!path) return std::nullopt;
  const UsableLine usable = is_strip ? path->usable_strip(deviation) : path->usable(deviation);
  return output_over(*path, usable.from, usable.to, line, places);
}

void StraightLineFamily::fill(RegionMap& map, std::span<const double> input, std::span<const double> output,
                              bool /*respect_direction*/, const RegionOptions& options,
                              const Progress& progress) const {
  map.lay(input, output, straight_line_measures, false, options);
  map.leave_out_drivers();
  const auto axes = axes_of(task_);
  const auto value = [&](Side side, double coordinate) {
    const LineAxis& along = axes[static_cast<std::size_t>(side)];
    const double read = axis_value(side, coordinate);
    return line_axis_value(along, is_angle(along.quantity) ? radians(read) : read);
  };
  std::vector<LineAxisValue> columns;
  for (const double coordinate : output) columns.push_back(value(Side::output, coordinate));
  const LineEstimateTask estimated = estimate_task(*this, options.simd);
  const bool has_defects = std::holds_alternative<straight_cases::MixedContacts>(task_.given);
  parallel_for(input.size(), options.threads, [&](std::size_t begin, std::size_t end) {
    RowOfLinkages row_of;
    row_of.estimates.resize(output.size());
    for (std::size_t row = begin; row < end; ++row) {
      map.leave_empty(row, row + 1);
      if (progress.is_cancelled()) continue;
      const auto layer = static_cast<std::size_t>(place_of({input[row], 0}).layer);
      const LineAxisValue first = value(Side::input, input[row]);
      const RegionMap::Cells cells = map.cells(row);
      row_of.linkages.clear();
      row_of.columns.clear();
      for (std::size_t column = 0; column < columns.size(); ++column) {
        const LineDesign found = designs_at(task_, first, columns[column])[layer];
        if (found.kind == DesignKind::slider) cells.measures[straight_line_measures.size() - 1][column] = 2;
        if (found.kind != DesignKind::four_bar) continue;
        row_of.linkages.push_back(found.linkage);
        row_of.columns.push_back(column);
      }
      estimate_lines(row_of.linkages, estimated, row_of.estimates);
      for (std::size_t i = 0; i < row_of.linkages.size(); ++i)
        write_cell(cells, row_of.columns[i], row_of.linkages[i], row_of.estimates[i], measuring_.measure);
      for (std::size_t i = 0; i < row_of.linkages.size() && has_defects; ++i)
        cells.defects[row_of.columns[i]] = defects(row_of.linkages[i]).bits;
    }
  });
}

}  // namespace linkwright
