#pragma once

#include <string>
#include <string_view>

namespace linkwright::wasm {

/// One instant of a planar four-bar as the page draws it: of {"pivots": {…}} as linkage files have them, the object
/// `instant` of an analysis, and beside it `circling_points` and `centering_points`, lists of polylines [[x, y], …]
/// about the linkage up to ten times its size. In place of it {"mistakes": […]}.
[[nodiscard]] std::string instant_reply(std::string_view text);

}  // namespace linkwright::wasm
