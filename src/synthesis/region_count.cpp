#include "region_count.hpp"

#include <limits>

#include "linkwright/synthesis/tolerance_measures.hpp"

namespace linkwright {
namespace {

/// A measure of the cells that meet requirements; of others it is not worth its time.
class AmongPassing : public CellMeasure {
 public:
  /// Refers to both.
  AmongPassing(const CellMeasure& of, const RequirementFilter& filter)
      : CellMeasure(of.measure()), of_(of), filter_(filter) {}

  [[nodiscard]] std::optional<double> at(MapPoint place) const override { return of_.at(place); }
  [[nodiscard]] Rows rows_of(const RegionMap& map) const override {
    return [this, &map](std::size_t row, std::span<float> values) {
      for (std::size_t column = 0; column < values.size(); ++column) {
        const MapPoint place = {map.input_coordinates()[row], map.output_coordinates()[column]};
        const auto found = filter_.passes(row, column) ? at(place) : std::nullopt;
        values[column] = found ? static_cast<float>(*found) : std::numeric_limits<float>::quiet_NaN();
      }
    };
  }

 private:
  const CellMeasure& of_;
  const RequirementFilter& filter_;
};

}  // namespace

void measure_added(RegionMap& map, const LinkageFamily& family, const Findings& found, const Progress& progress) {
  if (found.added.tolerance_error) map.add(*found.added.tolerance_error, progress);
  const SynthesisOptions& options = found.options;
  const bool ranks =
      options.pareto && ((*options.pareto)[0] == Objective::yield || (*options.pareto)[1] == Objective::yield);
  const bool is_asked =
      options.measure_yields || found.requirements.min_yield > 0 || options.objective == Objective::yield || ranks;
  if (!found.added.yield || !is_asked) return;
  Requirements all_else = found.requirements;
  all_else.min_yield = 0;
  map.add(AmongPassing(*found.added.yield, filter_of(family, map, all_else)), progress);
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
