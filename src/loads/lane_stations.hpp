#pragma once

// Where four-bars stand, and how they move on.

#include "loads/lane_tables.hpp"

namespace linkwright::LINKWRIGHT_ISA::load_lanes {

/// Some linkages of the row.
template <class R>
struct Linkages {
  Links<R> links;
  Vector<R> output_fixed;
  R output_square, coupler_square;
  Vector<R> unturn;                           ///< takes the coupler to its turn from position 1
  R twist_sense;                              ///< so that the driver's rate, ± β × h, has the sense of travel
  R shape_sense;                              ///< of β × h
  R least_square;                             ///< of rates of points: where they are less, they rest
  R least_torque_square;                      ///< of rates of cranks
  R share;                                    ///< of the strength of a spring that leaves it free
  Carried<R> coupler[LaneLoads::most_cases];  ///< where something acts there
};

/// All that acts does: there is nothing between the positions, and nothing that a pair alone has.
LINKWRIGHT_INLINE bool is_in_tables(const LoadRow& row) {
  const LaneLoads& loads = *row.tables->loads;
  return row.stations == row.tables->positions && loads.springs == loads.column_springs && !loads.on_coupler &&
         row.drive != LoadRow::by_cylinder;
}

template <int Width, class R = Real<Width>>
LINKWRIGHT_INLINE void set_coupler(const LaneLoads& loads, Vector<R> coupler_1, R over_coupler_square,
                                   Linkages<R>& of) {
  const R length = square_root<Width>(of.coupler_square);
  const R over_length = length * over_coupler_square;
  of.links.coupler_1 = over_length * coupler_1;
  for (int c = 0; c < loads.cases; ++c) {
    of.coupler[c] = carried_by(loads, LanePoint::coupler, length, c);
    of.coupler[c].turn(of.links.coupler_1);
  }
}

template <int Width, class R = Real<Width>>
LINKWRIGHT_INLINE void set_links(const LoadRow& row, Vector<R> coupler_1, R output, Linkages<R>& of) {
  const R over_coupler_square = 1.0 / of.coupler_square;
  of.unturn = over_coupler_square * conjugate(coupler_1);
  of.links.body = vector_of<R>(row.body);
  of.links.over_input = of_all<R>(1 / row.length);
  of.links.over_output = 1.0 / output;
  if (row.tables->loads->on_coupler) set_coupler<Width>(*row.tables->loads, coupler_1, over_coupler_square, of);
}

template <int Width, class R = Real<Width>>
LINKWRIGHT_INLINE void set_linkages(const LoadRow& row, int at, Linkages<R>& of) {
  const LoadTables& tables = *row.tables;
  const Vector<R> pivot = vector_of<R>(row.input_moving[0]);
  const Vector<R> output_moving = load_vector<Width>(tables.moving(0, 0) + at, tables.stride);
  of.output_fixed = load_vector<Width>(tables.fixed(0) + at, tables.stride);
  const R length = load<Width>(tables.length() + at);
  const Vector<R> coupler_1 = output_moving - pivot;
  of.output_square = length * length;
  of.coupler_square = square_of(coupler_1);
  of.share = row.shares ? load<Width>(row.shares + at) : R{};
  const R one = of_all<R>(1.0);
  of.shape_sense = with_sign_of<Width>(one, cross(output_moving - of.output_fixed, coupler_1));
  of.twist_sense = of.shape_sense * row.sense;
  // Twists are as large as coupler times output.
  of.least_torque_square = 1e-24 * of.coupler_square * of.output_square;
  of.least_square = 1e6 * of.least_torque_square * (row.length * row.length + of.coupler_square + of.output_square);
  if (!is_in_tables(row)) set_links<Width>(row, coupler_1, length, of);
}

/// (β × h, α × β, α × h), which has no size of its own.
template <class R>
LINKWRIGHT_INLINE void set_twist(const Linkages<R>& of, Station<R>& s) {
  s.rate_input = of.twist_sense * cross(s.output, s.coupler);
  s.rate_coupler = of.twist_sense * cross(s.input, s.output);
  s.rate_output = of.twist_sense * cross(s.input, s.coupler);
}

/// A station that is a position.
template <int Width, class R = Real<Width>>
LINKWRIGHT_INLINE Station<R> station_in_position(const LoadRow& row, const Linkages<R>& of, int j, int at) {
  const LoadTables& tables = *row.tables;
  Station<R> s;
  s.input_fixed = vector_of<R>(row.input_fixed);
  s.pivot = vector_of<R>(row.input_moving[j]);
  s.output_fixed = of.output_fixed;
  s.input = s.pivot - s.input_fixed;
  s.output = load_vector<Width>(tables.moving(j, 0) + at, tables.stride) - s.output_fixed;
  s.coupler = s.output - (s.pivot - s.output_fixed);
  s.turned = vector_of<R>(tables.turned[j]);
  set_twist(of, s);
  return s;
}

template <int Width, class R = Real<Width>>
LINKWRIGHT_INLINE Station<R> station(const LoadRow& row, const Linkages<R>& of, int j, int at) {
  const LoadTables& tables = *row.tables;
  Station<R> s;
  s.input_fixed = vector_of<R>(row.input_fixed);
  s.pivot = vector_of<R>(row.input_moving[j]);
  s.output_fixed = of.output_fixed;
  s.input = s.pivot - s.input_fixed;
  const Vector<R> d = s.pivot - s.output_fixed;
  const int position = row.position[j];
  if (position >= 0) {
    s.output = load_vector<Width>(tables.moving(position, 0) + at, tables.stride) - s.output_fixed;
    s.coupler = s.output - d;
    s.turned = vector_of<R>(tables.turned[position]);
  } else {
    // β from the diagonal D = A − B₀: β = D (x + iy), on the side that it has in position 1: h = β − D, so
    // β × h = D × β has the sign of y.
    const R square = square_of(d), over_square = 1.0 / square;
    const R x = 0.5 * (square + of.output_square - of.coupler_square) * over_square;
    const R y = square_root<Width>(larger(R(of.output_square * over_square - x * x), R{}));
    s.output = product(d, Vector<R>{x, y * of.shape_sense});
    s.coupler = s.output - d;
    s.turned = product(s.coupler, of.unturn);
  }
  set_twist(of, s);
  return s;
}

}  // namespace linkwright::LINKWRIGHT_ISA::load_lanes
