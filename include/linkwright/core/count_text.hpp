#pragma once

#include <cstdint>
#include <string>

namespace linkwright {

/// A count in groups of three: 159600 → "159 600".
[[nodiscard]] std::string grouped_text(std::int64_t count);

/// The end of a range that can be given: a whole number in groups of three, "1e100" where that is too long to read.
[[nodiscard]] std::string limit_text(double limit);

}  // namespace linkwright
