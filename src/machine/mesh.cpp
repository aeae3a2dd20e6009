#include "linkwright/machine/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "linkwright/core/angle.hpp"
#include "machine/flat_pattern.hpp"

namespace linkwright {
namespace {

/// A pattern lifted onto two surfaces, with walls between them where it ends.
template <class Lift>
Mesh thickened(const FlatPattern& pattern, Lift lift) {
  Mesh mesh;
  const int count = static_cast<int>(pattern.points.size());
  for (const bool upper : {false, true})
    for (const Point point : pattern.points) mesh.vertices.push_back(lift(point, upper));
  std::map<std::pair<int, int>, int> edges;
  for (const auto& [a, b, c] : pattern.triangles) {
    mesh.triangles.push_back({a + count, b + count, c + count});
    mesh.triangles.push_back({a, c, b});
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) ++edges[{from, to}];
  }
  for (const auto& [edge, uses] : edges) {
    const auto [from, to] = edge;
    if (edges.contains({to, from})) continue;
    mesh.triangles.push_back({from, to, to + count});
    mesh.triangles.push_back({from, to + count, from + count});
  }
  return mesh;
}

Mesh mesh_of_shape(const FlatPlate& plate, double turn) {
  std::vector<PatternSite> sites;
  for (const Point hole : plate.holes) sites.push_back({hole, circle(hole, plate.hole_radius, turn)});
  return thickened(flat_pattern(rounded(plate.outline, plate.radius, turn), sites), [&](Point point, bool upper) {
    return Vector3{point.real(), point.imag(), upper ? plate.high : plate.low};
  });
}

/// Longitude along the arc and latitude beside it.
class ArcChart {
 public:
  explicit ArcChart(const ShellPlate& plate)
      : along_(plate.from), normal_(normalized(cross(plate.from, plate.to))), across_(cross(normal_, along_)) {}

  [[nodiscard]] Vector3 direction_at(Point place) const {
    const double x = std::cos(place.imag());
    return x * (std::cos(place.real()) * along_ + std::sin(place.real()) * across_) + std::sin(place.imag()) * normal_;
  }
  [[nodiscard]] Point place_of(Vector3 direction) const {
    return {std::atan2(dot(direction, across_), dot(direction, along_)),
            std::asin(std::clamp(dot(direction, normal_), -1.0, 1.0))};
  }
  /// Of directions at an angle from the point of the arc at `longitude`, counter-clockwise seen from outside.
  [[nodiscard]] std::vector<Point> circle_about(double longitude, double angle, double from, double to,
                                                double turn) const {
    const Vector3 middle = direction_at(longitude), east = cross(normal_, middle);
    const int chords = static_cast<int>(std::ceil((to - from) / turn));
    std::vector<Point> places;
    for (int k = 0; k <= chords; ++k) {
      const double at = from + (to - from) * k / chords;
      places.push_back(
          place_of(std::cos(angle) * middle + std::sin(angle) * (std::cos(at) * east + std::sin(at) * normal_)));
    }
    return places;
  }

