#pragma once

#include <vector>

#include "linkwright/machine/machine.hpp"
#include "machine/linkage_loads.hpp"

namespace linkwright {

/// What holds springs and a driving cylinder, and the gas springs themselves as they lie in a position of the task
/// (from 0): `stud_NAME_from` and `stud_NAME_to`, pins that move with their bodies, from the plate of the body up to a
/// plane above all layers, in which `NAME_tube` lies at the stud `to`, a stud's diameter shorter than the compressed
/// spring, and `NAME_rod` between it and the other stud. These two are the ground's parts: they lie so in this position
/// alone. A rod of no known diameter is as thick as a pin; a tube is twice as thick as its rod. Nothing here is looked
/// at for collisions. None where the linkage does not get to the position. `on`: the four-bar of the machine.
[[nodiscard]] std::vector<Part> spring_parts(const Machine& machine, const LinkageLoads& on, int position);

}  // namespace linkwright
