#pragma once

#include <string>
#include <variant>
#include <vector>

#include "linkwright/core/result.hpp"
#include "linkwright/machine/moving_linkage.hpp"
#include "linkwright/machine/plate_layers.hpp"

namespace linkwright {

/// A flat plate: all that is nearer than `radius` to the convex polygon of its corners, between two heights.
struct FlatPlate {
  std::vector<Point> outline;  ///< corners of the convex polygon, counter-clockwise; two of a bar
  std::vector<Point> holes;
  double radius = 0, hole_radius = 0;
  double low = 0, high = 0;  ///< z
};

/// A piece of a spherical shell: all directions that are nearer than `half_angle` to the arc, between two radii.
struct ShellPlate {
  Vector3 from, to;  ///< the arc's ends, unit vectors; holes along them
  double half_angle = 0, hole_radius = 0;
  double low = 0, high = 0;  ///< radii
};

/// A cylinder.
struct RoundPin {
  Vector3 from, to;  ///< the middles of its ends
  double radius = 0;
};

/// A piece of a machine as it lies in position 1, fixed frame, user's unit.
struct Part {
  std::string name;  ///< that of its body; "pin_" and that of its hinge
  int body = 0;      ///< that it moves with
  std::variant<FlatPlate, ShellPlate, RoundPin> shape;
};

/// A linkage as one builds it: a plate to each body, the ground's the lowest (about a centre the innermost), and a pin
/// to each hinge, held by the body nearer to the ground.
struct Machine {
  MovingLinkage linkage;
  PlateSizes sizes;
  PlateLayers layers;
  std::vector<Part> parts;  ///< plates by body, then pins by hinge
};

/// Errors: those of plate_sizes(). Where no layers are free of collisions and the width is not given, narrower plates
/// are tried, down to a third.
[[nodiscard]] Result<Machine> machine(const MovingLinkage& linkage, const WantedSizes& wanted = {});

/// One sentence on what runs into what; empty where the layers are free of collisions.
[[nodiscard]] std::string collision_text(const Machine& machine);

}  // namespace linkwright
