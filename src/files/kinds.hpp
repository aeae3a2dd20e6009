#pragma once

#include <array>

#include "files/four_bar/four_bar_kind.hpp"
#include "files/six_bar/six_bar_kind.hpp"
#include "files/spherical/spherical_kind.hpp"
#include "files/straight_line/straight_line_kind.hpp"

// The kinds that files know. A new one has a folder beside four_bar/ and six_bar/ with the functions of their headers,
// and its line here.
namespace linkwright {

inline constexpr std::array task_forms = {
    motion_by_four_bar,           function_by_four_bar,           motion_by_six_bar,
    motion_by_spherical_four_bar, function_by_spherical_four_bar, straight_line_by_four_bar};

}  // namespace linkwright
