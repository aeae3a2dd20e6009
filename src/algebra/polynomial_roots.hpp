#pragma once

#include <span>
#include <vector>

namespace linkwright {

/// c₀ + c₁ t + c₂ t² + …
[[nodiscard]] double polynomial_value(std::span<const double> coefficients, double t);

/// Where a polynomial is zero between two places, at which it has different signs or is zero; to the last digits.
[[nodiscard]] double sign_change_between(std::span<const double> coefficients, double from, double to);

/// Where a polynomial of degree ≤ 15 changes its sign in [from, to], rising: between the places where its derivative
/// changes sign it is monotone, and so from the linear one upwards none is missed.
/// Double roots, where it only touches zero, are none.
[[nodiscard]] std::vector<double> sign_changes_within(std::span<const double> coefficients, double from, double to);

}  // namespace linkwright
