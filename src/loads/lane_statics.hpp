#pragma once

// What acts on four-bars, one linkage to each lane: src/loads/statics.cpp in lanes. Of numbers that lanes share
// `R` is a double.

#include "core/pack_vector.hpp"
#include "loads/load_kernel.hpp"

namespace linkwright::LINKWRIGHT_ISA::load_lanes {

template <int Width>
using Real = typename Pack<Width>::Real;

/// The same in all lanes; what is taken away costs nothing, as x − 0 is x whatever its sign.
template <class R>
LINKWRIGHT_INLINE R of_all(double number) {
  return number - R{};
}
template <class R>
LINKWRIGHT_INLINE Vector<R> vector_of(double x, double y) {
  return {of_all<R>(x), of_all<R>(y)};
}
template <class R>
LINKWRIGHT_INLINE Vector<R> vector_of(const double (&numbers)[2]) {
  return vector_of<R>(numbers[0], numbers[1]);
}
template <class R>
LINKWRIGHT_INLINE Vector<R> conjugate(Vector<R> a) {
  return {a.x, -a.y};
}
template <class R>
LINKWRIGHT_INLINE Vector<R> negative_of(Vector<R> a) {
  return {-a.x, -a.y};
}
template <class R>
LINKWRIGHT_INLINE Vector<R> quarter_turned(Vector<R> a) {
  return {-a.y, a.x};
}
template <class R>
LINKWRIGHT_INLINE R square_of(Vector<R> a) {
  return dot(a, a);
}

/// What does not change over the travel.
template <class R>
struct Links {
  Vector<R> body;             ///< the body's origin from its pivot in position 1
  Vector<R> coupler_1;        ///< direction from there to the other pivot; where something acts on the coupler
  R over_input, over_output;  ///< over the lengths
};

/// A station, with the twist in the sense of opening.
template <class R>
struct Station {
  Vector<R> input_fixed, pivot, output_fixed;  ///< `pivot`: of the body at the input link
  Vector<R> input, coupler, output;
  Vector<R> turned;  ///< e^{i turn} of the body from position 1
  R rate_input, rate_coupler, rate_output;
};

enum LaneLink { input_link, body_link, output_link };

// Neither has values by itself: there are whole arrays of them, of which some are used.

/// Of forces on the links that there are: what they do per twist.
template <class R>
struct Power {
  static constexpr bool has_forces = false;
  R all;

  /// `moment`: of a grounded link about its fixed pivot, of the body about its own.
  LINKWRIGHT_INLINE void add(const Station<R>& s, LaneLink link, Vector<R> force, R moment) {
    if (link == input_link) all = all + s.rate_input * moment;
    if (link == output_link) all = all + s.rate_output * moment;
    if (link == body_link) all = all + s.rate_input * cross(s.input, force) + s.rate_coupler * moment;
  }
  LINKWRIGHT_INLINE void add_moment(const Station<R>& s, R of_body) { all = all + s.rate_coupler * of_body; }
  LINKWRIGHT_INLINE void add(const Station<R>& s, const LaneWrench& wrench) {
    all = all + s.rate_input * wrench.about_input + s.rate_coupler * wrench.body_moment;
  }
  LINKWRIGHT_INLINE void add(R times, const Power& other) { all = all + times * other.all; }
  LINKWRIGHT_INLINE R power(const Station<R>& /*s*/) const { return all; }
};

/// The same, forces and moments being kept, by LaneLink.
template <class R>
struct Sums {
  static constexpr bool has_forces = true;
  Vector<R> force[3];
  R moment[3];

  LINKWRIGHT_INLINE void add(const Station<R>& /*s*/, LaneLink link, Vector<R> acting, R about) {
    force[link] = force[link] + acting;
    moment[link] = moment[link] + about;
  }
  LINKWRIGHT_INLINE void add_moment(const Station<R>& /*s*/, R of_body) {
    moment[body_link] = moment[body_link] + of_body;
  }
  LINKWRIGHT_INLINE void add(const Station<R>& s, const LaneWrench& wrench) {
    add(s, input_link, vector_of<R>(wrench.input), of_all<R>(wrench.input_moment));
    add(s, body_link, vector_of<R>(wrench.body), of_all<R>(wrench.body_moment));
  }
  LINKWRIGHT_INLINE void add(R times, const Sums& other) {
    for (int k = 0; k < 3; ++k) {
      force[k] = force[k] + times * other.force[k];
      moment[k] = moment[k] + times * other.moment[k];
    }
  }
  LINKWRIGHT_INLINE R power(const Station<R>& s) const {
    return s.rate_input * (moment[input_link] + cross(s.input, force[body_link])) + s.rate_coupler * moment[body_link] +
           s.rate_output * moment[output_link];
  }
};

/// A point, and where it is from the pivot about which its moment is told.
template <class R>
struct Carrier {
  Vector<R> arm, at;
};

template <class R>
LINKWRIGHT_INLINE Carrier<R> carrier(const Links<R>& links, const Station<R>& s, const LanePoint& point) {
  const Vector<R> local = vector_of<R>(point.x, point.y);
  const auto about = [](Vector<R> pivot, Vector<R> arm) { return Carrier<R>{arm, pivot + arm}; };
  switch (point.on) {
    case LanePoint::ground:
      return {local, local};
    case LanePoint::input:
      return about(s.input_fixed, product(links.over_input * s.input, local));
    case LanePoint::output:
      return about(s.output_fixed, product(links.over_output * s.output, local));
    case LanePoint::coupler:
      return about(s.pivot, product(s.turned, product(links.coupler_1, local)));
    default:
      return about(s.pivot, product(s.turned, links.body + local));
  }
}

template <class W, class R>
LINKWRIGHT_INLINE void add_at(W& sum, const Station<R>& s, const LanePoint& point, Vector<R> arm, Vector<R> acting) {
  if (point.on == LanePoint::ground) return;
  const LaneLink link = point.on == LanePoint::input    ? input_link
                        : point.on == LanePoint::output ? output_link
                                                        : body_link;
  sum.add(s, link, acting, cross(arm, acting));
}

/// LaneCarried in lanes.
template <class R>
struct Carried {
  Vector<R> force, lever, turning;
  R moment;

