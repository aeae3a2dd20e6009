#pragma once

// What is read off forces as a travel goes by, one linkage to each lane.

#include "loads/lane_statics.hpp"

namespace linkwright::LINKWRIGHT_ISA::load_lanes {

/// Curves of a case, values of lanes station by station.
enum LaneCurve { open_curve, close_curve, effort_curve, joint_curve };
static_assert(joint_curve + 4 == LoadRow::curves);

template <int Width>
LINKWRIGHT_INLINE double* curve_of(const LoadRow& row, int c, int curve) {
  return row.values + (c * LoadRow::curves + curve) * row.stations * Width;
}

/// By how much the parabola through an inner station and its neighbours rises above it.
template <int Width, class R = Real<Width>>
LINKWRIGHT_INLINE R rise_above(const double* here, const LoadSteps& steps) {
  const R value = load<Width>(here);
  const R rise = (value - load<Width>(here - Width)) * steps.over_before;
  const R fall = (load<Width>(here + Width) - value) * steps.over_after;
  const R slope = (rise * steps.after + fall * steps.before) * steps.over_both;
  const R curvature = (fall - rise) * steps.over_both;
  const Mask bends = less<Width>(curvature, R{});
  const R bend = select<Width>(bends, curvature, of_all<R>(1.0));
  return where<Width>(bends, R(slope * slope / (-4.0 * bend)));
}

/// The largest value of a curve, with the parabola where it is an inner one; of several that are as large the first.
template <int Width, class R = Real<Width>>
LINKWRIGHT_INLINE R top_of(const LoadRow& row, const double* curve) {
  R most = load<Width>(curve);
  for (int j = 1; j < row.stations; ++j) most = larger(most, load<Width>(curve + j * Width));
  R top = most;
  for (int j = row.stations - 2; j >= 0; --j) {
    const Mask is_most = negated<Width>(less<Width>(load<Width>(curve + j * Width), most));
    if (is_most == 0) continue;
    const R here = j == 0 ? most : R(most + rise_above<Width>(curve + j * Width, row.steps[j]));
    top = select<Width>(is_most, here, top);
  }
  return top;
}

/// Which curves are asked for.
struct Asked {
  bool hand, drive, joints;

  LINKWRIGHT_INLINE explicit Asked(const LoadRow& row) {
    const unsigned* counted = row.counted;
    drive = counted[LoadRow::pin] | counted[LoadRow::effort];
    hand = counted[LoadRow::open] | counted[LoadRow::close] | counted[LoadRow::hand] | counted[LoadRow::hold] ||
           (drive && row.drive == LoadRow::by_hand);
    joints = counted[LoadRow::pin];
  }
};

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
  const CurvesOf curves = curves_of(what);
  R most = of_all<R>(-__builtin_huge_val());
  for (int curve = curves.first; curve <= curves.last; ++curve)
    most = larger(most, top_of<Width>(row, curve_of<Width>(row, c, curve)));
  return most;
}

}  // namespace linkwright::LINKWRIGHT_ISA::load_lanes
