#pragma once

// What the linkages of a map, of a row or of a column share, worked out once.

#include "loads/lane_statics.hpp"

namespace linkwright::LINKWRIGHT_ISA::load_lanes {

LINKWRIGHT_INLINE void put(Vector<double> a, double (&to)[2]) {
  to[0] = a.x;
  to[1] = a.y;
}

/// Of a force or moment that lanes share, what LaneWrench holds.
LINKWRIGHT_INLINE LaneWrench wrench_of(const Sums<double>& sum, Vector<double> input) {
  LaneWrench wrench;
  put(sum.force[input_link], wrench.input);
  put(sum.force[body_link], wrench.body);
  wrench.input_moment = sum.moment[input_link];
  wrench.body_moment = sum.moment[body_link];
  wrench.about_input = wrench.input_moment + cross(input, sum.force[body_link]);
  return wrench;
}

/// What springs do in a position, of which the station has what they act on: to each case its sum, to each spring that
/// has friction what that does while the spring becomes longer.
template <int Width, class R, class Case, class Friction>
LINKWRIGHT_INLINE void act(const LaneLoads& loads, int from, int to, const Links<R>& links, const Station<R>& s,
                           const Case& to_case, const Friction& to_spring) {
  for (int k = from; k < to; ++k) {
    const LaneLoads::Spring& spring = loads.spring[k];
    const Stretched<Sums<R>, R> line = stretched<Width, Sums<R>>(links, s, spring);
    for (int c = 0; c < loads.cases; ++c) to_case(c).add(push_of(spring, line, c), line.unit);
    Sums<R> rubbing{};
    if (spring.is_gas) rubbing.add(-friction_of(spring, line.length), line.unit);
    to_spring(k, rubbing);
  }
}

/// Where the body alone has a place in a position: its own origin is the pivot of its moments.
template <class R>
LINKWRIGHT_INLINE Station<R> station_of_body(const LoadTables& tables, int j) {
  Station<R> s{};
  s.pivot = vector_of<R>(tables.origin[j]);
  s.turned = vector_of<R>(tables.turned[j]);
  return s;
}

inline void keep(const Carried<double>& by, LaneCarried& to) {
  put(by.force, to.force);
  put(by.lever, to.lever);
  put(by.turning, to.turning);
  to.moment = by.moment;
}
template <class R>
LINKWRIGHT_INLINE Carried<R> carried_of(const LaneCarried& by) {
  return {vector_of<R>(by.force), vector_of<R>(by.lever), vector_of<R>(by.turning), of_all<R>(by.moment)};
}

inline void fill_common(LoadTables& tables) {
  const LaneLoads& loads = *tables.loads;
  const Vector<double> nothing = {0, 0};
  for (int c = 0; c < loads.cases; ++c) keep(carried_by(loads, LanePoint::body, 0.0, c), tables.carried[c]);
  for (int j = 0; j < tables.positions; ++j) {
    const Station<double> s = station_of_body<double>(tables, j);
    Sums<double> all[LaneLoads::most_cases];
    for (int c = 0; c < loads.cases; ++c) {
      all[c] = Sums<double>{};
      add_carried(all[c], s, body_link, carried_of<double>(tables.carried[c]), s.turned, true);
    }
    act<1>(
        loads, 0, loads.common_springs, Links<double>{}, s, [&](int c) -> Sums<double>& { return all[c]; },
        [&](int k, const Sums<double>& rubbing) {
          tables.common_rubbing[j * loads.common_springs + k] = wrench_of(rubbing, nothing);
        });
    for (int c = 0; c < loads.cases; ++c) tables.common[j * loads.cases + c] = wrench_of(all[c], nothing);
  }
}

template <int Width>
LINKWRIGHT_INLINE Vector<Real<Width>> load_vector(const double* numbers, int stride) {
  return {load<Width>(numbers), load<Width>(numbers + stride)};
}
template <int Width>
LINKWRIGHT_INLINE void store_vector(Vector<Real<Width>> a, double* numbers, int stride) {
  store<Width>(a.x, numbers);
  store<Width>(a.y, numbers + stride);
}

template <int Width>
LINKWRIGHT_INLINE void store_carried(const Carried<Real<Width>>& by, double* numbers, int stride) {
  store_vector<Width>(by.force, numbers, stride);
  store_vector<Width>(by.lever, numbers + 2 * stride, stride);
  store_vector<Width>(by.turning, numbers + 4 * stride, stride);
  store<Width>(by.moment, numbers + 6 * stride);
}
template <int Width>
LINKWRIGHT_INLINE Carried<Real<Width>> load_carried(const double* numbers, int stride) {
  return {load_vector<Width>(numbers, stride), load_vector<Width>(numbers + 2 * stride, stride),
          load_vector<Width>(numbers + 4 * stride, stride), load<Width>(numbers + 6 * stride)};
}

/// Output link and body, whose moment is about its origin.
template <int Width>
LINKWRIGHT_INLINE void store_wrench(const Sums<Real<Width>>& sum, double* numbers, int stride) {
  store<Width>(sum.moment[output_link], numbers);
  store_vector<Width>(sum.force[output_link], numbers + stride, stride);
  store<Width>(sum.moment[body_link], numbers + 3 * stride);
  store_vector<Width>(sum.force[body_link], numbers + 4 * stride, stride);
}

template <int Width>
void fill_columns(LoadTables& tables, int at) {
  using R = Real<Width>;
  const LaneLoads& loads = *tables.loads;
  const int stride = tables.stride;
  const Vector<R> fixed = load_vector<Width>(tables.fixed(0) + at, stride);
  const Vector<R> first = load_vector<Width>(tables.moving(0, 0) + at, stride) - fixed;
  const R length = square_root<Width>(square_of(first));
  Links<R> links{};
  links.over_output = 1.0 / length;
  store<Width>(length, tables.length() + at);
  for (int c = 0; c < loads.cases; ++c) {
    Carried<R> by = carried_by(loads, LanePoint::output, length, c);
    by.turn({links.over_output, R{}});
    store_carried<Width>(by, tables.carried_at(c) + at, stride);
  }
  for (int j = 0; j < tables.positions; ++j) {
    Station<R> s = station_of_body<R>(tables, j);
    s.output_fixed = fixed;
    s.output = load_vector<Width>(tables.moving(j, 0) + at, stride) - fixed;
    Sums<R> all[LaneLoads::most_cases];
    for (int c = 0; c < loads.cases; ++c) {
      all[c] = Sums<R>{};
      add_carried(all[c], s, output_link, load_carried<Width>(tables.carried_at(c) + at, stride), s.output, true);
    }
    act<Width>(
        loads, loads.row_springs, loads.column_springs, links, s, [&](int c) -> Sums<R>& { return all[c]; },
        [&](int k, const Sums<R>& rubbing) { store_wrench<Width>(rubbing, tables.rubbing(j, k) + at, stride); });
    for (int c = 0; c < loads.cases; ++c) store_wrench<Width>(all[c], tables.acting(j, c) + at, stride);
  }
}

template <int Width>
void fill_tables(LoadTables& tables) {
  fill_common(tables);
  for (int at = 0; at < tables.stride; at += Width) fill_columns<Width>(tables, at);
}

/// Its moment about a point from which the one that it is told about is at `arm`.
LINKWRIGHT_INLINE Sums<double> moved(const LaneWrench& wrench, Vector<double> arm) {
  Sums<double> sum{};
  sum.add({}, wrench);
  sum.moment[body_link] += cross(arm, sum.force[body_link]);
  return sum;
}

inline Station<double> station_of_row(const LoadRow& row, int j) {
  Station<double> s{};
  s.input_fixed = vector_of<double>(row.input_fixed);
  s.pivot = vector_of<double>(row.input_moving[j]);
  s.input = s.pivot - s.input_fixed;
  if (row.position[j] >= 0) s.turned = vector_of<double>(row.tables->turned[row.position[j]]);
  return s;
}

/// At a position all that is of the row.
inline void fill_position(LoadRow& row, const Links<double>& links, const Station<double>& s, int position,
                          Sums<double>* all) {
  const LoadTables& tables = *row.tables;
  const LaneLoads& loads = *tables.loads;
  const Vector<double> origin = vector_of<double>(tables.origin[position]) - s.pivot;
  LaneWrench* rubs = row.rubbing + position * loads.row_springs;
  for (int c = 0; c < loads.cases; ++c) all[c].add(1.0, moved(tables.common[position * loads.cases + c], origin));
  for (int k = 0; k < loads.common_springs; ++k)
    rubs[k] = wrench_of(moved(tables.common_rubbing[position * loads.common_springs + k], origin), s.input);
  act<1>(
      loads, loads.common_springs, loads.row_springs, links, s, [&](int c) -> Sums<double>& { return all[c]; },
      [&](int k, const Sums<double>& rubbing) { rubs[k] = wrench_of(rubbing, s.input); });
  put(product(s.turned, links.body + Vector<double>{row.handle.x, row.handle.y}), row.grip[position]);
}

inline void fill_row(LoadRow& row) {
  const LaneLoads& loads = *row.tables->loads;
  const Vector<double> body = vector_of<double>(row.tables->origin[0]) - vector_of<double>(row.input_moving[0]);
  put(body, row.body);
  row.length = square_root<1>(square_of(station_of_row(row, 0).input));
  Links<double> links{};
  links.body = body;
  links.over_input = 1 / row.length;
  Carried<double> by_input[LaneLoads::most_cases];
  for (int c = 0; c < loads.cases; ++c) {
    by_input[c] = carried_by(loads, LanePoint::input, row.length, c);
    by_input[c].turn({links.over_input, 0.0});
    Carried<double> by_body = carried_of<double>(row.tables->carried[c]);
    by_body.move(body);
    keep(by_body, row.carried[c]);
  }
  for (int j = 0; j < row.stations; ++j) {
    const Station<double> s = station_of_row(row, j);
    Sums<double> all[LaneLoads::most_cases];
    for (int c = 0; c < loads.cases; ++c) {
      all[c] = Sums<double>{};
      add_carried(all[c], s, input_link, by_input[c], s.input, true);
    }
    if (row.position[j] >= 0)
      fill_position(row, links, s, row.position[j], all);
    else
      for (int c = 0; c < loads.cases; ++c) all[c].add(s, body_link, vector_of<double>(row.carried[c].force), 0.0);
    for (int c = 0; c < loads.cases; ++c) row.acting[j * loads.cases + c] = wrench_of(all[c], s.input);
  }
}

}  // namespace linkwright::LINKWRIGHT_ISA::load_lanes
