#include "linkwright/machine/mesh.hpp"

#include <gtest/gtest.h>
#include <map>

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

TEST(Mesh, IsClosedAndEnclosesWhatTheFormulasSay) {
  for (const Machine& made : testing::machines()) {
    for (const Part& part : made.parts) {
      const double exact = std::visit([](const auto& shape) { return exact_volume(shape); }, part.shape);
      double last = 1;
      for (const double turn : {0.2, 0.1, 0.05}) {
        const Mesh mesh = mesh_of(part, turn);
        EXPECT_TRUE(is_closed(mesh)) << made.linkage.title << ": " << part.name << ' ' << turn;
        const double error = std::abs(volume(mesh) / exact - 1);
        EXPECT_LT(error, 0.3 * turn * turn) << made.linkage.title << ": " << part.name << ' ' << turn;
        EXPECT_LT(error, last) << made.linkage.title << ": " << part.name;
        last = error;
      }
    }
  }
}

}  // namespace
}  // namespace linkwright::mesh_test
