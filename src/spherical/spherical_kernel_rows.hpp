#pragma once

// The rows of a region of spherical four-bars, for one pack width. Included by the kernel_*.cpp files, one for each
// instruction set.

#include "mechanism/spherical_verdict.hpp"
#include "spherical/spherical_kernel.hpp"

namespace linkwright::LINKWRIGHT_ISA {

/// Columns worked on for all rows of a task before going on: few enough to stay in the nearest cache.
inline constexpr int spherical_block = 128;
/// Lanes that are read past the last column of a block, and thrown away.
inline constexpr int spherical_margin = 8;

template <int Poses>
using SphericalBlock = SphericalDrivenLinks<Poses, spherical_block + spherical_margin>;

template <int Poses>
LINKWRIGHT_INLINE SphericalDriver<Poses> spherical_driver(const SphericalKernelAxis& axis, std::size_t row) {
  SphericalDriver<Poses> driver;
  for (int i = 0; i < 3; ++i) {
    driver.fixed[i] = axis.fixed[i][row];
    for (int j = 0; j < Poses; ++j) {
      driver.moving[j][i] = axis.moving[j][i][row];
      driver.normal[j][i] = axis.normal[j][i][row];
    }
  }
  driver.half_sine = axis.half_sine[row];
  driver.half_cosine = axis.half_cosine[row];
  driver.admissible_directions = axis.admissible_directions[row];
  driver.at_least_half_turn = axis.at_least_half_turn[row];
  return driver;
}

template <int Poses>
LINKWRIGHT_INLINE void fetch(const SphericalKernelAxis& axis, std::size_t column, std::size_t count,
                             SphericalBlock<Poses>& driven) {
  const auto copy = [&](const double* from, double* to) {
    __builtin_memcpy(to, from + column, count * sizeof(double));
    __builtin_memset(to + count, 0, spherical_margin * sizeof(double));
  };
  for (int i = 0; i < 3; ++i) {
    copy(axis.fixed[i], driven.fixed[i]);
    for (int j = 0; j < Poses; ++j) {
      copy(axis.moving[j][i], driven.moving[j][i]);
      copy(axis.normal[j][i], driven.normal[j][i]);
    }
  }
  copy(axis.half_sine, driven.half_sine);
  copy(axis.half_cosine, driven.half_cosine);
}

/// The columns of a pack as they are stored.
template <int Width>
struct SphericalColumns {
  using Single = typename Pack<Width>::Single;
  unsigned long long type, defects;
  Single versine, full_versine, least, largest;
};

template <int Width>
LINKWRIGHT_INLINE SphericalColumns<Width> columns_of(const SphericalVerdict<Width>& v) {
  using Real = typename Pack<Width>::Real;
  using Single = typename Pack<Width>::Single;
  Real scale = v.scale, least = v.least, largest = v.largest;
  if (v.whole != all_lanes<Width>) [[unlikely]] {
    scale = select<Width>(v.whole, scale, Real{} + 1.0);
    least = where<Width>(v.whole, least);
    largest = where<Width>(v.whole, largest);
  }
  // 1 − cos γ: subtracted in double, where digits are lost, divided in single.
  const auto versine = [&](Mask mask, Real worst) {
    return mask ? single<Width>(where<Width>(mask, larger(scale - worst, Real{}))) / single<Width>(scale) : Single{};
  };
  return {v.type,
          v.defects,
          versine(v.clean, v.worst),
          versine(v.turns, v.worst_turn),
          single<Width>(2.0 * least * least),
          single<Width>(2.0 * largest * largest)};
}

template <int Width>
LINKWRIGHT_INLINE void put(const SphericalColumns<Width>& columns, const SphericalKernelCells& cells,
                           std::size_t cell) {
  store<Width>(columns.type, cells.type + cell);
  store<Width>(columns.defects, cells.defects + cell);
  store<Width>(columns.versine, cells.versine + cell);
  store<Width>(columns.full_versine, cells.full_versine + cell);
  store<Width>(columns.least, cells.least + cell);
  store<Width>(columns.largest, cells.largest + cell);
}

/// The first `count` lanes only.
template <int Width>
LINKWRIGHT_INLINE void put_some(const SphericalColumns<Width>& columns, const SphericalKernelCells& cells,
                                std::size_t cell, std::size_t count) {
  std::uint8_t type[Width], defects[Width];
  float versine[Width], full_versine[Width], least[Width], largest[Width];
  put<Width>(columns, {type, defects, versine, full_versine, least, largest, nullptr}, 0);
  __builtin_memcpy(cells.type + cell, type, count);
  __builtin_memcpy(cells.defects + cell, defects, count);
  __builtin_memcpy(cells.versine + cell, versine, count * sizeof(float));
  __builtin_memcpy(cells.full_versine + cell, full_versine, count * sizeof(float));
  __builtin_memcpy(cells.least + cell, least, count * sizeof(float));
  __builtin_memcpy(cells.largest + cell, largest, count * sizeof(float));
}

template <int Width, int Poses>
void spherical_rows(const SphericalKernelTask& task) {
  alignas(64) SphericalBlock<Poses> driven;
  for (std::size_t column = 0; column < task.columns; column += spherical_block) {
    const int count =
        static_cast<int>(task.columns - column < spherical_block ? task.columns - column : spherical_block);
    fetch<Poses>(task.output, column, static_cast<std::size_t>(count), driven);
    for (std::size_t row = task.row_begin; row < task.row_end; ++row) {
      const SphericalDriver<Poses> driver = spherical_driver<Poses>(task.input, row);
      std::size_t cell = row * task.columns + column;
      for (int at = 0; at < count; at += Width, cell += Width) {
        const auto verdict = spherical_verdict<Width>(driver, driven, at, task.zero_share);
        const auto lanes = static_cast<std::size_t>(count - at < Width ? count - at : Width);
        // Three orientations or more come in order one way only; two may do so both ways, and the pair has a say in it.
        if constexpr (Poses == 2)
          if (task.cells.admissible_directions) {
            std::uint8_t directions[Width];
            store<Width>(bytes<Width>(verdict.travels_ccw) * ccw_bit | bytes<Width>(verdict.travels_cw) * cw_bit,
                         directions);
            __builtin_memcpy(task.cells.admissible_directions + cell, directions, lanes);
          }
        if (lanes == Width)
          put<Width>(columns_of<Width>(verdict), task.cells, cell);
        else
          put_some<Width>(columns_of<Width>(verdict), task.cells, cell, lanes);
      }
    }
  }
}

template <int Width>
void spherical_kernel(const SphericalKernelTask& task) {
  with_position_count(task.orientations, [&](auto count) { spherical_rows<Width, decltype(count)::value>(task); });
}

}  // namespace linkwright::LINKWRIGHT_ISA
