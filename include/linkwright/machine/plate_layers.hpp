#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "linkwright/core/result.hpp"
#include "linkwright/machine/moving_linkage.hpp"

namespace linkwright {

/// What the links of a linkage are made of, user's unit: flat plates with round ends on pins; about a centre, pieces of
/// spherical shells on radial pins.
struct PlateSizes {
  double width = 0;      ///< of a plate; about a centre, on the outermost sphere
  double thickness = 0;  ///< of a plate
  double gap = 0;        ///< between layers, and between what moves past each other in one layer
  double pin = 0;        ///< diameter
  double clearance = 0;  ///< of a pin in its hole, diameters
  double radius = 0;     ///< of the outermost sphere; 0: planar

  [[nodiscard]] double pitch() const { return thickness + gap; }
  [[nodiscard]] double hole() const { return pin + clearance; }
};

/// What is not given comes from the longest link: plates 12 % of it wide and 6 % thick, pins 5 % but at most 40 % of
/// the shortest link. About a centre the sphere's radius, 100 if not given, takes the place of the longest link.
struct WantedSizes {
  double width = 0, thickness = 0, gap = 0, pin = 0, radius = 0;  ///< 0: not given
  double clearance = -1;                                          ///< negative: not given
};

/// Errors: `size_out_of_range` (not from 1e-4 to 10 of the longest link or of the sphere's radius, 0.8 of which is as
/// wide as plates can be), `sphere_too_small` (four layers reach its centre), `pin_too_wide` (the plate is narrower
/// than 1.3 holes), `pins_overlap` (two holes of a link meet).
[[nodiscard]] Result<PlateSizes> plate_sizes(const MovingLinkage& linkage, const WantedSizes& wanted);

/// Where something runs into something else.
struct Crossing {
  int body = 0;
  bool is_pin = false;                ///< what is run into: a hinge's pin, or another body's plate
  std::size_t obstacle = 0;           ///< a hinge, or a body
  double from_turn = 0, to_turn = 0;  ///< of the driver, radians, where first and where last
};

/// In which layer each body's plate lies, so that nothing collides as the linkage moves.
struct PlateLayers {
  enum class Over : unsigned char { travel, task };
  std::vector<int> layer;  ///< by body; the ground lies in 0, alone
  Over over = Over::travel;
  std::vector<Crossing> crossings;  ///< none where the layers are free of collisions over that stretch
};

/// Of all ways to lay the plates over each other, those with fewer layers and shorter pins first, the first that is
/// free of collisions over the travel; otherwise over the task; otherwise the one that collides least over the task
/// (the travel, where there is no task). A pin reaches from the layer of one of its bodies to that of the other.
/// Between two states of the travel things may come closer
/// by as much as they move meanwhile: that is allowed for, along the chords of their ways.
[[nodiscard]] PlateLayers plate_layers(const MovingLinkage& linkage, const PlateSizes& sizes);

}  // namespace linkwright
