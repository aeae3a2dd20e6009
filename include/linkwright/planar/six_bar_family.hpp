#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/linkage_output.hpp"
#include "linkwright/mechanism/six_bar.hpp"
#include "linkwright/mechanism/six_bar_position.hpp"
#include "linkwright/planar/burmester_curve.hpp"
#include "linkwright/planar/pose_conditions.hpp"
#include "linkwright/planar/six_bar_task.hpp"

namespace linkwright {

/// A body in one of the four positions: where its reference point lies, and the unit complex number by which the body
/// has turned from position 1. Fixed frame.
struct BodyPosition {
  Point reference{};
  Point turn{1, 0};
};

/// A body in all four positions.
struct BodyPositions {
  std::array<BodyPosition, 4> at{};

  /// Where the point of the body that lies at `point` in position 1 lies in position j (0 … 3).
  [[nodiscard]] Point moved(Point point, std::size_t j) const {
    return at[j].reference + at[j].turn * (point - at[0].reference);
  }
  /// The point of the body, in position 1, that lies at `point` in position j.
  [[nodiscard]] Point back(Point point, std::size_t j) const {
    return at[0].reference + std::conj(at[j].turn) * (point - at[j].reference);
  }
};

/// Bodies 0 … 3 of the chain in the four positions; nothing where it does not reach a pose.
[[nodiscard]] std::optional<std::array<BodyPositions, 4>> chain_positions(const std::vector<PrescribedPose>& poses,
                                                                          const ThreeLinkChain& chain);

/// A link that is joined to bodies x and k by hinges at these places in position 1: its reference point is the one on
/// x.
[[nodiscard]] BodyPositions positions_of_link(const std::array<Point, 2>& hinges, const BodyPositions& x,
                                              const BodyPositions& k);

/// The poses of body `k` as seen from body `x`, in the frame that is body x and the fixed frame in position 1.
[[nodiscard]] std::vector<PrescribedPose> relative_poses(const BodyPositions& x, const BodyPositions& k);

/// All links that may join two bodies of the linkage: the dyads of the four relative poses.
struct AddedLinks {
  BodyPair between;           ///< centre points on body a, circle points on body b
  PoseConditions conditions;  ///< of the relative poses
  std::shared_ptr<const BurmesterCurve> curve;
  /// (centre, circle point) of the link that is there already: the two hinges of a body that joins both bodies, in
  /// position 1. It is on the curve, and no new link.
  std::optional<std::array<Point, 2>> present;

  /// Hinges in position 1, fixed frame, of the link at τ: centre point, circle point. Nothing where one is at infinity,
  /// where they coincide, and where it is the link that is there already (to tolerance::same_linkage of `size`).
  [[nodiscard]] std::optional<std::array<Point, 2>> hinges(double tau, double size) const;
};

/// A six-bar whose guided body is in the four poses when its bodies have made these turns.
struct SixBarMember {
  SixBar six_bar;
  std::array<SixBarTurns, 4> turns;
  std::array<double, 2> coordinates{};  ///< τ of link 4 and of link 5
};

/// How it lies in the poses. `reference`: the guided frame in position 1.
[[nodiscard]] SixBarOutput output_of(const SixBarMember& member, const Pose& reference);

/// The chain in its positions with both links added by their hinges; `link_4` from positions_of_link(). No coordinates.
[[nodiscard]] SixBarMember six_bar_member(const ThreeLinkChain& chain, std::array<BodyPair, 2> added,
                                          const std::array<BodyPositions, 4>& bodies,
                                          const std::array<Point, 2>& hinges_4, const BodyPositions& link_4,
                                          const std::array<Point, 2>& hinges_5);

/// The six-bars of a given chain: a curve of links 4 and, for each of them, a curve of links 5, each of four relative
/// poses (docs/theory/six-bars.md).
class SixBarFamily {
 public:
  /// `added` as in six_bar_rows(); `bodies` as from chain_positions().
  SixBarFamily(const ThreeLinkChain& chain, std::array<BodyPair, 2> added, std::array<BodyPositions, 4> bodies);

  [[nodiscard]] const std::array<BodyPositions, 4>& bodies() const { return bodies_; }
  [[nodiscard]] const AddedLinks& first() const { return first_; }
  /// Link 5 is joined to link 4, so that its curve depends on link 4.
  [[nodiscard]] bool second_depends_on_first() const { return added_[1].a == 4 || added_[1].b == 4; }

  /// The links 5 whatever link 4 is; null where they depend on it.
  [[nodiscard]] const AddedLinks* independent_second() const { return independent_second_.get(); }

  /// A link 4 in place: its hinges, its positions, and the links 5 that go with it.
  struct WithFirst {
    double coordinate = 0;
    std::array<Point, 2> hinges{};
    BodyPositions positions;
    std::shared_ptr<const AddedLinks> second;
  };
  /// Nothing where τ gives no link (AddedLinks::hinges).
  [[nodiscard]] std::optional<WithFirst> with_first(double tau) const;

  /// Length of the second axis of a map: of the curve of links 5; 1 where that depends on link 4.
  [[nodiscard]] double second_axis_length() const;
  /// τ of link 5 at a coordinate of that axis.
  [[nodiscard]] double second_tau(const WithFirst& first, double coordinate) const;
  /// The inverse of second_tau().
  [[nodiscard]] double second_coordinate(const WithFirst& first, double tau) const;

  /// The six-bar; nothing where τ gives no link 5.
  [[nodiscard]] std::optional<SixBarMember> member(const WithFirst& first, double tau) const;
  /// Hinges of the links 5 at coordinates of the second axis, where they do not depend on link 4; otherwise none.
  using SecondHinges = std::vector<std::optional<std::array<Point, 2>>>;
  [[nodiscard]] SecondHinges independent_hinges(std::span<const double> coordinates) const;
  /// The six-bar at the i-th of the coordinates that `hinges` are of.
  [[nodiscard]] std::optional<SixBarMember> member(const WithFirst& first, std::span<const double> coordinates,
                                                   const SecondHinges& hinges, std::size_t i) const;
  /// The same with link 5's hinges known already.
  [[nodiscard]] SixBarMember member(const WithFirst& first, double tau, std::array<Point, 2> hinges) const;

 private:
  [[nodiscard]] AddedLinks links(BodyPair between, const BodyPositions& x, const BodyPositions& k) const;
  [[nodiscard]] const BodyPositions& positions_of(int body, const BodyPositions& link_4) const;

  ThreeLinkChain chain_;
  std::array<BodyPair, 2> added_;
  std::array<BodyPositions, 4> bodies_;
  AddedLinks first_;
  std::shared_ptr<const AddedLinks> independent_second_;
};

}  // namespace linkwright
