#pragma once

// The verdict over one pair of grounded links of a spherical four-bar, or several at once: type, defects and what ranks
// it, by sign tests alone (docs/theory/spherical.md). One source for find_defects (one pair) and for the region kernels
// (packs), as pair_verdict.hpp is for planar ones.

#include "mechanism/driver_travel.hpp"

namespace linkwright::LINKWRIGHT_ISA {

/// A driving link at each orientation; everything that does not depend on the partner. Unit vectors.
template <int Poses>
struct SphericalDriver {
  double fixed[3];
  double moving[Poses][3];
  double normal[Poses][3];        ///< fixed × moving
  double half_sine, half_cosine;  ///< of half the link angle
  int admissible_directions;      ///< turning that way, the orientations come in order within one turn
  int at_least_half_turn;         ///< turning that way, half a turn or more from first to last
};

/// `Count` other grounded links at each orientation.
template <int Poses, int Count>
struct SphericalDrivenLinks {
  double fixed[3][Count];
  double moving[Poses][3][Count];
  double normal[Poses][3][Count];
  double half_sine[Count], half_cosine[Count];
};

template <int Width>
struct SphericalVerdict {
  using Real = typename Pack<Width>::Real;
  unsigned long long type, defects;  ///< codes of LinkageType and Defects, a byte for each lane
  Mask whole;                        ///< not degenerate
  Mask clean;                        ///< not degenerate and without defects
  Mask turns;                        ///< the input is a crank
  Mask travels_ccw, travels_cw;      ///< senses in which it does the task, where clean
  Mask passes_0, passes_pi;          ///< in the better of them the driver comes to lie along the frame, opposite to it
  /// |cos μ|·s₂s₃ at its largest over the travel (where clean) and over the full turn (where `turns`), and s₂s₃.
  Real worst, worst_turn, scale;
  /// Half sines of the least and the largest of the four link angles, each or its supplement.
  Real least, largest;
};

/// Sine and cosine of half an angle between two unit vectors: both exact however small it or its supplement is.
template <class Real>
struct HalfAngle {
  Real sine, cosine;
};

template <int Width, class Real = typename Pack<Width>::Real>
LINKWRIGHT_INLINE HalfAngle<Real> half_angle(const Real (&a)[3], const Real (&b)[3]) {
  const Real dx = a[0] - b[0], dy = a[1] - b[1], dz = a[2] - b[2];
  const Real sx = a[0] + b[0], sy = a[1] + b[1], sz = a[2] + b[2];
  return {0.5 * square_root<Width>(dx * dx + dy * dy + dz * dz), 0.5 * square_root<Width>(sx * sx + sy * sy + sz * sz)};
}

/// sin and cos of half the sum and half the difference of two angles.
template <class Real>
struct SumAndDifference {
  Real sine_sum, cosine_sum, sine_difference, cosine_difference;
};
template <class Real>
LINKWRIGHT_INLINE SumAndDifference<Real> sum_and_difference(const HalfAngle<Real>& a, const HalfAngle<Real>& b) {
  const Real sc = a.sine * b.cosine, cs = a.cosine * b.sine, ss = a.sine * b.sine, cc = a.cosine * b.cosine;
  return {sc + cs, cc - ss, sc - cs, cc + ss};
}

/// The pairs of a driver and a pack of driven links.
template <int Width, int Poses, int Count>
struct SphericalPairs {
  using Real = typename Pack<Width>::Real;
  const SphericalDriver<Poses>& driver;
  const SphericalDrivenLinks<Poses, Count>& driven;
  int first;

