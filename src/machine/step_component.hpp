#pragma once

#include <string>

#include "linkwright/machine/machine.hpp"

// What the component linkwright_step offers; program and component are of one version.
namespace linkwright {

/// Writes `text`, or what failed; lengths are multiplied by `scale` to be millimetres. Exported as
/// linkwright_step_writer.
using StepWriter = bool(const Machine& machine, int position, double scale, std::string& text);
/// Of the library that the component was built with. Exported as linkwright_step_version.
using StepVersion = const char*();

}  // namespace linkwright
