#include "region_count.hpp"

#include <algorithm>

#include "linkwright/planar/chain_family.hpp"
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

namespace {

/// A search keeps to yields that more samples will not take back, where the map has such.
void set_yield_margin(Findings& found, const LinkageFamily& family) {
  Requirements sure = found.requirements;
  const double margin = margin_of_yield(sure.min_yield, *found.options.tolerances);
  sure.min_yield += margin;
  if (margin > 0 && filter_of(family, found.region, sure).census().meeting > 0) found.added.yield_margin = margin;
}

/// What a map of half the step would have of linkages that fail one requirement alone: advice that relaxing one does
/// not help is not to hang on where the samples lie. Six-bars and yields take too long for it.
std::vector<Relaxation> relaxations_between(const Findings& found, const LinkageFamily& family, const MapExtent& extent,
                                            const Progress& progress) {
  constexpr int most_samples = 1000;
  const int samples = std::min(2 * extent.samples, most_samples);
  const bool takes_long = found.options.tolerances || dynamic_cast<const ChainFamily*>(&family) != nullptr;
  if (takes_long || samples <= extent.samples) return {};
  RegionMap map;
  family.classify(map, samples_within(family, Side::input, extent.window, samples, found.options.spacing),
                  samples_within(family, Side::output, extent.window, samples, found.options.spacing),
                  found.requirements.respect_direction, found.options.region, {{}, progress.cancelled});
  const RequirementFilter filter = filter_of(family, map, found.requirements);
  return filter.relaxations(filter.census());
}

}  // namespace

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
  if (found.options.tolerances && census.meeting > 0) set_yield_margin(found, family);
  if (found.options.pareto) found.pareto = pareto_front(found.region, filter, *found.options.pareto);
  if (census.meeting == 0) {
    found.relax = filter.relaxations(census, progress);
    if (found.relax.empty()) found.relax = relaxations_between(found, family, extent, progress);
    if (found.relax.empty()) found.relax_together = census.joint_relaxation();
  }
  progress(0.7);
  return filter;
}

}  // namespace linkwright
