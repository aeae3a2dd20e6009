#pragma once

#include "linkwright/planar/pose_conditions.hpp"
#include "linkwright/region/region_map.hpp"

namespace linkwright::testing {

/// An axis of a task's region in its working frame: over given coordinates, over given dyads, or `samples` even in τ.
[[nodiscard]] RegionAxis axis_at(const std::vector<PrescribedPose>& poses, const std::vector<double>& coordinates);
[[nodiscard]] RegionAxis axis_of(const std::vector<PrescribedPose>& poses, const std::vector<Dyad>& dyads);
[[nodiscard]] RegionAxis axis_of(const std::vector<PrescribedPose>& poses, int samples);

/// The square region over such an axis, lengths in user units.
[[nodiscard]] RegionMap region_of(const std::vector<PrescribedPose>& poses, const RegionAxis& axis,
                                  const RegionOptions& options = {});
[[nodiscard]] RegionMap region_of(const std::vector<PrescribedPose>& poses, int samples,
                                  const RegionOptions& options = {});

}  // namespace linkwright::testing
