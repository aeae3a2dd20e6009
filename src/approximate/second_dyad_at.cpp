#include <array>
#include <cmath>

#include "approximate/dyad_scan.hpp"

namespace linkwright {
namespace {

using Row = std::array<double, 4>;  // of x, y, the constant, and what they make

// Symmetric equations by Cramer's rule, in the two unknowns that are left where the constant is eliminated.
std::optional<Point> solved(const std::array<Row, 3>& m) {
  const double count = m[2][2];
  if (!(count > 0)) return std::nullopt;
  const auto reduced = [&](std::size_t i, std::size_t k) { return m[i][k] - m[i][2] * m[2][k] / count; };
  const double xx = reduced(0, 0), xy = reduced(0, 1), yy = reduced(1, 1), x = reduced(0, 3), y = reduced(1, 3);
  const double determinant = xx * yy - xy * xy;
  if (!(determinant > 0)) return std::nullopt;
  return Point{(x * yy - y * xy) / determinant, (xx * y - xy * x) / determinant};
}

}  // namespace

// |a e + z u − C|² = b²: Re(z (a ē − C̄) u) + (a² + |z|² + |C|² − b²)/2 = Re(a C̄ e).
std::optional<CouplerLinkage> second_dyad_at(Point second, double input, double arm, std::span<const LoopState> driven,
                                             std::span<const double> weights) {
  std::array<Row, 3> sums{};
  for (std::size_t j = 0; j < driven.size(); ++j) {
    const Point q = product(std::conj(input * driven[j].e - second), driven[j].u);
    const Row row = {q.real(), -q.imag(), 1, input * dot(second, driven[j].e)};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 4; ++k) sums[i][k] += weights[j] * row[i] * row[k];
  }
  const auto z = solved(sums);
  if (!z) return std::nullopt;
  const double h = std::abs(*z);
  if (!std::isfinite(h) || !(h > 0)) return std::nullopt;
  return CouplerLinkage{{}, second, input, h, 0, arm / h * std::conj(*z)};
}

}  // namespace linkwright
