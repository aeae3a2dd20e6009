#include "spherical_function_family.hpp"

#include <algorithm>
#include <utility>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/spherical_defects.hpp"
#include "spherical_function_linkage.hpp"

namespace linkwright {
namespace {

using Turns = std::vector<Matrix3x3>;

// About a fixed axis, from the first pair to each.
Turns turns_of(const std::vector<AnglePair>& pairs, Vector3 axis, double AnglePair::*angle) {
  Turns turns;
  for (const AnglePair& pair : pairs)
    turns.push_back(UnitQuaternion::about(axis, pair.*angle - pairs.front().*angle).matrix());
  return turns;
}

// The input link as a body that turns.
std::vector<PrescribedOrientation> input_orientations(const std::vector<AnglePair>& pairs, Vector3 axis) {
  std::vector<PrescribedOrientation> orientations;
  for (const AnglePair& pair : pairs) {
    orientations.push_back({UnitQuaternion::about(axis, pair.input - pairs.front().input), {}});
    for (const AngleDerivative& derivative : pair.derivatives)
      orientations.back().derivatives.push_back(derivative.input * axis);
  }
  return orientations;
}

void put(SphericalAxis& axis, std::size_t at, const SphericalDyad& dyad, const Turns& turns) {
  std::vector<Vector3> moving;
  for (const Matrix3x3& turn : turns) moving.push_back(turn * dyad.moving_axis);
  axis.put(at, dyad, moving);
}

}  // namespace

SphericalFunctionFamily::SphericalFunctionFamily(SphericalFunctionTask task,
                                                 std::shared_ptr<const SphericalCouplers> couplers)
    : SphericalFunctionFamily(
          task, std::make_unique<const Columns>(task, std::move(couplers),
                                                [ground = task.ground_angle](const std::vector<AnglePair>& pairs) {
                                                  return spherical_couplers(pairs, ground);
                                                })) {}

SphericalFunctionFamily::SphericalFunctionFamily(SphericalFunctionTask task, std::unique_ptr<const Columns> columns)
    : SphericalFamily(columns->coupler_axis(), axis_of(task.free)),
      task_(std::move(task)),
      columns_(std::move(columns)),
      axes_(fixed_axes(task_.ground_angle)) {}

SphericalFunctionTask SphericalFunctionFamily::task_at(MapPoint place) const {
  return task_.free ? linkwright::task_at(task_, columns_->value_at(place.output)) : task_;
}

FunctionError SphericalFunctionFamily::error_of(const SphericalFourBar& bars, MapPoint place,
                                                const ErrorSampling& sampling) const {
  return columns_->error_of([&](const AnglePair& first) { return generated_function(bars, first); }, place.output,
                            sampling);
}

bool SphericalFunctionFamily::are_alike(const Pivots& one, const Pivots& other) const {
  constexpr double alike = pi / 180;
  return norm(cross(one.moving[0], other.moving[0])) < alike && norm(cross(one.moving[1], other.moving[1])) < alike;
}

std::optional<double> SphericalFunctionFamily::rate_residual(MapPoint place) const {
  const Columns::Column column = columns_->recent_at(place.output);
  const auto coupler = column.couplers->coupler(axis(Side::input).onto(place.input));
  const auto rows = derivative_rows(column.pairs, column.couplers->conditions);
  if (!coupler || rows.empty()) return std::nullopt;
  return residual_of(coupler->fixed_axis, coupler->moving_axis, rows);
}

SphericalDyadPair SphericalFunctionFamily::links_of(const SphericalDyad& coupler, MapPoint place) const {
  return {{axes_[0], coupler.fixed_axis, place.input}, {axes_[1], coupler.moving_axis, place.output}};
}

std::optional<SphericalDyadPair> SphericalFunctionFamily::dyad_pair(MapPoint place) const {
  const auto found = columns_->recent_at(place.output).couplers->coupler(axis(Side::input).onto(place.input));
  return found ? std::optional(links_of(*found, place)) : std::nullopt;
}

SphericalFourBar SphericalFunctionFamily::four_bar(const SphericalDyadPair& links) const {
  return with_short_side_links(
      {links.input.fixed_axis, links.input.moving_axis, links.output.moving_axis, links.output.fixed_axis});
}

std::vector<PrescribedOrientation> SphericalFunctionFamily::orientations(MapPoint place,
                                                                         const SphericalFourBar& bars) const {
  return coupler_orientations(bars, columns_->pairs_at(place.output));
}

LinkageOutput SphericalFunctionFamily::output_of(MapPoint place, const SphericalFourBar& bars) const {
  return spherical_output(SphericalOutput::Kind::angle, bars, orientations(place, bars));
}

double SphericalFunctionFamily::axis_value(Side side, double tau) const {
  return side == Side::input ? tau : axis_value_of(task_.free, tau);
}

std::vector<double> SphericalFunctionFamily::samples(Side side, int count, Spacing spacing) const {
  const auto& curve = columns_->couplers().curve;
  if (side == Side::input && !task_.free && curve) return curve->samples(count, spacing);
  return SphericalFamily::samples(side, count, spacing);
}

MapPivots SphericalFunctionFamily::pivots(const RegionMap& map) const {
  constexpr int any_threads = 0;
  const auto columns =
      std::make_shared<const std::vector<Columns::Column>>(columns_->along(map.output_coordinates(), any_threads));
  const auto of_cell = [this, columns, &map](std::size_t row, std::size_t column) -> std::optional<Pivots> {
    const auto found = (*columns)[column].couplers->coupler(axis(Side::input).onto(map.input_coordinates()[row]));
    if (!found) return std::nullopt;
    return Pivots{{axes_[0], axes_[1]}, {found->fixed_axis, found->moving_axis}};
  };
  return {{}, {}, of_cell};
}

std::vector<SphericalDyad> SphericalFunctionFamily::polygon(Side side) const {
  const SphericalCouplers& all = columns_->couplers();
  if (task_.free) return {};
  std::vector<SphericalDyad> links;
  for (const SphericalDyad& coupler : all.curve ? all.curve->polygon() : all.points) {
    const SphericalDyadPair both = links_of(coupler, {coupler.coordinate, coupler.coordinate});
    links.push_back(side == Side::input ? both.input : both.output);
  }
  return links;
}

void SphericalFunctionFamily::fill(RegionMap& map, std::span<const double> input, std::span<const double> output,
                                   bool respect_direction, const RegionOptions& options,
                                   const Progress& progress) const {
  const std::vector<Columns::Column> columns = columns_->along(output, options.threads, progress);
  const Turns input_turns = turns_of(task_.pairs, axes_[0], &AnglePair::input);
  std::vector<Turns> output_turns;
  for (const Columns::Column& column : columns)
    output_turns.push_back(turns_of(column.pairs, axes_[1], &AnglePair::output));
  // All input links turn alike: the one that would lie along the output's fixed axis stands for them.
  const DriverSequence order =
      driver_sequence({axes_[0], axes_[1], 0}, input_orientations(task_.pairs, axes_[0]), respect_direction);
  const auto row_at = [&](std::size_t row) {
    SphericalRow links{{columns.size(), input_turns.size()}, {columns.size(), input_turns.size()}};
    for (std::size_t k = 0; k < columns.size(); ++k) {
      links.input.put(k, order);
      const auto found = columns[k].couplers->coupler(axis(Side::input).onto(input[row]));
      if (!found) continue;
      const SphericalDyadPair both = links_of(*found, {input[row], output[k]});
      put(links.input, k, both.input, input_turns);
      put(links.output, k, both.output, output_turns[k]);
    }
    return links;
  };
  classify_rows(map, input, output, row_at, options, progress);
}

void structural_errors_deg(const SphericalFunctionFamily& family, const RegionMap& map, std::span<float> values) {
  structural_errors_deg(map, values, [&](MapPoint place) -> std::optional<FunctionError> {
    const auto links = family.dyad_pair(place);
    if (!links) return std::nullopt;
    return family.error_of(family.four_bar(*links), place, ErrorSampling::coarse());
  });
}

SphericalTaskFamily task_family(const SphericalFunctionTask& task) {
  auto couplers = std::make_shared<const SphericalCouplers>(spherical_couplers(task.pairs, task.ground_angle));
  SphericalTaskFamily given;
  given.pattern = pattern(task.pairs);
  given.has_directions =
      std::any_of(task.pairs.begin(), task.pairs.end(), [](const AnglePair& pair) { return pair.multiplicity() > 1; });
  given.conditions = couplers->conditions;
  given.curve = couplers->curve;
  given.warnings = couplers->warnings;
  given.degeneracy = couplers->degeneracy;
  if (!given.degeneracy) given.functions = std::make_shared<SphericalFunctionFamily>(task, std::move(couplers));
  given.family = given.functions;
  return given;
}

}  // namespace linkwright
