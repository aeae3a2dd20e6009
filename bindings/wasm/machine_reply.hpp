#pragma once

#include <string>

#include "linkwright/machine/machine.hpp"

namespace linkwright::wasm {

/// JSON text: `{"mistakes"}`, or `{"sizes", "layers", "over", "crossings"}` with the sizes in force, `[body, layer]`
/// from the ground on, and what runs into what: `{"body", "pin" or "other", "from_deg", "to_deg"}`, driver angles from
/// position 1, positive as the positions are met.
[[nodiscard]] std::string machine_reply(const Result<Machine>& made);

}  // namespace linkwright::wasm
