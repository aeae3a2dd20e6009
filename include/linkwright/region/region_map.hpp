#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "linkwright/analysis/defects.hpp"
#include "linkwright/core/progress.hpp"
#include "linkwright/core/simd.hpp"
#include "linkwright/mechanism/dyad.hpp"
#include "linkwright/mechanism/pose.hpp"

namespace linkwright {

/// One axis of a region: everything that belongs to a single side link, computed once per sample (structure of arrays).
/// All coordinates in one frame, the working frame of the task.
struct RegionAxis {
  /// What the side links of an axis are asked for: all, or nothing that only a driver needs (senses, wide and sweep_ccw
  /// stay 0).
  enum class Role { driving, driven };

  /// `poses`: the distinct poses, in the same frame as the dyads.
  RegionAxis(std::vector<Dyad> samples, std::span<const PrescribedPose> poses, bool respect_direction = true,
             Role role = Role::driving);

  [[nodiscard]] std::size_t size() const { return dyads.size(); }
  [[nodiscard]] std::size_t pose_count() const { return arm_x.size(); }

  std::vector<Dyad> dyads;
  std::vector<double> center_x, center_y, circle_x, circle_y;  ///< circle points at the first pose
  std::vector<std::vector<double>> arm_x, arm_y;  ///< [pose][sample]: from centre to circle point at each pose
  std::vector<double> length;                     ///< of the side link; 0 where a point is at infinity
  std::vector<std::uint8_t> senses;  ///< as driver, it meets the poses in order turning ccw (bit 1), cw (bit 2)
  std::vector<std::uint8_t> wide;    ///< the same bits: that turn, from first to last pose, is half a turn or more
  std::vector<float> sweep_ccw;      ///< angle from first to last pose turning ccw, radians in [0, 2π)
};

struct RegionOptions {
  int threads = 0;  ///< 0: as many as the machine has
  Simd simd = Simd::automatic;
};

/// Memory that is not cleared, in large pages where the system has them (a map of 10⁸ cells is half a million small
/// ones). Throws std::bad_alloc.
[[nodiscard]] void* allocate_cells(std::size_t bytes);
struct FreeCells {
  void operator()(void* cells) const;
};

/// Memory of one property over the cells, not cleared when made: the kernel writes every cell.
template <class T>
class Column {
 public:
  void resize(std::size_t size) {
    if (size == size_) return;
    size_ = 0;
    values_.reset();
    values_.reset(static_cast<T*>(allocate_cells(size * sizeof(T))));
    size_ = size;
  }
  [[nodiscard]] T* data() { return values_.get(); }
  [[nodiscard]] std::span<const T> view() const { return {values_.get(), size_}; }
  [[nodiscard]] const T& operator[](std::size_t i) const { return values_[i]; }

 private:
  std::unique_ptr<T[], FreeCells> values_;
  std::size_t size_ = 0;
};

/// Number of cells of each kind; ordered pairs without the diagonal. Slider four-bars count as degenerate and in
/// nothing else.
struct RegionCounts {
  std::array<std::int64_t, 10> types{};  ///< by LinkageType
  std::int64_t order = 0, branch = 0, circuit = 0, defect_free = 0, pairs = 0;
};

/// A row of a region whose output side links depend on the driving one.
struct RegionRow {
  RegionAxis input;            ///< one sample: the driving side link
  RegionAxis output;           ///< one sample to each column
  std::vector<float> enlarge;  ///< by column, factor on the longest link; empty: 1
};

/// The verdict over one cell, where it does not come from a pair of side links.
struct RegionCell {
  LinkageType type = LinkageType::degenerate;
  Defects defects;
  float versine = 0, full_versine = 0, ratio = 0, longest = 0;  ///< as the columns of RegionMap
};

/// All pairs of side links of a task, classified: row i is the driving (input) side link's dyad, column k the output's.
/// 18 bytes a cell, one more where a driver may meet two poses either way. Cells on the diagonal (the same dyad twice)
/// and with a slider are degenerate.
class RegionMap {
 public:
  RegionMap() = default;
  /// `unit`: the user's length of one unit of the axes' frame (the characteristic length). Rows left out because
  /// `progress` was cancelled are degenerate. Throws std::bad_alloc where the cells do not fit in memory.
  RegionMap(const RegionAxis& input, const RegionAxis& output, double unit, const RegionOptions& options = {},
            const Progress& progress = {});

  /// The same over other axes; the memory is used again when the size is the same.
  void recompute(const RegionAxis& input, const RegionAxis& output, double unit, const RegionOptions& options = {},
                 const Progress& progress = {});

