#pragma once

// The rows of a region, for one pack width. Included by the kernel_*.cpp files, one for each instruction set.

#include "analysis/pair_verdict.hpp"
#include "region/kernel.hpp"

namespace linkwright::LINKWRIGHT_ISA {

/// Columns worked on for all rows of a task before going on: short enough for what they need to stay in the nearest
/// caches, long enough for the writes to run in streams.
inline constexpr std::size_t block_columns = 512;

template <int Poses>
LINKWRIGHT_INLINE Driver<Poses> driver_of(const KernelAxis& axis, std::size_t row) {
  Driver<Poses> driver;
  driver.center_x = axis.center_x[row];
  driver.center_y = axis.center_y[row];
  driver.length = axis.length[row];
  driver.circle_x = axis.circle_x[row];
  driver.circle_y = axis.circle_y[row];
  for (int j = 0; j < Poses; ++j) {
    driver.arm_x[j] = axis.arm_x[j][row];
    driver.arm_y[j] = axis.arm_y[j][row];
  }
  driver.senses = axis.senses[row];
  driver.wide = axis.wide[row];
  return driver;
}

template <int Width, int Poses>
LINKWRIGHT_INLINE Driven<Width, Poses> driven_of(const KernelAxis& axis, std::size_t column) {
  Driven<Width, Poses> driven;
  driven.center_x = load<Width>(axis.center_x + column);
  driven.center_y = load<Width>(axis.center_y + column);
  driven.length = load<Width>(axis.length + column);
  driven.circle_x = load<Width>(axis.circle_x + column);
  driven.circle_y = load<Width>(axis.circle_y + column);
  for (int j = 0; j < Poses; ++j) {
    driven.arm_x[j] = load<Width>(axis.arm_x[j] + column);
    driven.arm_y[j] = load<Width>(axis.arm_y[j] + column);
  }
  return driven;
}

/// The first `count` lanes.
template <int Width, class Value, class Lane>
LINKWRIGHT_INLINE void store(const Value& value, Lane* to, std::size_t count) {
  static_assert(sizeof value == Width * sizeof(Lane));
  if (Width == 1 || count == Width)
    __builtin_memcpy(to, &value, sizeof value);
  else
    __builtin_memcpy(to, &value, count * sizeof(Lane));
}

template <int Width, int Poses>
LINKWRIGHT_INLINE void write_cells(const KernelTask& task, const PairVerdict<Width>& v, std::size_t cell,
                                   std::size_t count) {
  using Real = typename Pack<Width>::Real;
  using Single = typename Pack<Width>::Single;
  using Byte = typename Pack<Width>::Byte;
  const Real none = Real{}, one = Real{} + 1.0;
  // 1 − cos γ: subtracted in double, where digits are lost, divided in single.
  const Single versine = converted<Width, Single>(select(v.clean, larger(v.hb - v.worst, none), none));
  const Single full_versine = converted<Width, Single>(select(v.turns, larger(v.hb - v.worst_turn, none), none));
  const Single hb = converted<Width, Single>(select(v.whole, v.hb, one));
  const Single longest = converted<Width, Single>(select(v.whole, v.longest, none));
  const Single shortest = converted<Width, Single>(select(v.whole, v.shortest, one));
  const Single ratio = longest / shortest, task_versine = versine / hb, turn_versine = full_versine / hb;
  const Single longest_in_units = longest * static_cast<float>(task.unit);
  store<Width>(converted<Width, Byte>(v.type), task.type + cell, count);
  store<Width>(converted<Width, Byte>(v.defects), task.defects + cell, count);
  store<Width>(task_versine, task.versine + cell, count);
  store<Width>(turn_versine, task.full_versine + cell, count);
  store<Width>(ratio, task.ratio + cell, count);
  store<Width>(longest_in_units, task.longest + cell, count);
}

template <int Width, int Poses>
void region_rows(const KernelTask& task) {
  for (std::size_t block = 0; block < task.columns; block += block_columns) {
    const std::size_t end = block + block_columns < task.columns ? block + block_columns : task.columns;
    for (std::size_t row = task.row_begin; row < task.row_end; ++row) {
      const Driver<Poses> driver = driver_of<Poses>(task.input, row);
      const std::size_t base = row * task.columns;
      std::size_t column = block;
      for (; column + Width <= end; column += Width)
        write_cells<Width, Poses>(
            task, pair_verdict<Width, Poses>(driver, driven_of<Width, Poses>(task.output, column), task.zero_share),
            base + column, Width);
      if (column < end)
        write_cells<Width, Poses>(
            task, pair_verdict<Width, Poses>(driver, driven_of<Width, Poses>(task.output, column), task.zero_share),
            base + column, end - column);
    }
  }
}

template <int Width>
void region_kernel(const KernelTask& task) {
  switch (task.poses) {
    case 1: return region_rows<Width, 1>(task);
    case 2: return region_rows<Width, 2>(task);
    case 3: return region_rows<Width, 3>(task);
    case 4: return region_rows<Width, 4>(task);
    case 5: return region_rows<Width, 5>(task);
    default: __builtin_unreachable();
  }
}

}  // namespace linkwright::LINKWRIGHT_ISA
