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
/// machine_layout, as the component was built. Exported as linkwright_step_layout.
using StepLayout = std::size_t();

/// Changes where what is handed over has other members.
inline constexpr std::size_t machine_layout = 10'000 * sizeof(Machine) + sizeof(Part);

}  // namespace linkwright