  LINKWRIGHT_INLINE void add(Vector<R> arm, Vector<R> acting, bool turns) {
    if (turns) {
      turning = turning + acting;
      moment = moment + cross(arm, acting);
    } else {
      force = force + acting;
      lever = lever + product(conjugate(arm), acting);
    }
  }
  /// Their moment about a point from which the one that they are told about is at `arm`.
  LINKWRIGHT_INLINE void move(Vector<R> arm) {
    lever = lever + product(conjugate(arm), force);
    moment = moment + cross(arm, turning);
  }
  /// To be turned by e · by in place of e.
  LINKWRIGHT_INLINE void turn(Vector<R> by) {
    lever = product(conjugate(by), lever);
    turning = product(by, turning);
  }
};

/// What a body carries in a case as it lies along the x-axis, links from their pivot and of this length.
template <class R>
LINKWRIGHT_INLINE Carried<R> carried_by(const LaneLoads& loads, LanePoint::On on, R length, int c) {
  Carried<R> all{};
  for (int k = 0; k < loads.forces; ++k) {
    const LaneLoads::Force& force = loads.force[k];
    if (force.at.on != on) continue;
    Vector<R> arm = vector_of<R>(force.at.x, force.at.y);
    if (force.at_middle) arm = {0.5 * length, R{}};
    const R times = force.is_rod ? length : of_all<R>(1.0);
    all.add(arm, Vector<R>{times * force.x[c], times * force.y[c]}, force.turns);
  }
  return all;
}

template <class W, class R>
LINKWRIGHT_INLINE void add_carried(W& sum, const Station<R>& s, LaneLink link, const Carried<R>& by, Vector<R> turned,
                                   bool turning) {
  const Vector<R> force = turning ? by.force + product(turned, by.turning) : by.force;
  sum.add(s, link, force, cross(turned, by.lever) + by.moment);
}

/// A linear spring, whatever the case.
template <class W, class R>
struct Stretched {
  R length;
  R over_gas;  ///< 1 / (1 − x per_volume)
  W unit;      ///< what it does as it pushes by 1
  R rate;      ///< of the length
};

/// A line between two points as it pushes them apart by 1.
template <int Width, class W, class R = Real<Width>>
LINKWRIGHT_INLINE Stretched<W, R> stretched(const Links<R>& links, const Station<R>& s, const LanePoint& from,
                                            const LanePoint& to, double extended, double per_volume) {
  const Carrier<R> start = carrier(links, s, from), end = carrier(links, s, to);
  const Vector<R> along = end.at - start.at;
  Stretched<W, R> line;
  line.length = square_root<Width>(square_of(along));
  // Both quotients by one division; a spring without length has no direction, and does nothing.
  const R length = larger(line.length, of_all<R>(1e-150));
  const R gap = 1.0 - (extended - line.length) * per_volume;
  const R over_both = 1.0 / (length * gap);
  line.over_gas = over_both * length;
  const Vector<R> unit = over_both * gap * along;
  line.unit = W{};
  add_at(line.unit, s, to, end.arm, unit);
  add_at(line.unit, s, from, start.arm, negative_of(unit));
  line.rate = line.unit.power(s);
  return line;
}

template <int Width, class W, class R = Real<Width>>
LINKWRIGHT_INLINE Stretched<W, R> stretched(const Links<R>& links, const Station<R>& s,
                                            const LaneLoads::Spring& spring) {
  return stretched<Width, W>(links, s, spring.from, spring.to, spring.extended, spring.per_volume);
}

template <class R>
LINKWRIGHT_INLINE R friction_of(const LaneLoads::Spring& spring, R length) {
  return spring.count * larger(R(spring.friction + spring.friction_slope * (spring.extended - length)), R{});
}

/// A spring's force in a case, pushing > 0. `share`: of the strength of a free one.
template <class W, class R>
LINKWRIGHT_INLINE R push_of(const LaneLoads::Spring& spring, const Stretched<W, R>& line, int c, R share = R{}) {
  if (spring.is_free)
    return spring.count * ((spring.charge[c] + share * spring.charge_rise[c]) * line.over_gas - spring.air[c]);
  if (spring.is_gas) return spring.count * (spring.charge[c] * line.over_gas - spring.air[c]);
  R force = spring.rate[c] * (spring.free_length - line.length);
  if (!spring.pushes) force = smaller(force, R{});
  if (!spring.pulls) force = larger(force, R{});
  return spring.count * force;
}

}  // namespace linkwright::LINKWRIGHT_ISA::load_lanes
