#include "planar/arm_reach.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/precondition.hpp"
#include "linkwright/mechanism/driver_sequence.hpp"

namespace linkwright {
namespace {

double direction_number(Point v) {
  const double share = v.imag() / (std::abs(v.real()) + std::abs(v.imag()));
  return v.real() < 0 ? 2 - share : share;
}

double turned(double from, double to) { return to < from ? to - from + 4 : to - from; }

std::uint8_t senses_of(bool ccw, bool cw) {
  return static_cast<std::uint8_t>((ccw ? DriverSequence::ccw_bit : 0) | (cw ? DriverSequence::cw_bit : 0));
}

}  // namespace

ArmReach::ArmReach(Point pivot, std::span<const Point> points) {
  require(!points.empty() && points.size() <= ArmElbows::most_points, "one to five points are reached");
  for (const Point point : points) from_pivot_.push_back(point - pivot);
  const auto nearer = [](Point a, Point b) { return std::norm(a) < std::norm(b); };
  const auto [nearest, farthest] = std::minmax_element(from_pivot_.begin(), from_pivot_.end(), nearer);
  least_ = std::abs(*nearest);
  largest_ = std::abs(*farthest);
}

Arm ArmReach::arm(double u, double v) const {
  const double sum = largest_ / u, difference = v * least_;
  return {(sum - difference) / 2, (sum + difference) / 2};
}

// A/D = X ± iY with 2X = 1 − sd/ρ² and 2Y = √((s² − ρ²)(ρ² − d²))/ρ².
ArmElbows ArmReach::elbows(const Arm& arm) const {
  const double sum = arm.reach + arm.link, difference = arm.reach - arm.link;
  ArmElbows found;
  found.points = from_pivot_.size();
  for (std::size_t j = 0; j < found.points; ++j) {
    const double square = std::norm(from_pivot_[j]), distance = std::sqrt(square);
    const double along = 0.5 * (1 - sum * difference / square);
    const double product = (sum - distance) * (sum + distance) * (distance - difference) * (distance + difference);
    const double across = 0.5 * std::sqrt(std::max(product, 0.0)) / square;
    for (std::size_t side = 0; side < 2; ++side) {
      const Point share{along, side == 0 ? across : -across}, d = from_pivot_[j];
      found.at[j][side] = {d.real() * share.real() - d.imag() * share.imag(),
                           d.real() * share.imag() + d.imag() * share.real()};
      found.direction[j][side] = direction_number(found.at[j][side]);
    }
  }
  return found;
}

namespace {

/// The elbows at the first points, and how the link has come to the last of them.
struct BegunPattern {
  std::uint8_t bits = 0;
  bool ccw = true, cw = true;
  double first = 0, sweep = 0;

  [[nodiscard]] BegunPattern with(const ArmElbows& elbows, std::size_t point, std::size_t side) const {
    BegunPattern next = *this;
    next.bits = static_cast<std::uint8_t>(bits | side << point);
    const double direction = elbows.direction[point][side];
    if (point == 0) {
      next.first = direction;
      return next;
    }
    next.sweep = turned(first, direction);
    next.ccw = ccw && next.sweep > sweep;
    next.cw = cw && next.sweep > 0 && (point == 1 || next.sweep < sweep);
    return next;
  }
  [[nodiscard]] ElbowPattern whole() const {
    return {bits, senses_of(ccw, cw), senses_of(sweep >= 2, sweep > 0 && sweep <= 2)};
  }
};

void extend(const BegunPattern& begun, std::size_t point, const ArmElbows& elbows, bool only_in_order,
            const FunctionRef<void(const ElbowPattern&)>& take) {
  if (point == elbows.points) return take(begun.whole());
  for (std::size_t side = 0; side < 2; ++side) {
    const BegunPattern next = begun.with(elbows, point, side);
    if (next.ccw || next.cw || !only_in_order) extend(next, point + 1, elbows, only_in_order, take);
  }
}

}  // namespace

void for_elbow_patterns(const ArmElbows& elbows, bool only_in_order, FunctionRef<void(const ElbowPattern&)> take) {
  extend({}, 0, elbows, only_in_order, take);
}

ElbowPattern elbow_pattern(const ArmElbows& elbows, std::uint8_t bits) {
  BegunPattern pattern;
  for (std::size_t j = 0; j < elbows.points; ++j) pattern = pattern.with(elbows, j, (bits >> j) & 1);
  return pattern.whole();
}

}  // namespace linkwright
