#include "linkwright/straight_line/line_worth.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/angle.hpp"

namespace linkwright {
namespace {

bool holds(const std::optional<Box>& box, Point one, Point other) {
  return !box || (box->contains(one) && box->contains(other));
}

}  // namespace

LineWorth LineWorth::of(const StrokeFigures& over, double deviation) {
  const double length = over.to - over.from;
  return {length, deviation, over.min_transmission_angle,
          over.drive ? over.drive->nonuniformity(length) : std::numeric_limits<double>::infinity()};
}

bool meets(RequirementKind kind, const TracingFourBar& linkage, const Requirements& wanted) {
  const FourBar& bars = linkage.bars;
  switch (kind) {
    case RequirementKind::types: {
      const auto& types = wanted.types;
      return types.empty() || std::find(types.begin(), types.end(), linkage_type(bars.lengths())) != types.end();
    }
    case RequirementKind::max_link_ratio:
      return linkage.longest() <= wanted.max_link_ratio * linkage.shortest();
    case RequirementKind::max_length:
      return linkage.longest() <= wanted.max_length.value_or(Requirements::unlimited);
    case RequirementKind::ground_pivots_within:
      return holds(wanted.ground_pivots_within, bars.input_center, bars.output_center);
    case RequirementKind::moving_pivots_within:
      return holds(wanted.moving_pivots_within, bars.input_circle, bars.output_circle);
    default:
      return true;
  }
}

bool meets(RequirementKind kind, const LineWorth& worth, const Requirements& wanted) {
  switch (kind) {
    case RequirementKind::min_transmission_angle:
      return worth.min_transmission_angle >= wanted.min_transmission_angle;
    case RequirementKind::min_stroke:
      return worth.usable >= wanted.min_stroke;
    case RequirementKind::max_deviation:
      return std::isfinite(worth.deviation) && worth.deviation <= wanted.max_deviation;
    default:
      return true;
  }
}

bool has_shape(const TracingFourBar& linkage, const Requirements& wanted) {
  return linkage_type(linkage.bars.lengths()) != LinkageType::degenerate &&
         meets(RequirementKind::max_link_ratio, linkage, wanted) && meets(RequirementKind::types, linkage, wanted);
}

bool has_place(const TracingFourBar& linkage, const Requirements& wanted) {
  return meets(RequirementKind::max_length, linkage, wanted) &&
         meets(RequirementKind::ground_pivots_within, linkage, wanted) &&
         meets(RequirementKind::moving_pivots_within, linkage, wanted);
}

bool meets(const LineWorth& worth, const Requirements& wanted) {
  return meets(RequirementKind::min_stroke, worth, wanted) && meets(RequirementKind::max_deviation, worth, wanted) &&
         meets(RequirementKind::min_transmission_angle, worth, wanted);
}

double score_of(Objective objective, const TracingFourBar& linkage, const LineWorth& worth) {
  RankedNumbers numbers;
  numbers.transmission_versine = versine_of_angle(worth.min_transmission_angle);
  numbers.longest_link = linkage.longest();
  numbers.stroke_over_longest = worth.usable / numbers.longest_link;
  numbers.deviation = worth.deviation;
  numbers.velocity_nonuniformity = worth.velocity_nonuniformity;
  return score_of(objective, numbers);
}

}  // namespace linkwright
