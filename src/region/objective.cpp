#include "linkwright/region/objective.hpp"

#include <array>

namespace linkwright {
namespace {

constexpr std::array<std::string_view, 10> objective_names = {
    "min_transmission_angle", "link_ratio",      "size", "structural_error", "link_angle", "stroke", "deviation",
    "velocity_uniformity",    "tolerance_error", "yield"};

}  // namespace

std::string_view name(Objective objective) { return objective_names[static_cast<std::size_t>(objective)]; }

const Measure& measure_of(Objective objective) {
  switch (objective) {
    case Objective::link_ratio:
      return measures::link_ratio;
    case Objective::size:
      return measures::longest_link;
    case Objective::link_angle:
      return measures::min_link_angle;
    case Objective::stroke:
      return measures::stroke_over_longest;
    case Objective::deviation:
      return measures::deviation;
    case Objective::velocity_uniformity:
      return measures::velocity_nonuniformity;
    case Objective::tolerance_error:
      return measures::tolerance_error;
    case Objective::yield:
      return measures::yield;
    default:
      return measures::min_transmission_angle;
  }
}

double score_of(Objective objective, const RankedNumbers& numbers) {
  switch (objective) {
    case Objective::link_ratio:
      return -numbers.link_ratio;
    case Objective::size:
      return -numbers.longest_link;
    case Objective::link_angle:
      return numbers.link_versine;
    case Objective::stroke:
      return numbers.stroke_over_longest;
    case Objective::deviation:
      return -numbers.deviation;
    case Objective::velocity_uniformity:
      return -numbers.velocity_nonuniformity;
    default:
      return numbers.transmission_versine;
  }
}

}  // namespace linkwright
