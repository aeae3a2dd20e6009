#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "linkwright/core/result.hpp"
#include "linkwright/loads/loads.hpp"
#include "linkwright/loads/spring_charge.hpp"
#include "linkwright/loads/spring_place.hpp"
#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/pose.hpp"

// Balance as good as coil springs with a free length can give it: what is left to the hand is least in squares over
// the travel. Newtons, the user's unit of length. docs/theory/loads.md.
namespace linkwright {

/// What is free to be chosen.
struct RealBalanceOptions {
  double free_share = 0.75;           ///< free length by the shortest that the spring gets over the travel, in [0, 1]
  std::optional<double> free_length;  ///< of each, ≥ 0, in place of that; a spring that is shorter is slack
  /// Where springs take hold of the ground; nothing: the box of the pivots over the travel. Without bounds the best
  /// spring would be a soft one from far away.
  std::optional<StudBox> ground;
  /// Where a single one takes hold of the body, moving frame; nothing: the box of its pivots, its centre and its
  /// handle.
  std::optional<StudBox> body;
  /// Where two take hold of input and output, along and across; nothing: at the moving pivots.
  std::array<std::optional<Point>, 2> stud{};
  int between = 12;  ///< ≥ 1 steps from position to position: the stations whose squares are summed
};

/// Springs that pull, and what they leave.
struct RealBalance {
  std::vector<Spring> springs;     ///< from the ground; fewer where one of them would only disturb
  double residual_hand_force = 0;  ///< largest over the continuous travel, absolute, without friction, N
};

struct RealBalances {
  double free_share = 0;                ///< 0 where a free length was given
  double hand_force_without = 0;        ///< largest without any spring, absolute, N
  std::optional<RealBalance> two, one;  ///< to input and output, to the body; nothing where no spring helps
};

/// Of all weights of `loads` and forces that are steady, in one case; springs, friction and inertia that are there are
/// left out. `bars`, `body`: as they lie in position 1. The best of a grid of studs and of descents from its best
/// places: no proof that none is better. Reasons where there is nothing: no_travel, no_handle, hand_rests,
/// hand_against.
[[nodiscard]] FoundOrNot<RealBalances> real_balance(const Loads& loads, const LoadCase& of, const FourBar& bars,
                                                    std::span<const PrescribedPose> poses,
                                                    const RealBalanceOptions& options = {});

/// The caller's mistakes; places begin with `balance.`.
[[nodiscard]] std::vector<Error> mistakes_in(const RealBalanceOptions& options);

}  // namespace linkwright
