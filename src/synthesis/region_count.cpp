#include "region_count.hpp"

namespace linkwright {

RequirementFilter count_region(Findings& found, const LinkageFamily& family, const MapExtent& extent,
                               const Progress& progress) {
  const auto samples = [&](Side side) {
    return samples_within(family, side, extent.window, extent.samples, found.options.spacing);
  };
  progress(0.1);
  family.classify(found.region, samples(Side::input), samples(Side::output), found.requirements.respect_direction,
                  found.options.region, progress);
  found.counts = found.region.counts();
  progress(0.6);
  RequirementFilter filter = filter_of(family, found.region, found.requirements);
  const RequirementCensus census = filter.census(progress);
  found.meeting_requirements = census.meeting;
  if (census.meeting == 0) {
    found.relax = filter.relaxations(census, progress);
    if (found.relax.empty()) found.relax_together = census.joint_relaxation();
  }
  progress(0.7);
  return filter;
}

}  // namespace linkwright
