#pragma once

#include "linkwright/planar/pose_conditions.hpp"
#include "linkwright/region/region_map.hpp"

namespace linkwright::testing {

/// N×N region of a task in its working frame, even in τ, lengths in user units.
[[nodiscard]] RegionMap region_of(const std::vector<PrescribedPose>& poses, int samples,
                                  const RegionOptions& options = {});

/// Over given dyads (working frame).
[[nodiscard]] RegionMap region_of(const std::vector<PrescribedPose>& poses, const std::vector<Dyad>& dyads,
                                  const RegionOptions& options = {});

}  // namespace linkwright::testing
