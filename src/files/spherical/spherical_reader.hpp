#pragma once

#include <optional>

#include "files/json/json_object.hpp"
#include "linkwright/mechanism/spherical_four_bar.hpp"

namespace linkwright {

/// The member `mechanism` is "spherical_four_bar".
[[nodiscard]] bool says_spherical_four_bar(const JsonValue& value);

/// An element of a result's `linkages`, `axes` or `angles_deg` (read_any_linkage); nothing, with a mistake, where it
/// cannot be read.
[[nodiscard]] std::optional<SphericalFourBar> read_spherical_four_bar(const JsonValue& value, Mistakes& mistakes);

}  // namespace linkwright
