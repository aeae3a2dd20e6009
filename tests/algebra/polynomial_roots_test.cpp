#include "algebra/polynomial_roots.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace linkwright::polynomial_roots_test {
namespace {

using Coefficients = std::vector<double>;

Coefficients with_roots(const std::vector<double>& roots) {
  Coefficients c = {1};
  for (const double root : roots) {
    c.push_back(0);
    for (std::size_t k = c.size(); k-- > 0;) c[k] = (k > 0 ? c[k - 1] : 0) - root * c[k];
  }
  return c;
}

TEST(PolynomialRoots, FindsAllThatItWasMadeFrom) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> place(-2, 2);
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<double> roots;
    for (int k = 0; k < 1 + trial % 7; ++k) roots.push_back(place(random));
    std::sort(roots.begin(), roots.end());
    for (std::size_t k = 1; k < roots.size(); ++k) roots[k] = std::max(roots[k], roots[k - 1] + 0.05);
    std::vector<double> expected;
    for (const double root : roots)
      if (root > -1 && root < 1) expected.push_back(root);
    const auto found = sign_changes_within(with_roots(roots), -1, 1);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t k = 0; k < found.size(); ++k) EXPECT_NEAR(found[k], expected[k], 1e-7);
  }
}

TEST(PolynomialRoots, FindsThemToTheLastDigits) {
  const auto cube = sign_changes_within(Coefficients{-2, 0, 0, 1}, -3, 2);
  ASSERT_EQ(cube.size(), 1U);
  EXPECT_DOUBLE_EQ(cube[0], std::cbrt(2.0));
  const auto tiny = sign_changes_within(Coefficients{-1e-30, 1, 7, 40}, -1, 1);
  ASSERT_EQ(tiny.size(), 1U);
  EXPECT_DOUBLE_EQ(tiny[0], 1e-30);
}

TEST(PolynomialRoots, AreExactToTheLastDigits) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> coefficient(-1, 1), place(-1, 1);
  for (int trial = 0; trial < 3000; ++trial) {
    Coefficients c;
    for (int k = 0; k < 2 + trial % 13; ++k) c.push_back(coefficient(random));
    const double at = place(random);
    c[1] += c[1] < 0 ? -40 : 40;  // monotone
    c[0] -= polynomial_value(c, at);
    for (const double root : {sign_change_between(c, -1, 1), sign_change_between(c, 1, -1)}) {
      EXPECT_NEAR(root, at, 1e-15);
      EXPECT_NEAR(polynomial_value(c, root), 0, 1e-14);
    }
  }
  EXPECT_EQ(sign_change_between(Coefficients{-1, 1}, 1, 2), 1);
  EXPECT_NEAR(sign_change_between(with_roots({0.25, 0.25, 0.25}), -3, 5), 0.25, 1e-4);
}

TEST(PolynomialRoots, WhereItOnlyTouchesIsNoSignChange) {
  EXPECT_TRUE(sign_changes_within(with_roots({0.5, 0.5}), 0, 1).empty());
  EXPECT_EQ(sign_changes_within(with_roots({0.5, 0.5, 0.5}), 0, 1).size(), 1U);
  EXPECT_EQ(sign_changes_within(with_roots({0, 0, 0}), -1, 1).size(), 1U);
}

TEST(PolynomialRoots, ConstantsAndBeginningsHaveNone) {
  EXPECT_TRUE(sign_changes_within(Coefficients{3}, -1, 1).empty());
  EXPECT_TRUE(sign_changes_within(Coefficients{0, 0, 0}, -1, 1).empty());
  EXPECT_TRUE(sign_changes_within(with_roots({0}), 0, 1).empty());
  EXPECT_DOUBLE_EQ(polynomial_value(Coefficients{1, 2, 3}, 2), 17);
}

}  // namespace
}  // namespace linkwright::polynomial_roots_test
