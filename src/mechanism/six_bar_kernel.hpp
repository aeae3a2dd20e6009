#pragma once

#include "core/kernels.hpp"

namespace linkwright {

inline constexpr int six_bar_lanes = 8;

/// A number to each lane.
struct LaneReal {
  alignas(64) double of[six_bar_lanes];
};
/// A vector of the plane to each lane.
struct LaneVector {
  LaneReal x, y;
};

enum class TravelEvent : unsigned char { none, arrived, dead_point, full, undecided };

/// Six-bars whose loops fall apart into dyads, each on its way to a place of the driver; the loops as in SixBarLoops.
/// Every lane is at all times a six-bar that closes at `turn`, or idle.
struct DyadLanes {
  // First loop: c0 + c1 r1 + X + Y = 0, |X|² = xx, |Y|² = yy; `side` is the sign of X × Y.
  LaneVector c0, c1;
  LaneReal xx, yy, side;
  // Second loop: the vector that its dyad spans is w = d0 + d1 r1 + gx X + gy Y, |w| between `shortest` and `longest`.
  LaneVector d0, d1, gx, gy;
  LaneReal pp_and_qq, two_pq, shortest, longest;
  // Bounds that depend on lengths alone (docs/theory/six-bars.md, section 4).
  LaneReal per_two_xy, bend_of_u, turned, slope, bend, first_bend, second_bend;

  LaneReal beyond_reach[2];  ///< a squared sine as far below zero as rounding never brings it

  LaneReal sense;        ///< ±1
  LaneVector goal;       ///< turn of the driver that it is on the way to
  LaneReal step;         ///< 2 tan(half the next step)
  LaneVector turn;       ///< of the driver, r1
  LaneReal cosine;       ///< of the first dyad's transmission angle
  LaneReal cosine_rate;  ///< its derivative by the driver's angle
  LaneVector w;
  LaneReal ww;

  static constexpr int most_samples = 256;
  /// What was passed: the driver's turns, the squared sines of both dyads. `full`: there is no room for more.
  LaneVector passed[most_samples];
  LaneReal sine_squares[2][most_samples];
  int samples[six_bar_lanes];

  bool idle[six_bar_lanes];
  TravelEvent event[six_bar_lanes];
};

/// Of the samples of one lane: between sample i and the next, halfway by the driver's angle, the squared sines of both
/// dyads.
struct DyadMiddles {
  const DyadLanes* lanes = nullptr;
  int lane = 0;
  double sine_squares[2][DyadLanes::most_samples];
};

/// Six-bars whose loops do not fall apart, each on its walk along its curve of configurations (SixBarStrand).
struct StrandLanes {
  static constexpr double step_in_reach = 0.75;  ///< length of a step, as a share of the reach
  static constexpr int most_steps = 50'000;
  static constexpr int places = 4;

  LaneVector ground[2], coefficient[2][5];  ///< of the two loops
  LaneReal along;                           ///< ±1: along the tangent or against it
  LaneReal home_sign;                       ///< of the tangent's first component where the walk began
  LaneReal least_reach;                     ///< below it strands may cross
  LaneVector place[places][5];              ///< that are looked out for; not numbers: none

  LaneVector turn[5];
  LaneReal tangent[5], correction[5], reach;
  LaneReal length, turned;  ///< walked so far; the driver's turn, radians, to a millionth or so
  LaneReal least_sine_4th;  ///< fourth power of the least sine so far
  int steps[six_bar_lanes];

  bool idle[six_bar_lanes];
  TravelEvent event[six_bar_lanes];  ///< arrived: a place is within reach
};

/// They go on with all lanes until at least one has come to an event.
LINKWRIGHT_DECLARE_KERNELS(dyad_kernel, DyadLanes&);
LINKWRIGHT_DECLARE_KERNELS(strand_kernel, StrandLanes&);
LINKWRIGHT_DECLARE_KERNELS(dyad_middles_kernel, DyadMiddles&);

}  // namespace linkwright
