#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "linkwright/core/result.hpp"
#include "linkwright/mechanism/linkage_output.hpp"
#include "linkwright/mechanism/pose.hpp"
#include "linkwright/mechanism/six_bar.hpp"
#include "linkwright/planar/body_points.hpp"
#include "linkwright/region/linkage_class.hpp"
#include "linkwright/region/requirements.hpp"

namespace linkwright {

/// The chain 0-1-2-3 that guides body 3: its hinges a (ground and body 1), b (1 and 2) and d (2 and 3) in position 1,
/// fixed frame.
struct ThreeLinkChain {
  Point a{}, b{}, d{};
  /// Sign of cross(d_j − a, b_j − a) by pose: the side of the line from a to d on which b lies. 0: as in position 1.
  std::array<int, 4> assembly_mode{};

  /// Distances a–b and b–d, user's unit.
  [[nodiscard]] double first_length() const { return std::abs(b - a); }
  [[nodiscard]] double second_length() const { return std::abs(d - b); }
  /// +1: b to the left of the line from a to d, or on it; −1: to its right.
  [[nodiscard]] int assembly_mode_in_position_1() const { return cross(d - a, b - a) < 0 ? -1 : 1; }
  /// Default of max_length of six-bars in this, the longest side of a, b, d.
  [[nodiscard]] double size() const;

  friend bool operator==(const ThreeLinkChain&, const ThreeLinkChain&) = default;
};

/// Motion generation by a six-bar: body 3 of a three-link chain shall pass through four poses in this order; two links
/// are added to the chain that leave it one degree of freedom. With `chain` all such six-bars are found, without it the
/// chain is searched for, too, all pivots in `box`.
struct SixBarTask {
  static constexpr const LinkageClass& linkages = unloaded_linkages;
  static constexpr OutputKind output = OutputKind::pose;

  std::vector<PrescribedPose> poses;
  std::optional<ThreeLinkChain> chain;
  std::array<BodyPair, 2> added = {BodyPair{0, 2}, BodyPair{0, 3}};  ///< bodies joined by link 4 and by link 5
  std::optional<Box> box;          ///< for all pivots in position 1; must be given where there is no chain
  std::vector<BodyPoints> points;  ///< what the poses were given by, in their order; empty: by themselves

  [[nodiscard]] bool is_search() const { return !chain; }
  friend bool operator==(const SixBarTask&, const SixBarTask&) = default;
};

/// One way to add two links to the chain: body pairs as the library orders them, centre point on the first body, circle
/// point on the second; the kind of six-bar.
struct SixBarRow {
  std::array<BodyPair, 2> added;
  SixBarTopology topology = SixBarTopology::watt_1;
};

/// The eleven ways that guide body 3 with body 1 as the driver (G. S. Soh & J. M. McCarthy, The synthesis of six-bar
/// linkages as constrained planar 3R chains, 2008).
[[nodiscard]] std::span<const SixBarRow> six_bar_rows();

/// The row of a pair of added links, the bodies of each pair in either order; nothing where it is none of the eleven.
[[nodiscard]] std::optional<SixBarRow> six_bar_row(std::array<BodyPair, 2> added);

/// The caller's mistakes: poses that are not four finite ones, numbers out of range, a chain that does not reach a
/// pose, is stretched or folded in position 1, or has an elbow other than drawn, pairs of bodies that are none of the
/// eleven rows, no chain and no box. Places are `task.…` and `options.box`. Empty when the task can be solved.
[[nodiscard]] std::vector<Error> mistakes_in(const SixBarTask& task);

/// The same of a box alone, as it stands in a file's options: borders out of range, low not below high.
[[nodiscard]] std::vector<Error> mistakes_in_search_box(const Box& box);

}  // namespace linkwright
