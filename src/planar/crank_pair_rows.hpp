#pragma once

// The rows of a map of timed linkages, for one pack width. Included by the crank_pair_kernel_*.cpp files, one for each
// instruction set.

#include "planar/crank_pair_kernel.hpp"
#include "planar/four_bar_kernel_rows.hpp"

namespace linkwright::LINKWRIGHT_ISA {

/// A crank as a dyad: the coupler of all loops of its row.
template <int Poses>
struct LoopCoupler {
  double center_x, center_y, length, crank_length;
  double arm_x[Poses], arm_y[Poses];
};

template <int Poses>
LINKWRIGHT_INLINE LoopCoupler<Poses> coupler_of(const CrankPairTask& task, std::size_t row) {
  const KernelAxis& axis = task.cranks;
  LoopCoupler<Poses> coupler{axis.center_x[row], axis.center_y[row], axis.length[row], task.crank_length[row], {}, {}};
  for (int j = 0; j < Poses; ++j) {
    coupler.arm_x[j] = axis.arm_x[j][row];
    coupler.arm_y[j] = axis.arm_y[j][row];
  }
  return coupler;
}

/// The links of a pack of loops that drive them: from the crank's circle point to the cognate's, at each pose.
template <int Width, int Poses>
struct LoopDrivers {
  using Real = typename Pack<Width>::Real;
  Real length;
  Real arm_x[Poses], arm_y[Poses];
  int admissible_directions, at_least_half_turn;
};

template <int Width, int Poses>
LINKWRIGHT_INLINE Distances<Width> loop_distances(const LoopCoupler<Poses>& coupler, const Block<Poses>& cognates,
                                                  int at) {
  using Real = typename Pack<Width>::Real;
  Distances<Width> d;
  d.frame_x = load<Width>(cognates.center_x + at) - coupler.center_x;
  d.frame_y = load<Width>(cognates.center_y + at) - coupler.center_y;
  d.gg = d.frame_x * d.frame_x + d.frame_y * d.frame_y;
  d.hh = Real{} + coupler.length * coupler.length;
  d.g = square_root<Width>(d.gg);
  d.h = Real{} + coupler.length;
  return d;
}

template <int Width, int Poses>
LINKWRIGHT_INLINE LoopDrivers<Width, Poses> loop_drivers(const CrankPairTask& task, const LoopCoupler<Poses>& coupler,
                                                         const Block<Poses>& cognates, int at,
                                                         const Distances<Width>& d) {
  LoopDrivers<Width, Poses> drivers;
  for (int j = 0; j < Poses; ++j) {
    drivers.arm_x[j] = (load<Width>(cognates.arm_x[j] + at) + d.frame_x) - coupler.arm_x[j];
    drivers.arm_y[j] = (load<Width>(cognates.arm_y[j] + at) + d.frame_y) - coupler.arm_y[j];
  }
  drivers.length = square_root<Width>(drivers.arm_x[0] * drivers.arm_x[0] + drivers.arm_y[0] * drivers.arm_y[0]);
  drivers.admissible_directions = task.admissible_directions;
  drivers.at_least_half_turn = task.at_least_half_turn;
  return drivers;
}

/// Of the linkage in place of its loop, which is larger by driver over crank.
template <int Width>
LINKWRIGHT_INLINE void scale(PairVerdict<Width>& v, double crank_length, typename Pack<Width>::Real driver_length) {
  using Real = typename Pack<Width>::Real;
  const Real share = (Real{} + crank_length) / select<Width>(v.whole, driver_length, Real{} + 1.0);
  v.longest = v.longest * share;
  v.shortest = v.shortest * share;
}

template <int Width, int Poses>
void crank_pair_rows(const CrankPairTask& task) {
  alignas(64) Block<Poses> cognates;
  const auto unit = static_cast<float>(task.unit);
  for (std::size_t column = 0; column < task.columns; column += block) {
    const int count = static_cast<int>(task.columns - column < block ? task.columns - column : block);
    fetch<Poses>(task.cognates, column, static_cast<std::size_t>(count), cognates);
    for (std::size_t row = task.row_begin; row < task.row_end; ++row) {
      const LoopCoupler<Poses> coupler = coupler_of<Poses>(task, row);
      std::size_t cell = row * task.columns + column;
      for (int at = 0; at < count; at += Width, cell += Width) {
        expect(task.cells, cell);
        const auto here = loop_distances<Width>(coupler, cognates, at);
        const auto drivers = loop_drivers<Width>(task, coupler, cognates, at, here);
        auto verdict = pair_verdict<Width>(drivers, cognates, at, here, task.zero_share);
        scale(verdict, coupler.crank_length, drivers.length);
        put_pack<Width, Poses>(verdict, unit, task.cells, cell, count - at);
      }
    }
  }
}

template <int Width>
void crank_pair_kernel(const CrankPairTask& task) {
  with_position_count(task.poses, [&](auto count) { crank_pair_rows<Width, decltype(count)::value>(task); });
}

}  // namespace linkwright::LINKWRIGHT_ISA
