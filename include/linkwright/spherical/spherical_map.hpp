#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "linkwright/mechanism/driver_sequence.hpp"
#include "linkwright/mechanism/pose.hpp"
#include "linkwright/mechanism/spherical_four_bar.hpp"
#include "linkwright/region/region_map.hpp"

namespace linkwright {

/// What maps of spherical four-bars hold, in this order.
inline constexpr std::array<Measure, 4> spherical_measures = {measures::min_transmission_angle,
                                                              measures::min_transmission_angle_full_turn,
                                                              measures::min_link_angle, measures::max_link_angle};

/// Memory of a map of spherical four-bars; one byte more where a driver may meet two orientations either way.
inline constexpr std::size_t spherical_bytes_per_cell = 2 + spherical_measures.size() * sizeof(float);

/// One axis of a map of spherical four-bars: everything that belongs to a single grounded link, computed once per
/// sample (structure of arrays).
struct SphericalAxis {
  using Column = std::vector<double>;
  using Columns = std::array<Column, 3>;

  /// `orientations`: the distinct ones. A null dyad makes degenerate pairs. `drives`: false leaves out what only a
  /// driver needs.
  SphericalAxis(std::vector<SphericalDyad> samples, std::span<const PrescribedOrientation> orientations,
                bool respect_direction = true, bool drives = true);

  /// `count` places without a link, of so many orientations.
  SphericalAxis(std::size_t count, std::size_t orientations);

  /// Puts a link at a place: its moving axis as it lies at each orientation, the dyad's own the first.
  void put(std::size_t at, const SphericalDyad& dyad, std::span<const Vector3> at_orientations);
  /// In which senses the link there, as driver, meets the orientations.
  void put(std::size_t at, const DriverSequence& order);

  [[nodiscard]] std::size_t size() const { return dyads.size(); }
  [[nodiscard]] std::size_t orientation_count() const { return moving.size(); }

  std::vector<SphericalDyad> dyads;
  Columns fixed;                        ///< by coordinate
  std::vector<Columns> moving, normal;  ///< [orientation]: moving axis, fixed × moving
  Column half_sine, half_cosine;        ///< of half the link angle; both 0 where there is no dyad
  std::vector<std::uint8_t> admissible_directions, at_least_half_turn;  ///< as in DyadAxis
  std::vector<float> sweep_ccw;  ///< angle from first to last orientation turning ccw, radians in [0, 2π)
};

/// A row of a map both of whose grounded links depend on the cell: one sample to each column. The driver turns alike in
/// all of them.
struct SphericalRow {
  SphericalAxis input, output;
};

/// The map of all pairs of grounded links; cells of a grounded link with itself (its diagonal) are degenerate. Rows
/// left out because `progress` was cancelled are degenerate. Throws std::bad_alloc where the cells do not fit in
/// memory.
void classify_pairs(RegionMap& map, const SphericalAxis& input, const SphericalAxis& output,
                    const RegionOptions& options = {}, const Progress& progress = {});

/// The same by rows, each with links of its own; `row_at` is called from several threads. No cell is on a diagonal.
void classify_rows(RegionMap& map, std::span<const double> input, std::span<const double> output,
                   const std::function<SphericalRow(std::size_t row)>& row_at, const RegionOptions& options = {},
                   const Progress& progress = {});

}  // namespace linkwright
