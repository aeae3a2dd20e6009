#pragma once

#include <span>
#include <vector>

#include "approximate/curve_least_squares.hpp"

namespace linkwright {

/// Points that are to be passed at angles of the input.
struct TimedTask : FitTask {
  std::span<const Point> turns;  ///< one to each point: the unit number of the input's angle, from any datum
};

/// A linkage whose input turns as is prescribed; its states follow from it in closed form. `branch` is never 0.
struct TimedStart : CurveStart {
  static constexpr unsigned hold_datum = 1u << fit_dimensions;  ///< of `held`

  TimedStart() { branch = 1; }

  Point datum{1, 0};      ///< direction of the input where a turn is 1
  bool reversed = false;  ///< it turns against the angles

  [[nodiscard]] Point input_at(Point turn) const { return product(datum, reversed ? std::conj(turn) : turn); }
  /// Sets the datum by the states.
  void take_datum(const TimedTask& task);
};

/// The states at the prescribed angles; false where the input does not reach one.
[[nodiscard]] bool place_states(const TimedTask& task, TimedStart& start);

/// The sums of a linkage at its states.
void evaluate(const TimedTask& task, TimedStart& start);

/// Nothing slides: where it stands is prescribed.
inline void slide_to_nearest(const TimedTask& task, TimedStart& start) { evaluate(task, start); }

/// Levenberg–Marquardt over the nine numbers of the linkage and the datum.
void improve(const TimedTask& task, TimedStart& start, int iterations);

}  // namespace linkwright
