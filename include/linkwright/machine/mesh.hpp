#pragma once

#include <array>
#include <vector>

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

}  // namespace linkwright
