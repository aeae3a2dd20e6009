#include "region_count.hpp"

#include "linkwright/synthesis/tolerance_measures.hpp"

namespace linkwright {
void measure_added(RegionMap& map, const LinkageFamily& family, const Findings& found, const Progress& progress) {
  const SynthesisOptions& options = found.options;
  const bool ranks =
      options.pareto && ((*options.pareto)[0] == Objective::yield || (*options.pareto)[1] == Objective::yield);
  const bool yields =
      options.measure_yields || found.requirements.min_yield > 0 || options.objective == Objective::yield || ranks;
  found.added.add_to(map, family, found.requirements, yields, progress);
}

RequirementFilter count_region(Findings& found, const Task& task, const LinkageFamily& family, const MapExtent& extent,
                               const Progress& progress) {
  const auto samples = [&](Side side) {
    return samples_within(family, side, extent.window, extent.samples, found.options.spacing);
  };
  progress(0.1);
  family.classify(found.region, samples(Side::input), samples(Side::output), found.requirements.respect_direction,
                  found.options.region, progress);
  found.counts = found.region.counts();
  if (found.options.tolerances) {
    found.added = tolerance_measures(task, family, *found.options.tolerances);
    measure_added(found.region, family, found, progress);
  }
  progress(0.6);
  RequirementFilter filter = filter_of(family, found.region, found.requirements);
  const RequirementCensus census = filter.census(progress);
  found.meeting_requirements = census.meeting;
  if (found.options.pareto) found.pareto = pareto_front(found.region, filter, *found.options.pareto);
  if (census.meeting == 0) {
    found.relax = filter.relaxations(census, progress);
    if (found.relax.empty()) found.relax_together = census.joint_relaxation();
  }
  progress(0.7);
  return filter;
}

}  // namespace linkwright
