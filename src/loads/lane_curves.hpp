#pragma once

// What is read off forces as a travel goes by, one linkage to each lane.

#include "loads/lane_statics.hpp"

namespace linkwright::LINKWRIGHT_ISA::load_lanes {

/// Curves of a case, values of lanes station by station.
enum LaneCurve { open_curve, close_curve, effort_curve, joint_curve };
static_assert(joint_curve + 4 == LoadRow::curves);

/// Of the body from position 1, behind the curves of the cases.
template <int Width>
LINKWRIGHT_INLINE double* turns_of(const LoadRow& row) {
  return row.values + row.tables->loads->cases * LoadRow::curves * row.stations * Width;
}
template <int Width>
LINKWRIGHT_INLINE double* curve_of(const LoadRow& row, int c, int curve) {
  return row.values + (c * LoadRow::curves + curve) * row.stations * Width;
}

/// From one unit vector to another, within half a turn: to 1e-9 where it is a right angle, to 1e-6 at 120°.
template <int Width, class R = Real<Width>>
LINKWRIGHT_INLINE R angle_between(Vector<R> from, Vector<R> to) {
  // Arctangent of a quarter of it by its series.
  constexpr int terms = 10;
  const R half = cross(from, to) / larger(R(1.0 + dot(from, to)), of_all<R>(1e-12));
  const R quarter = half / (1.0 + square_root<Width>(R(1.0 + half * half)));
  const R square = quarter * quarter;
  R series = of_all<R>(1.0 / (2 * terms + 1));
  for (int k = terms - 1; k >= 0; --k) series = 1.0 / (2 * k + 1) - square * series;
  return 4.0 * quarter * series;
}

/// By how much the parabola through an inner station and its neighbours, numbers behind and before it, rises above it;
/// 0 where its vertex is not between them.
template <int Width, class R = Real<Width>>
LINKWRIGHT_INLINE R rise_above(const double* here, int numbers, const LoadSteps& steps) {
  const R value = load<Width>(here);
  const R rise = (value - load<Width>(here - numbers)) * steps.over_before;
  const R fall = (load<Width>(here + numbers) - value) * steps.over_after;
  const R slope = (rise * steps.after + fall * steps.before) * steps.over_both;
  const R curvature = (fall - rise) * steps.over_both;
  const R low = 2.0 * curvature * steps.before, high = -2.0 * curvature * steps.after;
  const Mask is_beyond = less<Width>(slope, low) | less<Width>(high, slope);
  const Mask bends = less<Width>(curvature, R{}) & negated<Width>(is_beyond);
  const R bend = select<Width>(bends, curvature, of_all<R>(1.0));
  return where<Width>(bends, R(slope * slope / (-4.0 * bend)));
}

/// Stations at which a largest value is looked for: each `apart` from the next.
struct LookedAt {
  int count, apart;
  const LoadSteps* steps;

