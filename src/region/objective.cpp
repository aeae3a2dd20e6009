#include "linkwright/region/objective.hpp"

#include <algorithm>
#include <array>

namespace linkwright {
namespace {

/// A row of the table of all that can rank linkages.
struct ObjectiveRow {
  Objective objective;
  std::string_view name, superlative;
  const Measure* by;  ///< the cells of a map; a larger or a smaller one is better, as it says
};

constexpr std::array<ObjectiveRow, static_cast<std::size_t>(Objective::end)> objective_rows = {{
    {Objective::min_transmission_angle, "min_transmission_angle", "largest minimum transmission angle",
     &measures::min_transmission_angle},
    {Objective::link_ratio, "link_ratio", "smallest link ratio", &measures::link_ratio},
    {Objective::size, "size", "smallest longest link", &measures::longest_link},
    // No map holds it: its cells are ranked by the transmission angle.
    {Objective::structural_error, "structural_error", "smallest structural error", &measures::min_transmission_angle},
    {Objective::link_angle, "link_angle", "largest least link angle", &measures::min_link_angle},
    {Objective::stroke, "stroke", "longest usable length over the longest link", &measures::stroke_over_longest},
    {Objective::deviation, "deviation", "least deviation", &measures::deviation},
    {Objective::velocity_uniformity, "velocity_uniformity", "most even velocity", &measures::velocity_nonuniformity},
    {Objective::tolerance_error, "tolerance_error", "smallest error by tolerances", &measures::tolerance_error},
    {Objective::yield, "yield", "largest yield", &measures::yield},
    {Objective::hand_force, "hand_force", "smallest largest force of the hand", &measures::hand_force},
    {Objective::hold_open, "hold_open", "largest hold-open force", &measures::hold_open},
    {Objective::pin_force, "pin_force", "smallest largest force of a pin", &measures::max_pin_force},
    {Objective::torque, "torque", "smallest largest driving torque", &measures::max_torque},
    {Objective::path_error, "path_error", "smallest distance from the points", &measures::path_error},
    {Objective::near_error, "near_error", "smallest error at the near poses", &measures::near_error},
}};

/// Objectives by themselves, which others walk.
constexpr auto all_objectives = [] {
  std::array<Objective, objective_rows.size()> all{};
  for (std::size_t k = 0; k < all.size(); ++k) all[k] = objective_rows[k].objective;
  return all;
}();

constexpr bool are_in_order() {
  for (std::size_t k = 0; k < objective_rows.size(); ++k)
    if (static_cast<std::size_t>(objective_rows[k].objective) != k) return false;
  return true;
}
static_assert(are_in_order());

const ObjectiveRow& row_of(Objective objective) { return objective_rows[static_cast<std::size_t>(objective)]; }

}  // namespace

std::span<const Objective> objectives() { return all_objectives; }

std::string_view name(Objective objective) { return row_of(objective).name; }

std::string_view superlative(Objective objective) { return row_of(objective).superlative; }

const Measure& measure_of(Objective objective) { return *row_of(objective).by; }

Rank rank_of(Objective objective, std::span<const Measure> measures) {
  const auto place_of = [&](const Measure& measure) { return std::find(measures.begin(), measures.end(), measure); };
  auto by = place_of(measure_of(objective));
  if (by == measures.end()) by = place_of(measures::min_transmission_angle);
  return {static_cast<std::size_t>(by - measures.begin()), by->larger_is_better ? 1.0 : -1.0};
}

}  // namespace linkwright