  LINKWRIGHT_INLINE void take(const double (&from)[3][Count], Real (&to)[3]) const {
    for (int i = 0; i < 3; ++i) to[i] = load<Width>(from[i] + first);
  }
  LINKWRIGHT_INLINE static void spread(const double (&from)[3], Real (&to)[3]) {
    for (int i = 0; i < 3; ++i) to[i] = Real{} + from[i];
  }
  LINKWRIGHT_INLINE Real dot(const double (&a)[3], const double (&b)[3][Count]) const {
    return a[0] * load<Width>(b[0] + first) + a[1] * load<Width>(b[1] + first) + a[2] * load<Width>(b[2] + first);
  }
  // Triple products whose signs change at dead points; at the fixed axis −sin θ.
  LINKWRIGHT_INLINE Real at_input_fixed(int j) const { return dot(driver.normal[j], driven.fixed); }
  LINKWRIGHT_INLINE Real at_input_moving(int j) const { return dot(driver.normal[j], driven.moving[j]); }
  LINKWRIGHT_INLINE Real at_output_moving(int j) const { return dot(driver.moving[j], driven.normal[j]); }
  /// 1 − cos δ of the diagonal from the input's moving to the output's fixed axis.
  LINKWRIGHT_INLINE Real diagonal_versine(int j) const {
    Real sum{};
    for (int i = 0; i < 3; ++i) {
      const Real d = driver.moving[j][i] - load<Width>(driven.fixed[i] + first);
      sum = sum + d * d;
    }
    return 0.5 * sum;
  }
};

/// Lanes by the signs of T₁ … T₄, beyond rounding.
struct SphericalSigns {
  Mask n1, n2, n3, n4;
  Mask flat_0, flat_pi;  ///< a change point along the frame, opposite to it
  Mask whole;

