#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "six_bar_loops.hpp"

namespace linkwright {

/// Angles of bodies 1 … 5, or a difference of two configurations, radians.
using TurnVector = std::array<double, 5>;

/// The shortest way from one configuration to another.
[[nodiscard]] TurnVector shortest_way(const SixBarTurns& from, const SixBarTurns& to);
[[nodiscard]] double dot(const TurnVector& a, const TurnVector& b);
[[nodiscard]] double norm(const TurnVector& a);
[[nodiscard]] TurnVector times(double s, TurnVector v);
[[nodiscard]] TurnVector plus(TurnVector a, const TurnVector& b);
/// Of the driver, −π … π.
[[nodiscard]] double turn_between(const SixBarTurns& from, const SixBarTurns& to);

/// The curve of configurations near one of its points: a ball in which it is one strand that crosses each plane normal
/// to `tangent` at most once and turns by less than 20°.
struct SixBarStrand {
  SixBarTurns turns{};
  TurnVector tangent{};     ///< unit vector whose first component has the sign of the determinant; continuous
  TurnVector correction{};  ///< Newton's step of least length onto the curve
  double reach = 0;         ///< radius of the ball, radians; 0 where the Jacobian is singular
  LoopValues values;

  [[nodiscard]] bool positive() const { return tangent[0] > 0; }
};

/// `turns` on the curve or so near that `correction` is small beside the reach.
[[nodiscard]] SixBarStrand strand_at(const SixBarLoops& loops, const SixBarTurns& turns);

/// The configuration after a step of `way`; each angle x turns by 2 atan(x/2), which needs no trigonometry.
[[nodiscard]] SixBarTurns stepped(const SixBarTurns& turns, const TurnVector& way);

/// The strand at a point near the curve after Newton's method down to `accuracy` radians or rounding; nothing where it
/// does not converge.
[[nodiscard]] std::optional<SixBarStrand> corrected(const SixBarLoops& loops, const SixBarTurns& turns,
                                                    double accuracy);

/// Length of a step of a walk, as a share of the reach.
inline constexpr double step_in_reach = 0.75;

/// How far along a step of `length` from `here` a point on the strand, or a little off it, lies; nothing where the step
/// does not pass it. Points off the strand can fall into the wedge between the planes that end one step and begin the
/// next: they count for both.
[[nodiscard]] std::optional<double> distance_to(const SixBarTurns& point, const SixBarStrand& here,
                                                const TurnVector& ahead, double length);

/// A configuration met: how far the walk had come, and how far the driver had turned.
struct PositionMet {
  double arc = 0, turn = 0;
};

/// What a walk from position 1 in one sense of the driver met.
struct SixBarProgress {
  std::vector<std::optional<PositionMet>> meetings;
  double length = 0, turn = 0;

  SixBarProgress() = default;
  explicit SixBarProgress(std::size_t wanted) : meetings(wanted) { meetings.front() = PositionMet{}; }
  [[nodiscard]] bool met_all() const;
  [[nodiscard]] bool met_all_in_order() const;
  /// Within its reach a strand crosses each plane once: the point where it crosses the plane of a wanted configuration
  /// is that configuration, or the linkage misses it. For a step from `here` that is `step` long.
  void meet(const SixBarLoops& loops, std::span<const SixBarTurns> wanted, const SixBarStrand& here,
            const TurnVector& ahead, double step, double pose_tolerance);
};

/// Configurations that one of two walks met.
[[nodiscard]] bool met_all_between_them(const SixBarProgress& one, const SixBarProgress& other);

/// The sense in which the driver's angles come in order, or nearest to it.
[[nodiscard]] int likelier_sense(std::span<const SixBarTurns> wanted);

}  // namespace linkwright
