#pragma once

#include <string>
#include <vector>

#include "linkwright/robust/made_dimension.hpp"
#include "linkwright/robust/tolerances.hpp"

namespace linkwright::wasm {

/// What tolerances do to one linkage, and some of the linkages made.
struct ToleranceReply {
  std::string report;  ///< JSON text: ToleranceAnswer of the protocol; empty at a dead point
  /// By sample, position, joint: x and y, on the sphere x, y, z. Joints: of four-bars input's fixed and moving pivot,
  /// output's moving and fixed pivot, in the plane and the body's origin; of six-bars their seven hinges and the body's
  /// origin.
  std::vector<double> drawn;
};

/// `drawn`: how many samples; of a straight line at its ends and in the middle. The turning length of the tolerances is
/// set.
[[nodiscard]] ToleranceReply tolerance_reply(const LinkageOutput& output, const Tolerances& tolerances, int bins,
                                             int drawn);

/// The same before it is looked at closely: `tolerance` of a result's linkages, by few samples; empty at a dead point.
[[nodiscard]] std::string tolerance_at_a_glance(const LinkageOutput& output, const Tolerances& tolerances);

}  // namespace linkwright::wasm
