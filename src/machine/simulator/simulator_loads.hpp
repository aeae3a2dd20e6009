#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "linkwright/machine/mesh.hpp"
#include "machine/linkage_loads.hpp"

namespace linkwright {

/// What acts on a four-bar as simulators know it: SI units, as it lies in position 1, in the first of its cases. Bodies
/// as in MovingLinkage: ground, input, coupler, output.
struct SimulatorLoads {
  struct Stud {
    int body = 0;
    Vector3 at;  ///< fixed frame
  };
  /// A linear spring.
  struct Line {
    std::string name, remark;
    Stud from, to;
    double stiffness = 0;           ///< N/m
    std::array<double, 2> slack{};  ///< no force between these lengths
    /// Of gas: pushes the studs apart by the first, N, and the second times the length, N/m.
    std::optional<std::array<double, 2>> push;
    double friction = 0;  ///< N
  };
  struct HingeSpring {
    FourBarJoint hinge = FourBarJoint::input_ground;
    double stiffness = 0, rests_at = 0;  ///< N·m per radian, radians
  };
  struct Force {
    std::string name;
    Stud at;
    Vector3 force;       ///< in the fixed frame, or as it is in position 1
    bool turns = false;  ///< with its body
  };
  std::string remark;
  Vector3 gravity;
  std::array<std::optional<MassProperties>, 4> matter;  ///< of bodies that weigh
  std::vector<Line> lines;
  std::vector<HingeSpring> hinges;
  std::vector<Force> forces;
};

/// `metre`: the metres in the user's unit.
[[nodiscard]] SimulatorLoads simulator_loads(const LinkageLoads& on, double metre);

}  // namespace linkwright
