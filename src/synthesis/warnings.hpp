#pragma once

#include "linkwright/synthesis/solve.hpp"

// What an answer is to be read with.
namespace linkwright {

/// Of the map: dyads that rounding keeps from being any, stretches of the curve between its samples.
void warn_of_map(Solution& solution);

/// Takes out of the lists what rounding decides (is_unconfirmed), counts it and says so.
void leave_out_unconfirmed(Solution& solution);

/// Where the best by another measure stand at a dead point: what keeps them away from it, and what that leaves.
void warn_of_locking(Solution& solution, const Progress& progress);

}  // namespace linkwright
