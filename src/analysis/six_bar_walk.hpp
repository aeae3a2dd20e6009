#pragma once

#include <array>
#include <optional>

#include "analysis/six_bar_loops.hpp"

namespace linkwright {

/// Angles of bodies 1 … 5, or a difference of two configurations, radians.
using TurnVector = std::array<double, 5>;

/// The shortest way from one configuration to another.
[[nodiscard]] TurnVector shortest_way(const SixBarTurns& from, const SixBarTurns& to);
[[nodiscard]] double dot(const TurnVector& a, const TurnVector& b);
[[nodiscard]] double norm(const TurnVector& a);

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

}  // namespace linkwright
