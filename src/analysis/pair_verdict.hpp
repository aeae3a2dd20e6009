#pragma once

// The verdict over one pair of side links, or several at once: type, defects and what ranks it, by sign tests alone.
// docs/theory/planar.md derives them. One source for find_defects (one pair) and for the region kernels (packs).

#include "core/pack.hpp"

namespace linkwright::LINKWRIGHT_ISA {

/// Senses of rotation, as bits.
inline constexpr int ccw_bit = 1, cw_bit = 2;

/// A driving side link at each pose; everything that does not depend on the partner.
template <int Poses>
struct Driver {
  double center_x, center_y, length;
  double circle_x, circle_y;          ///< circle point at the first pose
  double arm_x[Poses], arm_y[Poses];  ///< from the centre to the circle point
  int senses;                         ///< turning that way, the poses come in order within one turn
  int wide;                           ///< turning that way, half a turn or more from first to last pose
};

/// The other side link(s) at each pose.
template <int Width, int Poses>
struct Driven {
  using Real = typename Pack<Width>::Real;
  Real center_x, center_y, length;
  Real circle_x, circle_y;
  Real arm_x[Poses], arm_y[Poses];
};

template <int Width>
struct PairVerdict {
  using Real = typename Pack<Width>::Real;
  typename Pack<Width>::Integer type, defects;         ///< codes of LinkageType and Defects
  typename Pack<Width>::Mask whole;                    ///< not degenerate
  typename Pack<Width>::Mask clean;                    ///< not degenerate and without defects
  typename Pack<Width>::Mask turns;                    ///< the input is a crank
  typename Pack<Width>::Mask travels_ccw, travels_cw;  ///< senses in which it does the task, where clean
  /// |cos μ|·hb at its largest over the travel (where clean) and over the full turn (where `turns`), and hb.
  Real worst, worst_turn, hb;
  Real longest, shortest;
};

/// Whether values keep their sign from pose to pose.
template <int Width>
struct SignWatch {
  using Integer = typename Pack<Width>::Integer;
  Integer first{}, changed{};

