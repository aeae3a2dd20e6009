#pragma once

#include <string>
#include <string_view>

#include "linkwright/files/six_bar_file.hpp"

namespace linkwright {

/// One linkage as a file: `svg` (draw_linkage), `dxf` (draw_dxf), `csv` (motion_table of its tabulated motion) or
/// `json` (write_linkage). Empty where the format cannot carry it: `dxf` of spherical linkages.
[[nodiscard]] std::string exported(const AnyStoredLinkage& linkage, std::string_view format);

}  // namespace linkwright
