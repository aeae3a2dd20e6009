#pragma once

#include "drawn_task.hpp"

namespace linkwright::soak {

/// Adds loads to a share of the tasks that take them, plain ones and absurd ones, and what can be asked by them.
void add_loads(Draw& draw, const Sheet& sheet, std::string_view kind, Json& problem);

}  // namespace linkwright::soak
