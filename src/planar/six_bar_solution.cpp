#include "linkwright/planar/six_bar_solution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/tolerance.hpp"
#include "linkwright/mechanism/six_bar_check.hpp"
#include "linkwright/planar/four_bar_map.hpp"
#include "linkwright/region/cell_judge.hpp"
#include "planar/six_bar_rater.hpp"

namespace linkwright {
namespace {

// SixBar::lengths() one by one: a map asks for those of all its cells.
bool share_a_body(const SixBarJoint& x, const SixBarJoint& y) {
  return x.bodies[0] == y.bodies[0] || x.bodies[0] == y.bodies[1] || x.bodies[1] == y.bodies[0] ||
         x.bodies[1] == y.bodies[1];
}

LinkageType type_of_loop(const SixBar& six_bar) {
  const auto loop = six_bar.four_bar_loop();
  if (!loop) return LinkageType::degenerate;
  const auto at = [&](std::size_t i) { return six_bar.joints[(*loop)[i]].point; };
  return linkage_type(FourBar{at(0), at(1), at(3), at(2)}.lengths());
}

double length_residual(const SixBarMember& member, const std::vector<SixBarLength>& lengths) {
  double worst = 0;
  for (const SixBarTurns& turns : member.turns) {
    const auto joints = joints_at(member.six_bar, turns);
    for (const SixBarLength& length : lengths)
      worst =
          std::max(worst, std::abs(std::abs(joints[length.joints[1]] - joints[length.joints[0]]) / length.length - 1));
  }
  return worst;
}

double pose_residual(const SixBarMember& member, std::span<const PrescribedPose> poses, double longest) {
  double worst = 0;
  for (std::size_t j = 0; j < member.turns.size(); ++j) {
    const Pose reached = guided_pose(member.six_bar, member.turns[j], poses[0].pose);
    const double off = std::abs(reached.origin - poses[j].pose.origin) / longest;
    worst = std::max({worst, off, std::abs(wrap_signed(reached.angle - poses[j].pose.angle))});
  }
  return worst;
}

/// The poses come one after the other in one sense of the driver.
bool visits_all(const SixBar& six_bar, std::span<const PrescribedPose> poses) {
  for (const int sense : {+1, -1}) {
    const SixBarCheck check = check_by_driving(six_bar, poses, sense);
    if (check.visited.size() + 1 == poses.size() && std::is_sorted(check.visited.begin(), check.visited.end()))
      return check.worst_length < tolerance::rigid_body;
  }
  return false;
}

constexpr double six_bar_row_step = radians(1);

}  // namespace

SixBarShape shape_of(const SixBar& six_bar) {
  double shortest = std::numeric_limits<double>::infinity(), longest = 0;  // squares
  for (std::size_t i = 0; i < SixBar::joint_count; ++i)
    for (std::size_t k = i + 1; k < SixBar::joint_count; ++k) {
      if (!share_a_body(six_bar.joints[i], six_bar.joints[k])) continue;
      const double square = std::norm(six_bar.joints[k].point - six_bar.joints[i].point);
      shortest = std::min(shortest, square);
      longest = std::max(longest, square);
    }
  SixBarShape shape;
  shape.longest = std::sqrt(longest);
  shortest = std::sqrt(shortest);
  const bool sound = shortest > tolerance::change_point * shape.longest && std::isfinite(shape.longest);
  shape.link_ratio = sound ? shape.longest / shortest : std::numeric_limits<double>::infinity();
  shape.type = sound ? type_of_loop(six_bar) : LinkageType::degenerate;
  return shape;
}

double SixBarRating::versine() const {
  const double sine = drive.min_sine > 1 ? 1 : drive.min_sine;
  return sine * sine / (1 + std::sqrt((1 - sine) * (1 + sine)));
}

double SixBarRating::min_transmission_angle() const { return std::asin(std::min(1.0, drive.min_sine)); }

MapCell SixBarRating::cell() const {
  if (shape.type == LinkageType::degenerate) return {};
  MapCell cell;
  cell.type = shape.type;
  cell.defects = drive.defects;
  cell.values = {versine(), 0, shape.link_ratio, shape.longest};  // planar_measures
  return cell;
}

Pivots pivots_of(const SixBar& six_bar) {
  Pivots pivots;
  for (const SixBarJoint& joint : six_bar.joints)
    (is_on_ground(joint) ? pivots.ground : pivots.moving).push_back(in_space(joint.point));
  return pivots;
}

Cell cell_of(const SixBar& six_bar, const SixBarRating& rating) {
  Cell cell{rating.cell()};
  cell.pivots = pivots_of(six_bar);
  return cell;
}

SixBarRating rating_of(const SixBarMember& member, bool circuits) {
  if (!circuits) return ratings_of({&member, 1}).front();
  SixBarRating rating{shape_of(member.six_bar), {}};
  if (rating.shape.type != LinkageType::degenerate) {
    rating.drive = drive_six_bar(member.six_bar, member.turns);
  }
  return rating;
}

std::vector<SixBarRating> ratings_of(std::span<const SixBarMember> members, Simd simd) {
  std::vector<SixBarRating> ratings(members.size());
  SixBarRater rater([&](std::size_t place, const SixBarRating& rating) { ratings[place] = rating; }, simd);
  for (std::size_t i = 0; i < members.size(); ++i) rater.add(i, members[i]);
  rater.finish();
  return ratings;
}

bool meets(const Requirements& wanted, const SixBar& six_bar, const SixBarRating& rating) {
  return CellJudge(wanted, unloaded_linkages, planar_measures).passes(cell_of(six_bar, rating));
}

Requirements with_defaults(Requirements wanted, const ThreeLinkChain& chain) {
  return with_default_lengths(std::move(wanted), chain.size());
}

SixBarSolution solution_of(std::span<const PrescribedPose> poses, const ThreeLinkChain& chain, const SixBarRow& row,
                           const SixBarMember& member) {
  SixBarSolution solution;
  solution.chain = chain;
  solution.row = row;
  solution.member = member;
  SixBarDriveOptions exact;
  exact.exact_steps = true;
  solution.rating = {shape_of(member.six_bar), drive_six_bar(member.six_bar, member.turns, exact)};
  solution.lengths = member.six_bar.lengths();
  solution.residual = length_residual(member, solution.lengths);
  solution.pose_residual = pose_residual(member, poses, solution.rating.shape.longest);
  solution.verified_by_driving =
      solution.rating.drive.completed && visits_all(member.six_bar, poses) == solution.rating.drive.defects.none();
  return solution;
}

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