  [[nodiscard]] LINKWRIGHT_INLINE Mask change_point() const { return flat_0 | flat_pi; }
  [[nodiscard]] LINKWRIGHT_INLINE Mask can_pass_0() const { return ~(n1 ^ n2) & ~flat_0; }    ///< T₁T₂ > 0
  [[nodiscard]] LINKWRIGHT_INLINE Mask can_pass_pi() const { return ~(n3 ^ n4) & ~flat_pi; }  ///< T₃T₄ > 0
  [[nodiscard]] LINKWRIGHT_INLINE Mask regular() const { return whole & ~change_point(); }
  [[nodiscard]] LINKWRIGHT_INLINE Mask grashof() const { return regular() & ~(n1 ^ n2 ^ n3 ^ n4); }
  [[nodiscard]] LINKWRIGHT_INLINE Mask input_is_crank() const { return grashof() & can_pass_0(); }
  [[nodiscard]] LINKWRIGHT_INLINE Mask output_is_crank() const { return grashof() & (n1 ^ n3); }
  [[nodiscard]] LINKWRIGHT_INLINE Mask rocker_crank() const { return output_is_crank() & ~input_is_crank(); }
  [[nodiscard]] LINKWRIGHT_INLINE Mask double_rocker() const {
    return grashof() & ~input_is_crank() & ~output_is_crank();
  }
};

/// Codes of LinkageType, bit by bit: 0 to 3, 8 change point, 9 degenerate, 10 triple rocker.
template <int Width>
LINKWRIGHT_INLINE unsigned long long spherical_type_codes(const SphericalSigns& s) {
  const Mask grashof = s.grashof(), crank = s.input_is_crank(), triple = s.regular() & ~grashof;
  const Mask bit_0 = (grashof & ~crank) | negated<Width>(s.whole);
  const Mask bit_1 = (grashof & ~(crank ^ s.output_is_crank())) | triple;
  const Mask bit_3 = negated<Width>(s.regular()) | triple;
  return bytes<Width>(bit_0) | bytes<Width>(bit_1) << 1 | bytes<Width>(bit_3) << 3;
}

/// The joint that tells the circuits apart: as in the plane (pair_verdict.hpp).
template <int Width, int Poses, int Count>
LINKWRIGHT_INLINE LostWays lost_ways(const SphericalPairs<Width, Poses, Count>& pairs, const SphericalSigns& s) {
  const Mask output_changes = changes_sign<Width, Poses>([&](int j) { return pairs.at_output_moving(j); });
  Mask circuit = s.input_is_crank() & output_changes;
  if (const Mask lanes = s.rocker_crank())
    circuit |= lanes & changes_sign<Width, Poses>([&](int j) { return pairs.at_input_moving(j); });
  if (const Mask lanes = s.double_rocker())
    circuit |= lanes & changes_sign<Width, Poses>([&](int j) { return pairs.at_input_fixed(j); });
  return {circuit, circuit | output_changes};
}

template <int Width, int Poses, int Count>
LINKWRIGHT_INLINE SphericalVerdict<Width> spherical_verdict(const SphericalDriver<Poses>& driver,
                                                            const SphericalDrivenLinks<Poses, Count>& driven, int first,
                                                            double zero_share) {
  using Real = typename Pack<Width>::Real;
  using Half = HalfAngle<Real>;
  const SphericalPairs<Width, Poses, Count> pairs = {driver, driven, first};
  Real fixed[3], other_fixed[3], moving[3], other_moving[3];
  pairs.spread(driver.fixed, fixed);
  pairs.take(driven.fixed, other_fixed);
  pairs.spread(driver.moving[0], moving);
  pairs.take(driven.moving[0], other_moving);
  const Half ground = half_angle<Width>(fixed, other_fixed), coupler = half_angle<Width>(moving, other_moving);
  const Half input = {Real{} + driver.half_sine, Real{} + driver.half_cosine};
  const Half output = {load<Width>(driven.half_sine + first), load<Width>(driven.half_cosine + first)};

  // sin ½T of the sums and differences of ground and input, of coupler and output.
  const auto frame = sum_and_difference(ground, input), rest = sum_and_difference(coupler, output);
  const Real a = frame.sine_difference * rest.cosine_difference, b = frame.cosine_difference * rest.sine_difference;
  const Real c = rest.sine_sum * frame.cosine_sum, d = rest.cosine_sum * frame.sine_sum;
  const Real t1 = a + b, t2 = a - b, t3 = c - d, t4 = c + d;
  const auto short_side = [](const Half& half) { return smaller(half.sine, half.cosine); };
  const Real sides[] = {short_side(ground), short_side(input), short_side(coupler), short_side(output)};
  const Real least = smaller(smaller(sides[0], sides[1]), smaller(sides[2], sides[3]));
  const Real largest = larger(larger(sides[0], sides[1]), larger(sides[2], sides[3]));
  const Real zero = zero_share * ((sides[0] + sides[1]) + (sides[2] + sides[3]));
  const auto vanishes = [&](Real p, Real q) {
    return negated<Width>(less<Width>(zero, smaller(magnitude<Width>(p), magnitude<Width>(q))));
  };
  const SphericalSigns s = {negative<Width>(t1), negative<Width>(t2), negative<Width>(t3),     negative<Width>(t4),
                            vanishes(t1, t2),    vanishes(t3, t4),    less<Width>(zero, least)};
  LostWays lost = lost_ways(pairs, s);

  // s₂s₃ cos μ = cos δ − c₂c₃, by versines, which keep their digits when the angles are small.
  const Real coupler_versine = 2.0 * coupler.sine * coupler.sine, output_versine = 2.0 * output.sine * output.sine;
  const Real still = coupler_versine + output_versine - coupler_versine * output_versine;
  const auto off_square = [&](Real diagonal_versine) { return magnitude<Width>(still - diagonal_versine); };
  const Real worst_0 = off_square(2.0 * frame.sine_difference * frame.sine_difference);
  const Real worst_pi = off_square(2.0 * frame.sine_sum * frame.sine_sum);
  Drive<Width> way;
  if (driver.admissible_directions && lost.branch != all_lanes<Width>) {
    const Real worst_at_ends =
        larger(off_square(pairs.diagonal_versine(0)), off_square(pairs.diagonal_versine(Poses - 1)));
    way = drive<Width>(driver.admissible_directions, driver.at_least_half_turn, -pairs.at_input_fixed(0),
                       -pairs.at_input_fixed(Poses - 1),
                       {s.can_pass_0(), s.can_pass_pi(), worst_at_ends, worst_0, worst_pi});
  }
  const Mask in_order = way.in_order();
  // A change point between the orientations stops the drive like a dead point.
  if (driver.admissible_directions) lost.branch |= s.change_point() & ~in_order;
  const Mask lost_order = negated<Width>(lost.branch | in_order);

  SphericalVerdict<Width> verdict;
  verdict.type = spherical_type_codes<Width>(s);
  verdict.defects = defect_codes<Width>(s.whole, lost_order, lost);
  verdict.whole = s.whole;
  verdict.clean = s.whole & in_order & ~lost.branch;
  verdict.turns = s.input_is_crank();
  verdict.travels_ccw = way.ccw.possible;
  verdict.travels_cw = way.cw.possible;
  verdict.passes_0 = way.best.passes_0;
  verdict.passes_pi = way.best.passes_pi;
  verdict.worst = way.best.worst;
  verdict.worst_turn = larger(worst_0, worst_pi);
  verdict.scale = 4.0 * (coupler.sine * coupler.cosine) * (output.sine * output.cosine);
  verdict.least = least;
  verdict.largest = largest;
  return verdict;
}

}  // namespace linkwright::LINKWRIGHT_ISA
