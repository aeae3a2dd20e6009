#pragma once

#include "linkwright/mechanism/four_bar.hpp"

namespace linkwright {

/// The crank that a dyad of crank_poses() is, as a grounded link: from its ground pivot, the dyad's centre, to its
/// moving pivot in position 1 (docs/theory/path.md). Frame with its origin in the first point of the path. Pivots at
/// infinity stay there; the coordinate is the dyad's.
[[nodiscard]] Dyad crank_link(const Dyad& crank);

}  // namespace linkwright
