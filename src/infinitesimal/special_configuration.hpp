#pragma once

#include <vector>

#include "linkwright/core/result.hpp"
#include "linkwright/mechanism/four_bar.hpp"

namespace linkwright {

/// What an instant of the coupler has of its own because the links lie as they do, to tolerance::collinear_links: a
/// side link on the frame line or in line with the coupler, the coupler parallel to the frame, parallel side links.
/// Links that all lie in one line are none of these.
[[nodiscard]] std::vector<Notice> special_configurations(const FourBar& four_bar);

}  // namespace linkwright
