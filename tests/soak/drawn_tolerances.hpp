#pragma once

#include "drawn_task.hpp"

namespace linkwright::soak {

/// Adds tolerances to a share of the problems, fine ones and absurd ones, and what can be asked by them.
void add_tolerances(Draw& draw, const Sheet& sheet, std::string_view kind, Json& problem);

}  // namespace linkwright::soak
