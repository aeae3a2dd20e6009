#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "linkwright/algebra/vector3.hpp"
#include "linkwright/attitude/displacement.hpp"
#include "linkwright/files/six_bar_file.hpp"

namespace linkwright {

/// A hinge of two bodies, as it lies in position 1, fixed frame.
struct Hinge {
  std::string name;             ///< "input_ground"; of six-bars as joint_name()
  std::array<int, 2> bodies{};  ///< the one nearer to the ground first
  Vector3 point;                ///< in the plane z = 0, user's unit; about a centre: the axis as a unit vector
};

/// A linkage in one place of its travel.
struct MovingState {
  double driver_turn = 0;  ///< from position 1, radians, counter-clockwise about the driver's hinge on the ground
  std::vector<Displacement> bodies;  ///< of each body from position 1, fixed frame; the first is at rest
  std::optional<int> position;       ///< of the task, from 0, that is met here
};

/// Any linkage as rigid bodies and hinges: how it lies in position 1, and where it gets to when body 1 drives it.
/// Planar linkages move in the plane z = 0, their hinges along z; the hinges of spherical ones pass through the origin.
struct MovingLinkage {
  std::string title, length_unit;
  bool spherical = false;
  std::vector<std::string> bodies;  ///< the ground, the driver, and so on
  int guided = 0;                   ///< the body that the task guides
  std::optional<Vector3> traced;    ///< a point of the guided body that the linkage is made for, position 1
  std::vector<Hinge> hinges;
  int positions = 1;  ///< how many the task has

  std::vector<MovingState>
      travel;              ///< one way, a quarter of a degree of the driver apart or less; its ends are dead points, or
  bool full_turn = false;  ///< the same place
  std::vector<std::size_t> task;  ///< states of the travel from the first position to the last, as they are passed; of
                                  ///< those met in another order (a line's middle, start and end) the shortest stretch
                                  ///< with all of them; none where the drive does not get to one

  /// The hinges of a body, ascending.
  [[nodiscard]] std::vector<std::size_t> hinges_of(int body) const;
  /// The state that meets a position (from 0); null where the drive does not get there.
  [[nodiscard]] const MovingState* at_position(int position) const;
  /// Largest distance of two hinges of one body; about a centre, of their angles (radians).
  [[nodiscard]] double longest_link() const;
  /// Smallest of the same.
  [[nodiscard]] double shortest_link() const;
  /// To the unit of length; 1 to one that is not known, as if it were millimetres.
  [[nodiscard]] double millimetres() const;
};

/// The motion is that of drive_table(), six_bar_motion() or analyze(); none of it is computed here.
[[nodiscard]] MovingLinkage moving_linkage(const AnyStoredLinkage& linkage);

}  // namespace linkwright