  LINKWRIGHT_INLINE static LookedAt stations(const LoadRow& row) { return {row.stations, 1, row.steps}; }
  LINKWRIGHT_INLINE static LookedAt positions(const LoadRow& row) {
    const int count = row.tables->positions;
    return {count, count > 1 ? (row.stations - 1) / (count - 1) : 1, row.position_steps};
  }
};

/// The largest value of a curve, with the parabola where it is an inner one; of several that are as large that of any.
template <int Width, class R = Real<Width>>
LINKWRIGHT_INLINE R top_of(const LookedAt& at, const double* curve) {
  const int numbers = at.apart * Width;
  R most = load<Width>(curve);
  for (int j = 1; j < at.count; ++j) most = larger(most, load<Width>(curve + j * numbers));
  const R as_much = most - as_large * (1.0 + magnitude<Width>(most));
  R top = most;
  for (int j = 1; j + 1 < at.count; ++j) {
    const R here = load<Width>(curve + j * numbers);
    const Mask is_most = negated<Width>(less<Width>(here, as_much));
    if (is_most == 0) continue;
    top = select<Width>(is_most, larger(top, R(here + rise_above<Width>(curve + j * numbers, numbers, at.steps[j]))),
                        top);
  }
  return top;
}

/// How far the body has turned where it begins to go by itself: to rise, from the last station back as far as opening
/// takes a force below 0; to close, from the first one on.
template <int Width, class R = Real<Width>>
LINKWRIGHT_INLINE R self_going(const LoadRow& row, int c, bool rises) {
  const double* forces = curve_of<Width>(row, c, rises ? open_curve : close_curve);
  const double* turns = turns_of<Width>(row);
  const int last = row.stations - 1;
  R before = load<Width>(forces + (rises ? last : 0) * Width);
  R from = load<Width>(turns + (rises ? last : 0) * Width);
  R found = from;
  Mask goes = less<Width>(before, R{});
  for (int k = 1; k <= last && goes != 0; ++k) {
    const int j = rises ? last - k : k;
    const R here = load<Width>(forces + j * Width), to = load<Width>(turns + j * Width);
    const Mask goes_on = goes & less<Width>(here, R{});
    const R between = from + (to - from) * before / (before - here);
    found = select<Width>(goes, select<Width>(goes_on, to, between), found);
    goes = goes_on;
    before = here;
    from = to;
  }
  return magnitude<Width>(found);
}

/// Which curves are asked for.
struct Asked {
  bool hand, drive, joints, turns;

  LINKWRIGHT_INLINE explicit Asked(const LoadRow& row) {
    const unsigned* counted = row.counted;
    drive = counted[LoadRow::pin] | counted[LoadRow::effort];
    turns = counted[LoadRow::rise] | counted[LoadRow::shut];
    hand = turns ||
           counted[LoadRow::open] | counted[LoadRow::close] | counted[LoadRow::hand] | counted[LoadRow::hold] ||
           (drive && row.drive == LoadRow::by_hand);
    joints = counted[LoadRow::pin];
  }
};

/// Of linkages that are looked at in their positions alone a hand that goes along with its point, and nothing that acts
/// is the pair's.
LINKWRIGHT_INLINE bool asks_hand_in_tables(const LoadRow& row, const Asked& asked) {
  const LaneLoads& loads = *row.tables->loads;
  return row.stations == row.tables->positions && loads.springs == loads.column_springs && !loads.on_coupler &&
         row.hand_way == LoadRow::tangential && !asked.turns && !asked.drive && !row.hand_forces;
}

/// What is read off a case at its last station, whatever the curves.
template <class R>
struct Ends {
  R hold;
  R hand_checked, drive_checked;  ///< no number once an effort was none
};

/// Between which curves the largest value of a read-out is looked for.
struct CurvesOf {
  int first, last;
};
LINKWRIGHT_INLINE CurvesOf curves_of(int what) {
  switch (what) {
    case LoadRow::open:
      return {open_curve, open_curve};
    case LoadRow::close:
      return {close_curve, close_curve};
    case LoadRow::hand:
    case LoadRow::error:
      return {open_curve, close_curve};
    case LoadRow::effort:
      return {effort_curve, effort_curve};
    default:
      return {joint_curve, joint_curve + 3};
  }
}

template <int Width, class R = Real<Width>>
LINKWRIGHT_INLINE R found_in(const LoadRow& row, int c, int what, const Ends<R>& ends) {
  if (what == LoadRow::hold) return ends.hold;
  if (what == LoadRow::rise || what == LoadRow::shut) return self_going<Width>(row, c, what == LoadRow::rise);
  const LookedAt at = what == LoadRow::error ? LookedAt::positions(row) : LookedAt::stations(row);
  const CurvesOf curves = curves_of(what);
  R most = of_all<R>(-__builtin_huge_val());
  for (int curve = curves.first; curve <= curves.last; ++curve)
    most = larger(most, top_of<Width>(at, curve_of<Width>(row, c, curve)));
  return most;
}

}  // namespace linkwright::LINKWRIGHT_ISA::load_lanes
