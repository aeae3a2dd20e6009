#pragma once

#include <array>
#include <cstddef>

namespace linkwright {

struct RealRoots {
  std::array<double, 3> values{};
  std::size_t count = 0;
};

/// Where c₀ + c₁ t + c₂ t² + c₃ t³ changes its sign, ascending, |t| ≤ 1e6: between its extremes it is monotone. The
/// general finder (algebra/polynomial_roots.hpp) lists degrees of any size and takes ten times as long.
[[nodiscard]] RealRoots real_cubic_roots(const std::array<double, 4>& c);

}  // namespace linkwright
