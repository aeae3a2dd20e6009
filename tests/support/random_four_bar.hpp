#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/pose.hpp"
#include "linkwright/mechanism/position.hpp"

namespace linkwright::testing {

/// Four-bars by a fixed seed, the same on every machine (the standard's distributions are not).
class RandomFourBars {
 public:
  explicit RandomFourBars(std::uint64_t seed) : engine_(seed) {}

  /// Even in [from, to).
  double uniform(double from, double to);
  /// Even in {0, …, count − 1}.
  int below(int count);
  Assembly assembly() { return below(2) == 0 ? Assembly::negative : Assembly::positive; }

  /// Links between 0.1 and 2 that can be assembled: all linkage types turn up.
  LinkLengths lengths();
  /// Somewhere the input can be, radians.
  double input_angle(const LinkLengths& lengths);
  /// Lies anywhere near the origin, in any configuration.
  FourBar four_bar(const LinkLengths& lengths);
  FourBar four_bar() { return four_bar(lengths()); }

 private:
  std::mt19937_64 engine_;
};

/// A four-bar with its ground link on the x-axis from the origin; the configuration must exist.
[[nodiscard]] FourBar four_bar_at(const LinkLengths& lengths, double input_angle, Assembly assembly);

/// Pose of a frame that the coupler of a four-bar carries: at the input's moving pivot, along the coupler, moved by
/// `offset` and turned by `turn` in that frame.
[[nodiscard]] Pose coupler_pose(const FourBar& four_bar, Point offset = {0.3, -0.2}, double turn = 0.4);

/// Sine of the transmission angle: near 0 differences along the motion are far off.
[[nodiscard]] double transmission_sine(const FourBar& four_bar);

/// Length, user's unit, by which the loop of a four-bar fails to close.
[[nodiscard]] double loop_gap(const LinkLengths& lengths, const Configuration& configuration);

}  // namespace linkwright::testing
