#include "linkwright/planar/improved_linkage.hpp"

#include "planar/candidate.hpp"

namespace linkwright {

std::optional<MapPoint> improved_linkage(const FourBarFamily& family, const Requirements& requirements,
                                         Objective objective, MapPoint start, const AddedMeasures& added) {
  return improved_place(CellEvaluator(family, requirements, objective, {}, added), start);
}

}  // namespace linkwright
