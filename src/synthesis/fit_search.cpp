#include "linkwright/synthesis/fit_search.hpp"

#include "planar/fitted_motion_family.hpp"
#include "planar/fitted_path_family.hpp"

namespace linkwright {

std::optional<FitSearch> search_fits(const Problem& problem, FitEffort effort, const Progress& progress) {
  FitWishes wishes = problem.options.fit;
  wishes.effort = effort;
  const RegionOptions& region = problem.options.region;
  if (const auto* path = std::get_if<PathTask>(&problem.task); path && path->is_approximate())
    return search_nearest(*path, problem.requirements, wishes, region, progress);
  if (const auto* motion = std::get_if<MotionTask>(&problem.task); motion && motion->is_fitted())
    return search_near(*motion, problem.requirements, wishes, region, progress);
  return std::nullopt;
}

}  // namespace linkwright
