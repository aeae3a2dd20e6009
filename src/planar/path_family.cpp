#include "path_family.hpp"

#include <cmath>

#include "arm_family.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/driver_sequence.hpp"
#include "timed_path_family.hpp"
#include "turned_arm.hpp"

namespace linkwright {

std::vector<Cell> PathFamily::all_at(MapPoint place, bool respect_direction) const {
  const auto found = cell(place, respect_direction);
  return found ? std::vector{*found} : std::vector<Cell>{};
}

// The diagonal holds none.
std::vector<MapPoint> PathFamily::few_places() const {
  std::vector<MapPoint> places;
  if (!axis(Side::input).is_discrete() || !axis(Side::output).is_discrete()) return places;
  for (const double input : samples(Side::input, 0, Spacing::coordinate))
    for (const double output : samples(Side::output, 0, Spacing::coordinate))
      if (!has_cognates() || input != output) places.push_back({input, output});
  return places;
}

LinkageOutput PathFamily::output_of(MapPoint place, const FourBar& bars) const {
  return point_output(bars, user_poses(place, bars));
}

std::optional<LinkageOutput> PathFamily::output_form() const {
  PlanarOutput form;
  form.of_point = true;
  return form;
}

std::shared_ptr<const FourBarCells> PathFamily::four_bar_cells(const RegionMap& /*map*/) const { return nullptr; }

namespace {

// Derivatives of the angle of a crank whose moving pivot the body carries: of what is left of the point's way.
std::vector<double> crank_rates(const PrescribedPose& there, Point crank, Point arm) {
  std::vector<double> body;
  for (const PoseDerivative& d : there.derivatives) body.push_back(d.angle);
  std::vector<Point> link = turned_arm(arm, 0, body);
  link[0] = crank;
  for (std::size_t m = 1; m < link.size(); ++m) link[m] = there.derivatives[m - 1].origin - link[m];
  return turn_rates(link);
}

}  // namespace

std::vector<PrescribedPose> crank_poses_of(const FourBar& bars, std::vector<PrescribedPose> poses,
                                           std::optional<double> sense) {
  if (poses.empty()) return poses;
  const DriverSequence order = driver_sequence(bars.input_fixed, bars.input_moving, poses, true);
  const bool goes_ccw = sense ? *sense > 0 : order.ccw, goes_cw = sense ? *sense < 0 : order.cw;
  const Pose first = poses.front().pose;
  const Point first_crank = bars.input_moving - bars.input_fixed;
  for (PrescribedPose& there : poses) {
    const Point moving = displaced(bars.input_moving, first, there.pose), crank = moving - bars.input_fixed;
    const bool is_first = &there == &poses.front();
    const double ccw = is_first ? 0 : wrap_positive(std::arg(crank * std::conj(first_crank)));
    const std::vector<double> rates = crank_rates(there, crank, there.pose.origin - moving);
    there.pose.angle = goes_ccw || is_first ? ccw : goes_cw ? ccw - two_pi : wrap_signed(ccw);
    for (std::size_t m = 0; m < rates.size(); ++m) there.derivatives[m].angle = rates[m];
  }
  return poses;
}

TaskFamily task_family(const PathTask& task, const Requirements& requirements, Objective objective) {
  return task.form() == PathForm::cranks ? family_of_timed(task) : family_of_arms(task, requirements, objective);
}

}  // namespace linkwright
