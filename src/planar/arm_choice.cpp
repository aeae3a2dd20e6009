#include "arm_choice.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "degenerate_task.hpp"
#include "five_point_four_bars.hpp"
#include "given_pivot_family.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/tolerance.hpp"
#include "linkwright/planar/burmester_curve.hpp"
#include "linkwright/planar/motion_task.hpp"
#include "task_curve.hpp"
#include "three_pose_dyads.hpp"

namespace linkwright {

// ---- the task -------------------------------------------------------------------------------------------------------

namespace {

Point centroid_of(const PathTask& task) {
  Point sum{};
  for (const PathPoint& point : task.points) sum += point.point;
  return sum / static_cast<double>(task.points.size());
}

// Root of the mean square of the points' distances from their centroid; of one point its distance from the pivot, and
// at the pivot its speed.
double size_of(const PathTask& task) {
  const Point middle = centroid_of(task);
  double squares = 0;
  for (const PathPoint& point : task.points) squares += std::norm(point.point - middle);
  if (squares > 0) return std::sqrt(squares / static_cast<double>(task.points.size()));
  for (const auto& pivot : {task.pivots.input, task.pivots.output})
    if (pivot && *pivot != middle) return std::abs(*pivot - middle);
  const auto& derivatives = task.points.front().derivatives;
  const double speed = derivatives.empty() ? 0 : std::abs(derivatives.front().point);
  return speed > 0 ? speed : 1;
}

PathPlace path_place(const PathPoint& point, const WorkingFrame& frame) {
  PathPlace place;
  place.jet.push_back(frame.to_working(point.point));
  for (const PathDerivative& d : point.derivatives) place.jet.push_back(d.point / frame.scale);
  if (point.is_plain()) return place;
  place.known = point.angle ? PathPlace::Angle::of_body : PathPlace::Angle::of_link;
  return place;
}

std::vector<std::array<std::size_t, 2>> points_at_one_place(std::span<const PathPlace> path) {
  std::vector<std::array<std::size_t, 2>> pairs;
  for (std::size_t i = 0; i < path.size(); ++i)
    for (std::size_t j = i + 1; j < path.size(); ++j)
      if (std::abs(path[i].jet.front() - path[j].jet.front()) <= tolerance::repeated_pose) pairs.push_back({i, j});
  return pairs;
}

}  // namespace

ArmTask arm_task(const PathTask& task) {
  ArmTask arms;
  const bool only_output = task.form() == PathForm::arms && !task.pivots.input;
  arms.side = only_output ? Side::output : Side::input;
  arms.frame = {task.points.front().point, size_of(task)};
  arms.points = task.points;
  if (task.timing() != PathTiming::none) arms.sense = crank_sense(task);
  const std::vector<PrescribedPose> poses = angled_poses(task);
  std::size_t next = 0;
  for (const PathPoint& point : task.points) {
    arms.path.push_back(path_place(point, arms.frame));
    if (point.is_plain()) continue;
    const PrescribedPose& pose = poses[next++];
    arms.path.back().angles.push_back(pose.pose.angle);
    for (const PoseDerivative& d : pose.derivatives) arms.path.back().angles.push_back(d.angle);
  }
  arms.repeated = points_at_one_place(arms.path);
  return arms;
}

std::size_t ArmTask::plain_count() const {
  return static_cast<std::size_t>(std::count_if(
      path.begin(), path.end(), [](const PathPlace& place) { return place.known == PathPlace::Angle::none; }));
}

std::vector<Point> ArmTask::plain_places() const {
  std::vector<Point> places;
  for (const PathPlace& place : path)
    if (place.known == PathPlace::Angle::none) places.push_back(place.jet.front());
  return places;
}

namespace {

// ---- arms of every length -------------------------------------------------------------------------------------------

MapAxis range_axis(AxisQuantity quantity) { return {quantity, {{"", 0, 1}}}; }

/// All arms from a given pivot that reach the points: their rectangle (ArmReach).
class ReachChoice : public ArmChoice {
 public:
  ReachChoice(const ArmTask& task, Point pivot, std::optional<Point> other)
      : ArmChoice(range_axis(AxisQuantity::arm_reach), range_axis(AxisQuantity::arm_difference), LayersOf::input_axis,
                  other.has_value()),
        pivot_(pivot),
        other_(other),
        reach_(pivot, task.plain_places()) {}

