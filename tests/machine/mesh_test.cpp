#include "linkwright/machine/mesh.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <map>

#include "algebra/dense.hpp"
#include "linkwright/core/angle.hpp"
#include "support/machine_cases.hpp"

namespace linkwright::mesh_test {
namespace {

/// Each edge is passed once in each sense.
::testing::AssertionResult is_closed(const Mesh& mesh) {
  std::map<std::pair<int, int>, int> edges;
  for (const auto& [a, b, c] : mesh.triangles)
    for (const auto& edge : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      if (edge.first == edge.second) return ::testing::AssertionFailure() << "a triangle without area";
      ++edges[edge];
    }
  for (const auto& [edge, uses] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    if (uses != 1 || back == edges.end()) return ::testing::AssertionFailure() << "an open edge";
  }
  return ::testing::AssertionSuccess();
}

double perimeter(const std::vector<Point>& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) sum += std::abs(polygon[(i + 1) % polygon.size()] - polygon[i]);
  return sum;
}

double area(const std::vector<Point>& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) sum += cross(polygon[i], polygon[(i + 1) % polygon.size()]) / 2;
  return sum;
}

/// Steiner's formula for the area, less the holes.
double exact_volume(const FlatPlate& plate) {
  const double holes = static_cast<double>(plate.holes.size()) * pi * plate.hole_radius * plate.hole_radius;
  return (area(plate.outline) + perimeter(plate.outline) * plate.radius + pi * plate.radius * plate.radius - holes) *
         (plate.high - plate.low);
}

double exact_volume(const RoundPin& pin) { return pi * pin.radius * pin.radius * norm(pin.to - pin.from); }

/// The strip between two parallels and both half caps, less what holes take from the directions.
double exact_volume(const ShellPlate& plate) {
  const double arc = angle_between(plate.from, plate.to);
  const double hole = std::asin(plate.hole_radius / ((plate.low + plate.high) / 2));
  const double directions =
      2 * arc * std::sin(plate.half_angle) + 2 * pi * (1 - std::cos(plate.half_angle)) - 4 * pi * (1 - std::cos(hole));
  return directions * (std::pow(plate.high, 3) - std::pow(plate.low, 3)) / 3;
}

/// Faces of flat plates are covered once, those of shells look out or in: no triangle is folded over.
::testing::AssertionResult is_unfolded(const Part& part, const Mesh& mesh) {
  const auto* plate = std::get_if<FlatPlate>(&part.shape);
  const auto* shell = std::get_if<ShellPlate>(&part.shape);
  for (const auto& [a, b, c] : mesh.triangles) {
    const auto at = [&](int k) { return mesh.vertices[static_cast<std::size_t>(k)]; };
    const Vector3 normal = cross(at(b) - at(a), at(c) - at(a));
    if (!(norm(normal) > 0)) return ::testing::AssertionFailure() << "a triangle without area";
    if (plate != nullptr && at(a).z == at(b).z && at(b).z == at(c).z && (normal.z > 0) != (at(a).z == plate->high))
      return ::testing::AssertionFailure() << "a triangle folded over";
    if (shell == nullptr) continue;
    const auto on = [&](int k, double radius) { return std::abs(norm(at(k)) - radius) < 1e-9 * radius; };
    for (const double radius : {shell->low, shell->high})
      if (on(a, radius) && on(b, radius) && on(c, radius) && (dot(normal, at(a)) > 0) != (radius == shell->high))
        return ::testing::AssertionFailure() << "a triangle folded over";
  }
  return ::testing::AssertionSuccess();
}

TEST(Mesh, IsClosedAndEnclosesWhatTheFormulasSay) {
  for (const Machine& made : testing::machines()) {
    for (const Part& part : made.parts) {
      const double exact = std::visit([](const auto& shape) { return exact_volume(shape); }, part.shape);
      double last = 1;
      for (const double turn : {0.2, 0.1, 0.05}) {
        const Mesh mesh = mesh_of(part, turn);
        EXPECT_TRUE(is_unfolded(part, mesh)) << made.linkage.title << ": " << part.name << ' ' << turn;
        EXPECT_TRUE(is_closed(mesh)) << made.linkage.title << ": " << part.name << ' ' << turn;
        const double error = std::abs(volume(mesh) / exact - 1);
        EXPECT_LT(error, 0.3 * turn * turn) << made.linkage.title << ": " << part.name << ' ' << turn;
        EXPECT_LT(error, last) << made.linkage.title << ": " << part.name;
        last = error;
      }
    }
  }
}

TEST(Mesh, OfATracedPointInAHingeIsClosed) {
  for (const double off : {0.0, 1e-6, 0.01, 0.3}) {
    StoredLinkage stored;
    stored.four_bar = {{0, 0}, {0, 1}, {4, 0}, {3.5, 2.5}};
    stored.point = stored.four_bar.input_moving + Point{off, 0};
    const Machine made = machine(moving_linkage(AnyStoredLinkage(stored))).value();
    EXPECT_EQ(std::get<FlatPlate>(made.parts[2].shape).holes.size(), off < 0.2 ? 2u : 3u) << off;
    for (const Part& part : made.parts) {
      EXPECT_TRUE(is_closed(mesh_of(part))) << off;
      EXPECT_TRUE(is_unfolded(part, mesh_of(part))) << off;
    }
  }
}

TEST(Mesh, OfTheWidestPlatesOfASphereIsBounded) {
  for (const Machine& made : testing::machines()) {
    if (!made.linkage.spherical) continue;
    WantedSizes wanted;
    wanted.width = 0.8 * made.sizes.radius;
    const Machine wide = machine(made.linkage, wanted).value();
    for (const Part& part : wide.parts) {
      const Mesh mesh = mesh_of(part);
      EXPECT_LT(mesh.triangles.size(), 200'000u);
      EXPECT_TRUE(is_closed(mesh));
    }
  }
}

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
}  // namespace linkwright::mesh_test
