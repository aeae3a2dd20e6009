#include "linkwright/algebra/power_series.hpp"

#include <gtest/gtest.h>

namespace linkwright::power_series_test {
namespace {

constexpr std::size_t order = 8;
using Real = RealSeries<order>;

const Real some{{0.7, -1.2, 0.4, 0.9, -0.3, 0.25, 1.1, -0.6, 0.2}};
const Real other{{1.3, 0.5, -0.8, 0.1, 0.7, -0.2, 0.3, 0.9, -1.4}};

void expect_near(const Real& a, const Real& b) {
  for (std::size_t k = 0; k <= order; ++k) EXPECT_NEAR(a.c[k], b.c[k], 1e-12) << k;
}

TEST(PowerSeries, TellsItsFunction) {
  const Real geometric = Real::constant(1) / (Real::constant(2) - Real::variable(1));  // 1 / (1 − t)
  for (const double c : geometric.c) EXPECT_DOUBLE_EQ(c, 1);
  EXPECT_NEAR(geometric(0.1), 1 / 0.9, 1e-8);
  EXPECT_DOUBLE_EQ(geometric.derivative(5), 120);
}

TEST(PowerSeries, QuotientsUndoProducts) { expect_near(some * other / other, some); }

TEST(PowerSeries, RootsUndoSquares) { expect_near(square_root(other * other), other); }

TEST(PowerSeries, RotationsHaveUnitLengthAndAddTheirAngles) {
  const auto turned = rotation(some), both = rotation(some + other), product = turned * rotation(other);
  auto mirrored = turned;
  for (auto& c : mirrored.c) c = std::conj(c);
  const auto square = turned * mirrored;
  for (std::size_t k = 0; k <= order; ++k) {
    EXPECT_NEAR(std::abs(square.c[k] - (k == 0 ? 1.0 : 0.0)), 0, 1e-13);
    EXPECT_NEAR(std::abs(product.c[k] - both.c[k]), 0, 1e-12);
  }
  EXPECT_NEAR(std::abs(turned(0.01) - std::polar(1.0, some(0.01))), 0, 1e-14);
}

TEST(PowerSeries, InverseUndoesTheFunction) {
  Real from_zero = some;
  from_zero.c[0] = 0;
  const Real t = inverse(some);
  expect_near(composed(from_zero, t), Real::variable(0));
  Real sine, arcsine;  // sin t = t − t³/6 + …
  double factorial = 1;
  for (std::size_t k = 1; k <= order; ++k) {
    factorial *= static_cast<double>(k);
    if (k % 2 == 1) sine.c[k] = (k % 4 == 1 ? 1 : -1) / factorial;
  }
  arcsine.c = {0, 1, 0, 1.0 / 6, 0, 3.0 / 40, 0, 15.0 / 336, 0};
  expect_near(inverse(sine), arcsine);
}

}  // namespace
}  // namespace linkwright::power_series_test
