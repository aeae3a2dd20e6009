#pragma once

#include <string>
#include <string_view>

#include "linkwright/core/result.hpp"
#include "linkwright/machine/machine.hpp"
#include "linkwright/machine/mesh.hpp"
#include "machine/linkage_loads.hpp"

namespace linkwright {

/// Files for simulators of rigid bodies: the machine as it lies in position 1 in metres, kilograms and radians, z along
/// the hinges of planar linkages. Every body is a link of its name with its frame in the hinge to the body before it,
/// its axes along the fixed frame's; every hinge a joint of its name, at zero in position 1. Shapes are boxes and
/// cylinders to look at that touch nothing; masses are those of the plates and pins (mass_properties()). A unit of
/// length that is not known is taken for millimetres, and the file says so.

/// For MuJoCo. The hinge that closes a loop is an equality constraint `connect`, measured by two sites; the actuator
/// `motor` turns the driver, its control in radians from position 1; a keyframe `position_1`, … for each position that
/// the drive reaches. Without gravity, as the file says; with `loads` in the first of their cases: gravity, their
/// masses in place of the plates', springs as tendons (gas by a straight line, as the file says), torsion springs in
/// hinges that close no loop, and forces as actuators without control.
[[nodiscard]] std::string write_mjcf(const Machine& machine, double density = steel_density,
                                     const LinkageLoads* loads = nullptr);

/// SDFormat 1.9, for Gazebo and others: one model, every hinge a revolute joint. No link has two parent joints, which
/// Gazebo refuses: the hinge that closes a loop turns a pin with a thousandth of its link's mass, and Gazebo welds that
/// to the other link by the constraint of its system DetachableJoint.
[[nodiscard]] std::string write_sdf(const Machine& machine, double density = steel_density);

/// URDF, which knows trees only: the hinge that closes a loop is told in a comment. Joints whose angle is proportional
/// to the driver's mimic it: those of parallelograms, up to where their links lie in one line and the linkage may flip.
[[nodiscard]] std::string write_urdf(const Machine& machine, double density = steel_density);

/// One of them by its name: mjcf, sdf, urdf; `loads` are told by the first alone. Errors: `unknown_simulator`,
/// `density_out_of_range` (not between 1e-3 and 1e6 kg/m³), `machine_too_small`, `machine_too_large` (of the links, for
/// the numbers of simulators).
[[nodiscard]] Result<std::string> simulator_text(const Machine& machine, std::string_view format,
                                                 double density = steel_density, const LinkageLoads* loads = nullptr);

}  // namespace linkwright
