#pragma once

#include <optional>

#include "linkwright/region/added_measures.hpp"
#include "linkwright/region/linkage_family.hpp"
#include "linkwright/region/objective.hpp"
#include "linkwright/region/requirements.hpp"

namespace linkwright {

/// The top of the hill on which a linkage stands: climbed continuously in both coordinates, on the same branches, with
/// the same type and driver, meeting the requirements (lengths set) all the way. Nothing where the linkage does not
/// meet them itself or is at the top already.
[[nodiscard]] std::optional<MapPoint> improved_linkage(const LinkageFamily& family, const Requirements& requirements,
                                                       Objective objective, MapPoint start,
                                                       const AddedMeasures& added = {});

}  // namespace linkwright
