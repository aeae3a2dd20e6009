#include "linkwright/planar/improved_linkage.hpp"

#include "planar/candidate.hpp"

namespace linkwright {

std::optional<MapPoint> improved_linkage(const FourBarFamily& family, const Requirements& requirements,
                                         Objective objective, MapPoint start) {
  return improved_place(CellEvaluator(family, requirements, objective), start);
}

}  // namespace linkwright
