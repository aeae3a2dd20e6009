#pragma once

#include <functional>
#include <gtest/gtest.h>
#include <random>
#include <string>

namespace linkwright::testing {

/// A group as the laws see it: elements with a product, T() the identity.
template <class T>
struct Group {
  std::function<T(std::mt19937_64&)> random;
  std::function<T(const T&)> inverse;
  std::function<double(const T&, const T&)> ulps_between;  ///< of the sizes at hand
};

/// What every group keeps: inverses, the identity, association, the inverse of a product; each to `largest` ulps.
template <class T>
void expect_group_laws(const Group<T>& group, double largest, int count = 1000) {
  std::mt19937_64 random(7);
  double worst = 0;
  const auto compare = [&](const char* law, const T& a, const T& b) {
    const double ulps = group.ulps_between(a, b);
    worst = ulps > worst ? ulps : worst;
    EXPECT_LE(ulps, largest) << law;
  };
  for (int i = 0; i < count && !::testing::Test::HasFailure(); ++i) {
    const T a = group.random(random), b = group.random(random), c = group.random(random);
    compare("a a⁻¹ = 1", a * group.inverse(a), T());
    compare("a⁻¹ a = 1", group.inverse(a) * a, T());
    compare("1 a = a", T() * a, a);
    compare("a 1 = a", a * T(), a);
    compare("(a b) c = a (b c)", (a * b) * c, a * (b * c));
    compare("(a b)⁻¹ = b⁻¹ a⁻¹", group.inverse(a * b), group.inverse(b) * group.inverse(a));
    compare("(a⁻¹)⁻¹ = a", group.inverse(group.inverse(a)), a);
  }
  ::testing::Test::RecordProperty("worst_ulps", std::to_string(worst));
}

/// A product acts as its factors one after the other, and the inverse undoes what the element does.
template <class T, class Point>
void expect_action_laws(const Group<T>& group, const std::function<Point(const T&, const Point&)>& act,
                        const std::function<Point(std::mt19937_64&)>& random_point,
                        const std::function<double(const Point&, const Point&)>& ulps, double largest,
                        int count = 1000) {
  std::mt19937_64 random(11);
  for (int i = 0; i < count && !::testing::Test::HasFailure(); ++i) {
    const T a = group.random(random), b = group.random(random);
    const Point p = random_point(random);
    EXPECT_LE(ulps(act(a * b, p), act(a, act(b, p))), largest) << "(a b) p = a (b p)";
    EXPECT_LE(ulps(act(group.inverse(a), act(a, p)), p), largest) << "a⁻¹ (a p) = p";
    EXPECT_LE(ulps(act(T(), p), p), 0) << "1 p = p";
  }
}

}  // namespace linkwright::testing
