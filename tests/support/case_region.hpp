#pragma once

#include "linkwright/planar/four_bar_map.hpp"
#include "linkwright/planar/pose_conditions.hpp"
#include "linkwright/region/linkage_family.hpp"

namespace linkwright::testing {

/// An axis of a task's region in its working frame: over given coordinates, over given dyads, or `samples` even in τ.
[[nodiscard]] DyadAxis axis_at(const std::vector<PrescribedPose>& poses, const std::vector<double>& coordinates);
[[nodiscard]] DyadAxis axis_of(const std::vector<PrescribedPose>& poses, const std::vector<Dyad>& dyads);
[[nodiscard]] DyadAxis axis_of(const std::vector<PrescribedPose>& poses, int samples);

/// The map of all pairs of grounded links.
[[nodiscard]] RegionMap map_of(const DyadAxis& input, const DyadAxis& output, double unit,
                               const RegionOptions& options = {}, const Progress& progress = {});

/// Where the pivots of such a map lie.
[[nodiscard]] MapPivots pivots_of(const DyadAxis& input, const DyadAxis& output, const WorkingFrame& frame);

/// The square region over such an axis, lengths in user units.
[[nodiscard]] RegionMap region_of(const std::vector<PrescribedPose>& poses, const DyadAxis& axis,
                                  const RegionOptions& options = {});
[[nodiscard]] RegionMap region_of(const std::vector<PrescribedPose>& poses, int samples,
                                  const RegionOptions& options = {});

}  // namespace linkwright::testing