  [[nodiscard]] std::optional<ArmAtPlace> at(MapPoint place) const override {
    const double u = place.input, v = axis_value(Side::output, place.output);
    if (!(u > 0 && u <= 1 && v >= -1 && v <= 1)) return std::nullopt;
    const Arm arm = reach_.arm(u, v);
    return ArmAtPlace{{pivot_, arm, {}}, reach_.elbows(arm), other_};
  }
  [[nodiscard]] double axis_value(Side side, double coordinate) const override {
    return side == Side::input ? coordinate : 2 * coordinate - 1;
  }

 private:
  Point pivot_;
  std::optional<Point> other_;
  ArmReach reach_;
};

// ---- arms that keep angles ------------------------------------------------------------------------------------------

/// The dyads of the positions with angles are arms: of the coupler they are the input link, of a body that turns with
/// the crank they are crank and coupler exchanged (docs/theory/path.md).
class AngledArms {
 public:
  /// `poses`: angled_poses() of the task; `dyads_in`: the frame in which dyads are given, the first of them being the
  /// position in which their circle points lie.
  AngledArms(const ArmTask& task, const std::vector<PrescribedPose>& poses, const WorkingFrame& dyads_in)
      : frame_(task.frame),
        dyads_in_(dyads_in),
        plain_(task.plain_places()),
        first_(poses.front().pose),
        of_crank_(task.sense.has_value()) {}

  /// Nothing where a point is at infinity, a part of the arm has no length, or a point is out of reach.
  [[nodiscard]] std::optional<ArmAtPlace> arm_of(const Dyad& dyad, std::optional<Point> other) const {
    const auto center = finite_point(dyad.center), circle = finite_point(dyad.circle);
    if (!center || !circle) return std::nullopt;
    const Point pivot = frame_.to_working(dyads_in_.to_user(*center));
    const Point point_on_body = frame_.to_working(dyads_in_.to_user(*circle));
    const Point rest = frame_.to_working(first_.origin) - point_on_body;
    const double turning = std::abs(point_on_body - pivot), carried = std::abs(rest);
    if (!(turning > 0) || !(carried > 0)) return std::nullopt;
    ArmAtPlace found;
    found.arm = {pivot, of_crank_ ? Arm{carried, turning} : Arm{turning, carried}, direction(-first_.angle) * rest};
    found.other = other;
    if (plain_.empty()) return found;
    const ArmReach reach(pivot, plain_);
    if (!reach.contains(found.arm.lengths)) return std::nullopt;
    found.elbows = reach.elbows(found.arm.lengths);
    return found;
  }

 private:
  WorkingFrame frame_, dyads_in_;
  std::vector<Point> plain_;
  Pose first_;
  bool of_crank_;
};

MapAxis pivot_axis(const PathTask& task, AxisQuantity quantity) {
  return range_axis(task.pivots.count() == 2 ? AxisQuantity::nothing : quantity);
}

/// Three positions with angles leave a ground pivot one arm: the map is the plane of a ground pivot, that of the arm,
/// or that of the other link where the arm's is given. Rows run along y. Where both are given it is one place.
class PivotChoice : public ArmChoice {
 public:
  PivotChoice(const PathTask& task, const ArmTask& arms, const std::vector<PrescribedPose>& poses,
              const PoseConditions& conditions)
      : ArmChoice(pivot_axis(task, AxisQuantity::center_y), pivot_axis(task, AxisQuantity::center_x),
                  task.pivots.count() == 0 ? LayersOf::input_axis : LayersOf::nothing, task.pivots.count() > 0),
        frame_(arms.frame),
        dyads_in_(conditions.frame),
        pivots_(task.pivots),
        arms_(arms, poses, conditions.frame),
        dyads_(conditions) {
    const Point middle = frame_.to_working(centroid_of(task));
    ranges_ = {PivotRange{middle.real()}, PivotRange{middle.imag()}};
  }

