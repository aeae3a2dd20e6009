#pragma once

#include <array>

namespace linkwright {

/// binomial[n][k], n and k up to 4: the product rule differentiated again and again.
inline constexpr std::array<std::array<double, 5>, 5> binomial = {
    {{1, 0, 0, 0, 0}, {1, 1, 0, 0, 0}, {1, 2, 1, 0, 0}, {1, 3, 3, 1, 0}, {1, 4, 6, 4, 1}}};

}  // namespace linkwright
