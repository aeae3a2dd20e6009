#pragma once

#include <algorithm>
#include <cmath>

#include "linkwright/infinitesimal/line_contact.hpp"

namespace linkwright::testing {

/// Whether a path has fewer points in common with its line than promised, for a linkage of that size. Where the loop is
/// all but dead its series has large terms, which carry rounding into the small ones: the first term counts at a way
/// over which the promised one and the next are alike, at most the size of the linkage.
[[nodiscard]] inline bool falls_short(const LineContact& contact, int promised, double size) {
  if (contact.points >= promised) return false;
  const auto k = static_cast<std::size_t>(promised), first = static_cast<std::size_t>(contact.points);
  const double way = std::min(std::abs(contact.deviation[k] / contact.deviation[k + 1]), size);
  const auto term = [&](std::size_t j) { return std::abs(contact.deviation[j]) * std::pow(way, j); };
  return term(first) > 1e-4 * term(k);
}

}  // namespace linkwright::testing
