#include "linkwright/planar/six_bar_analysis.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/angle.hpp"

namespace linkwright {
namespace {

constexpr double six_bar_row_step = radians(1);

}  // namespace

SixBarAnalysis analyze(const SixBar& six_bar, std::span<const PrescribedPose> poses) {
  SixBarAnalysis analysis{.shape = shape_of(six_bar), .lengths = six_bar.lengths()};
  const SixBarTransmission as_it_lies = six_bar_transmission(six_bar, {1, 1, 1, 1, 1, 1});
  analysis.transmission_angle = std::asin(std::min(as_it_lies.sine, 1.0));
  if (poses.size() > 1) analysis.travel = travel_through(six_bar, poses, six_bar_row_step);
  analysis.motion = with_nearest_states(six_bar, poses, six_bar_motion(six_bar, poses, six_bar_row_step));
  return analysis;
}

SixBarMotion tabulated_motion(const SixBar& six_bar, std::span<const PrescribedPose> poses) {
  SixBarMotion travel;
  if (poses.size() > 1) travel = travel_through(six_bar, poses, six_bar_row_step);
  return travel.states.empty() ? with_nearest_states(six_bar, poses, six_bar_motion(six_bar, poses, six_bar_row_step))
                               : travel;
}

}  // namespace linkwright
