#pragma once

#include <string>

#include "linkwright/core/result.hpp"
#include "linkwright/machine/machine.hpp"

namespace linkwright {

/// A machine as a STEP file (ISO 10303-21, AP214), in millimetres: an assembly of its parts, solids with their names
/// and a colour to each body, placed as in a position of the task (from 0). Done by a component of its own that stands
/// on OpenCASCADE, loaded when it is needed: from the folder that the variable LINKWRIGHT_COMPONENTS of the environment
/// names, from that of the running program, or from where it is installed beside it. Errors: `no_step_component` (with
/// how to get it), `no_such_position`, `step_size` (links shorter than 1e-3 mm or
/// longer than 10 km), `step_failed`.
[[nodiscard]] Result<std::string> write_step(const Machine& machine, int position = 0);

}  // namespace linkwright
