#pragma once

#include <optional>

#include "linkwright/planar/four_bar_family.hpp"

namespace linkwright {

// Cranks of a timed path, and the linkages that they make (docs/theory/path.md). Frame with its origin in the first
// point of the path. A crank is a dyad of the body that turns with it: its centre is the ground pivot of the crank,
// which reaches from there as far as from the dyad's circle point to the origin.

/// The four-bar that `crank` drives and whose cognate is driven by `cognate`: input and output link with the dyads'
/// coordinates. The output is a slider where the cognate's centre lies at infinity. Nothing where the crank has no
/// length or a point at infinity, where the cognate's circle point lies at infinity, and where both are one.
[[nodiscard]] std::optional<DyadPair> linkage_of_cranks(const Dyad& crank, const Dyad& cognate);

}  // namespace linkwright
