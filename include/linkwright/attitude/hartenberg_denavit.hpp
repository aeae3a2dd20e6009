#pragma once

#include <span>
#include <vector>

#include "linkwright/attitude/common_normal.hpp"
#include "linkwright/attitude/displacement.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {

/// The four parameters of one link: two turns (radians) and two translations (the user's length).
struct HartenbergDenavit {
  double theta = 0;  ///< turn about z, from x to x: the variable of a revolute joint
  double d = 0;      ///< translation along z: the variable of a prismatic joint
  double a = 0;      ///< translation along x, the common normal: the length of the link
  double alpha = 0;  ///< turn about x, from z to z: the twist of the link
};

/// In which order a link's two screws follow each other, about carried axes.
enum class HartenbergDenavitForm : unsigned char {
  /// Rz(θ) Tz(d) Tx(a) Rx(α): z of frame j−1 is the axis of joint j. (Denavit and Hartenberg, A kinematic notation for
  /// lower-pair mechanisms based on matrices, 1955; Paul, Robot manipulators, 1981.)
  classic,
  /// Rx(α) Tx(a) Rz(θ) Tz(d): z of frame j is the axis of joint j; a and α are those of the link before it. (Craig,
  /// Introduction to robotics: mechanics and control, 1986.)
  modified,
};

/// T_ij of two neighbouring link frames. (Han Jianyou et al., Modern Synthesis Theory and Methods of Linkages, 2013,
/// section 1.3.3, names the transform after Hartenberg and Denavit.) Errors: `not_finite`.
[[nodiscard]] Result<Displacement> hartenberg_denavit(const HartenbergDenavit& link, HartenbergDenavitForm form);

/// T_0n of a chain of n links: the product of their transforms; the identity for none. Errors: `not_finite`, its place
/// the link, e.g. `links[2].theta`.
[[nodiscard]] Result<Displacement> hartenberg_denavit_chain(std::span<const HartenbergDenavit> links,
                                                            HartenbergDenavitForm form);

/// T_01, T_02, …, T_0n: every link frame of the chain in frame 0. Errors as above.
[[nodiscard]] Result<std::vector<Displacement>> hartenberg_denavit_frames(std::span<const HartenbergDenavit> links,
                                                                          HartenbergDenavitForm form);

/// The parameters of a transform.
struct HartenbergDenavitFit {
  HartenbergDenavit link;  ///< θ and α in (−π, π]
  /// How far the two frames are from what the form can say, which is only that x of the later frame (classic; modified:
  /// of the earlier) meets z of the other at a right angle: the cosine between the two, 0 for a right angle …
  double angle_defect = 0;
  double distance_defect = 0;  ///< … and the shortest distance between those two lines, the user's length
};

/// The inverse of hartenberg_denavit(). Six freedoms of a displacement do not go into four parameters: the defects say
/// what is left, and with both 0 (to rounding) the parameters give the transform back. Errors: `not_finite`.
[[nodiscard]] Result<HartenbergDenavitFit> hartenberg_denavit_of(const Displacement& t_ij, HartenbergDenavitForm form);

/// A chain of links by the lines of its joints.
struct LinkChain {
  Displacement base;                     ///< frame of the first joint, in the frame in which the lines are given
  std::vector<HartenbergDenavit> links;  ///< one for each joint, in the modified form; the first is all 0
};

/// The parameters of a chain whose joint axes lie in given lines at the reference attitude: base and the chain of the
/// first k links, in the modified form, make the frame of joint k, its z in line k. x of each frame is the common
/// normal to the next line; where two lines are parallel it is that through the origin the frame has from the line
/// before (or through the point of the first line), so that d is 0; where they coincide, and at the last joint, the x
/// before is kept (at the first, any normal of the line). Errors: `not_finite`, `zero_axis`, their place the line, e.g.
/// `axes[2]`; `no_axes` for an empty list.
[[nodiscard]] Result<LinkChain> hartenberg_denavit_of_axes(std::span<const Line> axes);

}  // namespace linkwright
