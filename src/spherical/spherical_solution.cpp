#include "linkwright/spherical/spherical_solution.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/tolerance.hpp"
#include "linkwright/mechanism/spherical_defects.hpp"
#include "linkwright/mechanism/spherical_position.hpp"

namespace linkwright {
namespace {

double angle_residual(const SphericalDyad& dyad, const std::vector<PrescribedOrientation>& orientations) {
  double worst = 0;
  for (const PrescribedOrientation& there : orientations) {
    const Vector3 moved = turned(dyad.moving_axis, orientations.front().orientation, there.orientation);
    worst = std::max(worst, std::abs(dot(dyad.fixed_axis, moved - dyad.moving_axis)));
  }
  return worst;
}

std::optional<double> rate_residual(const std::vector<Matrix3x3>& rows, const SphericalDyadPair& links) {
  if (rows.empty()) return std::nullopt;
  return std::max(residual_of(links.input.fixed_axis, links.input.moving_axis, rows),
                  residual_of(links.output.fixed_axis, links.output.moving_axis, rows));
}

}  // namespace

std::optional<SphericalSolution> make_spherical_four_bar(const SphericalTaskFamily& given, MapPoint place,
                                                         bool respect_direction, bool verify) {
  const auto links = given.family ? given.family->dyad_pair(place) : std::nullopt;
  if (!links) return std::nullopt;
  SphericalSolution made;
  made.four_bar = given.family->four_bar(*links);
  made.input = {made.four_bar.input_fixed, made.four_bar.input_moving, links->input.coordinate};
  made.output = {made.four_bar.output_fixed, made.four_bar.output_moving, links->output.coordinate};
  made.angles = made.four_bar.angles();
  const auto orientations = given.family->orientations(place, made.four_bar);
  made.report = find_defects(made.four_bar, orientations, respect_direction);
  if (made.report.type == LinkageType::degenerate) return std::nullopt;
  made.swapped = find_defects(made.four_bar.swapped(), orientations, respect_direction);
  made.input_residual = angle_residual(made.input, orientations);
  made.output_residual = angle_residual(made.output, orientations);
  made.residual = std::max(made.input_residual, made.output_residual);
  made.residual_derivatives = rate_residual(given.derivative_rows, *links);
  if (verify) {
    constexpr int max_steps = 50'000;  // as of planar four-bars
    const DriveThroughReport driven =
        drive_through(made.four_bar, orientations, {.max_steps = max_steps, .respect_direction = respect_direction});
    made.verified_by_driving = driven.completed && driven.defects == made.report.defects;
  }
  return made;
}

bool is_unconfirmed(const SphericalSolution& found) {
  if (found.residual > tolerance::side_link_length) return true;
  return found.report.defects.none() && !found.verified_by_driving;
}

}  // namespace linkwright
