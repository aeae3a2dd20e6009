#pragma once

#include "linkwright/synthesis/answer.hpp"

// What an answer is to be read with.
namespace linkwright {

/// Of the map: dyads that rounding keeps from being any, stretches of the curve between its samples.
void warn_of_map(FourBarAnswer& answer);

/// That so many meet the requirements beyond those that `best` lets be listed.
void warn_of_more(Findings& found, std::int64_t count);

/// Takes out of the lists what rounding decides (is_unconfirmed), counts it and says so.
void leave_out_unconfirmed(FourBarAnswer& answer);
void leave_out_unconfirmed(SphericalAnswer& answer);
void leave_out_unconfirmed(SixBarAnswer& answer);

/// Where the best by another measure stand at a dead point: what keeps them away from it, and what that leaves.
void warn_of_locking(FourBarAnswer& answer, const Progress& progress);
void warn_of_locking(SphericalAnswer& answer, const Progress& progress);
inline void warn_of_locking(SixBarAnswer& /*answer*/, const Progress& /*progress*/) {}

}  // namespace linkwright
