#include "linkwright/planar/near_poses.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "approximate/pose_least_squares.hpp"
#include "linkwright/mechanism/defects.hpp"
#include "linkwright/mechanism/driver_sequence.hpp"
#include "linkwright/planar/four_bar_family.hpp"
#include "linkwright/planar/pose_conditions.hpp"
#include "linkwright/region/region_map.hpp"

namespace linkwright {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

// As one error; infinite where there is none.
double combined(const NearPose::Tolerance& tolerance, double turning_length) {
  return std::min(tolerance.position.value_or(unlimited), turning_length * tolerance.angle.value_or(unlimited));
}

double share_of(const NearPose::Tolerance& tolerance, const PoseState& state) {
  return std::max(state.position_error / tolerance.position.value_or(unlimited),
                  state.angle_error / tolerance.angle.value_or(unlimited));
}

// Tolerances t weigh 1/t², beside weights that are given; the least of what weighs anything as about 1.
std::vector<double> weights_of(const MotionTask& task, const std::vector<TaskPlace>& places, double turning_length) {
  const auto tolerance_of = [&](const TaskPlace& place) {
    const auto& given = place.is_near ? task.near[place.index].tolerance : std::nullopt;
    return given ? combined(*given, turning_length) : unlimited;
  };
  double unit = unlimited;
  for (const TaskPlace& place : places) unit = std::min(unit, tolerance_of(place));
  std::vector<double> weights;
  for (const TaskPlace& place : places) {
    const double tolerance = tolerance_of(place);
    const double by_tolerance = std::isfinite(tolerance) ? unit / tolerance : 1;
    const double given = place.is_near ? task.near[place.index].weight.value_or(1) : 1;
    weights.push_back(given * by_tolerance * by_tolerance);
  }
  return weights;
}

// find_defects() of any number of poses: of the first with four others at a time, in one sense of all.
bool passes_all(const FourBar& bars, const std::vector<PrescribedPose>& poses, bool respect_direction) {
  constexpr std::size_t others = 4;
  const DriverSequence order = driver_sequence(bars.input_fixed, bars.input_moving, poses, respect_direction);
  bool ccw = order.ccw, cw = order.cw;
  for (std::size_t k = 1; k < poses.size() && (ccw || cw); k += others) {
    std::vector<PrescribedPose> some = {poses.front()};
    for (std::size_t j = k; j < std::min(k + others, poses.size()); ++j) some.push_back(poses[j]);
    const DefectReport report = find_defects(bars, some, respect_direction);
    ccw = ccw && (report.sense == DriveSense::ccw || report.sense == DriveSense::either);
    cw = cw && (report.sense == DriveSense::cw || report.sense == DriveSense::either);
  }
  return ccw || cw;
}

// Of many near poses the error takes longer than all else of a cell: maps then have that of linkages without defects
// alone, and NaN elsewhere.
class NearError : public CellMeasure {
 public:
  NearError(std::shared_ptr<const NearPoses> near, std::shared_ptr<const FourBarFamily> family)
      : CellMeasure(measures::near_error), near_(std::move(near)), family_(std::move(family)) {}

  [[nodiscard]] std::optional<double> at(MapPoint place) const override {
    return error_of(place, family_->dyad_pair(place));
  }
  [[nodiscard]] Rows rows_of(const RegionMap& map) const override {
    return [this, &map, pair_of = family_->dyad_pairs_of_cells(map.input_coordinates(), map.output_coordinates())](
               std::size_t row, std::span<float> values) {
      for (std::size_t column = 0; column < values.size(); ++column) {
        const std::size_t cell = map.index(row, column);
        if (is_of_many() && !map.defects(cell).none()) {
          values[column] = std::numeric_limits<float>::quiet_NaN();
          continue;
        }
        const bool is_whole = map.type(cell) != LinkageType::degenerate;
        const MapPoint place{map.input_coordinates()[row], map.output_coordinates()[column]};
        const auto error = is_whole ? error_of(place, pair_of(row, column)) : std::nullopt;
        values[column] = error ? static_cast<float>(*error) : 0.0F;
      }
    };
  }

 private:
  [[nodiscard]] bool is_of_many() const {
    constexpr std::size_t many = 12;
    return near_->target().poses.size() - near_->target().exact.size() > many;
  }
  [[nodiscard]] std::optional<double> error_of(MapPoint place, const std::optional<DyadPair>& links) const {
    const auto working = links ? four_bar_of(*links) : std::nullopt;
    if (!working) return std::nullopt;
    const FourBar bars = family_->frame().to_user(*working);
    constexpr bool respect_direction = true;
    return near_->error_of(bars, family_->user_poses(place, bars), respect_direction);
  }

