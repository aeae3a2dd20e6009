#pragma once

#include <array>
#include <optional>

#include "linkwright/mechanism/tracing_four_bar.hpp"

namespace linkwright {

/// The two other four-bars whose point traces the same curve (Roberts' theorem, 1875), as they lie when the point is
/// where it is: the first on the input's centre, which turns as the coupler does, the second on the output's. Their
/// outputs share the third centre. Nothing where the coupler has no length or the point is at a moving pivot, to
/// tolerance::vanishing_link of the longest: its path is a circle.
[[nodiscard]] std::optional<std::array<TracingFourBar, 2>> cognates(const TracingFourBar& linkage);

}  // namespace linkwright
