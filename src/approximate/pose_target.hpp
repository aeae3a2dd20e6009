#pragma once

#include <vector>

#include "approximate/body_linkage.hpp"
#include "linkwright/approximate/pose_fit.hpp"

namespace linkwright {

/// Asserts what a PoseTarget is to be, and that so many of its poses are distinct, three at most.
void require_pose_target(const PoseTarget& target, std::size_t distinct);

/// Some of the poses of a target, in the frame in which it is fitted: centroid of all origins at 0, a scale of 1.
struct ScaledPoses {
  std::vector<BodyPose> poses;
  std::vector<double> weights;  ///< of the near ones, with a mean of about 1; 0 of exact ones
  std::vector<std::size_t> exact;

  /// Exact ones weigh `factor` times as much as a near one.
  [[nodiscard]] std::vector<double> weights_with(double factor) const;
};

/// The frame of a fit.
struct PoseFrame {
  Point centroid{};
  double unit = 1;            ///< user's: the target's scale
  double turning_length = 1;  ///< over the unit

  explicit PoseFrame(const PoseTarget& target);
  [[nodiscard]] Point scaled(Point user) const { return (user - centroid) / unit; }
  [[nodiscard]] BodyPose scaled(const Pose& user) const { return {scaled(user.origin), direction(user.angle)}; }
  [[nodiscard]] FourBar scaled(const FourBar& user) const {
    return {scaled(user.input_fixed), scaled(user.input_moving), scaled(user.output_fixed), scaled(user.output_moving)};
  }
  [[nodiscard]] BodyLinkage in_user_frame(const BodyLinkage& l) const {
    return {centroid + unit * l.a0, centroid + unit * l.b0, unit * l.a, unit * l.b, unit * l.za, unit * l.zb};
  }
  [[nodiscard]] BodyPose in_user_frame(const BodyPose& p) const { return {centroid + unit * p.origin, p.axis}; }
  [[nodiscard]] ScaledPoses scaled(const PoseTarget& target, const std::vector<std::size_t>& chosen) const;
};

/// Exact poses, and of the others as many, evenly by their numbers, as make `count`: what stands for all where starts
/// are looked for. Ascending.
[[nodiscard]] std::vector<std::size_t> chosen_poses(const PoseTarget& target, std::size_t count);

}  // namespace linkwright
