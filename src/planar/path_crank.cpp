#include "linkwright/planar/path_crank.hpp"

namespace linkwright {

Dyad crank_link(const Dyad& crank) {
  const auto center = finite_point(crank.center), circle = finite_point(crank.circle);
  if (!center) return {crank.center, crank.center, crank.coordinate};
  if (!circle) return crank;
  return {crank.center, Homogeneous::of(*center - *circle), crank.coordinate};
}

}  // namespace linkwright