  LINKWRIGHT_INLINE void see(typename Pack<Width>::Real value, bool is_first) {
    const Integer bits = __builtin_bit_cast(Integer, value);
    if (is_first)
      first = bits;
    else
      changed = changed | (bits ^ first);
  }
  LINKWRIGHT_INLINE typename Pack<Width>::Mask changes() const { return changed < Integer{}; }
};

/// What the driver can do (can_pass: along the frame, opposite to it) and |cos μ|·hb there.
template <int Width>
struct DriverLimits {
  typename Pack<Width>::Mask can_pass_0, can_pass_pi;
  typename Pack<Width>::Real worst_at_ends, worst_0, worst_pi;
};

template <int Width>
struct Travel {
  typename Pack<Width>::Mask possible;
  typename Pack<Width>::Real worst;
};

/// The turn from one arm to another in one sense. `turn_in`, `turn_out`: vector products of the frame's direction with
/// the arm that comes first and last when turning counter-clockwise.
template <int Width, class Real = typename Pack<Width>::Real, class Mask = typename Pack<Width>::Mask>
LINKWRIGHT_INLINE Travel<Width> travel(Real turn_in, Real turn_out, bool wide, const DriverLimits<Width>& limits) {
  const Mask in_negative = turn_in < 0.0, in_positive = turn_in > 0.0;
  const Mask out_negative = turn_out < 0.0, out_positive = turn_out > 0.0;
  const Mask passes_0 = wide ? Mask(in_negative | out_positive) : Mask(in_negative & out_positive);
  const Mask passes_pi = wide ? Mask(in_positive | out_negative) : Mask(in_positive & out_negative);
  const Mask blocked = (passes_0 & negated(limits.can_pass_0)) | (passes_pi & negated(limits.can_pass_pi));
  Real worst = limits.worst_at_ends;
  worst = select(passes_0, larger(worst, limits.worst_0), worst);
  worst = select(passes_pi, larger(worst, limits.worst_pi), worst);
  return {negated(blocked), worst};
}

template <int Width, int Poses>
LINKWRIGHT_INLINE PairVerdict<Width> pair_verdict(const Driver<Poses>& driver, const Driven<Width, Poses>& driven,
                                                  double zero_share) {
  using Real = typename Pack<Width>::Real;
  using Mask = typename Pack<Width>::Mask;
  using Integer = typename Pack<Width>::Integer;
  const auto code = [](int value) { return Integer{} + value; };

  const Real frame_x = driven.center_x - driver.center_x, frame_y = driven.center_y - driver.center_y;
  const Real link_x = driver.circle_x - driven.circle_x, link_y = driver.circle_y - driven.circle_y;
  const Real a = Real{} + driver.length, b = driven.length;
  const Real gg = frame_x * frame_x + frame_y * frame_y, hh = link_x * link_x + link_y * link_y;
  const Real g = square_root<Width>(gg), h = square_root<Width>(hh);

  // Joint signs at each pose: of the frame and the driver, of driver and coupler, of coupler and driven link.
  SignWatch<Width> at_input_center, at_input_circle, at_output_circle;
  Real turn_first{}, turn_last{};
  for (int j = 0; j < Poses; ++j) {
    const Real turn = frame_x * driver.arm_y[j] - frame_y * driver.arm_x[j];
    const Real driven_turn = frame_x * driven.arm_y[j] - frame_y * driven.arm_x[j];
    const Real between = driven.arm_x[j] * driver.arm_y[j] - driven.arm_y[j] * driver.arm_x[j];
    at_input_center.see(turn, j == 0);
    at_input_circle.see(between + turn, j == 0);
    at_output_circle.see(between + driven_turn, j == 0);
    if (j == 0) turn_first = turn;
    if (j == Poses - 1) turn_last = turn;
  }

  // Grashof's excesses, positive and negative beyond rounding.
  const Real gh = g + h, ab = a + b, gb = g + b, ah = a + h, hb = h + b, ga = g + a;
  const Real t1 = gh - ab, t2 = gb - ah, t3 = hb - ga, zero = zero_share * (gh + ab);
  const Mask p1 = t1 > zero, p2 = t2 > zero, p3 = t3 > zero, n1 = t1 < -zero, n2 = t2 < -zero, n3 = t3 < -zero;
  const Mask change_point = negated(Mask((p1 | n1) & (p2 | n2) & (p3 | n3)));
  const Real shortest = smaller(smaller(a, b), smaller(g, h)), longest = larger(larger(a, b), larger(g, h));
  const Mask whole = shortest > zero;
  const Integer t1_positive = select(p2, select(p3, code(0), code(4)), select(p3, code(6), code(1)));
  const Integer t1_negative = select(p2, select(p3, code(7), code(3)), select(p3, code(2), code(5)));
  Integer type = select(p1, t1_positive, t1_negative);
  type = select(whole, select(change_point, code(8), type), code(9));

  // The joint that tells the circuits apart is the one that is not at the shortest link: of a crank-rocker (+++) and a
  // double crank (−−+) the output's, of a rocker-crank (+−−) the input's moving joint, of a double rocker (−+−) its fixed one.
  const Mask output_changes = at_output_circle.changes();
  const Mask input_cranks = p3 & ((p1 & p2) | (n1 & n2));
  const Mask lost_circuit = (input_cranks & output_changes) | (n3 & p1 & n2 & at_input_circle.changes()) |
                            (n3 & n1 & p2 & at_input_center.changes());

  // hb cos μ = (h² + b² − a² − g²)/2 + ga cos φ, φ from the frame to the driver.
  const Real still = 0.5 * ((hh - gg) + (b * b - a * a)), swing = g * a;
  const auto at_pose = [&](int j) {
    return magnitude<Width>(still + (frame_x * driver.arm_x[j] + frame_y * driver.arm_y[j]));
  };
  const DriverLimits<Width> limits = {Mask((p1 & p2) | (n1 & n2)), p3, larger(at_pose(0), at_pose(Poses - 1)),
                                      magnitude<Width>(still + swing), magnitude<Width>(still - swing)};
  const Mask none = Mask{} != Mask{};
  Travel<Width> ccw = {none, Real{}}, cw = {none, Real{}};
  if (driver.senses & ccw_bit) ccw = travel<Width>(turn_first, turn_last, driver.wide & ccw_bit, limits);
  if (driver.senses & cw_bit) cw = travel<Width>(turn_last, turn_first, driver.wide & cw_bit, limits);
  const Mask in_order = ccw.possible | cw.possible;
  // A change point between the poses stops the drive like a dead point.
  const Mask stopped = driver.senses ? Mask(change_point & negated(in_order)) : none;
  const Mask lost_branch = output_changes | lost_circuit | stopped;
  const Integer defects = select(lost_circuit, code(6), select(lost_branch, code(2), select(in_order, code(0), code(1))));

  PairVerdict<Width> verdict;
  verdict.type = type;
  verdict.defects = select(whole, defects, code(0));
  verdict.whole = whole;
  verdict.clean = whole & in_order & negated(lost_branch);
  verdict.turns = whole & input_cranks;
  verdict.travels_ccw = ccw.possible;
  verdict.travels_cw = cw.possible;
  verdict.worst = ccw.worst;
  if (driver.senses == cw_bit) verdict.worst = cw.worst;
  if (driver.senses == (ccw_bit | cw_bit)) {
    const Real of_either = select(cw.possible, smaller(ccw.worst, cw.worst), ccw.worst);
    verdict.worst = select(ccw.possible, of_either, cw.worst);
  }
  verdict.worst_turn = larger(limits.worst_0, limits.worst_pi);
  verdict.hb = h * b;
  verdict.longest = longest;
  verdict.shortest = shortest;
  return verdict;
}

}  // namespace linkwright::LINKWRIGHT_ISA
