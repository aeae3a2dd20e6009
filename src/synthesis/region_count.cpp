#include "region_count.hpp"

#include <algorithm>

#include "analyses/analyses.hpp"
#include "region/ordered_axes.hpp"

namespace linkwright {

void measure_added(RegionMap& map, const LinkageFamily& family, const Findings& found, const Progress& progress) {
  const SynthesisOptions& options = found.options;
  const AddedMeasure* sampled = found.added.sampled();
  const auto is_asked = [&](Objective objective) {
    return AddedMeasures::is_asked(*sampled, found.requirements, objective);
  };
  const bool with_sampled =
      sampled && (options.measure_yields || is_asked(options.objective) ||
                  (options.pareto && (is_asked((*options.pareto)[0]) || is_asked((*options.pareto)[1]))));
  found.added.add_to(map, family, found.requirements, with_sampled, progress);
}

std::vector<SearchMap> CountedRegion::maps(const RegionMap& region) const {
  std::vector<SearchMap> maps = {{&region, &filter, step}};
  for (const auto& closer : within.maps) maps.push_back(closer->view());
  return maps;
}

namespace {

/// A search keeps to what more samples will not take back, where the map has such.
void set_margins(Findings& found, const LinkageFamily& family) {
  for (AddedMeasure& added : found.added.all)
    for (const Criterion* asked : AddedMeasures::criteria_on(added)) {
      if (!added.margin_of || !asked->has_limit(found.requirements)) continue;
      const double limit = asked->limit(found.requirements), margin = added.margin_of(limit);
      Requirements sure = found.requirements;
      asked->set(sure, asked->stricter(limit, margin));
      if (margin > 0 && filter_of(family, found.region, sure).census().meeting > 0) added.margin = margin;
    }
}

/// What a map of half the step would have of linkages that fail one requirement alone: advice that relaxing one does
/// not help is not to depend on where the samples lie. What analyses add takes too long for it.
std::vector<Relaxation> relaxations_between(const Findings& found, const LinkageFamily& family, const MapExtent& extent,
                                            const Progress& progress) {
  constexpr int most_samples = 1000;
  const int samples = std::min(2 * extent.samples, most_samples);
  if (!found.added.all.empty() || samples <= extent.samples) return {};
  RegionMap map;
  family.classify(map, samples_within(family, Side::input, extent.window, samples, found.options.spacing),
                  samples_within(family, Side::output, extent.window, samples, found.options.spacing),
                  found.requirements.respect_direction, found.options.region, {{}, progress.cancelled});
  const RequirementFilter filter = filter_of(family, map, found.requirements);
  return filter.relaxations(filter.census());
}

}  // namespace

CountedRegion count_region(Findings& found, const LinkageFamily& family, const MapExtent& extent,
                           const Progress& progress) {
  const auto samples = [&](Side side) {
    return samples_within(family, side, extent.window, extent.samples, found.options.spacing);
  };
  found.added = added_measures(family, found.options, found.of_task);
  const MapMaking making{[&](RegionMap& map, std::span<const double> input, std::span<const double> output) {
                           family.classify(map, input, output, found.requirements.respect_direction,
                                           found.options.region, progress);
                           if (!found.added.all.empty()) measure_added(map, family, found, progress);
                         },
                         std::max(extent.samples, extent.inside), extent.window};
  progress(0.1);
  making.fill(found.region, samples(Side::input), samples(Side::output));
  found.counts = found.region.counts();
  progress(0.6);
  const double step = longest_axis(family) / static_cast<double>(std::max(found.region.rows(), found.region.columns()));
  CountedRegion counted{filter_of(family, found.region, found.requirements), {step, step}, extent.window, {}};
  const RequirementCensus census = counted.filter.census(progress);
  found.meeting_requirements = census.meeting;
  if (census.meeting > 0) set_margins(found, family);
  if (found.options.pareto) found.pareto = pareto_front(found.region, counted.filter, *found.options.pareto);
  counted.within =
      look_into_windows(family, {&found.region, &counted.filter, counted.step}, found.requirements, making, progress);
  const WindowLook& within = counted.within;
  if (within.looked_at > 0 || within.is_empty) found.inside = {within.looked_at, within.meeting, within.is_empty};
  if (census.meeting == 0 && within.meeting == 0) {
    found.relax = relaxations(family, counted.maps(found.region), found.requirements, making, progress);
    if (found.relax.empty()) found.relax = relaxations_between(found, family, extent, progress);
    if (found.relax.empty()) found.relax_together = census.joint_relaxation();
  }
  progress(0.7);
  return counted;
}

}  // namespace linkwright
