#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

#include "draw.hpp"
#include "drawn_poses.hpp"

namespace linkwright::soak {

using Json = nlohmann::ordered_json;

/// The `task` of a problem file.
[[nodiscard]] Json drawn_task(Draw& draw, const Sheet& sheet, std::string_view kind);

[[nodiscard]] Json written_point(const Sheet& sheet, Point p);
/// An interval of about this size, low first.
[[nodiscard]] Json drawn_interval(Draw& draw, double low_reach, double high_reach);

}  // namespace linkwright::soak
