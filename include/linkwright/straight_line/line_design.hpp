#pragma once

#include <cstdint>

#include "linkwright/mechanism/four_bar.hpp"

namespace linkwright {

/// What a case of straight lines gives at a place.
enum class DesignKind : std::uint8_t {
  none,      ///< the mathematics gives nothing, or a link has no length
  four_bar,  ///< of four links
  slider     ///< a pivot is at infinity: a slider in place of a link
};

/// A linkage in the configuration in which its point lies on the line; `linkage` only of a four-bar.
struct LineDesign {
  DesignKind kind = DesignKind::none;
  TracingFourBar linkage{};
};

/// A four-bar where it can be built: none where a link or an arm of the point is shorter than
/// tolerance::vanishing_link of the longest, a slider where a pivot is farther than the inverse of
/// tolerance::sliding_pivot in shares of `scale`.
[[nodiscard]] LineDesign line_design(const TracingFourBar& linkage, double scale);

}  // namespace linkwright
