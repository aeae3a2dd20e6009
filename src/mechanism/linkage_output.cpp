#include "linkwright/mechanism/linkage_output.hpp"

#include <algorithm>
#include <utility>

#include "linkwright/core/precondition.hpp"

namespace linkwright {
namespace {

/// Bars that lie in the first of the poses, in all of them, and the body's origin.
std::vector<TracingFourBar> carried_along(const FourBar& bars, std::span<const PrescribedPose> poses) {
  std::vector<TracingFourBar> positions;
  for (const PrescribedPose& there : poses) {
    const auto moved = [&](Point p) { return displaced(p, poses.front().pose, there.pose); };
    positions.push_back({{bars.input_fixed, moved(bars.input_moving), bars.output_fixed, moved(bars.output_moving)},
                         there.pose.origin});
  }
  return positions;
}

}  // namespace

PlanarOutput pose_output(std::vector<TracingFourBar> positions, double turning_length) {
  return {PlanarOutput::Kind::pose, std::move(positions), turning_length, {}, false};
}

PlanarOutput pose_output(const FourBar& bars, std::span<const PrescribedPose> poses) {
  PlanarOutput output = pose_output(carried_along(bars, poses), 0);
  if (!poses.empty()) output.body_angle = poses.front().pose.angle;
  for (const PrescribedPose& there : poses) output.derivatives.push_back(there.derivatives);
  return output;
}

std::vector<PrescribedPose> poses_of(const PlanarOutput& output) {
  const auto coupler = [](const TracingFourBar& at) { return at.bars.output_moving - at.bars.input_moving; };
  std::vector<PrescribedPose> poses;
  for (const TracingFourBar& at : output.positions) {
    const double turned = std::arg(coupler(at) / coupler(output.positions.front()));
    poses.push_back({{at.point, output.body_angle + turned}, {}});
  }
  for (std::size_t j = 0; j < std::min(poses.size(), output.derivatives.size()); ++j)
    poses[j].derivatives = output.derivatives[j];
  return poses;
}

PlanarOutput point_output(const FourBar& bars, std::span<const PrescribedPose> poses) {
  PlanarOutput output = pose_output(bars, poses);
  output.of_point = true;
  return output;
}

PlanarOutput angle_output(std::span<const FourBar> positions) {
  PlanarOutput output{PlanarOutput::Kind::angle, {}, 0, {}, false};
  for (const FourBar& bars : positions) output.positions.push_back({bars, bars.input_moving});
  return output;
}

PlanarOutput angle_output(const FourBar& bars, std::span<const PrescribedPose> poses) {
  std::vector<FourBar> all;
  for (const TracingFourBar& linkage : carried_along(bars, poses)) all.push_back(linkage.bars);
  return angle_output(all);
}

PlanarOutput line_output(std::vector<TracingFourBar> stroke, const DirectedLine& line, bool realigned) {
  require(!realigned || stroke.size() >= 3, "a line is realigned over three positions at least");
  return {PlanarOutput::Kind::line, std::move(stroke), 0, line, realigned};
}

SphericalOutput spherical_output(SphericalOutput::Kind kind, const SphericalFourBar& bars,
                                 std::span<const PrescribedOrientation> orientations) {
  SphericalOutput output{kind, {}};
  const UnitQuaternion first = orientations.front().orientation;
  for (const PrescribedOrientation& there : orientations) {
    const auto moved = [&](Vector3 axis) { return turned(axis, first, there.orientation); };
    output.positions.push_back(
        {bars.input_fixed, moved(bars.input_moving), moved(bars.output_moving), bars.output_fixed});
  }
  return output;
}

std::size_t positions_of(const LinkageOutput& output) {
  return std::visit([](const auto& one) { return one.positions.size(); }, output);
}

bool is_line(const LinkageOutput& output) {
  const auto* const planar = std::get_if<PlanarOutput>(&output);
  return planar != nullptr && planar->kind == PlanarOutput::Kind::line;
}

bool is_angle(const LinkageOutput& output) {
  if (const auto* const planar = std::get_if<PlanarOutput>(&output)) return planar->kind == PlanarOutput::Kind::angle;
  return std::holds_alternative<SphericalOutput>(output);
}

LinkageOutput with_turning_length(LinkageOutput output, double turning_length) {
  auto* const planar = std::get_if<PlanarOutput>(&output);
  if (planar && planar->kind == PlanarOutput::Kind::pose && !planar->of_point) planar->turning_length = turning_length;
  if (auto* const six_bar = std::get_if<SixBarOutput>(&output)) six_bar->turning_length = turning_length;
  return output;
}

}  // namespace linkwright
