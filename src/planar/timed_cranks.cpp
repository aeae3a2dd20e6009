#include "timed_cranks.hpp"

#include "linkwright/core/tolerance.hpp"

namespace linkwright {

std::optional<DyadPair> linkage_of_cranks(const Dyad& crank, const Dyad& cognate) {
  const auto center = finite_point(crank.center), circle = finite_point(crank.circle);
  const auto other = finite_point(cognate.circle);
  if (!center || !circle || !other || std::abs(*circle) <= tolerance::change_point || *other == *circle)
    return std::nullopt;
  const Point link = -*circle, arm = *circle - *center;
  const Point share = link / (*other - *circle);  // 1/λ
  const Point moving = *center + link;
  const auto other_center = finite_point(cognate.center);
  const Homogeneous fixed = other_center ? Homogeneous::of(*center + (*other_center - *center) * share)
                                         : normalized(Homogeneous::at_infinity(cognate.center.vector() * share));
  return DyadPair{{Homogeneous::of(*center), Homogeneous::of(moving), crank.coordinate},
                  {fixed, Homogeneous::of(moving + arm * share), cognate.coordinate}};
}

}  // namespace linkwright