  /// Rows by `row_at`, each with output side links of its own; called from several threads. No cell is on a diagonal.
  void recompute_rows(std::span<const double> input, std::span<const double> output,
                      const std::function<RegionRow(std::size_t row)>& row_at, double unit,
                      const RegionOptions& options = {}, const Progress& progress = {});

  /// Cells by `cell_at`, called from several threads; the driver turns in `sense` through `sweep_ccw` (radians, counted
  /// counter-clockwise) in all of them.
  void recompute_cells(std::span<const double> input, std::span<const double> output, DriveSense sense,
                       double sweep_ccw, const std::function<RegionCell(std::size_t row, std::size_t column)>& cell_at,
                       const RegionOptions& options = {}, const Progress& progress = {});

  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] std::size_t columns() const { return columns_; }
  [[nodiscard]] std::size_t index(std::size_t row, std::size_t column) const { return row * columns_ + column; }

  // Columns over the cells, row-major.
  [[nodiscard]] std::span<const std::uint8_t> types() const { return type_.view(); }
  [[nodiscard]] std::span<const std::uint8_t> defects() const { return defects_.view(); }
  /// 1 − cos γ of the least transmission angle γ over the task (full relative precision at both ends); 0 where a
  /// defect or degenerate.
  [[nodiscard]] std::span<const float> transmission_versines() const { return versine_.view(); }
  /// The same over the full turn of a crank; 0 for other types.
  [[nodiscard]] std::span<const float> full_turn_versines() const { return full_versine_.view(); }
  /// Longest over shortest link; 0 degenerate.
  [[nodiscard]] std::span<const float> link_ratios() const { return ratio_.view(); }
  [[nodiscard]] std::span<const float> longest_links() const { return longest_.view(); }  ///< user's unit; 0 degenerate

  [[nodiscard]] LinkageType type(std::size_t cell) const { return static_cast<LinkageType>(type_[cell]); }
  [[nodiscard]] Defects defects(std::size_t cell) const { return Defects{defects_[cell]}; }
  [[nodiscard]] double min_transmission_angle(std::size_t cell) const;            ///< radians; 0 where not defined
  [[nodiscard]] double min_transmission_angle_full_turn(std::size_t cell) const;  ///< radians; 0 where not defined
  /// Angle that the driver turns from first to last pose, radians, counter-clockwise where it can go either way; 0 with
  /// a defect.
  [[nodiscard]] double driver_sweep(std::size_t row, std::size_t column) const;
  [[nodiscard]] DriveSense drive_sense(std::size_t row, std::size_t column) const;

  [[nodiscard]] RegionCounts counts() const;

  /// RegionOptions::threads of the last computation: what goes over the cells afterwards takes as many.
  [[nodiscard]] int threads() const { return threads_; }

  /// The same side link twice.
  [[nodiscard]] bool is_diagonal(std::size_t row, std::size_t column) const {
    return !input_dyads_.empty() && input_[row] == output_[column] &&
           same_points(input_dyads_[row], output_dyads_[column]);
  }

  /// The coordinates of the samples.
  [[nodiscard]] std::span<const double> input_coordinates() const { return input_; }
  [[nodiscard]] std::span<const double> output_coordinates() const { return output_; }

  /// The side links at each sample, in the axes' frame; none where they belong to the cells.
  [[nodiscard]] std::span<const Dyad> input_dyads() const { return input_dyads_; }
  [[nodiscard]] std::span<const Dyad> output_dyads() const { return output_dyads_; }

  static constexpr std::size_t bytes_per_cell = 2 + 4 * sizeof(float);

 private:
  void resize(std::size_t rows, std::size_t columns);
  void lay_without_dyads(std::span<const double> input, std::span<const double> output);
  void leave_empty(std::size_t row_begin, std::size_t row_end);
  void put(std::size_t cell, const RegionCell& verdict);
  void classify_row(std::size_t row, const RegionRow& sides, double unit, Simd simd);
  /// The driver meets its two poses in order whichever way it turns: which ways are open depends on its partner.
  [[nodiscard]] bool pair_decides_sense(std::size_t row) const;

  std::size_t rows_ = 0, columns_ = 0;
  int threads_ = 0;
  std::vector<double> input_, output_;
  std::vector<Dyad> input_dyads_, output_dyads_;
  std::vector<std::uint8_t> senses_;
  std::vector<float> sweep_ccw_;
  Column<std::uint8_t> type_, defects_;
  Column<float> versine_, full_versine_, ratio_, longest_;
  Column<std::uint8_t> cell_senses_;  ///< as KernelCells::senses, of rows where pair_decides_sense; empty without any
};

/// γ from 1 − cos γ, radians.
[[nodiscard]] double angle_of_versine(double versine);
/// 1 − cos γ.
[[nodiscard]] double versine_of_angle(double angle);

}  // namespace linkwright
