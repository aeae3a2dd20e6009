#pragma once

// Arms, their further dyads and the pairs of both, an arm to each lane. Included by the arm_kernel_*.cpp files, one for
// each instruction set.

#include "mechanism/pair_verdict.hpp"
#include "planar/further_dyad_lanes.hpp"

namespace linkwright::LINKWRIGHT_ISA {

/// Of five places without derivatives: of the last four, seen from the first (arm_motion.hpp, condition_rows).
template <int Width>
LINKWRIGHT_INLINE void row_of_place(const ArmBlock& block, int place, int at, Row<Width>& row) {
  using R = Real<Width>;
  const double x = block.place[place][0], y = block.place[place][1];
  const R c = load<Width>(block.turn[place][0] + at), s = load<Width>(block.turn[place][1] + at);
  const R values[7] = {root_two * (1.0 - c),       root_two * s, c * x + s * y, c * y - s * x, R{} - x, R{} - y,
                       R{} + 0.5 * (x * x + y * y)};
  for (int i = 0; i < 7; ++i) row[i] = values[i];
}

template <int Width>
LINKWRIGHT_INLINE void fetch_rows(const ArmBlock& block, int at, Row<Width> (&rows)[4]) {
  for (int j = 0; j < 4; ++j) {
    if (block.has_rows) {
      for (int i = 0; i < 7; ++i) rows[j][i] = load<Width>(block.row[j][i] + at);
    } else {
      row_of_place<Width>(block, j + 1, at, rows[j]);
    }
  }
}

/// Bits of senses of a pack, a mask to each.
template <int Width>
LINKWRIGHT_INLINE LaneSenses fetch_senses(const std::uint8_t* from) {
  LaneSenses senses;
  for (int lane = 0; lane < Width; ++lane) {
    senses.ccw |= static_cast<Mask>((from[lane] & ccw_bit) != 0) << lane;
    senses.cw |= static_cast<Mask>((from[lane] & cw_bit) != 0) << lane;
  }
  return senses;
}

template <int Width, int Places>
LINKWRIGHT_INLINE DriverLanes<Width, Places> driving_arms(const ArmBlock& block, int at) {
  DriverLanes<Width, Places> driver;
  driver.center_x = load<Width>(block.pivot[0] + at);
  driver.center_y = load<Width>(block.pivot[1] + at);
  for (int j = 0; j < Places; ++j) {
    driver.arm_x[j] = load<Width>(block.link[j][0] + at);
    driver.arm_y[j] = load<Width>(block.link[j][1] + at);
  }
  driver.circle_x = driver.center_x + driver.arm_x[0];
  driver.circle_y = driver.center_y + driver.arm_y[0];
  driver.length = square_root<Width>(driver.arm_x[0] * driver.arm_x[0] + driver.arm_y[0] * driver.arm_y[0]);
  driver.admissible_directions = fetch_senses<Width>(block.senses + at);
  driver.at_least_half_turn = fetch_senses<Width>(block.half_turn_senses + at);
  return driver;
}

/// A further dyad where it is finite; elsewhere any.
template <int Width>
struct FiniteDyad {
  Mask finite;
  Real<Width> center_x, center_y, circle_x, circle_y;

  LINKWRIGHT_INLINE FiniteDyad(const ArmBlock& block, int dyad, int at) {
    using R = Real<Width>;
    const R center = load<Width>(block.center[dyad][0] + at), circle = load<Width>(block.circle[dyad][0] + at);
    const R least = R{} + block.infinity, one = R{} + 1.0;
    finite = less<Width>(least, center) & less<Width>(least, circle);
    const R of_center = one / select<Width>(finite, center, one), of_circle = one / select<Width>(finite, circle, one);
    center_x = load<Width>(block.center[dyad][1] + at) * of_center;
    center_y = load<Width>(block.center[dyad][2] + at) * of_center;
    circle_x = load<Width>(block.circle[dyad][1] + at) * of_circle;
    circle_y = load<Width>(block.circle[dyad][2] + at) * of_circle;
  }
};

template <int Width, int Places>
LINKWRIGHT_INLINE DrivenLinks<Places, Width> driven_dyads(const ArmBlock& block, const FiniteDyad<Width>& dyad,
                                                          int at) {
  using R = Real<Width>;
  DrivenLinks<Places, Width> driven;
  store<Width>(dyad.center_x, driven.center_x);
  store<Width>(dyad.center_y, driven.center_y);
  store<Width>(dyad.circle_x, driven.circle_x);
  store<Width>(dyad.circle_y, driven.circle_y);
  for (int j = 0; j < Places; ++j) {
    const R c = load<Width>(block.turn[j][0] + at), s = load<Width>(block.turn[j][1] + at);
    const R x = (c * dyad.circle_x - s * dyad.circle_y) + (block.place[j][0] - dyad.center_x);
    const R y = (c * dyad.circle_y + s * dyad.circle_x) + (block.place[j][1] - dyad.center_y);
    if (j == 0) store<Width>(square_root<Width>(x * x + y * y), driven.length);
    store<Width>(x, driven.arm_x[j]);
    store<Width>(y, driven.arm_y[j]);
  }
  return driven;
}

/// Code of LinkageType::degenerate.
inline constexpr unsigned long long degenerate_code = 9;

template <int Width, int Places>
LINKWRIGHT_INLINE void judge(ArmBlock& block, const DriverLanes<Width, Places>& driver, int dyad, int at) {
  using R = Real<Width>;
  const FiniteDyad<Width> found(block, dyad, at);
  const auto driven = driven_dyads<Width, Places>(block, found, at);
  const auto v = pair_verdict<Width>(driver, driven, 0, distances<Width>(driver, driven, 0), block.zero_share);
  const Mask whole = v.whole & found.finite;
  const R hb = select<Width>(whole, v.hb, R{} + 1.0);
  const auto versine = [&](Mask mask, R worst) { return where<Width>(mask & whole, larger(hb - worst, R{}) / hb); };
  const unsigned long long at_infinity = bytes<Width>(negated<Width>(found.finite));
  store<Width>((v.type & ~(at_infinity * 0xff)) | at_infinity * degenerate_code, block.type[dyad] + at);
  store<Width>(v.defects, block.defects[dyad] + at);
  store<Width>(versine(v.clean, v.worst), block.versine[dyad] + at);
  store<Width>(versine(v.turns, v.worst_turn), block.full_versine[dyad] + at);
  store<Width>(v.longest, block.longest[dyad] + at);
  store<Width>(v.shortest, block.shortest[dyad] + at);
}

template <int Width, int Places>
LINKWRIGHT_INLINE void judge_all(ArmBlock& block, int at) {
  const auto driver = driving_arms<Width, Places>(block, at);
  for (int dyad = 0; dyad < ArmBlock::most_dyads; ++dyad) {
    unsigned long long some = 0;
    __builtin_memcpy(&some, block.real[dyad] + at, Width);
    if (some) judge<Width, Places>(block, driver, dyad, at);
  }
}

template <int Width>
void arm_kernel(ArmBlock& block) {
  for (int at = 0; at < block.count; at += Width) {
    Row<Width> rows[4];
    fetch_rows<Width>(block, at, rows);
    further_dyads<Width>(block, rows, at);
    if (block.arm_drives)
      with_position_count(block.places, [&](auto count) { judge_all<Width, decltype(count)::value>(block, at); });
  }
}

}  // namespace linkwright::LINKWRIGHT_ISA
