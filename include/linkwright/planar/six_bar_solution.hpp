#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "linkwright/core/simd.hpp"
#include "linkwright/mechanism/linkage_type.hpp"
#include "linkwright/mechanism/pose.hpp"
#include "linkwright/mechanism/six_bar.hpp"
#include "linkwright/mechanism/six_bar_drive.hpp"
#include "linkwright/mechanism/six_bar_motion.hpp"
#include "linkwright/planar/six_bar_family.hpp"
#include "linkwright/planar/six_bar_task.hpp"
#include "linkwright/region/best_cells.hpp"
#include "linkwright/region/linkage_family.hpp"
#include "linkwright/region/requirements.hpp"

namespace linkwright {

/// Shape of a six-bar, whatever it does.
struct SixBarShape {
  LinkageType type = LinkageType::degenerate;  ///< of SixBar::four_bar_loop()
  double link_ratio = 0;  ///< longest over shortest distance between two hinges of a body; infinite where one is zero
  double longest = 0;     ///< user's unit
};
/// Of its hinges in position 1.
[[nodiscard]] SixBarShape shape_of(const SixBar& six_bar);

/// Shape, and what driving showed.
struct SixBarRating {
  SixBarShape shape;
  SixBarDriveReport drive;

  /// 1 − cos γ of the least transmission angle over the task (sin γ: SixBarTransmission::sine); 0 with a defect.
  [[nodiscard]] double versine() const;
  [[nodiscard]] double min_transmission_angle() const;  ///< γ, radians
  /// As a cell of a region. The type is degenerate where links have no length.
  [[nodiscard]] MapCell cell() const;
};

/// Hinges on the ground count as ground pivots, all others as moving ones.
[[nodiscard]] Pivots pivots_of(const SixBar& six_bar);
/// The same by itself, without place.
[[nodiscard]] Cell cell_of(const SixBar& six_bar, const SixBarRating& rating);

/// `circuits` as SixBarDriveOptions::circuits.
[[nodiscard]] SixBarRating rating_of(const SixBarMember& member, bool circuits);

/// Of many at once, without circuits: by packs, which is some hundred times as fast as to drive one after the other,
/// and says the same (docs/theory/six-bars.md, section 4). A member without links of its own length is not driven.
[[nodiscard]] std::vector<SixBarRating> ratings_of(std::span<const SixBarMember> members, Simd simd = Simd::automatic);

/// Whether a six-bar meets requirements whose lengths are set. Hinges on the ground count as ground pivots, all
/// others as moving ones, in position 1.
[[nodiscard]] bool meets(const Requirements& wanted, const SixBar& six_bar, const SixBarRating& rating);

/// The requirements with the defaults of both lengths filled in, by the longest side of the triangle a, b, d.
[[nodiscard]] Requirements with_defaults(Requirements wanted, const ThreeLinkChain& chain);

/// A six-bar found, fixed frame, user's unit, checked in user coordinates.
struct SixBarSolution {
  ThreeLinkChain chain;
  SixBarRow row;
  SixBarMember member;
  SixBarRating rating;
  std::vector<SixBarLength> lengths;
  double residual = 0;         ///< worst relative change of a distance between two hinges of a body over the four poses
  double pose_residual = 0;    ///< worst distance of the guided frame from a pose, as a share of the longest link
  bool local_optimum = false;  ///< refined to the top of its hill
  bool verified_by_driving = false;  ///< check_by_driving confirms the verdict
};

/// The solution of a member of the family of a chain, checked and driven.
[[nodiscard]] SixBarSolution solution_of(std::span<const PrescribedPose> poses, const ThreeLinkChain& chain,
                                         const SixBarRow& row, const SixBarMember& member);

/// What can be said of one six-bar as it is, driven by body 1. Angles in radians.
struct SixBarAnalysis {
  SixBarShape shape;
  std::vector<SixBarLength> lengths;
  double transmission_angle = 0;  ///< as it lies
  SixBarMotion travel;            ///< through all poses; no states where there is one only, or no such travel
  SixBarMotion motion;            ///< all that it can do: a full turn, or from dead point to dead point
};

/// `poses`: of the guided body, the first as the six-bar lies; at least one. States a degree of the driver apart or
/// less.
[[nodiscard]] SixBarAnalysis analyze(const SixBar& six_bar, std::span<const PrescribedPose> poses);

/// The travel through all poses, states a degree of the driver apart or less; without such a travel all that the
/// six-bar can do.
[[nodiscard]] SixBarMotion tabulated_motion(const SixBar& six_bar, std::span<const PrescribedPose> poses);

}  // namespace linkwright
