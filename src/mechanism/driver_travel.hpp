#pragma once

// How a driving link gets through the positions, for one pair of grounded links or several at once: shared by the
// verdicts over planar and spherical linkages, whose drivers both turn about one axis.

#include "core/pack.hpp"

namespace linkwright::LINKWRIGHT_ISA {

/// Senses of rotation, as bits.
inline constexpr int ccw_bit = 1, cw_bit = 2;

/// Senses that each lane has for itself.
struct LaneSenses {
  Mask ccw = 0, cw = 0;
};

/// The lanes that are open to a sense: all or none by the bits that they share.
template <int Width>
LINKWRIGHT_INLINE LaneSenses lane_senses(int shared) {
  return {shared & ccw_bit ? all_lanes<Width> : 0, shared & cw_bit ? all_lanes<Width> : 0};
}
template <int Width>
LINKWRIGHT_INLINE LaneSenses lane_senses(LaneSenses of_lanes) {
  return of_lanes;
}

/// A number of positions that the compiler knows.
template <int Count>
struct PositionCount {
  static constexpr int value = Count;
};

/// What `judge` says with the PositionCount of `count`, which is one to five.
template <class Judge>
LINKWRIGHT_INLINE auto with_position_count(int count, Judge judge) {
  switch (count) {
    case 1:
      return judge(PositionCount<1>{});
    case 2:
      return judge(PositionCount<2>{});
    case 3:
      return judge(PositionCount<3>{});
    case 4:
      return judge(PositionCount<4>{});
    case 5:
      return judge(PositionCount<5>{});
    default:
      __builtin_unreachable();
  }
}

/// Lanes in which a value changes its sign from pose to pose. An exact zero has the sign that its arithmetic gave it,
/// the same on every machine: + where the two products of a vector product are equal.
template <int Width, int Poses, class ValueAt>
LINKWRIGHT_INLINE Mask changes_sign(ValueAt value_at) {
  using Integer = typename Pack<Width>::Integer;
  const Integer first = __builtin_bit_cast(Integer, value_at(0));
  Integer changed{};
  for (int j = 1; j < Poses; ++j) changed = changed | (first ^ __builtin_bit_cast(Integer, value_at(j)));
  return sign_bits<Width>(changed);
}

struct LostWays {
  Mask circuit, branch;
};

/// What the driver can do (can_pass: along the frame, opposite to it) and |cos μ|·hb there.
template <int Width>
struct DriverLimits {
  Mask can_pass_0, can_pass_pi;
  typename Pack<Width>::Real worst_at_ends, worst_0, worst_pi;
};

template <int Width>
struct Travel {
  Mask possible{}, passes_0{}, passes_pi{};
  typename Pack<Width>::Real worst{};
};

/// Lanes in which a turn that comes in on one side and goes out on the other passes between.
LINKWRIGHT_INLINE Mask passed(Mask in, Mask out, bool at_least_half_turn) {
  return at_least_half_turn ? in | out : in & out;
}
LINKWRIGHT_INLINE Mask passed(Mask in, Mask out, Mask at_least_half_turn) {
  return (in & out) | (at_least_half_turn & (in | out));
}

/// The turn from one arm to another in one sense. `turn_in`, `turn_out`: vector products of the frame's direction with
/// the arm that comes first and last when turning counter-clockwise. An arm exactly along the frame is on neither side.
/// `at_least_half_turn`: of all lanes, or a mask of those of which it is one.
template <int Width, class Half, class Real = typename Pack<Width>::Real>
LINKWRIGHT_INLINE Travel<Width> travel(Real turn_in, Real turn_out, Half at_least_half_turn,
                                       const DriverLimits<Width>& limits) {
  const Mask in_negative = less<Width>(turn_in, Real{}), in_positive = less<Width>(Real{}, turn_in);
  const Mask out_negative = less<Width>(turn_out, Real{}), out_positive = less<Width>(Real{}, turn_out);
  const Mask passes_0 = passed(in_negative, out_positive, at_least_half_turn);
  const Mask passes_pi = passed(in_positive, out_negative, at_least_half_turn);
  const Mask blocked = (passes_0 & ~limits.can_pass_0) | (passes_pi & ~limits.can_pass_pi);
  const Real worst_0 = where<Width>(passes_0, limits.worst_0), worst_pi = where<Width>(passes_pi, limits.worst_pi);
  return {negated<Width>(blocked), passes_0, passes_pi, larger(limits.worst_at_ends, larger(worst_0, worst_pi))};
}

/// The better of two senses.
template <int Width>
LINKWRIGHT_INLINE Travel<Width> better(const Travel<Width>& ccw, const Travel<Width>& cw) {
  const auto of_either = select<Width>(cw.possible, smaller(ccw.worst, cw.worst), ccw.worst);
  const Mask is_cw = cw.possible & (negated<Width>(ccw.possible) | less<Width>(cw.worst, ccw.worst));
  const auto of_sense = [&](Mask in_ccw, Mask in_cw) { return (in_ccw & ~is_cw) | (in_cw & is_cw); };
  return {ccw.possible | cw.possible, of_sense(ccw.passes_0, cw.passes_0), of_sense(ccw.passes_pi, cw.passes_pi),
          select<Width>(ccw.possible, of_either, cw.worst)};
}

/// The turns that the driver is open to, and the better of them.
template <int Width>
struct Drive {
  Travel<Width> ccw, cw, best;

  [[nodiscard]] LINKWRIGHT_INLINE Mask in_order() const { return ccw.possible | cw.possible; }
};

/// `admissible_directions`, `at_least_half_turn`: bits of senses, the driver's own, which all lanes share; the turns as
/// in travel(), of first and last position.
template <int Width, class Real = typename Pack<Width>::Real>
LINKWRIGHT_INLINE Drive<Width> drive(int admissible_directions, int at_least_half_turn, Real first_turn, Real last_turn,
                                     const DriverLimits<Width>& limits) {
  Drive<Width> d;
  const auto is_half = [&](int sense) { return (at_least_half_turn & sense) != 0; };
  if (admissible_directions & ccw_bit) d.ccw = travel<Width>(first_turn, last_turn, is_half(ccw_bit), limits);
  if (admissible_directions & cw_bit) d.cw = travel<Width>(last_turn, first_turn, is_half(cw_bit), limits);
  d.best = admissible_directions == ccw_bit ? d.ccw : admissible_directions == cw_bit ? d.cw : better(d.ccw, d.cw);
  return d;
}

/// The same where each lane has its own driver.
template <int Width, class Real = typename Pack<Width>::Real>
LINKWRIGHT_INLINE Drive<Width> drive(LaneSenses admissible_directions, LaneSenses at_least_half_turn, Real first_turn,
                                     Real last_turn, const DriverLimits<Width>& limits) {
  Drive<Width> d;
  d.ccw = travel<Width>(first_turn, last_turn, at_least_half_turn.ccw, limits);
  d.cw = travel<Width>(last_turn, first_turn, at_least_half_turn.cw, limits);
  d.ccw.possible &= admissible_directions.ccw;
  d.cw.possible &= admissible_directions.cw;
  d.best = better(d.ccw, d.cw);
  return d;
}

/// Codes of Defects.
template <int Width>
LINKWRIGHT_INLINE unsigned long long defect_codes(Mask whole, Mask lost_order, const LostWays& lost) {
  return bytes<Width>(whole & lost_order) | bytes<Width>(whole & lost.branch) << 1 |
         bytes<Width>(whole & lost.circuit) << 2;
}

}  // namespace linkwright::LINKWRIGHT_ISA
