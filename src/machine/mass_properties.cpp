#include "linkwright/machine/mass_properties.hpp"

namespace linkwright {
namespace {

constexpr double chord_turn = 0.04;

/// The inertia of what has this second moment ∫ r rᵀ dm.
Matrix3x3 inertia_of(const Matrix3x3& second_moment) {
  return trace(second_moment) * Matrix3x3::identity() - second_moment;
}

/// What the parallel axes theorem adds for a centre of mass that lies off by `off`.
Matrix3x3 shifted(double mass, Vector3 off) { return inertia_of(mass * dyadic_product(off, off)); }

}  // namespace

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
