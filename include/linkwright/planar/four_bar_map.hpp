#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/pose.hpp"
#include "linkwright/region/region_map.hpp"

namespace linkwright {

/// What maps of planar linkages hold, in this order.
inline constexpr std::array<Measure, 4> planar_measures = {measures::min_transmission_angle,
                                                           measures::min_transmission_angle_full_turn,
                                                           measures::link_ratio, measures::longest_link};

/// Memory of a map of four-bars; one byte more where a driver may meet two poses either way.
inline constexpr std::size_t four_bar_bytes_per_cell = 2 + planar_measures.size() * sizeof(float);

/// One axis of a map of four-bars: everything that belongs to a single grounded link, computed once per sample
/// (structure of arrays). All coordinates in one frame, the working frame of the task.
struct DyadAxis {
  /// What the grounded links of an axis are asked for: all, or nothing that only a driver needs (senses, wide and
  /// sweep_ccw stay 0).
  enum class Role { driving, driven };

  /// `poses`: the distinct poses, in the same frame as the dyads.
  DyadAxis(std::vector<Dyad> samples, std::span<const PrescribedPose> poses, bool respect_direction = true,
           Role role = Role::driving);

  [[nodiscard]] std::size_t size() const { return dyads.size(); }
  [[nodiscard]] std::size_t pose_count() const { return arm_x.size(); }

  std::vector<Dyad> dyads;
  std::vector<double> center_x, center_y, circle_x, circle_y;  ///< circle points at the first pose
  std::vector<std::vector<double>> arm_x, arm_y;  ///< [pose][sample]: from centre to circle point at each pose
  std::vector<double> length;                     ///< of the grounded link; 0 where a point is at infinity
  std::vector<std::uint8_t>
      admissible_directions;  ///< as driver, it meets the poses in order turning ccw (bit 1), cw (bit 2)
  std::vector<std::uint8_t>
      at_least_half_turn;        ///< the same bits: that turn, from first to last pose, is half a turn or more
  std::vector<float> sweep_ccw;  ///< angle from first to last pose turning ccw, radians in [0, 2π)
};

/// The map of all pairs of grounded links; cells of a grounded link with itself (its diagonal) and with a slider are
/// degenerate. `unit`: the user's length of one unit of the axes' frame (the characteristic length). Rows left out
/// because `progress` was cancelled are degenerate. Throws std::bad_alloc where the cells do not fit in memory.
void classify_pairs(RegionMap& map, const DyadAxis& input, const DyadAxis& output, double unit,
                    const RegionOptions& options = {}, const Progress& progress = {});

/// A row of a map whose output links depend on the driving one, or the reverse: one of both has one sample, the other
/// one to each column.
struct FourBarRow {
  DyadAxis input;              ///< the driving link, or links
  DyadAxis output;             ///< the others, or the other
  std::vector<float> enlarge;  ///< by column, factor on the longest link; empty: 1
};

/// What changes along a row of a map.
enum class AlongRow { driven_link, driving_link };

/// The same by rows, each with links of its own; `row_at` is called from several threads. No cell is on a diagonal.
void classify_rows(RegionMap& map, std::span<const double> input, std::span<const double> output,
                   const std::function<FourBarRow(std::size_t row)>& row_at, double unit,
                   const RegionOptions& options = {}, const Progress& progress = {},
                   AlongRow changes = AlongRow::driven_link);

}  // namespace linkwright
