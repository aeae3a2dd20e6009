#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "linkwright/machine/machine.hpp"
#include "linkwright/machine/mesh.hpp"

namespace linkwright {

/// The parts as they are printed or cut, in millimetres: each laid flat with its lowest point at z = 0, plates on a
/// face and pins upright, in rows beside each other with a gap of one pin's diameter.
struct LaidPart {
  std::string name;
  Mesh mesh;
};
[[nodiscard]] std::vector<LaidPart> laid_parts(const Machine& machine);

/// One solid after another as a binary STL file, millimetres.
[[nodiscard]] std::string write_stl(const Machine& machine);

/// The parts as objects with their names in a 3MF file (3D Manufacturing Format, core specification 1.3), millimetres.
/// The same machine gives the same bytes.
[[nodiscard]] std::string write_3mf(const Machine& machine);

/// The plates as they are cut from a sheet, beside each other, as a DXF drawing (AutoCAD 2000) in millimetres, 1 : 1: a
/// layer to each plate, with its outline and its holes at their true diameters. Empty for spherical linkages, whose
/// plates are not flat.
[[nodiscard]] std::string draw_plates(const Machine& machine);

/// One of these files: `stl`, `3mf` or `plates`. Errors: `curved_plates`.
[[nodiscard]] Result<std::string> write_parts(const Machine& machine, std::string_view format);

}  // namespace linkwright
