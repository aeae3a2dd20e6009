#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "linkwright/core/result.hpp"
#include "linkwright/files/six_bar_file.hpp"
#include "linkwright/loads/loads.hpp"
#include "linkwright/machine/mesh.hpp"
#include "linkwright/machine/plate_layers.hpp"

namespace linkwright {

/// What is wanted of a linkage as a machine.
struct MachineWishes {
  WantedSizes sizes;
  std::optional<int> position;    ///< of the task, from 0, in which a STEP file shows it; the first where not given
  std::optional<double> density;  ///< kg/m³, for simulators; steel_density where not given
  std::optional<Loads> loads{};   ///< on a four-bar: what files of mjcf and step tell with it
};

struct MachineFile {
  std::string content;
  std::string
      warning;  ///< what comes too near to what, beyond which stretch something may, what unit is not known; or empty
};

/// `step` (write_step), `stl`, `3mf` (parts to print), `plates` (a DXF drawing to cut them from), and for simulators
/// `mjcf`, `sdf` and `urdf`.
[[nodiscard]] std::span<const std::string_view> machine_formats();

/// One linkage in one of these formats. Errors: `wish_of_another_format` (a
/// position, a density or a radius where it means nothing), those of plate_sizes(), write_step() and simulator_text();
/// `curved_plates` for plates of a spherical linkage.
[[nodiscard]] Result<MachineFile> exported_machine(const AnyStoredLinkage& linkage, std::string_view format,
                                                   const MachineWishes& wishes);

}  // namespace linkwright
