#include <algorithm>
#include <cmath>

#include "linkwright/analysis/drive_through.hpp"
#include "linkwright/planar/motion_synthesis.hpp"

namespace linkwright {
namespace {

// Worst change of the side link's length over the poses, relative to its length.
double length_residual(const MotionTask& task, Point center, Point circle) {
  const double length = std::abs(circle - center);
  double worst = 0;
  for (const PrescribedPose& pose : task.poses) {
    const Point moved = displaced(circle, task.poses.front().pose, pose.pose);
    worst = std::max(worst, std::abs(std::abs(moved - center) - length) / length);
  }
  return worst;
}

// By how much the side links, at unit scale, fail to keep still to the orders that the derivatives prescribe.
std::optional<double> derivative_residual(const MotionTask& task, const WorkingFrame& frame, const Dyad& input,
                                          const Dyad& output) {
  const std::vector<HomogeneousMatrix> conditions = derivative_conditions(task.poses, frame);
  if (conditions.empty()) return std::nullopt;
  double worst = 0;
  for (const Dyad& dyad : {input, output}) {
    const Homogeneous circle = normalized(frame.to_working(dyad.circle)),
                      center = normalized(frame.to_working(dyad.center));
    for (const HomogeneousMatrix& row : conditions) worst = std::max(worst, std::abs(dot(circle, row * center)));
  }
  return worst;
}

}  // namespace

std::optional<FourBarSolution> make_four_bar(const MotionTask& task, const WorkingFrame& frame, const Dyad& input,
                                             const Dyad& output, bool respect_direction, bool verify) {
  const auto a = frame.finite_user_point(input.center), b = frame.finite_user_point(input.circle);
  const auto c = frame.finite_user_point(output.center), d = frame.finite_user_point(output.circle);
  if (!a || !b || !c || !d) return std::nullopt;
  FourBarSolution solution;
  solution.input = input;
  solution.output = output;
  solution.four_bar = {*a, *b, *c, *d};
  solution.lengths = solution.four_bar.lengths();
  solution.report = find_defects(solution.four_bar, task.poses, respect_direction);
  if (solution.report.type == LinkageType::degenerate) return std::nullopt;
  solution.swapped = find_defects(solution.four_bar.swapped(), task.poses, respect_direction);
  solution.input_residual = length_residual(task, *a, *b);
  solution.output_residual = length_residual(task, *c, *d);
  solution.residual = std::max(solution.input_residual, solution.output_residual);
  solution.residual_derivatives = derivative_residual(task, frame, input, output);
  if (verify) {
    const DriveThroughReport driven =
        drive_through(solution.four_bar, task.poses, {.respect_direction = respect_direction});
    solution.verified_by_driving = driven.completed && driven.defects == solution.report.defects;
  }
  return solution;
}

}  // namespace linkwright
