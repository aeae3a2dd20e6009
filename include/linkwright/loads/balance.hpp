#pragma once

#include <array>
#include <optional>
#include <vector>

#include "linkwright/core/result.hpp"
#include "linkwright/loads/loads.hpp"
#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/pose.hpp"

// Exact balance of what a four-bar carries: by springs of no free length, or by counterweights, so that it rests
// anywhere. Newtons, kilograms, the user's unit of length. docs/theory/loads.md.
namespace linkwright {

/// What is free to be chosen.
struct BalanceOptions {
  /// Of the springs at the input and at the output, N per unit of length; nothing: so that the stud on the ground is as
  /// far from the fixed pivot as the other stud.
  std::array<std::optional<double>, 2> rate{};
  /// Where they take hold of these links, along and across; nothing: at the moving pivots.
  std::array<std::optional<Point>, 2> stud{};
  /// Of the counterweights from the fixed pivots; nothing: as long as the links.
  std::array<std::optional<double>, 2> lever{};
};

/// Of no free length: pulls by its rate times its length.
struct BalanceSpring {
  double rate = 0;  ///< N per unit of length
  CarriedPoint from, to;

  [[nodiscard]] Spring spring() const;
};

struct CounterWeight {
  LoadedBody on = LoadedBody::input;
  double mass = 0;  ///< kg
  Point at{};       ///< along and across the link, from its fixed pivot
};

/// All energies are ⟨G, e⟩ of the directions e of input and output and a constant.
struct Balance {
  std::array<Point, 2> reduced{};  ///< G of input and output, N times the unit of length

  std::vector<BalanceSpring> two_springs;  ///< at the input and at the output; none where there is nothing to balance
  /// From the ground to the line of the coupler's pivots: there is one at most. Its rate may be negative: then no
  /// spring can be it, and `why_not_one` says so, as where there is none.
  std::optional<BalanceSpring> one_spring;
  double one_share = 0;  ///< of the coupler, from its pivot at the input, at which it takes hold
  std::optional<Notice> why_not_one;
  std::vector<CounterWeight> counterweights;  ///< none without gravity
};

/// Of all weights of `loads`, and forces that keep their direction, in one case. Springs that are there are left out.
/// `bars`, `body`: as they lie in position 1. The caller's mistakes: a stud at a fixed pivot, a rate or a lever that is
/// not above 0, a force that turns with its link (it has no energy).
[[nodiscard]] Result<Balance> exact_balance(const Loads& loads, const LoadCase& of, const FourBar& bars,
                                            const Pose& body, const BalanceOptions& options = {});

}  // namespace linkwright