  [[nodiscard]] std::optional<ArmAtPlace> at(MapPoint place) const override {
    const bool is_on = place.input > 0 && place.input < 1 && place.output > 0 && place.output < 1;
    if (!is_on) return std::nullopt;
    const Point looked_for = frame_.to_user(Point{ranges_[0].at(place.output), ranges_[1].at(place.input)});
    const auto dyad =
        dyads_.dyad_with(PivotKind::ground, Homogeneous::of(dyads_in_.to_working(pivots_.input.value_or(looked_for))));
    if (!dyad) return std::nullopt;
    if (pivots_.count() == 0) return arms_.arm_of(*dyad, std::nullopt);
    return arms_.arm_of(*dyad, frame_.to_working(pivots_.output.value_or(looked_for)));
  }
  [[nodiscard]] double axis_value(Side side, double coordinate) const override {
    return side == Side::output ? frame_.to_user(Point{ranges_[0].at(coordinate), 0}).real()
                                : frame_.to_user(Point{0, ranges_[1].at(coordinate)}).imag();
  }

 private:
  WorkingFrame frame_, dyads_in_;
  GroundPivots pivots_;
  AngledArms arms_;
  ThreePoseDyads dyads_;
  std::array<PivotRange, 2> ranges_;  ///< of x and y
};

MapAxis branch_axis(AxisQuantity quantity, std::size_t count) {
  MapAxis axis{quantity, {}};
  for (std::size_t i = 0; i < count; ++i)
    axis.branches.push_back({"linkage", static_cast<double>(i), static_cast<double>(i + 1)});
  return axis;
}

/// Four positions with angles leave a curve of arms, and each of them some linkages, by their number.
class CurveChoice : public ArmChoice {
 public:
  static constexpr std::size_t linkages_of_arm = 6;

  CurveChoice(const ArmTask& arms, const std::vector<PrescribedPose>& poses, const WorkingFrame& dyads_in,
              std::shared_ptr<const BurmesterCurve> curve)
      : ArmChoice({AxisQuantity::curve_coordinate, curve->branches()},
                  branch_axis(AxisQuantity::layer, linkages_of_arm), LayersOf::output_branch, false),
        curve_(std::move(curve)),
        arms_(arms, poses, dyads_in) {}

  [[nodiscard]] std::optional<ArmAtPlace> at(MapPoint place) const override {
    const double tau = axis(Side::input).onto(place.input);
    if (!(tau >= 0 && tau < axis(Side::input).coordinate_length())) return std::nullopt;
    return arms_.arm_of(curve_->dyad(tau), std::nullopt);
  }

 private:
  std::shared_ptr<const BurmesterCurve> curve_;
  AngledArms arms_;
};

// ---- a few linkages -------------------------------------------------------------------------------------------------

/// Where the elbow stands on the arm of a four-bar: bits of an ElbowPattern.
std::uint8_t sides_of(const FivePointFourBar& found, std::span<const Point> places) {
  const Point pivot = found.bars.input_fixed;
  std::uint8_t bits = 0;
  for (std::size_t j = 0; j < places.size(); ++j)
    if (cross(places[j] - pivot, found.input_moving[j] - pivot) < 0) bits |= static_cast<std::uint8_t>(1 << j);
  return bits;
}

/// Both ground pivots and five points leave some linkages.
class FewChoice : public ArmChoice {
 public:
  /// `linkages`: in the working frame, like the places.
  FewChoice(std::span<const FivePointFourBar> linkages, std::span<const Point> places)
      : ArmChoice(range_axis(AxisQuantity::nothing), branch_axis(AxisQuantity::layer, linkages.size()),
                  LayersOf::nothing, true) {
    for (const FivePointFourBar& found : linkages) {
      const FourBar& bars = found.bars;
      const Arm lengths{std::abs(bars.input_moving - bars.input_fixed), std::abs(places[0] - bars.input_moving)};
      const ArmReach reach(bars.input_fixed, places);
      here_.push_back({{bars.input_fixed, lengths, {}},
                       reach.elbows(lengths),
                       bars.output_fixed,
                       bars.output_moving,
                       sides_of(found, places)});
    }
  }

