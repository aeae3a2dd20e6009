#pragma once

#include <optional>
#include <string>
#include <vector>

#include "linkwright/files/six_bar_file.hpp"
#include "linkwright/mechanism/pose.hpp"

namespace linkwright {

/// How near a linkage comes to a position of its file, moving as it is: with dimensions that were rounded it passes
/// none but the first exactly.
struct PositionError {
  int position = 0;                ///< from 1
  std::optional<BodyError> error;  ///< nothing: the motion from position 1 does not come there
};

/// Of the positions after the first, by the rows of its motion table; about a centre without distances.
[[nodiscard]] std::vector<PositionError> position_errors(const AnyStoredLinkage& linkage);

/// "as it moves the linkage misses position 2 by 0.21 mm and 0.5° and does not come to position 4". Empty where it
/// passes all of them, to 1e-6 of its longest link and 1e-6 radians.
[[nodiscard]] std::string position_error_words(const AnyStoredLinkage& linkage);

}  // namespace linkwright
