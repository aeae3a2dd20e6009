#include "linkwright/spherical/spherical_map.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/parallel.hpp"
#include "linkwright/core/precondition.hpp"
#include "linkwright/core/tolerance.hpp"
#include "linkwright/mechanism/spherical_defects.hpp"
#include "region/pair_map.hpp"
#include "spherical/spherical_kernel.hpp"

namespace linkwright {
namespace {

void put_axis(SphericalAxis::Columns& columns, std::size_t at, Vector3 v) {
  for (std::size_t i = 0; i < 3; ++i) columns[i][at] = v[i];
}

void assign(SphericalAxis::Columns& columns, std::size_t count) {
  for (SphericalAxis::Column& column : columns) column.assign(count, 0);
}

// From that sample on.
SphericalKernelAxis plain_arrays(const SphericalAxis& axis, std::size_t first = 0) {
  SphericalKernelAxis plain{{},
                            {},
                            {},
                            axis.half_sine.data() + first,
                            axis.half_cosine.data() + first,
                            axis.admissible_directions.data() + first,
                            axis.at_least_half_turn.data() + first};
  for (std::size_t i = 0; i < 3; ++i) {
    plain.fixed[i] = axis.fixed[i].data() + first;
    for (std::size_t j = 0; j < axis.orientation_count(); ++j) {
      plain.moving[j][i] = axis.moving[j][i].data() + first;
      plain.normal[j][i] = axis.normal[j][i].data() + first;
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

// The kernel's own way, a pair of links at a time.
void classify_row(RegionMap& map, std::size_t row, const SphericalRow& links, Simd simd) {
  const std::size_t columns = map.columns(), orientations = links.input.orientation_count();
  require(links.input.size() == columns && links.output.size() == columns, "a row has two links a column");
  const auto kernel = spherical_kernel.for_simd(simd);
  for (std::size_t column = 0; column < columns; ++column)
    kernel({plain_arrays(links.input, column), plain_arrays(links.output, column), 0, 1, 1,
            static_cast<int>(orientations), tolerance::change_point, spherical_cells(map.cells(row, column))});
  const DriverTravel travel = driver_travel(links.input, 0);
  map.set_driver(row, travel);
  if (orientations != 2) std::fill_n(map.cells(row).admissible_directions, columns, travel.admissible_directions);
}

bool same_axes(const SphericalDyad& a, const SphericalDyad& b) {
  return a.fixed_axis == b.fixed_axis && a.moving_axis == b.moving_axis;
}

}  // namespace

SphericalAxis::SphericalAxis(std::size_t count, std::size_t orientations) {
  require(orientations >= 1 && orientations <= max_orientations, "one to five orientations are judged");
  for (std::size_t i = 0; i < count; ++i) dyads.push_back(no_spherical_dyad(0));
  assign(fixed, count);
  moving.resize(orientations);
  normal.resize(orientations);
  for (std::vector<Columns>* axes : {&moving, &normal})
    for (Columns& columns : *axes) assign(columns, count);
  half_sine.assign(count, 0);
  half_cosine.assign(count, 0);
  admissible_directions.assign(count, 0);
  at_least_half_turn.assign(count, 0);
  sweep_ccw.assign(count, 0);
}

void SphericalAxis::put(std::size_t at, const SphericalDyad& dyad, std::span<const Vector3> at_orientations) {
  dyads[at] = dyad;
  put_axis(fixed, at, dyad.fixed_axis);
  half_sine[at] = 0.5 * norm(dyad.fixed_axis - dyad.moving_axis);
  half_cosine[at] = 0.5 * norm(dyad.fixed_axis + dyad.moving_axis);
  for (std::size_t j = 0; j < at_orientations.size(); ++j) {
    put_axis(moving[j], at, at_orientations[j]);
    put_axis(normal[j], at, cross(dyad.fixed_axis, at_orientations[j]));
  }
}

void SphericalAxis::put(std::size_t at, const DriverSequence& order) {
  admissible_directions[at] = order.senses();
  at_least_half_turn[at] = order.half_turn_senses();
  sweep_ccw[at] = static_cast<float>(order.sweep_ccw);
}

SphericalAxis::SphericalAxis(std::vector<SphericalDyad> samples, std::span<const PrescribedOrientation> orientations,
                             bool respect_direction, bool drives)
    : SphericalAxis(samples.size(), orientations.size()) {
  std::vector<UnitQuaternion> turns;
  for (const PrescribedOrientation& there : orientations)
    turns.push_back(there.orientation * orientations.front().orientation.inverse());
  std::vector<Vector3> at_orientations(turns.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const SphericalDyad& dyad = samples[i];
    if (dyad.fixed_axis == Vector3{}) continue;
    for (std::size_t j = 0; j < turns.size(); ++j) at_orientations[j] = turns[j].apply(dyad.moving_axis);
    put(i, dyad, at_orientations);
    if (drives) put(i, driver_sequence(dyad, orientations, respect_direction));
  }
  dyads = std::move(samples);
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

void classify_rows(RegionMap& map, std::span<const double> input, std::span<const double> output,
                   const std::function<SphericalRow(std::size_t row)>& row_at, const RegionOptions& options,
                   const Progress& progress) {
  constexpr bool of_pairs = true;
  map.lay(input, output, spherical_measures, of_pairs, options);
  parallel_for(map.rows(), options.threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      if (progress.is_cancelled())
        map.leave_empty(row, row + 1);
      else
        classify_row(map, row, row_at(row), options.simd);
    }
  });
}

}  // namespace linkwright
