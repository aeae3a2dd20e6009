// Elbows of random arms against what they are: as long as link and arm, on the side that is told, and in the order that
// the angles of the link tell.

#include <cmath>
#include <cstdio>
#include <random>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/driver_sequence.hpp"
#include "planar/arm_reach.hpp"

using namespace linkwright;

namespace {

int differences_of(const Arm& arm, const std::vector<Point>& points, Point pivot, const ArmElbows& elbows,
                   const ElbowPattern& pattern) {
  DriverSequenceBuilder order;
  int different = 0;
  for (std::size_t j = 0; j < points.size(); ++j) {
    const Point link = elbow(elbows, pattern, j), first = elbow(elbows, pattern, 0), way = points[j] - pivot;
    order.meet(j == 0 ? 0 : wrap_positive(std::arg(link * std::conj(first))));
    const double size = arm.link + arm.reach;
    different += std::abs(std::abs(link) - arm.link) > 1e-9 * size;
    different += std::abs(std::abs(way - link) - arm.reach) > 1e-9 * size;
    different += (cross(way, link) > 0) != ((pattern.bits >> j & 1) == 0);
  }
  const DriverSequence& known = order.sequence();
  different += pattern.senses != known.senses();
  different += pattern.senses != 0 && pattern.half_turn_senses != known.half_turn_senses();
  return different;
}

}  // namespace

int main() {
  std::mt19937_64 random(34);
  const auto in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  int different = 0, patterns = 0, listed = 0, in_order = 0;
  for (int task = 0; task < 400; ++task) {
    const Point pivot{in(-3, 3), in(-3, 3)};
    std::vector<Point> points;
    for (int j = 0; j < 5; ++j) points.emplace_back(in(-5, 5), in(-5, 5));
    const ArmReach reach(pivot, points);
    const double u = in(0.02, 0.98), v = in(-0.98, 0.98);
    const Arm arm = reach.arm(u, v);
    different += std::abs(arm.reach - arm.link - v * reach.least()) > 1e-9 * reach.largest() / u;
    different += std::abs((arm.reach + arm.link) * u - reach.largest()) > 1e-9 * reach.largest();
    const ArmElbows elbows = reach.elbows(arm);
    for (std::size_t bits = 0; bits < pattern_count(points.size()); ++bits, ++patterns) {
      const ElbowPattern pattern = elbow_pattern(elbows, static_cast<std::uint8_t>(bits));
      different += differences_of(arm, points, pivot, elbows, pattern);
      in_order += pattern.senses != 0;
    }
    for_elbow_patterns(elbows, true, [&](const ElbowPattern& pattern) {
      ++listed;
      different += differences_of(arm, points, pivot, elbows, pattern);
    });
  }
  std::printf("%d of %d patterns differ, %d of %d in order are listed\n", different, patterns, listed, in_order);
  return different == 0 && listed == in_order && in_order > patterns / 20 ? 0 : 1;
}
