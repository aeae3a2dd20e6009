#pragma once

#include <array>
#include <cstddef>

namespace linkwright {

/// How many monomials of a degree there are in x, y, z.
[[nodiscard]] constexpr std::size_t monomial_count(std::size_t degree) { return (degree + 1) * (degree + 2) / 2; }

/// Where monomials times x, y or z stand among those of the next degree, up to degree 4. They are ordered by falling
/// power of x, then of y (CubicForm): the r + 1 of the degree r in y and z stand together, in every degree from the
/// same index on.
inline constexpr auto times_axis = [] {
  std::array<std::array<std::size_t, 3>, monomial_count(4)> place{};
  for (std::size_t r = 0, i = 0; r <= 4; ++r)
    for (std::size_t k = 0; k <= r; ++k, ++i) place[i] = {i, i + r + 1, i + r + 2};
  return place;
}();

}  // namespace linkwright
