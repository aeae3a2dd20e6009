#pragma once

#include <TopoDS_Shape.hxx>
#include <gp_Trsf.hxx>

#include "linkwright/machine/machine.hpp"

namespace linkwright::step {

/// The solid of a part in position 1; lengths times `scale`.
[[nodiscard]] TopoDS_Shape solid_of(const Part& part, double scale);

/// The same displacement, lengths times `scale`.
[[nodiscard]] gp_Trsf transformation(const Displacement& displacement, double scale);

}  // namespace linkwright::step
