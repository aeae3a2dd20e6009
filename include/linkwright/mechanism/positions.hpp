#pragma once

#include <concepts>
#include <cstddef>
#include <ranges>
#include <string>

namespace linkwright {

/// Something prescribed with derivatives, which counts as several infinitesimally close positions.
template <class Position>
concept HasMultiplicity = requires(const Position& position) {
  { position.multiplicity() } -> std::same_as<int>;
};

template <class Positions>
concept PositionList = std::ranges::input_range<Positions> && HasMultiplicity<std::ranges::range_value_t<Positions>>;

/// The multiplicities in the field's notation: P-P-P-P, PP-P-P, PPPP, …
template <PositionList Positions>
[[nodiscard]] std::string pattern(const Positions& positions) {
  std::string text;
  for (const auto& position : positions) {
    if (!text.empty()) text += '-';
    text.append(static_cast<std::size_t>(position.multiplicity()), 'P');
  }
  return text;
}

/// Number of positions, each with its multiplicity.
template <PositionList Positions>
[[nodiscard]] int position_count(const Positions& positions) {
  int count = 0;
  for (const auto& position : positions) count += position.multiplicity();
  return count;
}

}  // namespace linkwright
