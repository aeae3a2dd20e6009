#pragma once

#include <string>
#include <vector>

#include "linkwright/algebra/directed_line.hpp"
#include "linkwright/core/result.hpp"

namespace linkwright {

/// Adds a mistake to those found for each number of a line that is out of range or none.
void check_line(const LineAtAngle& line, const std::string& place, std::vector<Error>& found);

}  // namespace linkwright
