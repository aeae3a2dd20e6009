#include "linkwright/algebra/cubic_cone.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "linkwright/core/angle.hpp"

namespace linkwright::cubic_cone_test {
namespace {

class RandomForms {
 public:
  explicit RandomForms(unsigned seed) : random_(seed) {}
  double number() { return number_(random_); }
  Vector3 axis() {
    const double x = number(), y = number();
    return normalized(Vector3{x, y, number()});
  }
  CubicForm form() {
    CubicForm made;
    for (double& c : made.coefficient) c = number();
    return made;
  }
  /// The same with a unit vector on it: less F(v) (v·x)³.
  CubicForm form_through(Vector3 v) {
    CubicForm made = form();
    const double off = made(v);
    const std::array<double, 10> cube = {
        v.x * v.x * v.x,     3 * v.x * v.x * v.y, 3 * v.x * v.x * v.z, 3 * v.x * v.y * v.y, 6 * v.x * v.y * v.z,
        3 * v.x * v.z * v.z, v.y * v.y * v.y,     3 * v.y * v.y * v.z, 3 * v.y * v.z * v.z, v.z * v.z * v.z};
    for (std::size_t k = 0; k < cube.size(); ++k) made.coefficient[k] -= off * cube[k];
    return made;
  }

 private:
  std::mt19937 random_;
  std::normal_distribution<double> number_;
};

CubicForm product(Vector3 plane, const std::array<double, 6>& q) {  // xx xy xz yy yz zz
  const auto [a, b, c] = std::array{plane.x, plane.y, plane.z};
  return {{a * q[0], a * q[1] + b * q[0], a * q[2] + c * q[0], a * q[3] + b * q[1], a * q[4] + b * q[2] + c * q[1],
           a * q[5] + c * q[2], b * q[3], b * q[4] + c * q[3], b * q[5] + c * q[4], c * q[5]}};
}

void expect_all_on_cone(const CubicCone& cone, double accuracy) {
  const double length = cone.branches().back().to;
  for (int i = 0; i < 200; ++i) {
    const double at = length * (i + 0.5) / 200;
    const Vector3 v = cone.axis(at);
    EXPECT_NEAR(norm(v), 1, 1e-14);
    EXPECT_LT(std::abs(cone.form()(v)), accuracy) << at;
    const auto back = cone.coordinate_of(v);
    ASSERT_TRUE(back);
    EXPECT_LT(norm(cross(cone.axis(*back), v)), 1e-7) << at << " " << *back;
  }
}

// Directions of the cone in a plane, by signs along a fine walk: shares nothing with the cone's own way.
std::vector<Vector3> found_by_walking(const CubicForm& form, Vector3 plane) {
  constexpr int steps = 4000;
  const Vector3 p = normalized(cross(plane, Vector3{0.123, 0.77, -0.31})), q = cross(normalized(plane), p);
  const auto at = [&](double t) { return std::cos(t) * p + std::sin(t) * q; };
  std::vector<Vector3> found;
  for (int i = 0; i < steps; ++i) {
    double low = pi * i / steps, high = pi * (i + 1) / steps;
    if ((form(at(low)) < 0) == (form(at(high)) < 0)) continue;
    for (int turn = 0; turn < 60; ++turn) {
      const double middle = 0.5 * (low + high);
      ((form(at(middle)) < 0) == (form(at(low)) < 0) ? low : high) = middle;
    }
    found.push_back(at(low));
  }
  return found;
}

TEST(CubicForm, PolarIsTheFormOnItsDiagonal) {
  RandomForms random(1);
  for (int i = 0; i < 50; ++i) {
    const CubicForm form = random.form();
    const Vector3 a = random.axis(), b = random.axis(), c = random.axis();
    EXPECT_NEAR(form.polar(a, a, a), form(a), 1e-13);
    EXPECT_NEAR(form.polar(a, b, c), form.polar(c, a, b), 1e-13);
    EXPECT_NEAR(form(a + b), form(a) + 3 * form.polar(a, a, b) + 3 * form.polar(a, b, b) + form(b), 1e-12);
    EXPECT_NEAR(dot(form.gradient(a), b), 3 * form.polar(a, a, b), 1e-13);
  }
}

TEST(CubicForm, OfThreeMatricesIsTheirDeterminant) {
  RandomForms random(2);
  for (int i = 0; i < 50; ++i) {
    std::array<Matrix3x3, 3> d;
    for (Matrix3x3& m : d) m = {{random.axis(), random.axis(), random.axis()}};
    const Vector3 v = random.axis();
    EXPECT_NEAR(determinant_form(d)(v), determinant(d[0] * v, d[1] * v, d[2] * v), 1e-14);
  }
}

TEST(CubicCone, EveryCoordinateIsOnTheConeAndComesBack) {
  RandomForms random(3);
  int with_oval = 0;
  for (int i = 0; i < 200; ++i) {
    const Vector3 b = random.axis();
    const CubicCone cone(random.form_through(b), {{b}});
    with_oval += cone.kind() == CubicConeKind::two_components;
    EXPECT_EQ(cone.branches().size(), cone.kind() == CubicConeKind::two_components ? 2u : 1u);
    expect_all_on_cone(cone, 1e-12);
  }
  EXPECT_GT(with_oval, 5);
  EXPECT_LT(with_oval, 195);
}

TEST(CubicCone, NothingOfItIsMissed) {
  RandomForms random(4);
  for (int i = 0; i < 60; ++i) {
    const Vector3 b = random.axis();
    const CubicCone cone(random.form_through(b), {{b}});
    for (int plane = 0; plane < 10; ++plane)
      for (const Vector3 v : found_by_walking(cone.form(), random.axis())) {
        const auto at = cone.coordinate_of(v);
        ASSERT_TRUE(at);
        EXPECT_LT(norm(cross(cone.axis(*at), v)), 1e-8);
      }
  }
}

// On the sphere consecutive samples are near each other, and between branches there is a way across.
TEST(CubicCone, IsContinuousAlongABranch) {
  RandomForms random(5);
  for (int i = 0; i < 50; ++i) {
    const Vector3 b = random.axis();
    const CubicCone cone(random.form_through(b), {{b}});
    for (const CurveBranch& branch : cone.branches()) {
      constexpr int steps = 20'000;
      double longest = 0, run = 0;
      for (int k = 0; k < steps; ++k) {
        const double step = norm(cross(cone.axis(branch.from + (k + 0.0) / steps),
                                       cone.axis(branch.from + std::min((k + 1.0) / steps, 1 - 1e-12))));
        longest = std::max(longest, step);
        run += step;
      }
      EXPECT_LT(longest, 0.2) << "of " << run;
    }
  }
}

TEST(CubicCone, TakesApartAPlaneAndAQuadraticCone) {
  RandomForms random(6);
  for (int i = 0; i < 30; ++i) {
    const Vector3 plane = random.axis();
    const CubicCone cone(product(plane, {1, 0.2, -0.1, 2, 0.3, -1.5}), {});
    EXPECT_EQ(cone.kind(), CubicConeKind::great_circle_and_cone);
    ASSERT_EQ(cone.branches().size(), 2u);
    EXPECT_EQ(cone.branches()[0].name, "great_circle");
    EXPECT_LT(std::abs(dot(cone.axis(0.3), plane)), 1e-12);
    expect_all_on_cone(cone, 1e-12);
  }
}

TEST(CubicCone, TakesApartPlanes) {
  const CubicCone three({{0, 0, 0, 0, 1, 0, 0, 0, 0, 0}}, {});  // x y z
  EXPECT_EQ(three.kind(), CubicConeKind::great_circles);
  EXPECT_EQ(three.branches().size(), 3u);
  expect_all_on_cone(three, 1e-13);
  const CubicCone one(product({1, 2, 3}, {1, 0, 0, 1, 0, 1}), {});  // and a cone with no real line
  EXPECT_EQ(one.kind(), CubicConeKind::great_circles);
  EXPECT_EQ(one.branches().size(), 1u);
  const CubicCone with_line(product({1, 2, 3}, {1, 0, 0, 1, 0, 0}), {});  // and x² + y² = 0, the line z
  ASSERT_EQ(with_line.branches().size(), 2u);
  EXPECT_EQ(with_line.branches()[1].name, "point");
  EXPECT_LT(norm(cross(with_line.axis(1.7), Vector3{0, 0, 1})), 1e-12);
  EXPECT_GE(*with_line.coordinate_of({0, 0, 1}), 1);
  const CubicCone twice(product({1, 0, 0}, {0, 0, 0, 1, 0, 0}), {});  // x y²
  EXPECT_EQ(twice.branches().size(), 2u);
}

// A plane and an isolated line, all but for 1e-8: nothing of it may be lost.
TEST(CubicCone, NearlyAProductIsTakenForOne) {
  CubicForm form = product({1, 2, 3}, {1, 0, 0, 1, 0, 0});
  form.coefficient[4] += 1e-8;
  const CubicCone cone(form, {});
  EXPECT_EQ(cone.kind(), CubicConeKind::great_circles);
  for (double at = 0.05; at < 2; at += 0.1) EXPECT_LT(std::abs(cone.form()(cone.axis(at))), 1e-8);
}

TEST(CubicCone, PassesStraightThroughANode) {
  const CubicCone cone({{1, 0, 1, 0, 0, 0, 0, -1, 0, 0}}, {{{0, 1, 0}}});  // x³ + x²z = y²z: node at z
  EXPECT_EQ(cone.kind(), CubicConeKind::nodal);
  ASSERT_EQ(cone.branches().size(), 1u);
  EXPECT_EQ(cone.branches()[0].name, "nodal");
  expect_all_on_cone(cone, 1e-12);
  const CubicCone seen_from_node({{1, 0, 1, 0, 0, 0, 0, -1, 0, 0}}, {{{0, 0, 1}}});
  EXPECT_EQ(seen_from_node.kind(), CubicConeKind::nodal);
  expect_all_on_cone(seen_from_node, 1e-12);
  const CubicCone isolated({{1, 0, -1, 0, 0, 0, 0, -1, 0, 0}}, {{{0, 1, 0}}});  // x³ = x²z + y²z
  EXPECT_EQ(isolated.kind(), CubicConeKind::nodal);
  ASSERT_EQ(isolated.branches().size(), 2u);
  EXPECT_EQ(isolated.branches()[0].name, "odd");
  EXPECT_EQ(isolated.branches()[1].name, "point");
  EXPECT_LT(norm(cross(isolated.axis(1.3), Vector3{0, 0, 1})), 1e-14);
}

TEST(CubicCone, OfNoFormIsEveryAxis) {
  const CubicCone cone({}, {});
  EXPECT_EQ(cone.kind(), CubicConeKind::every_axis);
  EXPECT_TRUE(cone.branches().empty());
  EXPECT_FALSE(cone.coordinate_of({1, 0, 0}));
  EXPECT_EQ(name(cone.kind()), "every_axis");
}

// Against the signs of F all round the circle of lines at that angle.
TEST(LinesAtAngle, AreAllThatThereAre) {
  RandomForms random(44);
  int found = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const CubicForm form = random.form();
    const Vector3 axis = 3 * random.axis();
    const double angle = 0.05 + 1.4 * trial / 200;
    const auto lines = lines_at_angle(form, axis, angle);
    ASSERT_TRUE(lines);
    for (const Vector3 line : *lines) {
      EXPECT_NEAR(form(line), 0, 1e-9 * form.largest_coefficient());
      EXPECT_NEAR(std::abs(dot(line, normalized(axis))), std::cos(angle), 1e-12);
    }
    const Vector3 e = normalized(axis),
                  u = normalized(cross(e, std::abs(e.x) < 0.9 ? Vector3{1, 0, 0} : Vector3{0, 1, 0})), v = cross(e, u);
    constexpr int steps = 20000;
    int changes = 0;
    const auto value = [&](int i) {
      const double turn = two_pi * i / steps;
      return form(std::cos(angle) * e + std::sin(angle) * (std::cos(turn) * u + std::sin(turn) * v));
    };
    for (int i = 0; i < steps; ++i) changes += (value(i) < 0) != (value(i + 1) < 0);
    EXPECT_EQ(std::ssize(*lines), changes) << trial;
    found += changes;
  }
  EXPECT_GT(found, 300);
}

TEST(LinesAtAngle, AreNotToldWhereAllLieOnTheCone) {
  // (x² + y² − z² tan² 30°) z
  const double square = 1.0 / 3;
  const CubicForm form{{0, 0, 1, 0, 0, 0, 0, 1, 0, -square}};
  EXPECT_FALSE(lines_at_angle(form, {0, 0, 2}, radians(30)));
  EXPECT_TRUE(lines_at_angle(form, {0, 0, 2}, radians(31)));
}

}  // namespace
}  // namespace linkwright::cubic_cone_test
