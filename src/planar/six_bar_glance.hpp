#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include "linkwright/planar/six_bar_family.hpp"
#include "linkwright/planar/six_bar_solution.hpp"
#include "linkwright/planar/six_bar_synthesis.hpp"

namespace linkwright {

/// Hinges of an added link in position 1, fixed frame: centre point, circle point.
using LinkHinges = std::array<Point, 2>;

/// Links that may join two bodies, in closed form and unpolished: each pole is a circle point, so a line through it
/// meets the cubic of circle points in two others at most. Of even directions, two to a line. Empty where the bodies do
/// not turn to each other. The distances hold to some 1e-9 of the coordinates where poles are not close together.
[[nodiscard]] std::vector<LinkHinges> links_through_pole(const BodyPositions& x, const BodyPositions& k);

/// What can be said of a chain's six-bars without their curves.
class SixBarGlance {
 public:
  /// `wanted` with lengths set; they and the box outlive it.
  SixBarGlance(std::array<BodyPair, 2> added, const Box& box, const Requirements& wanted);

  struct Seen {
    std::int64_t six_bars = 0;  ///< all pivots in the box
    /// Hinges of link 4 and link 5 of those among them whose dyads do not change their assembly mode between the
    /// positions, and transmit well enough there.
    std::vector<std::array<LinkHinges, 2>> promising;
  };
  [[nodiscard]] Seen look_at(const std::array<BodyPositions, 4>& bodies) const;

 private:
  using Links = std::vector<LinkHinges>;
  [[nodiscard]] Links in_box(Links links) const;
  [[nodiscard]] bool is_promising(const LinkHinges& link, BodyPair between, const BodyPositions& centers,
                                  const std::array<BodyPositions, 4>& bodies) const;

  std::array<BodyPair, 2> added_;
  const Box& box_;
  const Requirements& wanted_;
  double least_sine_ = 0;
  bool falls_apart_ = false;  ///< a link 0-2 makes a four-bar with the driver; the other link and body 3 follow it
};

/// A six-bar that meets the requirements, and how good it is.
struct SixBarProspect {
  ThreeLinkChain chain;
  std::array<double, 2> tau{};
  double score = 0;  ///< as score_of
  SixBarMember member;
  bool local_optimum = false;
};

[[nodiscard]] double score_of(Objective objective, const SixBarRating& rating);

/// Better first; ties by the coordinates.
[[nodiscard]] bool is_better(const SixBarProspect& a, const SixBarProspect& b);

/// The first so many of prospects sorted by is_better, no two of which have all hinges within `least` of each other.
[[nodiscard]] std::vector<SixBarProspect> distinct(const std::vector<SixBarProspect>& sorted, std::size_t most,
                                                   double least);

/// Each driven in exact steps, best first again. What then fails the requirements after all – searches take larger
/// steps – is left out. By a measure added to the map they stay in order.
[[nodiscard]] std::vector<SixBarSolution> driven_exactly(const std::vector<SixBarProspect>& prospects,
                                                         const SixBarTask& task, const SixBarRow& row,
                                                         const Requirements& wanted, const SixBarChoice& choice);

}  // namespace linkwright
