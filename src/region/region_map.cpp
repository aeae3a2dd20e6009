#include "linkwright/region/region_map.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <mutex>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

#include "linkwright/algebra/homogeneous.hpp"
#include "linkwright/analysis/driver_order.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/parallel.hpp"
#include "linkwright/core/precondition.hpp"
#include "linkwright/core/tolerance.hpp"
#include "region/kernel.hpp"

namespace linkwright {
namespace {

KernelAxis plain_arrays(const RegionAxis& axis) {
  KernelAxis plain{axis.center_x.data(),
                   axis.center_y.data(),
                   axis.circle_x.data(),
                   axis.circle_y.data(),
                   axis.length.data(),
                   {},
                   {},
                   axis.senses.data(),
                   axis.wide.data()};
  for (std::size_t j = 0; j < axis.pose_count(); ++j) {
    plain.arm_x[j] = axis.arm_x[j].data();
    plain.arm_y[j] = axis.arm_y[j].data();
  }
  return plain;
}

std::uint8_t bits(bool ccw, bool cw) { return static_cast<std::uint8_t>((ccw ? 1 : 0) | (cw ? 2 : 0)); }

std::vector<double> coordinates_of(const std::vector<Dyad>& dyads) {
  std::vector<double> coordinates;
  coordinates.reserve(dyads.size());
  for (const Dyad& dyad : dyads) coordinates.push_back(dyad.coordinate);
  return coordinates;
}

// Rows that a thread takes before it looks whether to stop.
constexpr std::size_t rows_at_once = 16;

// A smaller map is ready before a second thread is awake.
constexpr std::size_t cells_worth_a_thread = 30'000;

}  // namespace

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

RegionAxis::RegionAxis(std::vector<Dyad> samples, std::span<const PrescribedPose> poses, bool respect_direction,
                       Role role)
    : dyads(std::move(samples)) {
  require(!poses.empty() && poses.size() <= most_poses, "one to five poses are judged");
  const std::size_t count = dyads.size();
  for (std::vector<double>* column : {&center_x, &center_y, &circle_x, &circle_y, &length}) column->assign(count, 0);
  arm_x.assign(poses.size(), std::vector<double>(count, 0));
  arm_y.assign(poses.size(), std::vector<double>(count, 0));
  senses.assign(count, 0);
  wide.assign(count, 0);
  sweep_ccw.assign(count, 0);
  const Pose& first = poses.front().pose;
  std::vector<Point> turns;
  for (const PrescribedPose& pose : poses) turns.push_back(direction(pose.pose.angle - first.angle));
  for (std::size_t i = 0; i < count; ++i) {
    const auto center = finite_point(dyads[i].center), circle = finite_point(dyads[i].circle);
    if (!center || !circle) continue;  // a slider: length 0 makes its pairs degenerate
    center_x[i] = center->real();
    center_y[i] = center->imag();
    circle_x[i] = circle->real();
    circle_y[i] = circle->imag();
    length[i] = std::abs(*circle - *center);
    for (std::size_t j = 0; j < poses.size(); ++j) {
      const Point arm = poses[j].pose.origin + turns[j] * (*circle - first.origin) - *center;
      arm_x[j][i] = arm.real();
      arm_y[j][i] = arm.imag();
    }
    if (role == Role::driven) continue;
    const DriverOrder order = driver_order(*center, *circle, poses, respect_direction);
    senses[i] = bits(order.ccw, order.cw);
    wide[i] = bits(order.is_wide_ccw(), order.is_wide_cw());
    sweep_ccw[i] = static_cast<float>(order.sweep_ccw);
  }
}

RegionMap::RegionMap(const RegionAxis& input, const RegionAxis& output, double unit, const RegionOptions& options,
                     const Progress& progress) {
  recompute(input, output, unit, options, progress);
}

// Where the cells do not fit in memory the map is empty, not the last one.
void RegionMap::resize(std::size_t rows, std::size_t columns) {
  const std::size_t cells = rows * columns;
  rows_ = columns_ = 0;
  type_.resize(cells);
  defects_.resize(cells);
  for (Column<float>* column : {&versine_, &full_versine_, &ratio_, &longest_}) column->resize(cells);
  rows_ = rows;
  columns_ = columns;
}

void RegionMap::recompute(const RegionAxis& input, const RegionAxis& output, double unit, const RegionOptions& options,
                          const Progress& progress) {
  require(input.pose_count() == output.pose_count(), "both axes are of one task");
  resize(input.size(), output.size());
  threads_ = options.threads;
  input_ = coordinates_of(input.dyads);
  output_ = coordinates_of(output.dyads);
  input_dyads_ = input.dyads;
  output_dyads_ = output.dyads;
  senses_ = input.senses;
  sweep_ccw_ = input.sweep_ccw;
  bool pairs_decide = false;
  for (std::size_t row = 0; row < rows_ && input.pose_count() == 2; ++row) pairs_decide |= pair_decides_sense(row);
  cell_senses_.resize(pairs_decide ? rows_ * columns_ : 0);

  KernelTask task{plain_arrays(input),
                  plain_arrays(output),
                  0,
                  rows_,
                  columns_,
                  static_cast<int>(input.pose_count()),
                  unit,
                  tolerance::change_point,
                  {type_.data(), defects_.data(), versine_.data(), full_versine_.data(), ratio_.data(), longest_.data(),
                   pairs_decide ? cell_senses_.data() : nullptr}};
  const auto kernel = region_kernel.for_simd(options.simd);
  const int threads = rows_ * columns_ < cells_worth_a_thread ? 1 : options.threads;
  parallel_for((rows_ + rows_at_once - 1) / rows_at_once, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t chunk = begin; chunk < end; ++chunk) {
      KernelTask part = task;
      part.row_begin = chunk * rows_at_once;
      part.row_end = std::min(part.row_begin + rows_at_once, rows_);
      if (progress.is_cancelled())
        leave_empty(part.row_begin, part.row_end);
      else
        kernel(part);
    }
  });
}

