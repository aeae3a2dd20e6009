#include "linkwright/region/objective.hpp"

#include <array>

namespace linkwright {
namespace {

/// A row of the table of all that can rank linkages.
struct ObjectiveRow {
  Objective objective;
  std::string_view name;
  const Measure* by;  ///< the cells of a map; a larger or a smaller one is better, as it says
  double RankedNumbers::*number;
};

constexpr std::array<ObjectiveRow, 10> objective_rows = {{
    {Objective::min_transmission_angle, "min_transmission_angle", &measures::min_transmission_angle,
     &RankedNumbers::transmission_versine},
    {Objective::link_ratio, "link_ratio", &measures::link_ratio, &RankedNumbers::link_ratio},
    {Objective::size, "size", &measures::longest_link, &RankedNumbers::longest_link},
    // No map holds it: its cells are ranked by the transmission angle.
    {Objective::structural_error, "structural_error", &measures::min_transmission_angle,
     &RankedNumbers::transmission_versine},
    {Objective::link_angle, "link_angle", &measures::min_link_angle, &RankedNumbers::link_versine},
    {Objective::stroke, "stroke", &measures::stroke_over_longest, &RankedNumbers::stroke_over_longest},
    {Objective::deviation, "deviation", &measures::deviation, &RankedNumbers::deviation},
    {Objective::velocity_uniformity, "velocity_uniformity", &measures::velocity_nonuniformity,
     &RankedNumbers::velocity_nonuniformity},
    // What no family measures itself, AddedMeasures scores; alone linkages are ranked by the transmission angle.
    {Objective::tolerance_error, "tolerance_error", &measures::tolerance_error, nullptr},
    {Objective::yield, "yield", &measures::yield, nullptr},
}};

constexpr bool are_in_order() {
  for (std::size_t k = 0; k < objective_rows.size(); ++k)
    if (static_cast<std::size_t>(objective_rows[k].objective) != k) return false;
  return true;
}
static_assert(are_in_order());

const ObjectiveRow& row_of(Objective objective) { return objective_rows[static_cast<std::size_t>(objective)]; }

}  // namespace

std::string_view name(Objective objective) { return row_of(objective).name; }

const Measure& measure_of(Objective objective) { return *row_of(objective).by; }

double score_of(Objective objective, const RankedNumbers& numbers) {
  const ObjectiveRow& by = row_of(objective);
  if (!by.number) return numbers.transmission_versine;
  return by.by->larger_is_better ? numbers.*by.number : -(numbers.*by.number);
}

}  // namespace linkwright
