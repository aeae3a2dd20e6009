#pragma once

// The verdict over one pair of grounded links, or several at once: type, defects and what ranks it, by sign tests
// alone. docs/theory/planar.md derives them. One source for find_defects (one pair) and for the region kernels (packs).
//
// Neighbours on a map mostly share their fate, so what no lane of a pack asks for is left out; what is left out never
// shows in the verdict.

#include "mechanism/driver_travel.hpp"

namespace linkwright::LINKWRIGHT_ISA {

/// A driving link at each pose; everything that does not depend on the partner.
template <int Poses>
struct Driver {
  double center_x, center_y, length;
  double circle_x, circle_y;          ///< circle point at the first pose
  double arm_x[Poses], arm_y[Poses];  ///< from the centre to the circle point
  int admissible_directions;          ///< turning that way, the poses come in order within one turn
  int at_least_half_turn;             ///< turning that way, half a turn or more from first to last pose
};

/// The same of a pack of them, to each lane its own.
template <int Width, int Poses>
struct DriverLanes {
  using Real = typename Pack<Width>::Real;
  Real center_x, center_y, length, circle_x, circle_y;
  Real arm_x[Poses], arm_y[Poses];
  LaneSenses admissible_directions, at_least_half_turn;
};

/// `Count` other grounded links at each pose.
template <int Poses, int Count>
struct DrivenLinks {
  double center_x[Count], center_y[Count], length[Count];
  double circle_x[Count], circle_y[Count];
  double arm_x[Poses][Count], arm_y[Poses][Count];
};

template <int Width>
struct PairVerdict {
  using Real = typename Pack<Width>::Real;
  unsigned long long type, defects;  ///< codes of LinkageType and Defects, a byte for each lane
  Mask whole;                        ///< not degenerate
  Mask clean;                        ///< not degenerate and without defects
  Mask turns;                        ///< the input is a crank
  Mask travels_ccw, travels_cw;      ///< senses in which it does the task, where clean
  Mask passes_0, passes_pi;          ///< in the better of them the driver comes to lie along the frame, opposite to it
  /// |cos μ|·hb at its largest over the travel (where clean) and over the full turn (where `turns`), and hb.
  Real worst, worst_turn, hb;
  Real longest, shortest;
};

/// What the lengths of ground and coupler are made of. Apart from the rest because a square root takes long: a kernel
/// takes those of the next pack while it judges this one.
template <int Width>
struct Distances {
  using Real = typename Pack<Width>::Real;
  Real frame_x, frame_y;  ///< from the input's centre to the output's
  Real gg, hh, g, h;      ///< lengths of ground and coupler, and their squares
};

template <int Width, class AnyDriver, int Poses, int Count>
LINKWRIGHT_INLINE Distances<Width> distances(const AnyDriver& driver, const DrivenLinks<Poses, Count>& driven,
                                             int first) {
  using Real = typename Pack<Width>::Real;
  Distances<Width> d;
  d.frame_x = load<Width>(driven.center_x + first) - driver.center_x;
  d.frame_y = load<Width>(driven.center_y + first) - driver.center_y;
  const Real link_x = driver.circle_x - load<Width>(driven.circle_x + first);
  const Real link_y = driver.circle_y - load<Width>(driven.circle_y + first);
  d.gg = d.frame_x * d.frame_x + d.frame_y * d.frame_y;
  d.hh = link_x * link_x + link_y * link_y;
  d.g = square_root<Width>(d.gg);
  d.h = square_root<Width>(d.hh);
  return d;
}

/// The pairs of a driver and a pack of driven links, and the joint signs: at each pose, the vector products of the
/// frame and the driver, of driver and coupler, of coupler and driven link.
template <int Width, class AnyDriver, int Poses, int Count>
struct Pairs {
  using Real = typename Pack<Width>::Real;
  const AnyDriver& driver;
  const DrivenLinks<Poses, Count>& driven;
  int first;
  Distances<Width> d;

