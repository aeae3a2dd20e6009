#pragma once

// The rows of a region, for one pack width. Included by the kernel_*.cpp files, one for each instruction set.

#include "mechanism/pair_verdict.hpp"
#include "planar/four_bar_kernel.hpp"

namespace linkwright::LINKWRIGHT_ISA {

/// Columns worked on for all rows of a task before going on: few enough to stay in the nearest cache.
inline constexpr int block = 256;
/// Lanes that are read past the last column of a block, and thrown away.
inline constexpr int margin = 16;

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
  driver.admissible_directions = axis.admissible_directions[row];
  driver.at_least_half_turn = axis.at_least_half_turn[row];
  return driver;
}

template <int Poses>
using Block = DrivenLinks<Poses, block + margin>;

template <int Poses>
LINKWRIGHT_INLINE void fetch(const KernelAxis& axis, std::size_t column, std::size_t count, Block<Poses>& driven) {
  const auto copy = [&](const double* from, double* to) {
    __builtin_memcpy(to, from + column, count * sizeof(double));
    __builtin_memset(to + count, 0, margin * sizeof(double));
  };
  copy(axis.center_x, driven.center_x);
  copy(axis.center_y, driven.center_y);
  copy(axis.length, driven.length);
  copy(axis.circle_x, driven.circle_x);
  copy(axis.circle_y, driven.circle_y);
  for (int j = 0; j < Poses; ++j) {
    copy(axis.arm_x[j], driven.arm_x[j]);
    copy(axis.arm_y[j], driven.arm_y[j]);
  }
}

template <int Width>
LINKWRIGHT_INLINE void put(const PairVerdict<Width>& v, float unit, const KernelCells& cells, std::size_t cell) {
  using Real = typename Pack<Width>::Real;
  using Single = typename Pack<Width>::Single;
  Real hb = v.hb, longest = v.longest, shortest = v.shortest;
  if (v.whole != all_lanes<Width>) [[unlikely]] {
    const Real one = Real{} + 1.0;
    hb = select<Width>(v.whole, hb, one);
    longest = where<Width>(v.whole, longest);
    shortest = select<Width>(v.whole, shortest, one);
  }
  // 1 − cos γ: subtracted in double, where digits are lost, divided in single.
  const auto versine = [&](Mask mask, Real worst) {
    return mask ? single<Width>(where<Width>(mask, larger(hb - worst, Real{}))) / single<Width>(hb) : Single{};
  };
  const Single longest_single = single<Width>(longest);
  store<Width>(v.type, cells.type + cell);
  store<Width>(v.defects, cells.defects + cell);
  store<Width>(versine(v.clean, v.worst), cells.versine + cell);
  store<Width>(versine(v.turns, v.worst_turn), cells.full_versine + cell);
  store<Width>(longest_single / single<Width>(shortest), cells.ratio + cell);
  store<Width>(longest_single * unit, cells.longest + cell);
}

/// The first `count` lanes only.
template <int Width>
LINKWRIGHT_INLINE void put_some(const PairVerdict<Width>& v, float unit, const KernelCells& cells, std::size_t cell,
                                std::size_t count) {
  std::uint8_t type[Width], defects[Width];
  float versine[Width], full_versine[Width], ratio[Width], longest[Width];
  put<Width>(v, unit, {type, defects, versine, full_versine, ratio, longest, nullptr}, 0);
  __builtin_memcpy(cells.type + cell, type, count);
  __builtin_memcpy(cells.defects + cell, defects, count);
  __builtin_memcpy(cells.versine + cell, versine, count * sizeof(float));
  __builtin_memcpy(cells.full_versine + cell, full_versine, count * sizeof(float));
  __builtin_memcpy(cells.ratio + cell, ratio, count * sizeof(float));
  __builtin_memcpy(cells.longest + cell, longest, count * sizeof(float));
}

/// Senses in which the first `count` pairs do the task.
template <int Width>
LINKWRIGHT_INLINE void put_directions(const PairVerdict<Width>& v, std::uint8_t* to, std::size_t count) {
  std::uint8_t admissible_directions[Width];
  store<Width>(bytes<Width>(v.travels_ccw) * ccw_bit | bytes<Width>(v.travels_cw) * cw_bit, admissible_directions);
  __builtin_memcpy(to, admissible_directions, count);
}

/// What a pack of cells has, of which `left` are still in the block.
template <int Width, int Poses>
LINKWRIGHT_INLINE void put_pack(const PairVerdict<Width>& v, float unit, const KernelCells& cells, std::size_t cell,
                                int left) {
  const auto count = static_cast<std::size_t>(left < Width ? left : Width);
  // Three poses or more come in order one way only; two may do so both ways, and the pair has a say in it.
  if constexpr (Poses == 2)
    if (cells.admissible_directions) put_directions<Width>(v, cells.admissible_directions + cell, count);
  if (count == Width)
    put<Width>(v, unit, cells, cell);
  else
    put_some<Width>(v, unit, cells, cell, count);
}

/// Asks for the memory of cells that will be written soon. The machine does not see six columns, in runs of a block,
/// coming by itself; without this, maps larger than the caches take up to half as long again.
LINKWRIGHT_INLINE void expect(const KernelCells& cells, std::size_t cell) {
  constexpr std::size_t floats_ahead = 96, bytes_ahead = 192;
  __builtin_prefetch(cells.type + cell + bytes_ahead, 1);
  __builtin_prefetch(cells.defects + cell + bytes_ahead, 1);
  __builtin_prefetch(cells.versine + cell + floats_ahead, 1);
  __builtin_prefetch(cells.full_versine + cell + floats_ahead, 1);
  __builtin_prefetch(cells.ratio + cell + floats_ahead, 1);
  __builtin_prefetch(cells.longest + cell + floats_ahead, 1);
}

template <int Width, int Poses>
void four_bar_rows(const KernelTask& task) {
  alignas(64) Block<Poses> driven;
  const auto unit = static_cast<float>(task.unit);
  for (std::size_t column = 0; column < task.columns; column += block) {
    const int count = static_cast<int>(task.columns - column < block ? task.columns - column : block);
    fetch<Poses>(task.output, column, static_cast<std::size_t>(count), driven);
    for (std::size_t row = task.row_begin; row < task.row_end; ++row) {
      const Driver<Poses> driver = driver_of<Poses>(task.input, row);
      std::size_t cell = row * task.columns + column;
      Distances<Width> next = distances<Width>(driver, driven, 0);
      for (int at = 0; at < count; at += Width, cell += Width) {
        const Distances<Width> here = next;
        next = distances<Width>(driver, driven, at + Width);
        expect(task.cells, cell);
        const auto verdict = pair_verdict<Width>(driver, driven, at, here, task.zero_share);
        put_pack<Width, Poses>(verdict, unit, task.cells, cell, count - at);
      }
    }
  }
}

template <int Width>
void four_bar_kernel(const KernelTask& task) {
  with_position_count(task.poses, [&](auto count) { four_bar_rows<Width, decltype(count)::value>(task); });
}

}  // namespace linkwright::LINKWRIGHT_ISA
