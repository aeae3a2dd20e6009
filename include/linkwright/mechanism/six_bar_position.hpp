#pragma once

#include <array>
#include <optional>

#include "linkwright/mechanism/pose.hpp"
#include "linkwright/mechanism/six_bar.hpp"

namespace linkwright {

/// A configuration of a six-bar: by body, the unit complex number by which it has turned from position 1 (e^{iφ}, fixed
/// frame; that of the ground is 1). Position 1 itself is all ones.
using SixBarTurns = std::array<Point, SixBar::bodies>;

/// Where the seven hinges lie in a configuration, fixed frame. Where links 4 and 5 do not close the loops (see
/// closure_error) it is their hinges z4 and z5 as bodies 2 … 4 have them.
[[nodiscard]] std::array<Point, SixBar::joint_count> joints_at(const SixBar& six_bar, const SixBarTurns& turns);

/// Where the frame that lies as `reference` on the guided body in position 1 lies in a configuration.
[[nodiscard]] Pose guided_pose(const SixBar& six_bar, const SixBarTurns& turns, const Pose& reference);

/// By how much the added links miss their hinges: the larger of the two distances, over the longest link.
[[nodiscard]] double closure_error(const SixBar& six_bar, const SixBarTurns& turns);

/// How well the driver moves a six-bar in a configuration. The loops that close over links 4 and 5 are two complex
/// equations in the turns; bodies 2 … 5 are unknown. Where they fall apart into two dyads that follow one after the
/// other (`dyadic`: both of Watt's ways to be driven, and the rows whose second link does not tie body 3 a second
/// time), each has a joint with an angle between its two links. Otherwise the four do not separate.
struct SixBarTransmission {
  bool dyadic = false;
  /// Sign of the determinant of the loops by bodies 2 … 5: constant between dead points of the driver.
  bool positive = false;
  /// Signs of the two dyads' joints, constant between dead points each; the first alone, as `positive`, otherwise.
  std::array<bool, 2> joint_positive{};
  /// Sine of the transmission angle, dyadic: the smaller |sin γ| of the two dyads' joints. Otherwise √(|det| / Π|cⱼ|),
  /// with cⱼ the determinant's columns: in [0, 1], 0 at dead points, and for two dyads that do not act on each
  /// other the geometric mean of their sines.
  double sine = 0;
};
/// `turns`: closed to rounding, as closed() gives them.
[[nodiscard]] SixBarTransmission six_bar_transmission(const SixBar& six_bar, const SixBarTurns& turns);

/// The configuration near `guess` with the driver where it is in `guess`: Newton's method on the loops. Nothing where
/// it does not converge.
[[nodiscard]] std::optional<SixBarTurns> closed(const SixBar& six_bar, const SixBarTurns& guess);

}  // namespace linkwright
