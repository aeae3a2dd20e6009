#pragma once

#include <array>
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

}  // namespace linkwright
