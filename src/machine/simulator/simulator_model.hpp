#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "linkwright/machine/mesh.hpp"

namespace linkwright {

struct SolidBox {
  Vector3 size;
};

/// About its z axis.
struct SolidCylinder {
  double radius = 0, length = 0;
};

/// A shape to look at; `place` is that of its middle in the frame of its link.
struct Solid {
  Displacement place;
  std::variant<SolidBox, SolidCylinder> shape;
};

/// A body in the tree that is left when each loop is cut in one hinge.
struct SimulatorLink {
  std::string name;
  int body = 0;
  int parent = -1;        ///< in SimulatorModel::links; none of the ground
  std::size_t hinge = 0;  ///< that it turns in, seen from the parent
  Vector3 origin;         ///< of its frame, fixed frame, position 1, m: that hinge
  MassProperties matter;
  std::vector<Solid> solids;
  std::vector<double> colour;  ///< red, green, blue, 0…1
};

/// A hinge where a loop is cut; its joint turns the second link about the hinge's axis, seen from the first.
struct SimulatorLoop {
  std::size_t hinge = 0;
  int first = 0, second = 0;  ///< in SimulatorModel::links
};

/// A position of the task: the angle of each link's joint, the ground's left out.
struct SimulatorKey {
  int position = 0;  ///< from 0
  std::vector<double> turns;
};

/// What the files of all simulators tell, SI units.
struct SimulatorModel {
  std::string remark;                ///< what the linkage is, and how its unit was read
  std::vector<SimulatorLink> links;  ///< the ground first, each right before all that hang on it
  std::vector<SimulatorLoop> loops;
  std::vector<std::string> hinge_names;
  std::vector<Vector3> hinge_points, hinge_axes;
  int driver = 0;  ///< the link that the motor turns
  int guided = 0;
  Vector3 guided_point;  ///< of the guided body: the traced one or the frame's origin; fixed frame, position 1
  std::vector<SimulatorKey> keys;
  std::optional<std::pair<double, double>> driver_range;  ///< none where the driver turns fully
  /// Of the joint's angle over the driver's, by link, where it is the same from position 1 on and in all positions.
  std::vector<std::optional<double>> ratios;
  double size = 0;  ///< the longest link, or the sphere's radius
  double mass = 0;  ///< of all that moves
};

[[nodiscard]] SimulatorModel simulator_model(const Machine& machine, double density);

struct InertiaElement {
  const char* name;
  std::size_t row, column;
};
/// As SDF and URDF call them.
inline constexpr std::array<InertiaElement, 6> inertia_elements = {
    {{"ixx", 0, 0}, {"ixy", 0, 1}, {"ixz", 0, 2}, {"iyy", 1, 1}, {"iyz", 1, 2}, {"izz", 2, 2}}};

/// A number of a file, ten digits; 0 for what is only rounding beside `size`.
[[nodiscard]] std::string number(double value, double size = 1);
[[nodiscard]] std::string numbers(Vector3 vector, double size = 1);

/// Turns about the fixed axes x, y, z in this order, radians: what SDF and URDF call roll, pitch and yaw.
[[nodiscard]] Vector3 roll_pitch_yaw(const Rotation& rotation);

}  // namespace linkwright
