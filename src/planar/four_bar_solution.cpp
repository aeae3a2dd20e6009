#include "linkwright/planar/four_bar_solution.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/tolerance.hpp"
#include "linkwright/mechanism/drive_through.hpp"
#include "linkwright/mechanism/pose_visits.hpp"
#include "planar/length_check.hpp"

namespace linkwright {
namespace {

// By how much the grounded links, at unit scale, fail to keep still to the orders that the derivatives prescribe.
std::optional<double> derivative_residual(const std::vector<HomogeneousMatrix>& rows, const DyadPair& links) {
  if (rows.empty()) return std::nullopt;
  return std::max(residual_of(links.input, rows), residual_of(links.output, rows));
}

}  // namespace

std::optional<FourBarSolution> make_four_bar(const TaskFamily& given, MapPoint place, bool respect_direction,
                                             bool verify) {
  const auto links = given.family ? given.family->dyad_pair(place) : std::nullopt;
  const WorkingFrame& frame = given.frame();
  const auto seen = links ? four_bar_of(*links) : std::nullopt;
  if (!seen) return std::nullopt;
  const FourBar bars = frame.to_user(*seen);
  const std::vector<PrescribedPose> poses = given.family->user_poses(place, bars);
  FourBarSolution solution;
  solution.input = frame.to_user(links->input);
  solution.output = frame.to_user(links->output);
  solution.four_bar = bars;
  solution.lengths = bars.lengths();
  solution.report = find_defects(bars, poses, respect_direction);
  if (solution.report.type == LinkageType::degenerate) return std::nullopt;
  solution.swapped = find_defects(bars.swapped(), poses, respect_direction);
  const LengthCheck lengths(poses);
  solution.input_residual = lengths.residual(bars.input_fixed, bars.input_moving);
  solution.output_residual = lengths.residual(bars.output_fixed, bars.output_moving);
  solution.residual = std::max(solution.input_residual, solution.output_residual);
  if (given.relaxed) solution.pose_error = pose_error(bars, poses, *given.relaxed);
  solution.residual_derivatives = derivative_residual(given.derivative_rows, *links);
  if (verify) {
    // Hundreds of times as many as an ordinary circuit takes: beside a short link steps get as short.
    constexpr int max_steps = 50'000;
    const DriveThroughReport driven =
        drive_through(bars, poses, {.max_steps = max_steps, .respect_direction = respect_direction});
    solution.verified_by_driving = driven.completed && driven.defects == solution.report.defects;
  }
  return solution;
}

bool is_unconfirmed(const FourBarSolution& found) {
  if (found.residual > tolerance::side_link_length) return true;
  return found.report.defects.none() && !found.verified_by_driving;
}

std::optional<Notice> defect_notice(const FourBarSolution& found, const TaskFamily& given) {
  if (found.report.defects.none()) return std::nullopt;
  const auto poses = given.family->user_poses({found.input.coordinate, found.output.coordinate}, found.four_bar);
  return defect_notice(found.report.defects, pose_visits(found.four_bar, poses));
}

}  // namespace linkwright
