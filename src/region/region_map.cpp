#include "linkwright/region/region_map.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <mutex>
#include <new>
#include <sys/mman.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/parallel.hpp"
#include "linkwright/core/precondition.hpp"
#include "linkwright/mechanism/driver_sequence.hpp"

#ifdef __linux__
#endif
namespace linkwright {

void RegionMap::lay(std::span<const double> input, std::span<const double> output, std::span<const Measure> measures,
                    bool of_pairs, const RegionOptions& options) {
  require(measures.size() <= MapCell::max_measures, "a map has max_measures at most");
  const std::size_t cells = input.size() * output.size();
  rows_ = columns_ = 0;
  type_.resize(cells);
  defects_.resize(cells);
  measures_.assign(measures.begin(), measures.end());
  values_.resize(measures.size());
  for (Column<float>& column : values_) column.resize(cells);
  cell_directions_.resize(of_pairs ? cells : 0);
  input_.assign(input.begin(), input.end());
  output_.assign(output.begin(), output.end());
  drivers_.assign(input.size(), {});
  diagonal_.clear();
  row_pivots_.clear();
  column_pivots_.clear();
  threads_ = options.threads;
  rows_ = input.size();
  columns_ = output.size();
}

RegionMap::Cells RegionMap::cells(std::size_t row, std::size_t column) {
  const std::size_t cell = index(row, column);
  Cells found{type_.data() + cell,
              defects_.data() + cell,
              {},
              cell_directions_.view().empty() ? nullptr : cell_directions_.data() + cell};
  for (std::size_t i = 0; i < values_.size(); ++i) found.measures[i] = values_[i].data() + cell;
  return found;
}

void RegionMap::evaluate_cells(std::span<const double> input, std::span<const double> output,
                               std::span<const Measure> measures, DriverTravel travel,
                               const std::function<MapCell(std::size_t row, std::size_t column)>& cell_at,
                               const RegionOptions& options, const Progress& progress) {
  const auto put_rows = [&](std::size_t first_row, std::span<MapCell> cells) {
    for (std::size_t i = 0; i < cells.size() && !progress.is_cancelled(); ++i)
      cells[i] = cell_at(first_row + i / columns_, i % columns_);
  };
  evaluate_rows(input, output, measures, travel, put_rows, options, progress);
}

void RegionMap::evaluate_rows(std::span<const double> input, std::span<const double> output,
                              std::span<const Measure> measures, DriverTravel travel, const RowsOfCells& put_rows,
                              const RegionOptions& options, const Progress& progress) {
  constexpr std::size_t cells_at_a_time = 4096;
  lay(input, output, measures, false, options);
  drivers_.assign(rows_, travel);
  const std::size_t most_rows = std::max<std::size_t>(1, cells_at_a_time / std::max<std::size_t>(1, columns_));
  parallel_for(rows_, options.threads, [&](std::size_t begin, std::size_t end) {
    std::vector<MapCell> cells;
    for (std::size_t first = begin; first < end; first += most_rows) {
      const std::size_t last = std::min(first + most_rows, end);
      leave_empty(first, last);
      if (progress.is_cancelled()) continue;
      cells.assign((last - first) * columns_, {});
      put_rows(first, cells);
      for (std::size_t i = 0; i < cells.size(); ++i) put(first + i / columns_, i % columns_, cells[i]);
    }
  });
}

void RegionMap::add(const CellMeasure& measure, const Progress& progress) {
  const std::array only = {measure.measure()};
  add(
      only, [fill = measure.rows_of(*this)](std::size_t row, auto values) { fill(row, values.front()); }, progress);
}

void RegionMap::add(std::span<const Measure> measures, const CellMeasures::Rows& fill, const Progress& progress) {
  std::vector<float*> columns;
  for (const Measure& measure : measures) columns.push_back(column_of(measure));
  parallel_for(rows_, threads_, [&](std::size_t begin, std::size_t end) {
    std::vector<std::span<float>> values(columns.size());
    for (std::size_t row = begin; row < end && !progress.is_cancelled(); ++row) {
      for (std::size_t k = 0; k < columns.size(); ++k) values[k] = {columns[k] + index(row, 0), columns_};
      fill(row, values);
    }
  });
}

float* RegionMap::column_of(const Measure& measure) {
  const auto held = std::find(measures_.begin(), measures_.end(), measure);
  const auto place = static_cast<std::size_t>(held - measures_.begin());
  if (held == measures_.end()) {
    require(measures_.size() < MapCell::max_measures, "a map has max_measures at most");
    values_.emplace_back().resize(rows_ * columns_);
    measures_.push_back(measure);
  }
  std::fill_n(values_[place].data(), rows_ * columns_, 0.0F);
  return values_[place].data();
}

void RegionMap::put(std::size_t row, std::size_t column, const MapCell& verdict) {
  const std::size_t cell = index(row, column);
  type_.data()[cell] = static_cast<std::uint8_t>(verdict.type);
  defects_.data()[cell] = verdict.defects.bits;
  for (std::size_t i = 0; i < values_.size(); ++i) values_[i].data()[cell] = static_cast<float>(verdict.values[i]);
}

void RegionMap::leave_empty(std::size_t row_begin, std::size_t row_end) {
  const auto begin = static_cast<std::ptrdiff_t>(row_begin * columns_),
             end = static_cast<std::ptrdiff_t>(row_end * columns_);
  std::fill(type_.data() + begin, type_.data() + end, static_cast<std::uint8_t>(LinkageType::degenerate));
  std::fill(defects_.data() + begin, defects_.data() + end, std::uint8_t{0});
  for (Column<float>& column : values_) std::fill(column.data() + begin, column.data() + end, 0.0F);
}

std::span<const float> RegionMap::values(const Measure& measure) const {
  const auto found = std::find(measures_.begin(), measures_.end(), measure);
  if (found == measures_.end()) return {};
  return values_[static_cast<std::size_t>(found - measures_.begin())].view();
}

std::vector<Measure> RegionMap::reported_measures() const {
  std::vector<Measure> told = measures_;
  if (rows_ == 0 || !drivers_.empty()) told.push_back(measures::driver_sweep);
  return told;
}

double RegionMap::min_transmission_angle(std::size_t cell) const {
  return angle_of_versine(values(measures::min_transmission_angle)[cell]);
}

static bool decided_by_pair(const DriverTravel& driver) {
  return driver.admissible_directions == (DriverTravel::ccw | DriverTravel::cw) && driver.sweep_ccw > 0;
}

bool RegionMap::pair_decides_sense(const DriverTravel& driver) { return decided_by_pair(driver); }

DriveSense RegionMap::drive_sense(std::size_t row, std::size_t column) const {
  const std::size_t cell = index(row, column);
  if (drivers_.empty() || type(cell) == LinkageType::degenerate || !defects(cell).none()) return DriveSense::none;
  const DriverTravel& own = driver(row, column);
  const bool by_pair = decided_by_pair(own) && !cell_directions_.view().empty();
  const unsigned admissible_directions = by_pair ? cell_directions_[cell] : own.admissible_directions;
  return linkwright::drive_sense(admissible_directions & DriverTravel::ccw, admissible_directions & DriverTravel::cw);
}

double RegionMap::driver_sweep(std::size_t row, std::size_t column) const {
  const DriveSense sense = drive_sense(row, column);
  if (sense == DriveSense::none) return 0;
  const double ccw = static_cast<double>(driver(row, column).sweep_ccw);
  return sense == DriveSense::cw && ccw > 0 ? two_pi - ccw : ccw;
}

RegionCounts RegionMap::counts() const {
  RegionCounts total;
  std::mutex adding;
  parallel_for(rows_, threads_, [&](std::size_t begin, std::size_t end) {
    // By type · 8 + defects; four times over, since neighbours are mostly alike and would wait for each other.
    using CountsByCode = std::array<std::int64_t, 8 * linkage_type_count>;
    std::array<CountsByCode, 4> of_code_by_turns{};
    for (std::size_t cell = begin * columns_; cell < end * columns_; ++cell)
      ++of_code_by_turns[cell % 4][static_cast<std::size_t>(type_[cell] * 8 + defects_[cell])];
    CountsByCode of_code{};
    for (const auto& turn : of_code_by_turns)
      for (std::size_t code = 0; code < of_code.size(); ++code) of_code[code] += turn[code];
    for (std::size_t row = begin; row < end; ++row)
      for (std::size_t column = 0; column < columns_; ++column)
        of_code[static_cast<std::size_t>(LinkageType::degenerate) * 8] -= is_diagonal(row, column);
    const std::lock_guard lock(adding);
    for (std::size_t code = 0; code < of_code.size(); ++code) {
      const std::int64_t n = of_code[code];
      const Defects d{static_cast<std::uint8_t>(code % 8)};
      const bool whole = code / 8 != static_cast<std::size_t>(LinkageType::degenerate);
      total.types[code / 8] += n;
      total.pairs += n;
      total.order += d.order() ? n : 0;
      total.branch += d.branch() ? n : 0;
      total.circuit += d.circuit() ? n : 0;
      total.defect_free += whole && d.none() ? n : 0;
    }
  });
  return total;
}

void* allocate_cells(std::size_t bytes) {
  constexpr std::size_t line = 64, large_page = std::size_t{1} << 21;
  const std::size_t unit = bytes < 2 * large_page ? line : large_page;
  void* cells = std::aligned_alloc(unit, (bytes / unit + 1) * unit);
  if (!cells) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
  if (unit == large_page) madvise(cells, bytes, MADV_HUGEPAGE);  // a wish; without it the map is only slower
#endif
  return cells;
}

void FreeCells::operator()(void* cells) const { std::free(cells); }

}  // namespace linkwright
