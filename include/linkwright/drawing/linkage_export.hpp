#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "linkwright/files/six_bar_file.hpp"
#include "linkwright/loads/loads.hpp"

namespace linkwright {

/// One linkage as a file: `svg` (draw_linkage), `dxf` (draw_dxf), `csv` (motion_table of its tabulated motion) or
/// `json` (write_linkage). Empty where the format cannot carry it: `dxf` of spherical linkages. What acts
/// on a four-bar with its poses is in its drawings.
[[nodiscard]] std::string exported(const AnyStoredLinkage& linkage, std::string_view format,
                                   const std::optional<Loads>& loads = std::nullopt);

}  // namespace linkwright