void RegionMap::lay_without_dyads(std::span<const double> input, std::span<const double> output) {
  resize(input.size(), output.size());
  input_.assign(input.begin(), input.end());
  output_.assign(output.begin(), output.end());
  input_dyads_.clear();
  output_dyads_.clear();
}

// The kernel's own way, for the one driver of a row.
void RegionMap::classify_row(std::size_t row, const RegionRow& sides, double unit, Simd simd) {
  require(sides.input.size() == 1 && sides.output.size() == columns_, "a row has one driver, and a partner a column");
  const std::size_t cell = index(row, 0);
  region_kernel.for_simd(simd)(
      {plain_arrays(sides.input),
       plain_arrays(sides.output),
       0,
       1,
       columns_,
       static_cast<int>(sides.input.pose_count()),
       unit,
       tolerance::change_point,
       {type_.data() + cell, defects_.data() + cell, versine_.data() + cell, full_versine_.data() + cell,
        ratio_.data() + cell, longest_.data() + cell, cell_senses_.data() + cell}});
  for (std::size_t column = 0; column < sides.enlarge.size(); ++column)
    longest_.data()[cell + column] *= sides.enlarge[column];
  senses_[row] = sides.input.senses.front();
  if (sides.input.pose_count() != 2) std::fill_n(cell_senses_.data() + cell, columns_, senses_[row]);
  sweep_ccw_[row] = sides.input.sweep_ccw.front();
}

void RegionMap::recompute_rows(std::span<const double> input, std::span<const double> output,
                               const std::function<RegionRow(std::size_t row)>& row_at, double unit,
                               const RegionOptions& options, const Progress& progress) {
  lay_without_dyads(input, output);
  threads_ = options.threads;
  senses_.assign(rows_, 0);
  sweep_ccw_.assign(rows_, 0);
  cell_senses_.resize(rows_ * columns_);
  parallel_for(rows_, options.threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      if (progress.is_cancelled())
        leave_empty(row, row + 1);
      else
        classify_row(row, row_at(row), unit, options.simd);
    }
  });
}

