#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "linkwright/algebra/vector3.hpp"
#include "linkwright/core/progress.hpp"
#include "linkwright/core/simd.hpp"
#include "linkwright/mechanism/defects.hpp"
#include "linkwright/mechanism/driver_sequence.hpp"
#include "linkwright/mechanism/linkage_type.hpp"
#include "linkwright/region/cell_measure.hpp"
#include "linkwright/region/measure.hpp"

namespace linkwright {

/// Memory that is not cleared, in large pages where the system has them (a map of 10⁸ cells is half a million small
/// ones). Throws std::bad_alloc.
[[nodiscard]] void* allocate_cells(std::size_t bytes);
/// Gives back memory of allocate_cells().
struct FreeCells {
  void operator()(void* cells) const;
};

/// Memory of one property over the cells of a map, not cleared when made: who judges writes every cell.
template <class T>
class Column {
 public:
  /// Values are lost where the size changes. Throws std::bad_alloc, and then the column is empty.
  void resize(std::size_t size) {
    if (size == size_) return;
    size_ = 0;
    values_.reset();
    values_.reset(static_cast<T*>(allocate_cells(size * sizeof(T))));
    size_ = size;
  }
  /// Null while the column is empty.
  [[nodiscard]] T* data() { return values_.get(); }
  [[nodiscard]] std::span<const T> view() const { return {values_.get(), size_}; }
  [[nodiscard]] const T& operator[](std::size_t i) const { return values_[i]; }

 private:
  std::unique_ptr<T[], FreeCells> values_;
  std::size_t size_ = 0;
};

struct RegionOptions {
  int threads = 0;  ///< 0: as many as the machine has
  Simd simd = Simd::automatic;
};

/// Number of cells of each kind; ordered pairs without the diagonal. Slider linkages count as degenerate and in nothing
/// else.
struct RegionCounts {
  std::array<std::int64_t, linkage_type_count> types{};  ///< by LinkageType
  std::int64_t order = 0, branch = 0, circuit = 0, defect_free = 0, pairs = 0;
};

/// The pivots of one grounded link in position 1, user's frame (in the plane z = 0), or unit vectors along its axes;
/// nothing at infinity.
struct GroundedLinkPivots {
  std::optional<Vector3> ground, moving;
};

/// How the driving link of a row passes the positions.
struct DriverTravel {
  static constexpr std::uint8_t ccw = DriverSequence::ccw_bit, cw = DriverSequence::cw_bit;

  std::uint8_t admissible_directions = 0;  ///< in which it meets them in order: bits ccw and cw
  float sweep_ccw = 0;  ///< from the first to the last turning counter-clockwise, radians in [0, 2π)
};

/// The verdict over one cell.
struct MapCell {
  static constexpr std::size_t max_measures = 18;

  LinkageType type = LinkageType::degenerate;
  Defects defects;
  std::array<double, max_measures> values{};  ///< in the order of the map's measures, as they are stored
};

/// All linkages that a task leaves open over two coordinates, sampled and judged: row i is the driving link's sample,
/// column k the other's. Two verdict columns, and a column for each measure. It knows no geometry: a family fills it.
class RegionMap {
 public:
  /// What a family writes to, from some cell on.
  struct Cells {
    std::uint8_t *type, *defects;
    std::array<float*, MapCell::max_measures> measures;
    std::uint8_t*
        admissible_directions;  ///< of the pair, bits as DriverTravel::senses; null where only the drivers have a say
  };

  /// Lays the map out over these coordinates; the memory is used again when the size is the same. Its cells are then to
  /// be written. `of_pairs`: in which sense a driver may turn depends on its partner. Throws std::bad_alloc where the
  /// cells do not fit in memory, and then the map is empty.
  void lay(std::span<const double> input, std::span<const double> output, std::span<const Measure> measures,
           bool of_pairs, const RegionOptions& options);
  /// Where to write, from this cell on in row-major order.
  [[nodiscard]] Cells cells(std::size_t row, std::size_t column = 0);
  /// How the driving link of a row travels through its positions.
  void set_driver(std::size_t row, DriverTravel travel) { drivers_[row] = travel; }
  /// Of a map whose driving links change along a row, too, as after give_each_cell_a_driver().
  void set_driver(std::size_t row, std::size_t column, DriverTravel travel) { drivers_[index(row, column)] = travel; }
  void give_each_cell_a_driver() { drivers_.assign(rows_ * columns_, {}); }
  /// Its linkages have no positions to be driven through.
  void leave_out_drivers() { drivers_.clear(); }
  /// For each row, the column in which the same grounded link stands a second time; none: no such.
  static constexpr std::uint32_t no_diagonal = 0xFFFFFFFF;
  void set_diagonal(std::vector<std::uint32_t> column_of_row) { diagonal_ = std::move(column_of_row); }
  /// Where the pivots of its rows and columns lie, where each grounded link depends on its own coordinate alone.
  void set_pivots(std::vector<GroundedLinkPivots> rows, std::vector<GroundedLinkPivots> columns) {
    row_pivots_ = std::move(rows);
    column_pivots_ = std::move(columns);
  }
  /// Degenerate cells, for rows that are not judged.
  void leave_empty(std::size_t row_begin, std::size_t row_end);

