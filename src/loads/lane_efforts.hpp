#pragma once

// What moves four-bars, and what it takes.

#include "loads/lane_acting.hpp"

namespace linkwright::LINKWRIGHT_ISA::load_lanes {

/// The wrench of a unit of effort and its rate.
template <class W, class R>
struct Effort {
  W wrench;
  R rate, over_rate;
};

template <class W, class R>
LINKWRIGHT_INLINE Effort<W, R> effort_of(const Station<R>& s, const W& wrench) {
  const R rate = wrench.power(s);
  return {wrench, rate, 1.0 / rate};
}

/// `c`: of a hand whose direction goes by the case.
template <int Width, class W, class R>
LINKWRIGHT_INLINE Effort<W, R> hand(const LoadRow& row, const Links<R>& links, const Station<R>& s, int position,
                                    int c) {
  const Vector<R> arm = position >= 0 ? vector_of<R>(row.grip[position])
                                      : product(s.turned, links.body + vector_of<R>(row.handle.x, row.handle.y));
  W wrench{};
  if (row.hand_way == LoadRow::along) {
    const LaneLoads& loads = *row.tables->loads;
    add_at(wrench, s, row.handle, arm, vector_of<R>(loads.hand_x[c], loads.hand_y[c]));
    return effort_of(s, wrench);
  }
  const Vector<R> way = s.rate_input * s.input + s.rate_coupler * arm;  // turned by a quarter, its velocity
  const R rate = square_root<Width>(square_of(way)), over_rate = 1.0 / rate;
  if constexpr (W::has_forces) add_at(wrench, s, row.handle, arm, over_rate * quarter_turned(way));
  return {wrench, rate, over_rate};
}

template <int Width, class W, class R>
LINKWRIGHT_INLINE Effort<W, R> drive(const LoadRow& row, const Links<R>& links, const Station<R>& s) {
  W wrench{};
  const Vector<R> no_force{};
  if (row.drive == LoadRow::by_input) wrench.add(s, input_link, no_force, of_all<R>(1.0));
  if (row.drive == LoadRow::by_output) wrench.add(s, output_link, no_force, of_all<R>(1.0));
  if (row.drive == LoadRow::by_cylinder)
    wrench = stretched<Width, W>(links, s, row.cylinder_from, row.cylinder_to, 0, 0).unit;
  return effort_of(s, wrench);
}

/// What it takes to move one way.
template <class R>
struct Pushed {
  R effort;
  Joints<R> joints;
};

/// `way`: +1 opening, −1 closing.
template <int Width, class W, class R>
LINKWRIGHT_INLINE Pushed<R> pushed(const LoadRow& row, const Station<R>& s, const JointRows<R>& rows, const W& still,
                                   const W& rubbing, const Effort<W, R>& by, double way) {
  Pushed<R> pushed;
  if constexpr (!W::has_forces) {
    pushed.effort = -(way * still.all + rubbing.all) * by.over_rate;
  } else {
    W all = still;
    all.add(of_all<R>(way), rubbing);
    const R effort = -all.power(s) * by.over_rate;
    all.add(effort, by.wrench);
    pushed.joints = joints_of<Width>(s, rows, all);
    pushed.effort = way * effort + row.friction_circle * pin_loss<Width>(s, pushed.joints) * by.over_rate;
  }
  return pushed;
}

}  // namespace linkwright::LINKWRIGHT_ISA::load_lanes
