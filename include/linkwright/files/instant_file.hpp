#pragma once

#include <optional>
#include <string>

#include "linkwright/core/result.hpp"
#include "linkwright/infinitesimal/instant_analysis.hpp"
#include "linkwright/synthesis/solve.hpp"

namespace linkwright {

/// A four-bar in the configuration that is looked at, and what the instant tells there.
struct LinkageInstant {
  FourBar four_bar;
  InstantAnalysis analysis;
};

/// A motion that is prescribed at one instant by a problem file, and what that tells.
struct PrescribedInstant {
  PrescribedPose pose;
  InstantAnalysis analysis;
  std::string title, length_unit;  ///< empty where the file does not say
};

/// Of a problem of motion by one pose and its derivatives, three at least; another problem is a mistake. `point`: of
/// the body, fixed frame.
[[nodiscard]] Result<PrescribedInstant> prescribed_instant(const Problem& problem, std::optional<Point> point);

/// As JSON text: the pose and the object `instant` as write_analysis() has it, by the parameter of the derivatives.
[[nodiscard]] std::string write_instant(const PrescribedInstant& instant);

}  // namespace linkwright
