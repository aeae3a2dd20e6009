#include "linkwright/spherical/spherical_map.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/parallel.hpp"
#include "linkwright/core/precondition.hpp"
#include "linkwright/core/tolerance.hpp"
#include "linkwright/spherical/spherical_defects.hpp"
#include "region/pair_map.hpp"
#include "spherical/spherical_kernel.hpp"

namespace linkwright {
namespace {

void put(SphericalAxis::Columns& columns, std::size_t at, Vector3 v) {
  for (std::size_t i = 0; i < 3; ++i) columns[i][at] = v[i];
}

void assign(SphericalAxis::Columns& columns, std::size_t count) {
  for (SphericalAxis::Column& column : columns) column.assign(count, 0);
}

SphericalKernelAxis plain_arrays(const SphericalAxis& axis) {
  SphericalKernelAxis plain{{},
                            {},
                            {},
                            axis.half_sine.data(),
                            axis.half_cosine.data(),
                            axis.admissible_directions.data(),
                            axis.at_least_half_turn.data()};
  for (std::size_t i = 0; i < 3; ++i) {
    plain.fixed[i] = axis.fixed[i].data();
    for (std::size_t j = 0; j < axis.orientation_count(); ++j) {
      plain.moving[j][i] = axis.moving[j][i].data();
      plain.normal[j][i] = axis.normal[j][i].data();
    }
  }
  return plain;
}

std::vector<double> coordinates_of(const std::vector<SphericalDyad>& dyads) {
  std::vector<double> coordinates;
  coordinates.reserve(dyads.size());
  for (const SphericalDyad& dyad : dyads) coordinates.push_back(dyad.coordinate);
  return coordinates;
}

SphericalKernelCells spherical_cells(const RegionMap::Cells& cells) {
  return {cells.type,        cells.defects,     cells.measures[0],          cells.measures[1],
          cells.measures[2], cells.measures[3], cells.admissible_directions};
}

bool same_axes(const SphericalDyad& a, const SphericalDyad& b) {
  return a.fixed_axis == b.fixed_axis && a.moving_axis == b.moving_axis;
}

}  // namespace

SphericalAxis::SphericalAxis(std::vector<SphericalDyad> samples, std::span<const PrescribedOrientation> orientations,
                             bool respect_direction, bool drives)
    : dyads(std::move(samples)) {
  require(!orientations.empty() && orientations.size() <= max_orientations, "one to five orientations are judged");
  const std::size_t count = dyads.size();
  assign(fixed, count);
  moving.resize(orientations.size());
  normal.resize(orientations.size());
  for (std::vector<Columns>* axes : {&moving, &normal})
    for (Columns& columns : *axes) assign(columns, count);
  half_sine.assign(count, 0);
  half_cosine.assign(count, 0);
  admissible_directions.assign(count, 0);
  at_least_half_turn.assign(count, 0);
  sweep_ccw.assign(count, 0);
  std::vector<UnitQuaternion> turns;
  for (const PrescribedOrientation& there : orientations)
    turns.push_back(there.orientation * orientations.front().orientation.inverse());
  for (std::size_t i = 0; i < count; ++i) {
    const SphericalDyad& dyad = dyads[i];
    if (dyad.fixed_axis == Vector3{}) continue;
    put(fixed, i, dyad.fixed_axis);
    half_sine[i] = 0.5 * norm(dyad.fixed_axis - dyad.moving_axis);
    half_cosine[i] = 0.5 * norm(dyad.fixed_axis + dyad.moving_axis);
    for (std::size_t j = 0; j < turns.size(); ++j) {
      const Vector3 there = turns[j].apply(dyad.moving_axis);
      put(moving[j], i, there);
      put(normal[j], i, cross(dyad.fixed_axis, there));
    }
    if (!drives) continue;
    const DriverSequence order = driver_sequence(dyad, orientations, respect_direction);
    admissible_directions[i] = sense_bits(order.ccw, order.cw);
    at_least_half_turn[i] = sense_bits(order.is_at_least_half_turn_ccw(), order.is_at_least_half_turn_cw());
    sweep_ccw[i] = static_cast<float>(order.sweep_ccw);
  }
}

void classify_pairs(RegionMap& map, const SphericalAxis& input, const SphericalAxis& output,
                    const RegionOptions& options, const Progress& progress) {
  require(input.orientation_count() == output.orientation_count(), "both axes are of one task");
  map.lay(coordinates_of(input.dyads), coordinates_of(output.dyads), spherical_measures,
          pairs_decide_sense(input, input.orientation_count()), options);
  map.set_diagonal(diagonal_of(input.dyads, output.dyads, same_axes));
  for (std::size_t row = 0; row < map.rows(); ++row) map.set_driver(row, driver_travel(input, row));
  const SphericalKernelTask task{plain_arrays(input),
                                 plain_arrays(output),
                                 0,
                                 map.rows(),
                                 map.columns(),
                                 static_cast<int>(input.orientation_count()),
                                 tolerance::change_point,
                                 spherical_cells(map.cells(0))};
  run_rows(map, task, spherical_kernel.for_simd(options.simd), options, progress);
}

}  // namespace linkwright
