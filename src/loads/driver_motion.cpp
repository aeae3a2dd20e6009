#include "linkwright/loads/driver_motion.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "linkwright/core/angle.hpp"

namespace linkwright {
namespace {

using Law = DriverMotion::Law;
using TimedShare = DriverMotion::TimedShare;

/// By the share of the duration: the share of the turn, and its first two derivatives.
struct UnitState {
  double share = 0, speed = 0, acceleration = 0;
};

/// 0 ≤ τ ≤ 1/2; the other half is its mirror image.
UnitState trapezoid(double tau, double ramp) {
  const double top = 1 / (1 - ramp);
  if (tau < ramp) return {top * tau * tau / (2 * ramp), top * tau / ramp, top / ramp};
  return {top * (tau - ramp / 2), top, 0};
}

UnitState cycloid(double tau) {
  const double angle = two_pi * tau, half = std::sin(angle / 2);
  return {tau - std::sin(angle) / two_pi, 2 * half * half, two_pi * std::sin(angle)};
}

UnitState polynomial_345(double tau) {
  const double rest = 1 - tau, both = tau * rest;
  return {tau * tau * tau * (10 + tau * (6 * tau - 15)), 30 * both * both, 60 * both * (1 - 2 * tau)};
}

UnitState unit_state(Law law, double tau, double ramp) {
  if (law == Law::uniform) return {tau, 1, 0};
  const bool is_second = tau > 0.5;
  const double first = is_second ? 1 - tau : tau;
  const UnitState is = law == Law::trapezoid ? trapezoid(first, ramp)
                       : law == Law::cycloid ? cycloid(first)
                                             : polynomial_345(first);
  return is_second ? UnitState{1 - is.share, is.speed, -is.acceleration} : is;
}

/// A piece of a cubic spline by Hermite's form, `u` in [0, 1] of its time.
struct SplinePiece {
  TimedShare from, to;
  double speed_from, speed_to;

