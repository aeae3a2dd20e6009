#pragma once

#include <array>
#include <optional>

#include "linkwright/mechanism/six_bar_position.hpp"

namespace linkwright {

/// The two loops of a six-bar, closed by links 4 and 5: Σ cᵢ rᵢ = 0 each, over the bodies' turns rᵢ = e^{iφᵢ}, the
/// ground's being 1. Lengths are divided by the largest coordinate of a coefficient. Nothing here knows of dyads but
/// `dyads`.
struct SixBarLoops {
  explicit SixBarLoops(const SixBar& six_bar);

  std::array<std::array<Point, SixBar::bodies>, 2> coefficient{};
  /// The pairs of bodies that follow one from the other, and the loop that each belongs to: the loops fall apart.
  struct Dyads {
    std::array<std::array<std::size_t, 2>, 2> bodies{};
    std::array<std::size_t, 2> loop{};
  };
  std::optional<Dyads> dyads;
};

/// The loops and what they change by, in one configuration. The derivative by body i's angle is i times `u[i − 1]`,
/// `v[i − 1]`.
struct LoopValues {
  LoopValues(const SixBarLoops& loops, const SixBarTurns& turns);

  std::array<Point, 5> u{}, v{};  ///< terms of bodies 1 … 5 in the first and in the second loop
  Point f, g;                     ///< the loops' errors

  /// The determinant of the Jacobian without the column of body 1: its sign tells whether the driver goes on.
  [[nodiscard]] double driver_minor() const;
};

/// Sines of the transmission of the two dyads, in the order in which they follow; of all four bodies, twice, where
/// there are none (SixBarTransmission::sine).
[[nodiscard]] std::array<double, 2> sines_of(const SixBarLoops& loops, const LoopValues& values);
/// All but the sine.
[[nodiscard]] SixBarTransmission signs_of(const SixBarLoops& loops, const LoopValues& values);

}  // namespace linkwright
