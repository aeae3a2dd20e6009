#pragma once

#include <optional>
#include <string_view>

namespace linkwright {

/// Millimetres to a unit of length that is known by its name: µm, mm, cm, dm, m, in, ft.
[[nodiscard]] std::optional<double> millimetres(std::string_view unit);

}  // namespace linkwright
