#pragma once

// What acts at a station, of tables where it is in them.

#include "loads/lane_pins.hpp"

namespace linkwright::LINKWRIGHT_ISA::load_lanes {

/// What is the same in all cases at a station.
template <class W, class R>
struct AtStation {
  Stretched<W, R> spring[LaneLoads::most_springs];  ///< those that are in no table there
  W rubbing;                                        ///< of springs while opening, which closing turns round
  JointRows<R> rows;                                ///< where forces are kept
};

/// `rubbing`: of a spring while it becomes longer.
template <int Width, class W, class R>
LINKWRIGHT_INLINE void add_rubbing(const Station<R>& s, const W& rubbing, W& all) {
  // It takes power, whichever way the spring goes.
  const R power = rubbing.power(s);
  if constexpr (W::has_forces)
    all.add(-with_sign_of<Width>(of_all<R>(1.0), power), rubbing);
  else
    all.add(of_all<R>(-1.0), W{magnitude<Width>(power)});
}

template <int Width, class W, class R>
LINKWRIGHT_INLINE void add_column(const LoadRow& row, const Station<R>& s, const double* numbers, bool on_body,
                                  int position, W& all) {
  const int stride = row.tables->stride;
  const Vector<R> force = W::has_forces ? load_vector<Width>(numbers + stride, stride) : Vector<R>{};
  all.add(s, output_link, force, load<Width>(numbers));
  if (!on_body) return;
  const Vector<R> on_it = load_vector<Width>(numbers + 4 * stride, stride);
  const Vector<R> origin = vector_of<R>(row.tables->origin[position]);
  all.add(s, body_link, on_it, R(load<Width>(numbers + 3 * stride) + cross(origin - s.pivot, on_it)));
}

/// Of springs in tables.
template <int Width, class W, class R>
LINKWRIGHT_INLINE void add_tabled_rubbing(const LoadRow& row, const Station<R>& s, int position, int at, W& all) {
  const LaneLoads& loads = *row.tables->loads;
  for (int k = 0; k < loads.column_springs; ++k) {
    if (!loads.spring[k].is_gas) continue;
    W of_spring{};
    if (k < loads.row_springs)
      of_spring.add(s, row.rubbing[position * loads.row_springs + k]);
    else
      add_column<Width>(row, s, row.tables->rubbing(position, k) + at, true, position, of_spring);
    add_rubbing<Width>(s, of_spring, all);
  }
}

template <int Width, class W, class R>
LINKWRIGHT_INLINE void at_station(const LoadRow& row, const Linkages<R>& of, const Station<R>& s, int position, int at,
                                  AtStation<W, R>& acting) {
  const LaneLoads& loads = *row.tables->loads;
  acting.rubbing = W{};
  if constexpr (W::has_forces) acting.rows = joint_rows<Width>(row, of, s);
  if (position >= 0) add_tabled_rubbing<Width>(row, s, position, at, acting.rubbing);
  for (int k = position >= 0 ? loads.column_springs : 0; k < loads.springs; ++k) {
    acting.spring[k] = stretched<Width, W>(of.links, s, loads.spring[k]);
    if (!loads.spring[k].is_gas) continue;
    W rubbing{};
    rubbing.add(-friction_of(loads.spring[k], acting.spring[k].length), acting.spring[k].unit);
    add_rubbing<Width>(s, rubbing, acting.rubbing);
  }
}

/// What the body carries, but for the forces that are the same in the fixed frame, which the row has.
template <class W, class R>
LINKWRIGHT_INLINE void add_swung(W& sum, const Station<R>& s, const Carried<R>& by, bool turning) {
  const R moment = cross(s.turned, by.lever) + by.moment;
  if (turning)
    sum.add(s, body_link, product(s.turned, by.turning), moment);
  else
    sum.add_moment(s, moment);
}

/// What is static in a case: all but the effort and friction.
template <int Width, class W, class R>
LINKWRIGHT_INLINE W still_in(const LoadRow& row, const Linkages<R>& of, const Station<R>& s,
                             const AtStation<W, R>& acting, int j, int c, int at) {
  const LoadTables& tables = *row.tables;
  const LaneLoads& loads = *tables.loads;
  const int position = row.position[j];
  W still{};
  still.add(s, row.acting[j * loads.cases + c]);
  if (loads.on_coupler) add_carried(still, s, body_link, of.coupler[c], s.turned, loads.turning);
  if (position < 0) {
    add_swung(still, s, carried_of<R>(row.carried[c]), loads.turning);
    if (loads.on_output)
      add_carried(still, s, output_link, load_carried<Width>(tables.carried_at(c) + at, tables.stride), s.output,
                  loads.turning);
  } else if (loads.on_output || loads.column_springs > loads.row_springs) {
    const bool on_body = loads.column_springs > loads.row_springs;
    add_column<Width>(row, s, tables.acting(position, c) + at, on_body, position, still);
  }
  for (int k = position >= 0 ? loads.column_springs : 0; k < loads.springs; ++k)
    still.add(push_of(loads.spring[k], acting.spring[k], c, of.share), acting.spring[k].unit);
  return still;
}

}  // namespace linkwright::LINKWRIGHT_ISA::load_lanes
