#include "linkwright/machine/mass_properties.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "algebra/dense.hpp"
#include "linkwright/core/angle.hpp"
#include "support/machine_cases.hpp"

namespace linkwright::mass_properties_test {
namespace {

constexpr double accuracy = 2e-4;

void expect_near(const Matrix3x3& found, const Matrix3x3& exact) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(found(i, k), exact(i, k), accuracy * trace(exact)) << i << k;
}

Matrix3x3 diagonal(double x, double y, double z) { return {{{{x, 0, 0}, {0, y, 0}, {0, 0, z}}}}; }

TEST(MassProperties, OfACylinderAreThoseOfTheTextbook) {
  const double r = 4, h = 20, mass = 2e-6 * pi * r * r * h;
  const Vector3 axis = normalized(Vector3{1, 2, 2}), from{300, -20, 5};
  const auto found = mass_properties(mesh_of(Part{"pin", 0, RoundPin{from, from + h * axis, r}}, 0.02), 2000, 0.001);
  EXPECT_NEAR(found.mass, mass, accuracy * mass);
  EXPECT_LT(norm(found.centre - 0.001 * (from + h / 2 * axis)), 1e-9);
  const double along = mass * r * r / 2 * 1e-6, across = mass * (3 * r * r + h * h) / 12 * 1e-6;
  expect_near(found.inertia, across * Matrix3x3::identity() + (along - across) * dyadic_product(axis, axis));
}

/// A box, two half discs about their common centre, moved apart, less two holes.
TEST(MassProperties, OfARoundedBarWithHolesAreThoseOfItsPieces) {
  const double length = 100, r = 10, hole = 3, t = 6;
  const FlatPlate plate{{{0, 0}, {length, 0}}, {{0, 0}, {length, 0}}, r, hole, 2, 2 + t};
  const auto found = mass_properties(mesh_of(Part{"bar", 0, plate}, 0.02), 1, 1);
  const double box = length * 2 * r * t, disc = pi * r * r * t, bore = pi * hole * hole * t, half = length / 2;
  const double mass = box + disc - 2 * bore;
  EXPECT_NEAR(found.mass, mass, accuracy * mass);
  EXPECT_LT(norm(found.centre - Vector3{half, 0, 2 + t / 2}), 1e-6 * length);
  // ∫ x² over a half disc that lies `half` off: its own, twice its first moment, and that of its middle.
  const double xx = box * length * length / 12 + disc * r * r / 4 + 2 * half * (4 * r * r * r / 3 * t) +
                    disc * half * half - 2 * bore * (hole * hole / 4 + half * half);
  const double yy = box * r * r / 3 + disc * r * r / 4 - 2 * bore * hole * hole / 4, zz = mass * t * t / 12;
  expect_near(found.inertia, diagonal(yy + zz, xx + zz, xx + yy));
}

/// A shell so thin and narrow that it is a bent wire; its mass as the mesh's volume says.
TEST(MassProperties, OfANarrowShellAreThoseOfAnArc) {
  const double radius = 50, arc = pi / 2;
  const ShellPlate plate{{1, 0, 0}, {0, 1, 0}, 1e-3, 1e-3, radius - 0.05, radius + 0.05};
  const auto found = mass_properties(mesh_of(Part{"shell", 0, plate}, 0.05), 1, 1);
  const double middle = radius * std::sin(arc / 2) / (arc / 2) / std::sqrt(2.0);
  EXPECT_LT(norm(found.centre - Vector3{middle, middle, 0}), 5e-3 * radius);
  EXPECT_NEAR(found.inertia(2, 2), found.mass * (radius * radius - 2 * middle * middle),
              1e-2 * found.mass * radius * radius);
}

double whole_mass(const Machine& machine, double density = steel_density) {
  double sum = 0;
  for (int body = 0; body < static_cast<int>(machine.linkage.bodies.size()); ++body)
    sum += mass_properties(machine, body, density).mass;
  return sum;
}

TEST(MassProperties, AddUpToAllParts) {
  for (const Machine& made : testing::machines()) {
    const double metre = made.linkage.millimetres() / 1000;
    double parts = 0;
    for (const Part& part : made.parts) parts += steel_density * std::pow(metre, 3) * volume(mesh_of(part, 0.04));
    EXPECT_NEAR(whole_mass(made), parts, 1e-9 * parts) << made.linkage.title;
    EXPECT_NEAR(whole_mass(made, 2 * steel_density), 2 * parts, 1e-9 * parts) << made.linkage.title;
  }
}

TEST(MassProperties, AreThoseOfMatter) {
  for (const Machine& made : testing::machines())
    for (int body = 0; body < static_cast<int>(made.linkage.bodies.size()); ++body) {
      const Matrix3x3 inertia = mass_properties(made, body).inertia;
      EXPECT_LT(frobenius_norm(inertia - transposed(inertia)), 1e-12 * frobenius_norm(inertia));
      const auto principal = principal_axes(inertia).values;
      EXPECT_GT(principal[0], 0);
      EXPECT_GT(principal[0] + principal[1], principal[2]);
    }
}

}  // namespace
}  // namespace linkwright::mass_properties_test
