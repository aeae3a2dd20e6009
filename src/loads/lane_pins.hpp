#pragma once

// Forces on the joints, one linkage to each lane.

#include "loads/lane_stations.hpp"

namespace linkwright::LINKWRIGHT_ISA::load_lanes {

/// Of the equations x × R = p, y × R = q of a joint's force those two whose vectors stand best to each other, of the
/// output link, the coupler and the input link.
template <class R>
struct JointRows {
  Vector<R> x, y;
  R over_area;
  Mask without_output, without_input;
};

template <int Width, class R>
LINKWRIGHT_INLINE JointRows<R> joint_rows(const LoadRow& row, const Linkages<R>& of, const Station<R>& s) {
  // By the square of the sine, times those of all lengths.
  const auto standing = [](Vector<R> x, Vector<R> y, R other_square) {
    const R area = cross(x, y);
    return R(area * area * other_square);
  };
  const R without_input = standing(s.output, s.coupler, of_all<R>(row.length * row.length));
  const R without_coupler = standing(s.output, s.input, of.coupler_square);
  const R without_output = standing(s.coupler, s.input, of.output_square);
  JointRows<R> rows;
  rows.without_output = less<Width>(larger(without_input, without_coupler), without_output);
  rows.without_input = negated<Width>(less<Width>(without_input, without_coupler) | rows.without_output);
  const auto chosen = [](Mask mask, Vector<R> yes, Vector<R> no) {
    return Vector<R>{select<Width>(mask, yes.x, no.x), select<Width>(mask, yes.y, no.y)};
  };
  rows.x = chosen(rows.without_output, s.coupler, s.output);
  rows.y = chosen(rows.without_input, s.coupler, s.input);
  rows.over_area = 1.0 / cross(rows.x, rows.y);
  return rows;
}

/// Sizes of the forces on the joints, in the order of FourBarJoint, without the friction of their pins.
template <class R>
struct Joints {
  R size[4];
};

template <int Width, class R = Real<Width>>
LINKWRIGHT_INLINE Joints<R> joints_of(const Station<R>& s, const JointRows<R>& rows, const Sums<R>& all) {
  const R by_output = all.moment[output_link], by_coupler = -all.moment[body_link],
          by_input = -cross(s.input, all.force[body_link]) - all.moment[input_link];
  const R p = select<Width>(rows.without_output, by_coupler, by_output);
  const R q = select<Width>(rows.without_input, by_coupler, by_input);
  const Vector<R> at_output = rows.over_area * (p * rows.y - q * rows.x);
  const Vector<R> at_input = negative_of(all.force[body_link] + at_output);
  const auto size_of = [](Vector<R> force) { return square_root<Width>(square_of(force)); };
  return {{size_of(at_input - all.force[input_link]), size_of(at_input), size_of(at_output),
           size_of(at_output - all.force[output_link])}};
}

template <int Width, class R = Real<Width>>
LINKWRIGHT_INLINE R pin_loss(const Station<R>& s, const Joints<R>& joints) {
  const auto loss = [&](int joint, R rate) { return joints.size[joint] * magnitude<Width>(rate); };
  return loss(0, s.rate_input) + loss(1, s.rate_coupler - s.rate_input) + loss(2, s.rate_coupler - s.rate_output) +
         loss(3, s.rate_output);
}

}  // namespace linkwright::LINKWRIGHT_ISA::load_lanes
