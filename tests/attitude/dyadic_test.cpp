#include "attitude/dyadic.hpp"

#include <gtest/gtest.h>

namespace linkwright::dyadic_test {
namespace {

// Small whole numbers: every result below is exact.
constexpr Vector3 a{1, 2, -3}, b{-4, 4, 1}, c{2, 0, 7}, d{0, -1, 5};

TEST(Dyadic, TakesAVectorOnEitherSide) {
  EXPECT_EQ(dot(Dyadic(a, b), c), dot(b, c) * a);
  EXPECT_EQ(dot(c, Dyadic(a, b)), dot(c, a) * b);
  EXPECT_EQ(dot(Dyadic(), c), Vector3{});
}

TEST(Dyadic, IsTheSumOfItsDyads) {
  const Dyadic sum = Dyadic(a, b) + 2 * Dyadic(c, d);
  EXPECT_EQ(sum.dyads().size(), 2U);
  EXPECT_EQ(dot(sum, c), dot(b, c) * a + 2 * dot(d, c) * c);
  EXPECT_EQ(sum.matrix(), dyadic_product(a, b) + 2 * dyadic_product(c, d));
  EXPECT_EQ(sum.matrix() * a, dot(sum, a));
}

TEST(Dyadic, UnitLeavesEveryVector) {
  EXPECT_EQ(dot(Dyadic::unit(), a), a);
  EXPECT_EQ(dot(a, Dyadic::unit()), a);
  EXPECT_EQ(Dyadic::unit().matrix(), Matrix3x3::identity());
}

TEST(Dyadic, CrossIsTheCrossProduct) {
  EXPECT_EQ(dot(Dyadic::cross(a), b), cross(a, b));
  EXPECT_EQ(dot(b, Dyadic::cross(a)), cross(b, a));
  EXPECT_EQ(Dyadic::cross(a).matrix(), skew_matrix(a));
}

TEST(Dyadic, CrossTwiceProjects) {
  // (p×)·(p×) = pp − p² E
  const Dyadic twice = dot(Dyadic::cross(a), Dyadic::cross(a));
  EXPECT_EQ(twice.matrix(), (Dyadic(a, a) + -dot(a, a) * Dyadic::unit()).matrix());
}

TEST(Dyadic, ProductIsOneAfterTheOther) {
  const Dyadic first = Dyadic(a, b) + Dyadic::cross(c), second = Dyadic(c, d) + Dyadic::unit();
  EXPECT_EQ(dot(dot(second, first), a), dot(second, dot(first, a)));
  EXPECT_EQ(dot(second, first).matrix(), second.matrix() * first.matrix());
}

TEST(Dyadic, ConjugateScalarAndVector) {
  const Dyadic sum = Dyadic(a, b) + Dyadic(c, d);
  EXPECT_EQ(sum.conjugate().matrix(), transposed(sum.matrix()));
  EXPECT_EQ(sum.scalar(), trace(sum.matrix()));
  EXPECT_EQ(sum.vector(), -2 * axial_vector(sum.matrix()));
}

}  // namespace
}  // namespace linkwright::dyadic_test
