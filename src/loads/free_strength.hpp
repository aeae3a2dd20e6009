#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "linkwright/loads/loads.hpp"

// A gas spring whose strength is left free. The force of the hand is linear in its F1, so that what is known of the
// weakest and the strongest one tells all between them: docs/theory/loads.md, section 6. Newtons.
namespace linkwright {

/// Between which F1 it is looked for.
struct StrengthRange {
  double weakest = 0, strongest = 0;

  [[nodiscard]] double f1(double share) const { return weakest + share * (strongest - weakest); }
};
[[nodiscard]] StrengthRange strengths_of(const FreeStrength& free);

/// By which it is to hold open; a little more than what is asked, which may be required of the linkage, too.
[[nodiscard]] std::optional<double> held_open(const FreeStrength& free);

/// The loads with a strength of the spring that leaves it free, which is then as any other.
[[nodiscard]] Loads with_f1(Loads loads, double f1);

/// A force under the weakest and under the strongest spring, without the friction of pins.
struct SmoothForce {
  double weakest = 0, strongest = 0;
};

/// Forces under the weakest spring, and what the strongest adds to them, number by number.
struct StrengthLines {
  std::vector<double> weakest, rise;

  /// Through the force under a share of the range; friction of pins is taken to be what it is there.
  /// What rises by rounding alone does not: of springs that do nothing the weakest is the best.
  void add(double force, double share, const SmoothForce& smooth) {
    constexpr double rounding = 1e-10;
    const double by = smooth.strongest - smooth.weakest;
    const bool is_level = std::abs(by) <= rounding * (1 + std::abs(smooth.weakest));
    rise.push_back(is_level ? 0 : by);
    weakest.push_back(force - share * rise.back());
  }
};

/// Friction of pins goes by the strength: so often the best one is looked for with that under the one before, until
/// both agree to so much of the range.
inline constexpr int most_strengths = 40;
inline constexpr double agreed_strength = 1e-9;

/// The share of the range at which the largest of the forces of the hand is least, and none of those that open the last
/// position is above −`hold_open`; nothing where there is none. Infinite or undefined forces: nothing.
[[nodiscard]] std::optional<double> best_share(const StrengthLines& hand, const StrengthLines& last,
                                               std::optional<double> hold_open);

}  // namespace linkwright
