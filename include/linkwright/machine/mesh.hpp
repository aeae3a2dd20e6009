#pragma once

#include <array>
#include <vector>

#include "linkwright/algebra/matrix3x3.hpp"
#include "linkwright/machine/machine.hpp"

namespace linkwright {

/// A closed surface of triangles, counter-clockwise seen from outside; each edge belongs to two of them.
struct Mesh {
  std::vector<Vector3> vertices;  ///< fixed frame, user's unit
  std::vector<std::array<int, 3>> triangles;
};

/// The surface of a part. Circles are cut into chords of at most `turn` radians; vertices lie on the
/// part's surface, on rims of shell plates to the square of `turn`.
[[nodiscard]] Mesh mesh_of(const Part& part, double turn = 0.1);

/// The volume that a mesh encloses, user's unit cubed.
[[nodiscard]] double volume(const Mesh& mesh);

/// Of structural steel, kg/m³.
inline constexpr double steel_density = 7850;

/// What a rigid body's motion needs of its matter, SI units, axes of the fixed frame.
struct MassProperties {
  double mass = 0;    ///< kg
  Vector3 centre;     ///< of mass, m
  Matrix3x3 inertia;  ///< about the centre of mass, kg m²
};

/// Of two things that move as one.
[[nodiscard]] MassProperties operator+(const MassProperties& a, const MassProperties& b);

/// Of what a closed surface encloses, one tetrahedron to each triangle (S. Lien and J. T. Kajiya, A symbolic method for
/// calculating the integral properties of arbitrary nonconvex polyhedra, 1984). `density` in kg/m³, `metre` the metres
/// in the mesh's unit of length.
[[nodiscard]] MassProperties mass_properties(const Mesh& mesh, double density, double metre);

/// Of all parts that move with a body, as they lie in position 1; to about 5e-4 of themselves, for circles are taken as
/// chords. A unit of length that is not known is taken for millimetres.
[[nodiscard]] MassProperties mass_properties(const Machine& machine, int body, double density = steel_density);

}  // namespace linkwright