void RegionMap::recompute_cells(std::span<const double> input, std::span<const double> output, DriveSense sense,
                                double sweep_ccw,
                                const std::function<RegionCell(std::size_t row, std::size_t column)>& cell_at,
                                const RegionOptions& options, const Progress& progress) {
  lay_without_dyads(input, output);
  threads_ = options.threads;
  senses_.assign(rows_, static_cast<std::uint8_t>(sense));
  sweep_ccw_.assign(rows_, static_cast<float>(sweep_ccw));
  cell_senses_.resize(0);
  parallel_for(rows_, options.threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      leave_empty(row, row + 1);
      for (std::size_t column = 0; column < columns_ && !progress.is_cancelled(); ++column)
        put(index(row, column), cell_at(row, column));
    }
  });
}

void RegionMap::put(std::size_t cell, const RegionCell& verdict) {
  type_.data()[cell] = static_cast<std::uint8_t>(verdict.type);
  defects_.data()[cell] = verdict.defects.bits;
  versine_.data()[cell] = verdict.versine;
  full_versine_.data()[cell] = verdict.full_versine;
  ratio_.data()[cell] = verdict.ratio;
  longest_.data()[cell] = verdict.longest;
}

void RegionMap::leave_empty(std::size_t row_begin, std::size_t row_end) {
  const auto begin = static_cast<std::ptrdiff_t>(row_begin * columns_),
             end = static_cast<std::ptrdiff_t>(row_end * columns_);
  std::fill(type_.data() + begin, type_.data() + end, static_cast<std::uint8_t>(LinkageType::degenerate));
  std::fill(defects_.data() + begin, defects_.data() + end, std::uint8_t{0});
  for (Column<float>* column : {&versine_, &full_versine_, &ratio_, &longest_})
    std::fill(column->data() + begin, column->data() + end, 0.0F);
}

double angle_of_versine(double versine) { return 2 * std::asin(std::sqrt(std::min(versine, 2.0) / 2)); }

double versine_of_angle(double angle) {
  const double half = std::sin(angle / 2);
  return 2 * half * half;
}

double RegionMap::min_transmission_angle(std::size_t cell) const { return angle_of_versine(versine_[cell]); }

double RegionMap::min_transmission_angle_full_turn(std::size_t cell) const {
  return angle_of_versine(full_versine_[cell]);
}

bool RegionMap::pair_decides_sense(std::size_t row) const { return senses_[row] == 3 && sweep_ccw_[row] > 0; }

DriveSense RegionMap::drive_sense(std::size_t row, std::size_t column) const {
  const std::size_t cell = index(row, column);
  if (type(cell) == LinkageType::degenerate || !defects(cell).none()) return DriveSense::none;
  const bool by_pair = pair_decides_sense(row) && !cell_senses_.view().empty();
  const unsigned senses = by_pair ? cell_senses_[cell] : senses_[row];
  return linkwright::drive_sense(senses & 1, senses & 2);
}

double RegionMap::driver_sweep(std::size_t row, std::size_t column) const {
  const DriveSense sense = drive_sense(row, column);
  if (sense == DriveSense::none) return 0;
  const double ccw = static_cast<double>(sweep_ccw_[row]);
  return sense == DriveSense::cw && ccw > 0 ? two_pi - ccw : ccw;
}

RegionCounts RegionMap::counts() const {
  RegionCounts total;
  std::mutex adding;
  parallel_for(rows_, threads_, [&](std::size_t begin, std::size_t end) {
    // By type · 8 + defects; four times over, since neighbours are mostly alike and would wait for each other.
    std::array<std::array<std::int64_t, 80>, 4> of_code_by_turns{};
    for (std::size_t cell = begin * columns_; cell < end * columns_; ++cell)
      ++of_code_by_turns[cell % 4][static_cast<std::size_t>(type_[cell] * 8 + defects_[cell])];
    std::array<std::int64_t, 80> of_code{};
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

}  // namespace linkwright
