#pragma once

#include <optional>
#include <vector>

#include "linkwright/mechanism/defects.hpp"
#include "linkwright/mechanism/travel.hpp"
#include "linkwright/straight_line/straight_line_family.hpp"
#include "linkwright/straight_line/straight_line_solution.hpp"

namespace linkwright {

/// Of a linkage whose point runs straight, over its whole travel. Its positions are the ends of the usable length, and
/// between them where the linkage lies; or its contacts at places. The body is the coupler, its origin the point.
[[nodiscard]] Travel travel_of(const StraightLineFamily& family, const StraightLineSolution& found);

/// The path beside the line at one place.
struct ProfilePlace {
  double s = 0, e = 0;             ///< along the line, 0 where the linkage lies, and off it; user's unit
  std::optional<double> velocity;  ///< ds/dφ; nothing where it is unbounded
  double turn = 0;                 ///< of the driver, as TravelState::turn
};
/// Somewhat more than what is usable, and all of the stroke that is asked for.
[[nodiscard]] std::vector<ProfilePlace> profile_of(const StraightLineFamily& family, const StraightLineSolution& found);

/// What the input does over the stretch by which a linkage is judged. A driver that turns back on the way does not
/// drive it: there the linkage locks (branch).
[[nodiscard]] DefectReport report_of(const StraightLineFamily& family, const TracingFourBar& linkage,
                                     const StrokeFigures& judged);

}  // namespace linkwright