  LINKWRIGHT_INLINE Real arm_x(int j) const { return load<Width>(driven.arm_x[j] + first); }
  LINKWRIGHT_INLINE Real arm_y(int j) const { return load<Width>(driven.arm_y[j] + first); }
  LINKWRIGHT_INLINE Real at_input_fixed(int j) const {
    return d.frame_x * driver.arm_y[j] - d.frame_y * driver.arm_x[j];
  }
  LINKWRIGHT_INLINE Real at_input_moving(int j) const {
    return (arm_x(j) + d.frame_x) * driver.arm_y[j] - (arm_y(j) + d.frame_y) * driver.arm_x[j];
  }
  LINKWRIGHT_INLINE Real at_output_moving(int j) const {
    return arm_x(j) * (driver.arm_y[j] - d.frame_y) - arm_y(j) * (driver.arm_x[j] - d.frame_x);
  }
};

/// Lanes by the signs of Grashof's excesses: positive and negative beyond rounding.
struct ExcessSigns {
  Mask p1, p2, p3, n1, n2, n3;
  Mask change_point, whole;

  [[nodiscard]] LINKWRIGHT_INLINE Mask input_meets_frame() const { return (p1 & p2) | (n1 & n2); }
  [[nodiscard]] LINKWRIGHT_INLINE Mask input_is_crank() const { return p3 & input_meets_frame(); }
  [[nodiscard]] LINKWRIGHT_INLINE Mask rocker_crank() const { return p1 & n2 & n3; }
  [[nodiscard]] LINKWRIGHT_INLINE Mask double_rocker() const { return n1 & p2 & n3; }
};

template <int Width, class Real = typename Pack<Width>::Real>
LINKWRIGHT_INLINE ExcessSigns excess_signs(Real g, Real a, Real h, Real b, Real shortest, double zero_share) {
  const Real gh = g + h, ab = a + b, zero = zero_share * (gh + ab);
  const Real t1 = gh - ab, t2 = (g + b) - (a + h), t3 = (h + b) - (g + a);
  const Real m1 = magnitude<Width>(t1), m2 = magnitude<Width>(t2), m3 = magnitude<Width>(t3);
  const Mask n1 = negative<Width>(t1), n2 = negative<Width>(t2), n3 = negative<Width>(t3);
  ExcessSigns s = {negated<Width>(n1), negated<Width>(n2), negated<Width>(n3), n1, n2, n3, 0, all_lanes<Width>};
  const Mask beyond_rounding = less<Width>(zero, smaller(smaller(m1, m2), smaller(m3, shortest)));
  if (beyond_rounding != all_lanes<Width>) [[unlikely]] {
    const Mask not_1 = negated<Width>(less<Width>(zero, m1)), not_2 = negated<Width>(less<Width>(zero, m2)),
               not_3 = negated<Width>(less<Width>(zero, m3));
    s.p1 &= ~not_1, s.p2 &= ~not_2, s.p3 &= ~not_3;
    s.n1 &= ~not_1, s.n2 &= ~not_2, s.n3 &= ~not_3;
    s.change_point = not_1 | not_2 | not_3;
    s.whole = less<Width>(zero, shortest);
  }
  return s;
}

/// Codes of LinkageType, bit by bit.
template <int Width>
LINKWRIGHT_INLINE unsigned long long type_codes(const ExcessSigns& s) {
  const Mask regular = s.whole & ~s.change_point;
  const Mask bit_0 = (regular & ((s.p2 & s.n1) | (s.n2 & s.n3))) | negated<Width>(s.whole);
  const Mask bit_1 = regular & ((s.p2 & s.n1) | (s.n2 & s.p3));
  const Mask bit_2 = regular & ~(s.p1 ^ s.p2 ^ s.p3);
  const Mask bit_3 = negated<Width>(regular);
  return bytes<Width>(bit_0) | bytes<Width>(bit_1) << 1 | bytes<Width>(bit_2) << 2 | bytes<Width>(bit_3) << 3;
}

/// The joint that tells the circuits apart is the one that is not at the shortest link: of a crank-rocker and a double
/// crank the output's, of a rocker-crank the input's moving joint, of a double rocker its fixed one.
template <int Width, class AnyDriver, int Poses, int Count>
LINKWRIGHT_INLINE LostWays lost_ways(const Pairs<Width, AnyDriver, Poses, Count>& pairs, const ExcessSigns& s) {
  const Mask output_changes = changes_sign<Width, Poses>([&](int j) { return pairs.at_output_moving(j); });
  Mask circuit = s.input_is_crank() & output_changes;
  if (const Mask lanes = s.rocker_crank())
    circuit |= lanes & changes_sign<Width, Poses>([&](int j) { return pairs.at_input_moving(j); });
  if (const Mask lanes = s.double_rocker())
    circuit |= lanes & changes_sign<Width, Poses>([&](int j) { return pairs.at_input_fixed(j); });
  return {circuit, circuit | output_changes};
}

/// `driver`: a Driver, or a pack of them as DriverLanes.
template <int Width, class AnyDriver, int Poses, int Count>
LINKWRIGHT_INLINE PairVerdict<Width> pair_verdict(const AnyDriver& driver, const DrivenLinks<Poses, Count>& driven,
                                                  int first, const Distances<Width>& d, double zero_share) {
  using Real = typename Pack<Width>::Real;
  const Pairs<Width, AnyDriver, Poses, Count> pairs = {driver, driven, first, d};
  const Real a = Real{} + driver.length, b = load<Width>(driven.length + first);
  const Real shortest = smaller(smaller(a, b), smaller(d.g, d.h)), longest = larger(larger(a, b), larger(d.g, d.h));
  const ExcessSigns s = excess_signs<Width>(d.g, a, d.h, b, shortest, zero_share);
  LostWays lost = lost_ways(pairs, s);

  // hb cos μ = (h² + b² − a² − g²)/2 + ga cos φ, φ from the frame to the driver.
  const Real still = 0.5 * ((d.hh - d.gg) + (b * b - a * a)), swing = d.g * a;
  const auto at_pose = [&](int j) {
    return magnitude<Width>(still + (d.frame_x * driver.arm_x[j] + d.frame_y * driver.arm_y[j]));
  };
  const Real worst_0 = magnitude<Width>(still + swing), worst_pi = magnitude<Width>(still - swing);
  const LaneSenses open = lane_senses<Width>(driver.admissible_directions);
  Drive<Width> way;
  if ((open.ccw | open.cw) && lost.branch != all_lanes<Width>) {
    const Real first_turn = pairs.at_input_fixed(0), last_turn = pairs.at_input_fixed(Poses - 1);
    way = drive<Width>(driver.admissible_directions, driver.at_least_half_turn, first_turn, last_turn,
                       {s.input_meets_frame(), s.p3, larger(at_pose(0), at_pose(Poses - 1)), worst_0, worst_pi});
  }
  const Mask in_order = way.in_order();
  // A change point between the poses stops the drive like a dead point.
  lost.branch |= s.change_point & ~in_order & (open.ccw | open.cw);
  const Mask lost_order = negated<Width>(lost.branch | in_order);

  PairVerdict<Width> verdict;
  verdict.type = type_codes<Width>(s);
  verdict.defects = defect_codes<Width>(s.whole, lost_order, lost);
  verdict.whole = s.whole;
  verdict.clean = s.whole & in_order & ~lost.branch;
  verdict.turns = s.whole & s.input_is_crank();
  verdict.travels_ccw = way.ccw.possible;
  verdict.travels_cw = way.cw.possible;
  verdict.passes_0 = way.best.passes_0;
  verdict.passes_pi = way.best.passes_pi;
  verdict.worst = way.best.worst;
  verdict.worst_turn = larger(worst_0, worst_pi);
  verdict.hb = d.h * b;
  verdict.longest = longest;
  verdict.shortest = shortest;
  return verdict;
}

}  // namespace linkwright::LINKWRIGHT_ISA
