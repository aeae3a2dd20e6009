#pragma once

#include <span>
#include <string>
#include <string_view>

#include "linkwright/core/result.hpp"
#include "linkwright/files/six_bar_file.hpp"
#include "linkwright/machine/mass_properties.hpp"
#include "linkwright/machine/plate_layers.hpp"

namespace linkwright {

/// What is wanted of a linkage as a machine.
struct MachineWishes {
  WantedSizes sizes;
  int position = 0;                ///< of the task, from 0, in which a STEP file shows it
  double density = steel_density;  ///< kg/m³, for simulators
};

struct MachineFile {
  std::string content;
  std::string warning;  ///< one sentence: what collides, or beyond which stretch something may; empty otherwise
};

/// `step` (write_step), `stl`, `3mf` (parts to print), `plates` (a DXF drawing to cut them from), and for simulators
/// `mjcf`, `sdf` and `urdf`.
[[nodiscard]] std::span<const std::string_view> machine_formats();

/// One linkage in one of these formats. Errors: those of plate_sizes(), write_step() and simulator_text();
/// `curved_plates` for plates of a spherical linkage.
[[nodiscard]] Result<MachineFile> exported_machine(const AnyStoredLinkage& linkage, std::string_view format,
                                                   const MachineWishes& wishes);

}  // namespace linkwright
