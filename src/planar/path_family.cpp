#include "path_family.hpp"

#include "arm_family.hpp"
#include "timed_path_family.hpp"

namespace linkwright {

std::vector<Cell> PathFamily::all_at(MapPoint place, bool respect_direction) const {
  const auto found = cell(place, respect_direction);
  return found ? std::vector{*found} : std::vector<Cell>{};
}

// The diagonal holds none.
std::vector<MapPoint> PathFamily::few_places() const {
  std::vector<MapPoint> places;
  if (!axis(Side::input).is_discrete() || !axis(Side::output).is_discrete()) return places;
  for (const double input : samples(Side::input, 0, Spacing::coordinate))
    for (const double output : samples(Side::output, 0, Spacing::coordinate))
      if (!has_cognates() || input != output) places.push_back({input, output});
  return places;
}

LinkageOutput PathFamily::output_of(MapPoint place, const FourBar& bars) const {
  return point_output(bars, user_poses(place, bars));
}

std::optional<LinkageOutput> PathFamily::output_form() const {
  PlanarOutput form;
  form.of_point = true;
  return form;
}

std::shared_ptr<const FourBarCells> PathFamily::four_bar_cells(const RegionMap& /*map*/) const { return nullptr; }

TaskFamily task_family(const PathTask& task, const Requirements& requirements, Objective objective) {
  return task.form() == PathForm::cranks ? family_of_timed(task) : family_of_arms(task, requirements, objective);
}

}  // namespace linkwright