  [[nodiscard]] std::optional<ArmAtPlace> at(MapPoint place) const override {
    const bool is_on = place.output >= 0 && place.output < static_cast<double>(here_.size());
    return is_on ? std::optional(here_[static_cast<std::size_t>(place.output)]) : std::nullopt;
  }

 private:
  std::vector<ArmAtPlace> here_;
};

/// `sentence`: of how many solutions there are, and how many were found.
Notice about_solutions(std::string_view code, fmt::format_string<const int&, int&> sentence, int ends) {
  return {std::string(code),
          fmt::format(sentence, FivePointSystem::solutions, ends),
          {{"solutions", FivePointSystem::solutions}, {"ends", ends}}};
}

ArmChoiceSetup choice_of_few(const PathTask& task, const ArmTask& arms) {
  const std::vector<Point> plain = arms.plain_places();
  std::array<Point, 5> places;
  std::copy(plain.begin(), plain.end(), places.begin());
  const FivePointFourBars found = five_point_four_bars(places, arms.frame.to_working(*task.pivots.input),
                                                       arms.frame.to_working(*task.pivots.output));
  ArmChoiceSetup setup;
  setup.has_none = found.real.empty();
  if (setup.has_none) {
    setup.degeneracy = about_solutions(
        "no_linkage_between_pivots",
        "No four-bar on these two ground pivots takes a point of its coupler through all five points: of {} solutions "
        "that such a task has, {} were found, and none of them is real. Move a pivot or a point.",
        found.ends);
    return setup;
  }
  if (found.ends < FivePointSystem::solutions)
    setup.warnings.push_back(about_solutions(
        "fewer_solutions",
        "Of {} solutions that a task of five points and two ground pivots has, {} were found: the others lie at "
        "infinity, coincide, or were lost on their way, so that a linkage may be missing.",
        found.ends));
  setup.choice = std::make_shared<const FewChoice>(found.real, plain);
  return setup;
}

ArmChoiceSetup choice_along_curve(const std::vector<PrescribedPose>& poses, const ArmTask& arms) {
  TaskCurve found = task_curve({poses, {}, {}, {}, {}});
  ArmChoiceSetup setup;
  setup.warnings = std::move(found.warnings);
  setup.degeneracy = std::move(found.degeneracy);
  if (found.curve) setup.choice = std::make_shared<const CurveChoice>(arms, poses, found.conditions.frame, found.curve);
  return setup;
}

ArmChoiceSetup choice_of_pivot(const PathTask& task, const std::vector<PrescribedPose>& poses, const ArmTask& arms) {
  const PoseConditions conditions = pose_conditions(poses);
  ArmChoiceSetup setup;
  setup.degeneracy = shared_center(conditions);
  if (setup.degeneracy) return setup;
  setup.warnings = pose_warnings(poses, conditions);
  setup.choice = std::make_shared<const PivotChoice>(task, arms, poses, conditions);
  return setup;
}

ArmChoiceSetup choice_of_reach(const PathTask& task, const ArmTask& arms) {
  const auto working = [&](const std::optional<Point>& pivot) {
    return pivot ? std::optional(arms.frame.to_working(*pivot)) : std::nullopt;
  };
  const auto input = working(task.pivots.input), output = working(task.pivots.output);
  ArmChoiceSetup setup;
  setup.choice =
      std::make_shared<const ReachChoice>(arms, input ? *input : *output, input && output ? output : std::nullopt);
  return setup;
}

}  // namespace

ArmChoiceSetup arm_choice(const PathTask& task, const ArmTask& arms) {
  const std::vector<PrescribedPose> poses = angled_poses(task);
  switch (task.form()) {
    case PathForm::ground_pivot:
    case PathForm::other_pivot:
      return choice_of_pivot(task, poses, arms);
    case PathForm::curve_of_arms:
      return choice_along_curve(poses, arms);
    case PathForm::few:
      return poses.empty() ? choice_of_few(task, arms) : choice_of_pivot(task, poses, arms);
    default:
      return choice_of_reach(task, arms);
  }
}

}  // namespace linkwright
