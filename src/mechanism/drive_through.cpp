#include "linkwright/mechanism/drive_through.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "circuit_drive.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

Vector3 in_space(Point p) { return {p.real(), p.imag(), 0}; }

/// How fast the first derivative of a pose moves a point of the body that lies at `point` in it.
Point rate_of(const PrescribedPose& pose, Point point) {
  const PoseDerivative& d = pose.derivatives.front();
  return d.origin + Point{0, d.angle} * (point - pose.pose.origin);
}

DriveTarget target_of(const FourBar& four_bar, const Pose& first, const PrescribedPose& prescribed) {
  const Pose& pose = prescribed.pose;
  const Point ground = four_bar.output_fixed - four_bar.input_fixed;
  const Point turn = std::conj(ground) / std::abs(ground);
  const Point input_moving = displaced(four_bar.input_moving, first, pose);
  const Point output_moving = displaced(four_bar.output_moving, first, pose);
  const Point a = turn * (input_moving - four_bar.input_fixed), b = turn * (output_moving - four_bar.input_fixed);
  DriveTarget target{{std::arg(a), std::arg(b - a), std::arg(b - std::abs(ground))}, {in_space(a), in_space(b)}, {}};
  if (!prescribed.derivatives.empty())
    target.rates = {in_space(turn * rate_of(prescribed, input_moving)),
                    in_space(turn * rate_of(prescribed, output_moving))};
  return target;
}

bool can_be_driven(const FourBar& four_bar, std::span<const PrescribedPose> poses, const DriveThroughOptions& options) {
  const LinkLengths lengths = four_bar.lengths();
  const double perimeter = lengths.perimeter();
  const bool links = std::isfinite(perimeter) && lengths.shortest() > tolerance::change_point * perimeter;
  return links && !poses.empty() && options.step > 0 &&
         std::all_of(poses.begin(), poses.end(),
                     [](const PrescribedPose& p) { return is_finite(p.pose.origin) && std::isfinite(p.pose.angle); });
}

}  // namespace

DriveThroughReport drive_through(const FourBar& four_bar, std::span<const PrescribedPose> poses,
                                 const DriveThroughOptions& options) {
  if (!can_be_driven(four_bar, poses, options)) return {};
  std::vector<DriveTarget> targets;
  for (const PrescribedPose& pose : poses) targets.push_back(target_of(four_bar, poses[0].pose, pose));
  return drive_along(PlanarConfigurationCurve(four_bar.lengths()), std::move(targets), options);
}

}  // namespace linkwright
