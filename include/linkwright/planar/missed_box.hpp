#pragma once

#include <string>
#include <vector>

#include "linkwright/algebra/point.hpp"
#include "linkwright/planar/four_bar_family.hpp"
#include "linkwright/region/requirement_filter.hpp"
#include "linkwright/region/requirements.hpp"

namespace linkwright {

/// A box for pivots that the curve of grounded links does not enter: no linkage will ever have its pivots there.
struct MissedBox {
  RequirementKind box = RequirementKind::ground_pivots_within;
  Point nearest{};  ///< point of the curve that lies closest to the box; user's frame
  Point beyond{};   ///< from the border of the box to it

  friend bool operator==(const MissedBox&, const MissedBox&) = default;
};

/// The boxes asked for that the curve of four positions misses: ground pivots on the centre-point curve, moving pivots
/// on the circle-point curve in position 1. None for tasks of other kinds, whose grounded links have no curve in
/// common.
[[nodiscard]] std::vector<MissedBox> missed_boxes(const FourBarFamily& family, const Requirements& wanted);

/// "The centre-point curve does not enter ground_pivots_within; nearest is (250, 210), 60 below it."
[[nodiscard]] std::string missed_box_text(const MissedBox& missed);

}  // namespace linkwright
