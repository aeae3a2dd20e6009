#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace linkwright {

/// A homogeneous polynomial Σ aₖ cⁿ⁻ᵏ sᵏ over the directions (c, s) = (cos t, sin t), t modulo π.
[[nodiscard]] double form_value(std::span<const double> a, double c, double s);

struct FormRoot {
  double angle = 0;      ///< in [0, π)
  int multiplicity = 1;  ///< roots closer than `same` are one
};

/// Real roots of a form of degree ≤ 8 that does not vanish, by rising angle; pairs whose imaginary part is below `same`
/// (radians) count as one double real root. Eigenvalues of the companion matrix, seen from the direction in which the
/// form is largest, so that no root is at infinity; simple ones polished by Newton's method.
[[nodiscard]] std::vector<FormRoot> real_roots(std::span<const double> a, double same);

/// binomial[n][k], n and k up to 4: the product rule differentiated again and again.
inline constexpr std::array<std::array<double, 5>, 5> binomial = {
    {{1, 0, 0, 0, 0}, {1, 1, 0, 0, 0}, {1, 2, 1, 0, 0}, {1, 3, 3, 1, 0}, {1, 4, 6, 4, 1}}};

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