 private:
  Vector3 along_, normal_, across_;
};

Mesh mesh_of_shape(const ShellPlate& plate, double turn) {
  const ArcChart chart(plate);
  const double arc = angle_between(plate.from, plate.to), half = plate.half_angle;
  const double hole = std::asin(plate.hole_radius / ((plate.low + plate.high) / 2));
  std::vector<Point> outline = chart.circle_about(arc, half, -pi / 2, pi / 2, turn);
  const int steps = static_cast<int>(std::ceil(arc / (turn / 2)));
  for (int k = steps - 1; k > 0; --k) outline.emplace_back(arc * k / steps, half);
  const std::vector<Point> end = chart.circle_about(0, half, pi / 2, 3 * pi / 2, turn);
  outline.insert(outline.end(), end.begin(), end.end());
  for (int k = 1; k < steps; ++k) outline.emplace_back(arc * k / steps, -half);
  std::vector<PatternSite> sites;
  for (const double longitude : {0.0, arc}) {
    sites.push_back({longitude, chart.circle_about(longitude, hole, 0, two_pi, turn)});
    sites.back().hole.pop_back();
  }
  const double room = arc - 4 * half;
  const int between = room > 0 ? 1 + static_cast<int>(std::ceil(room / turn)) : 0;
  for (int k = 0; k < between; ++k)
    sites.push_back({2 * half + (between > 1 ? room * k / (between - 1) : room / 2), {}});
  return thickened(with_short_edges(flat_pattern(outline, sites), turn / 2), [&](Point place, bool upper) {
    return (upper ? plate.high : plate.low) * chart.direction_at(place);
  });
}

Mesh mesh_of_shape(const RoundPin& pin, double turn) {
  const Vector3 axis = normalized(pin.to - pin.from);
  const Vector3 beside = std::abs(axis.z) > 0.5 ? Vector3{1, 0, 0} : Vector3{0, 0, 1};
  const Vector3 u = normalized(cross(beside, axis)), v = cross(axis, u);
  FlatPattern disc = flat_pattern(circle(0, pin.radius, turn), {{0, {}}});
  return thickened(
      disc, [&](Point place, bool upper) { return (upper ? pin.to : pin.from) + place.real() * u + place.imag() * v; });
}

constexpr double chord_turn = 0.04;

/// The inertia of what has this second moment ∫ r rᵀ dm.
Matrix3x3 inertia_of(const Matrix3x3& second_moment) {
  return trace(second_moment) * Matrix3x3::identity() - second_moment;
}

/// What the parallel axes theorem adds for a centre of mass that lies off by `off`.
Matrix3x3 shifted(double mass, Vector3 off) { return inertia_of(mass * dyadic_product(off, off)); }

}  // namespace

Mesh mesh_of(const Part& part, double turn) {
  return std::visit([turn](const auto& shape) { return mesh_of_shape(shape, turn); }, part.shape);
}

double volume(const Mesh& mesh) {
  double six_volumes = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    six_volumes += determinant(mesh.vertices[static_cast<std::size_t>(a)], mesh.vertices[static_cast<std::size_t>(b)],
                               mesh.vertices[static_cast<std::size_t>(c)]);
  return six_volumes / 6;
}

MassProperties operator+(const MassProperties& a, const MassProperties& b) {
  MassProperties sum;
  sum.mass = a.mass + b.mass;
  if (!(sum.mass > 0)) return sum;
  sum.centre = (a.mass * a.centre + b.mass * b.centre) / sum.mass;
  sum.inertia = a.inertia + shifted(a.mass, a.centre - sum.centre) + b.inertia + shifted(b.mass, b.centre - sum.centre);
  return sum;
}

MassProperties mass_properties(const Mesh& mesh, double density, double metre) {
  // Seen from a vertex, so that a far origin costs no digits.
  const Vector3 origin = mesh.vertices.front();
  const auto corner = [&](int vertex) { return metre * (mesh.vertices[static_cast<std::size_t>(vertex)] - origin); };
  double mass = 0;
  Vector3 first;
  Matrix3x3 second;
  for (const auto& triangle : mesh.triangles) {
    const Vector3 a = corner(triangle[0]), b = corner(triangle[1]), c = corner(triangle[2]), sum = a + b + c;
    const double weight = density * determinant(a, b, c);
    mass += weight / 6;
    first = first + weight / 24 * sum;
    second =
        second +
        weight / 120 * (dyadic_product(sum, sum) + dyadic_product(a, a) + dyadic_product(b, b) + dyadic_product(c, c));
  }
  const Vector3 centre = first / mass;
  return {mass, metre * origin + centre, inertia_of(second - mass * dyadic_product(centre, centre))};
}

MassProperties mass_properties(const Machine& machine, int body, double density) {
  const double metre = machine.linkage.millimetres() / 1000;
  MassProperties sum;
  for (const Part& part : machine.parts)
    if (part.body == body) sum = sum + mass_properties(mesh_of(part, chord_turn), density, metre);
  return sum;
}

}  // namespace linkwright