  [[nodiscard]] double time() const { return to.time - from.time; }
  [[nodiscard]] UnitState at(double u) const {
    const double h = time(), rise = to.share - from.share, a = h * speed_from, b = h * speed_to;
    const double square = 3 * rise - 2 * a - b, cube = a + b - 2 * rise;
    return {from.share + u * (a + u * (square + u * cube)), (a + u * (2 * square + 3 * u * cube)) / h,
            (2 * square + 6 * u * cube) / (h * h)};
  }
  /// Its speed, a parabola of the time, is nowhere below 0 but by rounding.
  [[nodiscard]] bool never_turns_back() const {
    constexpr double rounding = 1e-12;
    const double h = time(), rise = to.share - from.share, a = h * speed_from, b = h * speed_to;
    const double slope = 2 * (3 * rise - 2 * a - b), bend = 6 * (a + b - 2 * rise);
    double least = std::min(a, b);
    if (bend > 0 && -slope > 0 && -slope < bend) least = std::min(least, a - slope * slope / (2 * bend));
    return least >= -rounding;
  }
};

/// Speeds at the points of the cubic spline with continuous acceleration that starts and ends at rest: a system of
/// three diagonals, which dominate.
std::vector<double> spline_speeds(const std::vector<TimedShare>& table) {
  const std::size_t n = table.size();
  std::vector<double> speeds(n), over(n);
  for (std::size_t k = 1; k + 1 < n; ++k) {
    const double before = table[k].time - table[k - 1].time, after = table[k + 1].time - table[k].time;
    const double right = 3 * ((table[k].share - table[k - 1].share) / before * after +
                              (table[k + 1].share - table[k].share) / after * before);
    const double pivot = 2 * (before + after) - after * over[k - 1];
    over[k] = before / pivot;
    speeds[k] = (right - after * speeds[k - 1]) / pivot;
  }
  for (std::size_t k = n - 1; k-- > 1;) speeds[k] -= over[k] * speeds[k + 1];
  return speeds;
}

SplinePiece piece_of(const std::vector<TimedShare>& table, const std::vector<double>& speeds, std::size_t k) {
  return {table[k], table[k + 1], speeds[k], speeds[k + 1]};
}

/// Where a rising function of [0, 1] has a value that its ends enclose: Newton's steps, halving where they leave what
/// encloses it.
template <class Of>
double where_it_is(double value, const Of& of) {
  constexpr int most_steps = 200;
  double low = 0, high = 1, at = 0.5;
  for (int step = 0; step < most_steps && low < high; ++step) {
    const UnitState is = of(at);
    const double over = is.share - value;
    if (over == 0) break;
    (over > 0 ? high : low) = at;
    const double next = is.speed > 0 ? at - over / is.speed : low;
    const double before = at;
    at = next > low && next < high ? next : low + (high - low) / 2;
    if (at == before || at == low || at == high) break;
  }
  return at;
}

std::vector<Error> mistakes_in_table(const std::vector<TimedShare>& table) {
  const std::string place = "loads.motion.table";
  if (table.size() < 2 || table.size() > most_timed_shares)
    return {{"motion_table",
             place,
             fmt::format("a motion has 2 to {} points [seconds, share of the turn]", most_timed_shares),
             {{"most", most_timed_shares}}}};
  if (table.front() != TimedShare{0, 0} || table.back().share != 1)
    return {{"motion_ends", place, "a motion goes from [0, 0] to share 1 at its end"}};
  for (std::size_t k = 1; k < table.size(); ++k)
    if (!(table[k].time > table[k - 1].time && table[k].share > table[k - 1].share))
      return {{"motion_order", fmt::format("{}[{}]", place, k), "times and shares ascend from point to point"}};
  return {};
}

/// Between points of a table that is in order.
std::vector<Error> turns_back(const std::vector<TimedShare>& table) {
  const std::vector<double> speeds = spline_speeds(table);
  for (std::size_t k = 0; k + 1 < table.size(); ++k)
    if (!piece_of(table, speeds, k).never_turns_back())
      return {{"motion_turns_back",
               fmt::format("loads.motion.table[{}]", k),
               "a smooth motion through these points would turn back after this one; give more points, or such that "
               "speed changes less between them",
               {}}};
  return {};
}

}  // namespace

std::vector<Error> mistakes_in(const DriverMotion& motion) {
  const bool has_table = motion.law == Law::table;
  if (has_table)
    if (auto mistakes = mistakes_in_table(motion.table); !mistakes.empty()) return mistakes;
  std::vector<Error> found;
  const double duration = has_table ? motion.table.back().time : motion.duration;
  const auto outside = [&](const char* member, double value, double least, double most) {
    found.push_back({"load_range",
                     fmt::format("loads.motion.{}", member),
                     fmt::format("{} is not within {} to {}", value, least, most),
                     {{"value", value}, {"least", least}, {"most", most}}});
  };
  if (!(duration >= shortest_motion && duration <= longest_motion))
    outside(has_table ? "table" : "duration_s", duration, shortest_motion, longest_motion);
  constexpr double least_ramp = 1e-3, most_ramp = 0.5;
  if (motion.law == Law::trapezoid && !(motion.ramp >= least_ramp && motion.ramp <= most_ramp))
    outside("ramp", motion.ramp, least_ramp, most_ramp);
  if (has_table && found.empty()) return turns_back(motion.table);
  return found;
}

TimeLaw::TimeLaw(const DriverMotion& motion)
    : law_(motion.law),
      duration_(motion.law == Law::table ? motion.table.back().time : motion.duration),
      ramp_(motion.ramp) {
  if (law_ != Law::table) return;
  table_ = motion.table;
  speeds_ = spline_speeds(table_);
}

DriverState TimeLaw::at_time(double time) const {
  const double within = std::clamp(time, 0.0, duration_);
  if (law_ != Law::table) {
    const UnitState is = unit_state(law_, within / duration_, ramp_);
    return {within, is.share, is.speed / duration_, is.acceleration / (duration_ * duration_)};
  }
  const auto after = std::upper_bound(table_.begin() + 1, table_.end() - 1, within,
                                      [](double wanted, const TimedShare& point) { return wanted < point.time; });
  const SplinePiece piece = piece_of(table_, speeds_, static_cast<std::size_t>(after - table_.begin()) - 1);
  const UnitState is = piece.at((within - piece.from.time) / piece.time());
  return {within, is.share, is.speed, is.acceleration};
}

DriverState TimeLaw::at_share(double share) const {
  if (!(share > 0)) return at_time(0);
  if (share >= 1) return at_time(duration_);
  if (law_ != Law::table) {
    // Of the second half by its mirror image, which keeps the digits of what is left to go.
    const bool is_second = share > 0.5;
    const double tau =
        where_it_is(is_second ? 1 - share : share, [&](double at) { return unit_state(law_, at, ramp_); });
    DriverState state = at_time(duration_ * (is_second ? 1 - tau : tau));
    state.share = share;
    return state;
  }
  const auto after = std::upper_bound(table_.begin() + 1, table_.end() - 1, share,
                                      [](double wanted, const TimedShare& point) { return wanted < point.share; });
  const SplinePiece piece = piece_of(table_, speeds_, static_cast<std::size_t>(after - table_.begin()) - 1);
  const double u = where_it_is(share, [&](double at) {
    UnitState is = piece.at(at);
    is.speed *= piece.time();
    return is;
  });
  const UnitState is = piece.at(u);
  return {piece.from.time + u * piece.time(), share, is.speed, is.acceleration};
}

}  // namespace linkwright