  /// The cells of whole rows from one on, row-major, each to its place.
  using RowsOfCells = std::function<void(std::size_t first_row, std::span<MapCell> cells)>;
  /// A few rows at a time, for linkages that are judged in packs; called from several threads. Rows left out because
  /// `progress` was cancelled are degenerate.
  void evaluate_rows(std::span<const double> input, std::span<const double> output, std::span<const Measure> measures,
                     DriverTravel travel, const RowsOfCells& put_rows, const RegionOptions& options = {},
                     const Progress& progress = {});
  /// Cells by `cell_at`, called from several threads; the driver turns as `travel` says in all of them. Rows left out
  /// because `progress` was cancelled are degenerate.
  void evaluate_cells(std::span<const double> input, std::span<const double> output, std::span<const Measure> measures,
                      DriverTravel travel, const std::function<MapCell(std::size_t row, std::size_t column)>& cell_at,
                      const RegionOptions& options = {}, const Progress& progress = {});

  /// A column of a further measure, or the one of its key anew. Rows left out because `progress` was cancelled keep 0.
  /// Throws std::bad_alloc.
  void add(const CellMeasure& measure, const Progress& progress = {});
  /// Of several, row by row.
  void add(std::span<const Measure> measures, const CellMeasures::Rows& fill, const Progress& progress = {});

  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] std::size_t columns() const { return columns_; }
  /// Of a cell in the columns, row-major.
  [[nodiscard]] std::size_t index(std::size_t row, std::size_t column) const { return row * columns_ + column; }

  // Columns over the cells, row-major.
  [[nodiscard]] std::span<const std::uint8_t> types() const { return type_.view(); }
  [[nodiscard]] std::span<const std::uint8_t> defects() const { return defects_.view(); }
  /// As it is stored; empty where the map has no such measure.
  [[nodiscard]] std::span<const float> values(const Measure& measure) const;
  /// Those that the map holds, in order.
  [[nodiscard]] const std::vector<Measure>& measures() const { return measures_; }
  /// Those and, where there are positions to be driven through, what is computed without being held: driver_sweep.
  [[nodiscard]] std::vector<Measure> reported_measures() const;

  /// `cell`: index().
  [[nodiscard]] LinkageType type(std::size_t cell) const { return static_cast<LinkageType>(type_[cell]); }
  [[nodiscard]] Defects defects(std::size_t cell) const { return Defects{defects_[cell]}; }
  [[nodiscard]] double min_transmission_angle(std::size_t cell) const;  ///< radians; 0 where not defined
  /// Angle that the driver turns from first to last position, radians, counter-clockwise where it can go either way; 0
  /// with a defect.
  [[nodiscard]] double driver_sweep(std::size_t row, std::size_t column) const;
  /// `none` with a defect.
  [[nodiscard]] DriveSense drive_sense(std::size_t row, std::size_t column) const;

  /// Counts the cells anew at each call, by threads().
  [[nodiscard]] RegionCounts counts() const;

  /// RegionOptions::threads of the last computation: what goes over the cells afterwards takes as many.
  [[nodiscard]] int threads() const { return threads_; }

  /// The same grounded link twice.
  [[nodiscard]] bool is_diagonal(std::size_t row, std::size_t column) const {
    return row < diagonal_.size() && diagonal_[row] == column;
  }

  /// As set; none where they belong to the cells.
  [[nodiscard]] const std::vector<GroundedLinkPivots>& row_pivots() const { return row_pivots_; }
  [[nodiscard]] const std::vector<GroundedLinkPivots>& column_pivots() const { return column_pivots_; }

  /// The coordinates of the samples.
  [[nodiscard]] std::span<const double> input_coordinates() const { return input_; }
  [[nodiscard]] std::span<const double> output_coordinates() const { return output_; }

 private:
  /// The driver meets its positions in order whichever way it turns: which ways are open depends on its partner.
  [[nodiscard]] static bool pair_decides_sense(const DriverTravel& driver);
  [[nodiscard]] const DriverTravel& driver(std::size_t row, std::size_t column) const {
    return drivers_[drivers_.size() == rows_ ? row : index(row, column)];
  }
  void put(std::size_t row, std::size_t column, const MapCell& verdict);
  /// Of zeros; added where there is none.
  [[nodiscard]] float* column_of(const Measure& measure);

  std::size_t rows_ = 0, columns_ = 0;
  int threads_ = 0;
  std::vector<double> input_, output_;
  std::vector<DriverTravel> drivers_;  ///< by row, or by cell
  std::vector<std::uint32_t> diagonal_;
  std::vector<GroundedLinkPivots> row_pivots_, column_pivots_;
  Column<std::uint8_t> type_, defects_;
  std::vector<Measure> measures_;
  std::vector<Column<float>> values_;
  Column<std::uint8_t> cell_directions_;  ///< of rows where pair_decides_sense; empty where only the drivers have a say
};

}  // namespace linkwright
