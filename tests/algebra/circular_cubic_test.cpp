#include "linkwright/algebra/circular_cubic.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "linkwright/core/angle.hpp"

namespace linkwright::circular_cubic_test {
namespace {

// (x + a)(x² + y²) + dx + ey with the focus and the axis anywhere.
PlaneCubic focal_cubic(double a, double d, double e, Point focus, double axis) {
  const double c = std::cos(axis), s = std::sin(axis);
  // x = c X + s Y, y = −s X + c Y with X = x' − f₁w, Y = y' − f₂w.
  std::array<double, 10> shifted{};  // in X, Y
  const double lead_x = c, lead_y = s;
  shifted[6] = lead_x, shifted[7] = lead_y, shifted[8] = lead_x, shifted[9] = lead_y;
  shifted[3] = a, shifted[5] = a;
  shifted[1] = d * c - e * s, shifted[2] = d * s + e * c;
  const double f = focus.real(), g = focus.imag();
  PlaneCubic cubic;
  auto& k = cubic.coefficient;
  k[6] = shifted[6], k[7] = shifted[7], k[8] = shifted[8], k[9] = shifted[9];
  k[3] = shifted[3] - 3 * f * shifted[6] - g * shifted[7];
  k[4] = -2 * f * shifted[7] - 2 * g * shifted[8];
  k[5] = shifted[5] - f * shifted[8] - 3 * g * shifted[9];
  k[1] = shifted[1] - 2 * f * shifted[3] + 3 * f * f * shifted[6] + 2 * f * g * shifted[7] + g * g * shifted[8];
  k[2] = shifted[2] - 2 * g * shifted[5] + f * f * shifted[7] + 2 * f * g * shifted[8] + 3 * g * g * shifted[9];
  k[0] = -f * shifted[1] - g * shifted[2] + f * f * shifted[3] + g * g * shifted[5] - f * f * f * shifted[6] -
         f * f * g * shifted[7] - f * g * g * shifted[8] - g * g * g * shifted[9];
  return cubic;
}

void expect_on_curve(const PlaneCubic& cubic, const CircularCubic& curve, double tau) {
  const Homogeneous p = curve.point(tau);
  EXPECT_NEAR(norm(p), 1, 1e-14);
  EXPECT_LT(std::abs(cubic(p)), 1e-12 * cubic.largest_coefficient()) << "tau " << tau;
}

struct Shape {
  double a, d, e;
  CubicKind kind;
};

class FocalCubic : public ::testing::TestWithParam<Shape> {};

TEST_P(FocalCubic, IsRecognisedAndAllItsPointsSatisfyItsEquation) {
  const Shape shape = GetParam();
  for (const double axis : {0.0, 0.7, 2.5, -1.9}) {
    const PlaneCubic cubic = focal_cubic(shape.a, shape.d, shape.e, {0.4, -0.3}, axis);
    const CircularCubic curve(cubic);
    ASSERT_EQ(curve.kind(), shape.kind) << name(curve.kind());
    for (int i = 0; i < 500; ++i) expect_on_curve(cubic, curve, curve.branches().back().to * (i + 0.5) / 500);
  }
}

TEST_P(FocalCubic, CoordinateOfIsTheInverseOfPoint) {
  const Shape shape = GetParam();
  const CircularCubic curve(focal_cubic(shape.a, shape.d, shape.e, {0.4, -0.3}, 0.7));
  for (int i = 0; i < 500; ++i) {
    const double tau = curve.branches().back().to * (i + 0.25) / 500;
    const auto found = curve.coordinate_of(curve.point(tau));
    ASSERT_TRUE(found);
    EXPECT_LT(great_circle(curve.point(*found), curve.point(tau)), 1e-9);
  }
}

TEST_P(FocalCubic, IsContinuousWithinABranchAndClosed) {
  const Shape shape = GetParam();
  const CircularCubic curve(focal_cubic(shape.a, shape.d, shape.e, {0.4, -0.3}, 0.7));
  constexpr int steps = 20'000;
  for (const CurveBranch& branch : curve.branches()) {
    if (branch.from == branch.to) continue;
    Homogeneous before = curve.point(branch.from);
    for (int i = 1; i < steps; ++i) {
      const Homogeneous p = curve.point(branch.from + (branch.to - branch.from) * i / steps);
      EXPECT_LT(great_circle(before, p), 0.02);
      before = p;
    }
    EXPECT_LT(great_circle(before, curve.point(branch.from)), 0.02);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, FocalCubic,
    ::testing::Values(Shape{1, -0.5, 1.1, CubicKind::one_branch}, Shape{1, -0.5, 0.1, CubicKind::two_branches},
                      Shape{2, 0.3, 0.2, CubicKind::two_branches}, Shape{0, 0.7, 0.4, CubicKind::one_branch},
                      Shape{1, -1, std::sqrt(1.25), CubicKind::nodal}, Shape{0, -2, 0, CubicKind::line_and_circle},
                      Shape{0, 2, 0, CubicKind::line}, Shape{1, 0, 0, CubicKind::line_and_point}));

TEST(CircularCubic, MeetsEveryRandomLineWhereTheCurveIs) {
  // Completeness: each real intersection with a line is a point(τ).
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> number(-2, 2);
  for (int trial = 0; trial < 300; ++trial) {
    const PlaneCubic cubic =
        focal_cubic(number(random), number(random), number(random), {number(random), number(random)}, number(random));
    const CircularCubic curve(cubic);
    const Homogeneous p{1, number(random), number(random)}, q{1, number(random), number(random)};
    double before = cubic(p);
    for (int i = 1; i <= 2000; ++i) {
      const double t = pi * i / 2000;
      const Homogeneous at = std::cos(t) * p + std::sin(t) * q;
      const double value = cubic(at);
      if (before * value < 0) {
        double low = pi * (i - 1) / 2000, high = t;
        for (int k = 0; k < 60; ++k) {
          const double middle = (low + high) / 2;
          (cubic(std::cos(middle) * p + std::sin(middle) * q) * before > 0 ? low : high) = middle;
        }
        const Homogeneous root = normalized(std::cos(low) * p + std::sin(low) * q);
        const auto tau = curve.coordinate_of(root);
        ASSERT_TRUE(tau);
        EXPECT_LT(great_circle(curve.point(*tau), root), 1e-7) << trial;
      }
      before = value;
    }
  }
}

TEST(CircularCubic, KappaIsInvariantUnderScaleAndMotion) {
  const auto kappa = [](double scale, double angle, Point focus) {
    return *CircularCubic(focal_cubic(1 * scale, -0.5 * scale * scale, 0.8 * scale * scale, focus, angle)).kappa();
  };
  EXPECT_NEAR(kappa(1, 0, 0), kappa(0.3, 1.1, {0.5, 0.2}), 1e-12);
}

TEST(CircularCubic, NodeIsWhereTwoCoordinatesMeet) {
  const CircularCubic curve(focal_cubic(1, -1, std::sqrt(1.25), {0, 0}, 0));
  ASSERT_EQ(curve.kind(), CubicKind::nodal);
  EXPECT_LT(great_circle(curve.point(0.25), curve.point(0.75)), 1e-7);
  ASSERT_EQ(curve.double_points().size(), 1u);
  EXPECT_LT(great_circle(curve.double_points()[0], curve.point(0.25)), 1e-12);
}

PlaneCubic line_at_infinity_times(std::array<double, 6> conic) {
  PlaneCubic cubic;
  for (std::size_t i = 0; i < 6; ++i) cubic.coefficient[i] = conic[i];
  return cubic;
}

TEST(CircularCubic, RecognisesWhatBelongsToTheLineAtInfinity) {
  const auto kind = [](std::array<double, 6> conic) { return CircularCubic(line_at_infinity_times(conic)).kind(); };
  EXPECT_EQ(kind({-1, 0, 0, 1, 0, 1}), CubicKind::line_at_infinity_and_conic);   // circle
  EXPECT_EQ(kind({-1, 0, 0, 1, 0, -1}), CubicKind::line_at_infinity_and_conic);  // hyperbola
  EXPECT_EQ(kind({0, 0, 0, 1, 0, -1}), CubicKind::line_at_infinity_and_lines);
  EXPECT_EQ(kind({0, 0, 0, 1, 2, 1}), CubicKind::line_at_infinity_and_lines);  // a double line
  EXPECT_EQ(kind({1, 0, 0, 1, 0, 1}), CubicKind::line);                        // no real point beside
  EXPECT_EQ(kind({0, 0, 0, 1, 0, 1}), CubicKind::line_and_point);
  EXPECT_EQ(CircularCubic(PlaneCubic{}).kind(), CubicKind::every_point);
}

TEST(CircularCubic, PointsOfReducibleCurvesWithTheLineAtInfinitySatisfyTheEquation) {
  for (const std::array<double, 6>& conic : {std::array<double, 6>{-1, 0.2, 0.1, 1, 0.3, 1},
                                             {-1, 0.4, 0, 1, 0.1, -1},
                                             {0, 0.3, 0, 1, 0, 0},
                                             {0, 0, 0, 1, 0.5, -1}}) {
    const PlaneCubic cubic = line_at_infinity_times(conic);
    const CircularCubic curve(cubic);
    for (int i = 0; i < 300; ++i) expect_on_curve(cubic, curve, curve.branches().back().to * (i + 0.5) / 300);
    for (const Homogeneous p : curve.double_points()) EXPECT_LT(norm(cubic.gradient(p)), 1e-9);
  }
}

TEST(PlaneCubic, GradientIsTheDerivative) {
  const PlaneCubic cubic = focal_cubic(0.7, -0.4, 0.9, {0.3, 0.1}, 0.4);
  const Homogeneous p{0.8, -0.3, 0.5}, g = cubic.gradient(p);
  constexpr double h = 1e-6;
  EXPECT_NEAR((cubic({p.w + h, p.x, p.y}) - cubic({p.w - h, p.x, p.y})) / (2 * h), g.w, 1e-8);
  EXPECT_NEAR((cubic({p.w, p.x + h, p.y}) - cubic({p.w, p.x - h, p.y})) / (2 * h), g.x, 1e-8);
  EXPECT_NEAR((cubic({p.w, p.x, p.y + h}) - cubic({p.w, p.x, p.y - h})) / (2 * h), g.y, 1e-8);
}

TEST(DeterminantCubic, EqualsTheDeterminantItStandsFor) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> number(-1, 1);
  const auto vector = [&] { return Homogeneous{number(random), number(random), number(random)}; };
  for (int trial = 0; trial < 100; ++trial) {
    std::array<HomogeneousMatrix, 3> a;
    for (HomogeneousMatrix& m : a) m = {{{vector(), vector(), vector()}}};
    const Homogeneous p = vector();
    EXPECT_NEAR(determinant_cubic(a)(p), determinant(p * a[0], p * a[1], p * a[2]), 1e-13);
  }
}

TEST(CircularCubic, ItsAsymptoteIsTheTangentAtItsPointAtInfinity) {
  // (x + 2)(x² + y²) + 3x − y = 0: the asymptote is x = −2.
  const CircularCubic curve(PlaneCubic{{0, 3, -1, 2, 0, 2, 1, 0, 1, 0}});
  const auto asymptote = curve.asymptote();
  ASSERT_TRUE(asymptote);
  EXPECT_NEAR((*asymptote)[0].real(), -2, 1e-12);
  EXPECT_NEAR(std::abs((*asymptote)[1].imag()), 1, 1e-12);
  // A line and a circle: x(x² + y² − 1).
  EXPECT_FALSE(CircularCubic(PlaneCubic{{0, -1, 0, 0, 0, 0, 1, 0, 1, 0}}).asymptote());
}

}  // namespace
}  // namespace linkwright::circular_cubic_test
