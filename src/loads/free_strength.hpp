#pragma once

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

/// The loads with a strength of the spring that leaves it free, which is then as any other.
[[nodiscard]] Loads with_f1(Loads loads, double f1);

/// Forces under the weakest spring, and what the strongest adds to them, number by number.
struct StrengthLines {
  std::vector<double> weakest, rise;

  void add(double under_weakest, double under_strongest) {
    weakest.push_back(under_weakest);
    rise.push_back(under_strongest - under_weakest);
  }
  void clear() {
    weakest.clear();
    rise.clear();
  }
};

/// The share of the range at which the largest of the forces of the hand is least, and none of those that open the last
/// position is above −`hold_open`; nothing where there is none. Infinite or undefined forces: nothing.
[[nodiscard]] std::optional<double> best_share(const StrengthLines& hand, const StrengthLines& last,
                                               std::optional<double> hold_open);

}  // namespace linkwright
