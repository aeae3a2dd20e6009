#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "linkwright/algebra/point.hpp"

namespace linkwright {

/// The kinds of planar six-bars with hinges only that guide a floating body, by the place of the ground: Watt's chain
/// with a binary ground link; Stephenson's with the ground a single binary between the two ternaries (I), in the chain
/// of two binaries between them (II), or ternary (III).
enum class SixBarTopology : std::uint8_t { watt_1, stephenson_1, stephenson_2, stephenson_3 };
[[nodiscard]] std::string_view name(SixBarTopology topology);  ///< "watt_1", …

/// Two bodies joined by a link with a hinge at each end: 0 is the ground, 1, 2, 3 the guiding chain from the ground on
/// (3 is the guided body), 4 the first added link.
struct BodyPair {
  int a = 0, b = 0;
  friend bool operator==(BodyPair, BodyPair) = default;
};
[[nodiscard]] std::string text(BodyPair pair);  ///< "0-2"
/// Two digits 0 … 5 and a hyphen between them; nothing otherwise.
[[nodiscard]] std::optional<BodyPair> body_pair_from(std::string_view text);

/// A hinge: the two bodies, and where it lies in position 1 (fixed frame).
struct SixBarJoint {
  std::array<int, 2> bodies{};
  Point point{};
};

/// One of its two bodies is the ground.
[[nodiscard]] inline bool is_on_ground(const SixBarJoint& joint) {
  return joint.bodies[0] == 0 || joint.bodies[1] == 0;
}

/// Distance between two hinges of one body, user's unit.
struct SixBarLength {
  int body = 0;
  std::array<std::size_t, 2> joints{};
  double length = 0;
};

/// A planar six-bar with one degree of freedom as it lies in position 1, fixed frame: the chain 0-1-2-3 with hinges a,
/// b, d, and two links added to it: link 4 with its hinge c4 on body added[0].a and z4 on added[0].b, link 5 likewise
/// with c5 and z5. Driven by body 1, which turns about a; body 3 is guided.
struct SixBar {
  static constexpr int bodies = 6, driver = 1, guided = 3;
  enum JointIndex : std::uint8_t { a, b, d, c4, z4, c5, z5 };
  static constexpr std::size_t joint_count = 7;

  std::array<SixBarJoint, joint_count> joints{};

  /// The chain's three hinges; the added links' two each.
  [[nodiscard]] static SixBar of(std::array<Point, 3> chain, std::array<BodyPair, 2> added, std::array<Point, 2> link_4,
                                 std::array<Point, 2> link_5);

  /// Where a hinge lies in position 1, fixed frame.
  [[nodiscard]] Point at(JointIndex joint) const { return joints[joint].point; }
  /// Of link 4 and of link 5: first the body that carries c4 (c5), then that of z4 (z5).
  [[nodiscard]] std::array<BodyPair, 2> added() const;
  /// Indices of the hinges of a body, ascending: two of a binary link, three of a ternary one.
  [[nodiscard]] std::vector<std::size_t> joints_of(int body) const;
  /// All distances between hinges of one body, by body: one of a binary link, three of a ternary one; ten in all.
  [[nodiscard]] std::vector<SixBarLength> lengths() const;
  /// The four hinges of a loop of four bodies, of which each six-bar has one or two: as those of a four-bar, the first
  /// two on the input link, the second and third on the coupler, the first and last on the frame. The loop of
  /// ground and driver where there is one, with the driver as the input; otherwise the body with the lowest number is
  /// the frame, and its neighbour with the lower number the input.
  [[nodiscard]] std::optional<std::array<std::size_t, 4>> four_bar_loop() const;
  /// Read off the joints; nothing where they do not make one of the four.
  [[nodiscard]] std::optional<SixBarTopology> topology() const;
};

/// "a", "b", "d", "c4", "z4", "c5", "z5".
[[nodiscard]] std::string_view joint_name(std::size_t joint);
/// Body and hinges: "1:a-b", "2:b-d", …
[[nodiscard]] std::string name(const SixBarLength& length);

}  // namespace linkwright
