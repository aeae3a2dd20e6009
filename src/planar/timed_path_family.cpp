#include "timed_path_family.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "crank_pair_kernel.hpp"
#include "kernel_arrays.hpp"
#include "linkwright/core/tolerance.hpp"
#include "linkwright/planar/path_crank.hpp"
#include "linkwright/planar/timed_path.hpp"
#include "region/pair_map.hpp"
#include "timed_cranks.hpp"

namespace linkwright {
namespace {

std::vector<PrescribedPose> turns_of(std::span<const PrescribedPose> crank_poses) {
  std::vector<PrescribedPose> turns;
  for (const PrescribedPose& there : crank_poses) {
    turns.push_back({{0, there.pose.angle}, {}});
    for (const PoseDerivative& d : there.derivatives) turns.back().derivatives.push_back({0, d.angle});
  }
  return turns;
}

// All cranks turn alike.
DyadAxis turning_crank(std::span<const PrescribedPose> crank_poses, bool respect_direction) {
  return DyadAxis({{Homogeneous::of(0), Homogeneous::of(1), 0}}, turns_of(crank_poses), respect_direction);
}

Notice too_few_cranks(std::size_t count) {
  if (count == 0)
    return {"no_crank",
            "No real crank: no four-bar takes a point of its coupler exactly through these five positions at these "
            "angles. Change an angle a little, or leave one point out.",
            {}};
  return {"one_crank",
          "Only one crank goes with these five positions, and a four-bar needs two, its own and its cognate's. Change "
          "an angle a little, or leave one point out.",
          {}};
}

// Where the first point itself runs on a circle of the crank's body: its centre.
std::optional<Notice> on_circle(const TaskFamily& given) {
  if (!given.curve) return std::nullopt;
  const Homogeneous first = Homogeneous::of(0), center = given.curve->center_of(first);
  if (given.curve->residual({center, first, 0}) > tolerance::vanishing_coefficient) return std::nullopt;
  const auto at = finite_point(center);
  const auto tau = given.curve->coordinate_of(first);
  if (!at || !tau) return std::nullopt;
  const Point user = given.frame().to_user(*at);
  return Notice{"points_on_circle",
                fmt::format("The points lie on a circle about ({:.6g}, {:.6g}). Among the linkages are those whose "
                            "output link carries the point round it: column {:.6g} of the solution region.",
                            user.real(), user.imag(), *tau),
                {{"x", user.real()}, {"y", user.imag()}, {"coordinate", *tau}}};
}

// Said of points, where that of poses would mislead.
Notice of_points(Notice notice) {
  if (notice.code == "ill_conditioned")
    notice.message =
        "The points are so close together that round-off dominates; replace points that lie close together by one "
        "point with derivatives (direction of travel, curvature).";
  return notice;
}

bool is_of_cranks(const Notice& notice) { return notice.code != "parallel_poses"; }

}  // namespace

TimedPathFamily::TimedPathFamily(const PathTask& task, std::shared_ptr<const FourBarFamily> cranks)
    : PathFamily(cranks->frame(), cranks->axis(Side::input), cranks->axis(Side::output)),
      cranks_(std::move(cranks)),
      user_poses_(angled_poses(task)),
      working_poses_(frame().to_working(user_poses_)),
      derivative_rows_(derivative_conditions(user_poses_, frame())) {}

std::optional<double> TimedPathFamily::rate_residual(MapPoint place) const {
  const auto crank = cranks_->dyad(Side::input, place.input), cognate = cranks_->dyad(Side::output, place.output);
  if (derivative_rows_.empty() || !crank || !cognate) return std::nullopt;
  return std::max(residual_of(*crank, derivative_rows_), residual_of(*cognate, derivative_rows_));
}

std::optional<DyadPair> TimedPathFamily::dyad_pair(MapPoint place) const {
  const auto crank = cranks_->dyad(Side::input, place.input), cognate = cranks_->dyad(Side::output, place.output);
  return crank && cognate ? linkage_of_cranks(*crank, *cognate) : std::nullopt;
}

FourBarFamily::DyadPairsOfCells TimedPathFamily::dyad_pairs_of_cells(std::span<const double> input,
                                                                     std::span<const double> output) const {
  return [rows = cranks_->dyads(Side::input, input), columns = cranks_->dyads(Side::output, output)](
             std::size_t row, std::size_t column) { return linkage_of_cranks(rows[row], columns[column]); };
}

std::optional<Dyad> TimedPathFamily::dyad(Side side, double tau) const {
  const auto crank = side == Side::input ? cranks_->dyad(side, tau) : std::nullopt;
  return crank ? std::optional(crank_link(*crank)) : std::nullopt;
}

std::vector<PrescribedPose> TimedPathFamily::user_poses(MapPoint /*place*/, const FourBar& bars) const {
  return path_poses(bars, user_poses_);
}
std::vector<PrescribedPose> TimedPathFamily::working_poses(MapPoint /*place*/, const FourBar& bars) const {
  return path_poses(bars, working_poses_);
}

std::vector<double> TimedPathFamily::samples(Side side, int count, Spacing spacing) const {
  return cranks_->samples(side, count, spacing);
}

std::vector<Dyad> TimedPathFamily::polygon(Side side) const {
  std::vector<Dyad> links;
  if (side == Side::input)
    for (const Dyad& crank : cranks_->polygon(side)) links.push_back(crank_link(crank));
  return links;
}

std::optional<AxisArcs> TimedPathFamily::arcs_within(Side side, const PivotWindows& windows) const {
  if (side == Side::output) return std::nullopt;
  return AxisArcs{arcs_of_dyads(side, windows, [&](double tau) { return dyad(side, tau); }), axis(side).is_discrete()};
}

// No linkage has a crank without length.
void TimedPathFamily::fill(RegionMap& map, std::span<const double> input, std::span<const double> output,
                           bool respect_direction, const RegionOptions& options, const Progress& progress) const {
  DyadAxis cranks(cranks_->dyads(Side::input, input), working_poses_, respect_direction, DyadAxis::Role::driven);
  const DyadAxis cognates(cranks_->dyads(Side::output, output), working_poses_, respect_direction,
                          DyadAxis::Role::driven);
  std::vector<double> crank_length(cranks.size(), 0);
  for (std::size_t row = 0; row < cranks.size(); ++row) {
    crank_length[row] = std::hypot(cranks.circle_x[row], cranks.circle_y[row]);
    if (crank_length[row] <= tolerance::change_point) cranks.length[row] = 0;
  }
  const DyadAxis turning = turning_crank(working_poses_, respect_direction);
  map.lay(input, output, planar_measures, pairs_decide_sense(turning, turning.pose_count()), options);
  map.set_diagonal(diagonal_of(cranks.dyads, cognates.dyads, same_points));
  for (std::size_t row = 0; row < map.rows(); ++row) map.set_driver(row, driver_travel(turning, 0));
  const CrankPairTask task{plain_arrays(cranks),
                           plain_arrays(cognates),
                           crank_length.data(),
                           turning.admissible_directions.front(),
                           turning.at_least_half_turn.front(),
                           0,
                           map.rows(),
                           map.columns(),
                           static_cast<int>(turning.pose_count()),
                           frame().scale,
                           tolerance::change_point,
                           kernel_cells(map.cells(0))};
  run_rows(map, task, crank_pair_kernel.for_simd(options.simd), options, progress);
}

// The cranks are the dyads of a motion task.
TaskFamily family_of_timed(const PathTask& task) {
  TaskFamily given = task_family(MotionTask{angled_poses(task), {}, {}, {}, {}}, Requirements{}, Objective{});
  given.derivative_rows.clear();
  std::erase_if(given.warnings, [](const Notice& notice) { return !is_of_cranks(notice); });
  std::transform(given.warnings.begin(), given.warnings.end(), given.warnings.begin(), of_points);
  if (given.has_no_dyads) given.degeneracy = too_few_cranks(given.points.size());
  if (!given.family) return given;
  if (auto notice = on_circle(given)) given.warnings.push_back(*std::move(notice));
  given.paths = std::make_shared<const TimedPathFamily>(task, given.family);
  given.family = given.paths;
  return given;
}

}  // namespace linkwright
