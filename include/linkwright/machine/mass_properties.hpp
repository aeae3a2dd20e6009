#pragma once

#include "linkwright/algebra/matrix3x3.hpp"
#include "linkwright/machine/machine.hpp"
#include "linkwright/machine/mesh.hpp"

namespace linkwright {

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