  std::shared_ptr<const NearPoses> near_;
  std::shared_ptr<const FourBarFamily> family_;
};

}  // namespace

NearPoses::NearPoses(const MotionTask& task) : places_(places_of(task)) {
  const std::vector<PrescribedPose> all = all_poses(task);
  target_.turning_length = task.turning_length.value_or(characteristic_length(all));
  target_.weights = weights_of(task, places_, target_.turning_length);
  for (std::size_t j = 0; j < places_.size(); ++j) {
    target_.poses.push_back(all[j].pose);
    if (!places_[j].is_near) target_.exact.push_back(j);
    tolerance_.push_back(places_[j].is_near ? task.near[places_[j].index].tolerance.value_or(NearPose::Tolerance{})
                                            : NearPose::Tolerance{});
  }
}

NearMiss NearPoses::miss_of(const PoseFit& fit) const {
  NearMiss miss;
  miss.error = fit.error;
  constexpr double exact =
      1e-6;  // of the scale: states assigned in turn may lie off exact poses that come out of order
  miss.in_order = fit.drive.no_defects(false) && fit.error.exact_residual <= exact * target_.scale();
  miss.at_length_limit = fit.at_length_limit;
  for (std::size_t j = 0; j < fit.states.size(); ++j) {
    const PoseState& state = fit.states[j];
    miss.at.push_back({j, places_[j].is_near, state.input_angle - fit.states.front().input_angle, state.body,
                       state.position_error, state.angle_error});
    if (places_[j].is_near && share_of(tolerance_[j], state) > 1) miss.outside.push_back(j);
  }
  return miss;
}

std::optional<NearMiss> NearPoses::miss_of(const FourBar& bars, const Pose& body) const {
  const auto fit = compare_with_poses(bars, body, target_);
  if (!fit) return std::nullopt;
  NearMiss miss = miss_of(*fit);
  const Point first = bars.input_moving - bars.input_fixed;
  const FourBar& at_start = fit->states.front().bars;
  // Turns are told from position 1, in which the bars lie, and that need not be the first pose.
  const double to_start = turn_between(first, at_start.input_moving - at_start.input_fixed);
  for (NearMiss::Nearest& at : miss.at) at.input += to_start;
  return miss;
}

double NearPoses::error_of(const FourBar& bars, const std::vector<PrescribedPose>& exact,
                           bool respect_direction) const {
  const BodyLinkage linkage = body_linkage(bars, body_pose(exact.front().pose));
  std::vector<PrescribedPose> all;
  FourBar first = bars;
  double sum = 0, weights = 0;
  for (std::size_t j = 0; j < places_.size(); ++j) {
    if (!places_[j].is_near) {
      all.push_back(exact[places_[j].index]);
      continue;
    }
    const BodyPose pose = body_pose(target_.poses[j]);
    BodyPose state = pose;
    if (!BodyClosing(linkage, target_.turning_length).close(state)) return unlimited;
    state = nearest_state(linkage, state, pose, target_.turning_length);
    if (j == 0) first = four_bar(linkage, state);
    sum += target_.weight(j) * square(move_between(pose, state, target_.turning_length));
    weights += target_.weight(j);
    all.push_back({{state.origin, target_.poses[j].angle + turn_between(pose.axis, state.axis)}, {}});
  }
  if (!passes_all(first, all, respect_direction) && find_defects(bars, exact, respect_direction).defects.none())
    return unlimited;
  return weights > 0 ? std::sqrt(sum / weights) : 0;
}

double NearPoses::tolerance_factor(const PoseFit& fit) const {
  double factor = 0;
  for (std::size_t j = 0; j < fit.states.size(); ++j)
    if (places_[j].is_near) factor = std::max(factor, share_of(tolerance_[j], fit.states[j]));
  return factor;
}

bool NearPoses::has_tolerance() const {
  return std::any_of(tolerance_.begin(), tolerance_.end(),
                     [](const NearPose::Tolerance& tolerance) { return tolerance.position || tolerance.angle; });
}

std::shared_ptr<const CellMeasure> near_error_measure(std::shared_ptr<const NearPoses> near,
                                                      std::shared_ptr<const FourBarFamily> family) {
  return std::make_shared<const NearError>(std::move(near), std::move(family));
}

}  // namespace linkwright
