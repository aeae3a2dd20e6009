#pragma once

#include <array>
#include <span>
#include <vector>

#include "linkwright/algebra/directed_line.hpp"
#include "linkwright/mechanism/pose.hpp"
#include "linkwright/straight_line/line_design.hpp"

namespace linkwright {

/// A place of a line at which the path of a point is to have points in common with it.
struct PlacedContact {
  double s = 0;          ///< along the line from its point, user's unit
  int multiplicity = 1;  ///< points in common: 1 crosses, 2 touches, 3 inflects, 4 is that of Ball's point
  int side = 1;  ///< +1 where the crank's pin then lies to the left of the way from the input pivot to the point, −1

  friend bool operator==(const PlacedContact&, const PlacedContact&) = default;
};

/// The four-bars whose coupler's point has `contacts` with the line (multiplicities add up to four, s rises) and whose
/// driving dyad, from `input_pivot`, has the lengths `crank` and `point_arm` (pin to point). `coupler_angle`, radians:
/// from the point, seen from the pin, to the output's moving pivot or to the opposite of it. Each in the configuration
/// of the first contact.
///
/// One at most where the coupler is straight (coupler_angle 0 or π: a λ), the first of the two; otherwise none or two,
/// the roots of a quadratic equation, each continuous over crank and point_arm. None where the dyad does not reach a
/// contact or is stretched or folded there, where the side is no longer a matter of course. Contacts on one side
/// within tolerance::double_contact of `scale`, the size of the task, are taken as one. `scale` is that of
/// line_design() as well. Formulas: docs/theory/straight_lines.md.
[[nodiscard]] std::array<LineDesign, 2> mixed_designs(const DirectedLine& line, Point input_pivot,
                                                      std::span<const PlacedContact> contacts, double coupler_angle,
                                                      double crank, double point_arm, double scale);

/// The poses of the coupler at the contacts, origin at the point, where the contact is multiple with the derivatives by
/// s: find_defects() tells whether the linkage, as it lies at the first contact, passes them all, in order and in the
/// sense of the line, without being taken apart. For contacts and a linkage of mixed_designs(); empty for others.
[[nodiscard]] std::vector<PrescribedPose> contact_poses(const TracingFourBar& linkage, const DirectedLine& line,
                                                        std::span<const PlacedContact> contacts);

}  // namespace linkwright
