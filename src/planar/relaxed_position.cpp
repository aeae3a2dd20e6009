#include "linkwright/planar/relaxed_position.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "linkwright/core/count_text.hpp"
#include "linkwright/core/parallel.hpp"
#include "linkwright/core/precondition.hpp"
#include "linkwright/planar/burmester_points.hpp"
#include "linkwright/planar/pose_conditions.hpp"
#include "region/climb.hpp"
#include "region/window_look.hpp"

namespace linkwright {
namespace {

constexpr float does_not_pass = -1;

RelaxedPose in_working_frame(const RelaxedPose& relaxed, const WorkingFrame& frame) {
  return {{frame.to_working(relaxed.pose.origin), relaxed.pose.angle}, relaxed.index, relaxed.size / frame.scale};
}

/// A linkage of the map and what it misses the relaxed pose by, working frame.
struct RatedCandidate {
  Candidate candidate;
  double error = 0;
};

/// Looks for the least miss among the linkages that meet the requirements, from cells of a map on.
class PoseErrorSearch {
 public:
  PoseErrorSearch(const FourBarFamily& family, const Requirements& requirements, const RelaxedPose& relaxed,
                  const Progress& progress)
      : family_(family),
        evaluator_(family, requirements, Objective::min_transmission_angle),
        relaxed_(in_working_frame(relaxed, family.frame())),
        progress_(progress) {}

  /// Nothing where the linkage does not meet the requirements.
  [[nodiscard]] std::optional<RatedCandidate> at(MapPoint place) const {
    const auto candidate = evaluator_.candidate(place);
    const auto error = candidate ? error_of(*candidate) : std::nullopt;
    return error ? std::optional(RatedCandidate{*candidate, *error}) : std::nullopt;
  }

  /// From there to where nothing near misses less; steps from `first_step` (in τ) on, to that share of it.
  [[nodiscard]] RatedCandidate minimized(const RatedCandidate& from, double first_step, double resolution) const {
    const auto score = [&](const Candidate& candidate) -> std::optional<double> {
      const auto error = error_of(candidate);
      return error ? std::optional(-*error) : std::nullopt;
    };
    const Candidate end = climbed(evaluator_, from.candidate, {{first_step, first_step}, resolution, score}, progress_);
    return {end, error_of(end).value_or(from.error)};
  }

 private:
  [[nodiscard]] std::optional<double> error_of(const Candidate& candidate) const {
    const MapPoint place = candidate.cell.place;
    const FourBar bars = *four_bar_of(*family_.dyad_pair(place));  // as they are in the working frame
    const auto error = pose_error(bars, family_.working_poses(place, bars), relaxed_);
    return error ? std::optional(error->combined(relaxed_.size)) : std::nullopt;
  }

  const FourBarFamily& family_;
  Evaluator evaluator_;
  RelaxedPose relaxed_;
  const Progress& progress_;
};

/// Cells of least miss, none with a lesser one near.
std::vector<MapPoint> low_cells(const RegionMap& map, const std::vector<float>& errors,
                                const RelaxedPositionOptions& options) {
  const auto score = [&](std::size_t row, std::size_t column) {
    const float error = errors[map.index(row, column)];
    return error >= 0 ? -static_cast<double>(error) : no_score;
  };
  const auto any = [](std::size_t, std::size_t, std::size_t, std::size_t) { return true; };
  const HillTopOptions tops = {map.rows() / 20 + 1, static_cast<std::size_t>(options.starts), options.region.threads};
  std::vector<MapPoint> places;
  for (const RankedCell& cell : hill_tops(map.rows(), map.columns(), tops, score, any))
    places.push_back({map.input_coordinates()[cell.row], map.output_coordinates()[cell.column]});
  return places;
}

Notice nothing_meets(const RegionMap& map, const Requirements& requirements) {
  const RegionCounts counts = map.counts();
  const std::int64_t whole = counts.pairs - counts.types[static_cast<std::size_t>(LinkageType::degenerate)];
  const auto counted = [](std::int64_t count) { return Values{{"count", static_cast<double>(count)}}; };
  if (whole == 0) return {"no_pair", "No pair of dyads of the other poses makes a four-bar with four pivots.", {}};
  if (counts.defect_free == 0 && requirements.no_defects)
    return {"none_defect_free",
            fmt::format("None of the four-bars through the other poses that were looked at ({}) is free of defects.",
                        grouped_text(whole)),
            counted(whole)};
  return {"none_left",
          fmt::format("None of the four-bars through the other poses that were looked at and are free of defects ({}) "
                      "meets all requirements.",
                      grouped_text(counts.defect_free)),
          counted(counts.defect_free)};
}

// Where the pairs of grounded links through all five positions lie on the map that is left: there nothing is missed.
// Their circle points lie as in the whole task's first pose.
std::vector<MapPoint> exact_places(const MotionTask& whole, const TaskFamily& given, const RelaxedTask& relaxed) {
  if (!given.curve) return {};
  const PoseConditions conditions = pose_conditions(whole.poses);
  const Pose &from = whole.poses.front().pose, &to = relaxed.task.poses.front().pose;
  const Point turn = direction(to.angle - from.angle);
  std::vector<double> coordinates;
  for (const BurmesterPoint& point : burmester_points(conditions).points) {
    const Homogeneous circle = conditions.frame.to_user(point.dyad).circle;
    const Point there = turn * (circle.vector() - circle.w * from.origin) + circle.w * to.origin;
    const Homogeneous moved{circle.w, there.real(), there.imag()};
    if (const auto tau = given.curve->coordinate_of(given.frame().to_working(moved))) coordinates.push_back(*tau);
  }
  std::vector<MapPoint> places;
  for (const double input : coordinates)
    for (const double output : coordinates)
      if (input != output) places.push_back({input, output});
  return places;
}

/// The map of the family that is left, and where on it the miss is least.
class DroppedPositionSearch {
 public:
  DroppedPositionSearch(const TaskFamily& given, const RelaxedTask& relaxed, std::vector<MapPoint> exact,
                        const RelaxedPositionOptions& options, bool respect_direction, const Progress& progress)
      : given_(given),
        relaxed_(relaxed),
        exact_(std::move(exact)),
        options_(options),
        respect_direction_(respect_direction),
        progress_(progress) {
    const auto samples = [&](Side side) {
      return given.family->samples(side, options.region_samples, Spacing::coordinate);
    };
    given.family->classify(map_, samples(Side::input), samples(Side::output), respect_direction, options.region,
                           progress);
  }

  /// False where nothing meets these requirements.
  [[nodiscard]] bool find(const Requirements& requirements, RelaxedPosition& found) {
    const RequirementFilter filter = filter_of(*given_.family, map_, requirements);
    std::vector<MapPoint> starts = low_cells_of({&map_, &filter, {step(), step()}});
    if (starts.empty()) starts = starts_in_windows(filter, requirements);
    if (starts.empty()) return false;
    const auto nearest = least(requirements, std::move(starts));
    if (!nearest) return false;
    found.place = nearest->candidate.cell.place;
    found.linkage = make_four_bar(given_, nearest->candidate.cell.place, respect_direction_, true);
    if (!found.linkage || is_unconfirmed(*found.linkage)) {
      found.linkage.reset();
      return false;
    }
    found.pose_error = pose_error(found.linkage->four_bar, relaxed_.task.poses, relaxed_.relaxed).value_or(PoseError{});
    found.combined = found.pose_error.combined(relaxed_.relaxed.size);
    return true;
  }

  [[nodiscard]] std::int64_t meeting(const Requirements& requirements) const {
    return filter_of(*given_.family, map_, requirements).census().meeting;
  }
  [[nodiscard]] const RegionMap& map() const { return map_; }

 private:
  [[nodiscard]] double step() const {
    return given_.family->axis(Side::input).coordinate_length() / options_.region_samples;
  }

  /// Of what passes; none where nothing does.
  [[nodiscard]] std::vector<MapPoint> low_cells_of(const SearchMap& judged) const {
    std::vector<FailureBits> failures(judged.map->rows() * judged.map->columns());
    judged.filter->failures_of_all(failures);
    if (std::count(failures.begin(), failures.end(), 0) == 0) return {};
    std::vector<float> errors(failures.size());
    pose_errors(*given_.family, *judged.map, failures, relaxed_.relaxed, errors, options_.region.threads, progress_);
    return low_cells(*judged.map, errors, options_);
  }

  [[nodiscard]] std::vector<MapPoint> starts_in_windows(const RequirementFilter& filter,
                                                        const Requirements& requirements) const {
    const MapMaking making{[&](RegionMap& map, std::span<const double> input, std::span<const double> output) {
                             given_.family->classify(map, input, output, respect_direction_, options_.region,
                                                     progress_);
                           },
                           options_.region_samples,
                           {}};
    const WindowLook look = look_into_windows(*given_.family, {&map_, &filter, {step(), step()}}, requirements, making);
    std::vector<MapPoint> starts;
    for (const auto& closer : look.maps) {
      const std::vector<MapPoint> more = low_cells_of(closer->view());
      starts.insert(starts.end(), more.begin(), more.end());
    }
    return starts;
  }

  [[nodiscard]] std::optional<RatedCandidate> least(const Requirements& requirements,
                                                    std::vector<MapPoint> starts) const {
    // Of climbs that tell which cell leads lowest, and of the one whose miss is the answer.
    constexpr double coarse = 1e-2, fine = 1e-9;
    const PoseErrorSearch error_search(*given_.family, requirements, relaxed_.relaxed, progress_);
    const double first_step = step();
    std::optional<RatedCandidate> best;
    starts.insert(starts.end(), exact_.begin(), exact_.end());
    for (const MapPoint place : starts) {
      // The map's numbers are single: a cell on the very edge of a requirement may fail here.
      const auto start = error_search.at(place);
      if (!start) continue;
      const RatedCandidate end = error_search.minimized(*start, first_step, coarse);
      if (!best || end.error < best->error) best = end;
    }
    return best ? std::optional(error_search.minimized(*best, first_step, fine)) : std::nullopt;
  }

  const TaskFamily& given_;
  const RelaxedTask& relaxed_;
  std::vector<MapPoint> exact_;
  RelaxedPositionOptions options_;
  bool respect_direction_;
  const Progress& progress_;
  RegionMap map_;
};

// What is nearest of all lies at an edge of what is allowed: where nothing keeps the transmission angle up, at a dead
// point. So a usable angle is asked for as long as there is one.
void find_nearest(RelaxedPosition& found, const MotionTask& whole, const RelaxedTask& relaxed, const TaskFamily& given,
                  const Requirements& requirements, const RelaxedPositionOptions& options, const Progress& progress) {
  DroppedPositionSearch dropped_search(given, relaxed, exact_places(whole, given, relaxed), options,
                                       requirements.respect_direction, progress);
  found.meeting = dropped_search.meeting(requirements);
  Requirements usable = requirements;
  usable.min_transmission_angle = std::max(usable.min_transmission_angle, options.usable_transmission_angle);
  if (!dropped_search.find(usable, found) && !dropped_search.find(requirements, found))
    found.reason = nothing_meets(dropped_search.map(), requirements);
}

}  // namespace

RelaxedTask relaxed_task(const MotionTask& task, std::size_t pose) {
  require(pose < task.poses.size() && task.poses[pose].derivatives.empty(), "a pose without derivatives is freed");
  RelaxedTask result{task, {task.poses[pose].pose, pose, pose_conditions(task.poses).frame.scale}};
  result.task.poses.erase(result.task.poses.begin() + static_cast<std::ptrdiff_t>(pose));
  result.task.relaxed.reset();
  result.task.points.clear();
  return result;
}

void pose_errors(const FourBarFamily& family, const RegionMap& map, std::span<const FailureBits> failures,
                 const RelaxedPose& relaxed, std::span<float> values, int threads, const Progress& progress) {
  require(values.size() == failures.size(), "there is a place for each cell");
  const auto links_at = family.dyad_pairs_of_cells(map.input_coordinates(), map.output_coordinates());
  const RelaxedPose working = in_working_frame(relaxed, family.frame());
  parallel_for(map.rows(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t cell = map.index(begin, 0); cell < map.index(end, 0); ++cell) {
      values[cell] = does_not_pass;
      if (failures[cell] != 0 || progress.is_cancelled()) continue;
      const std::size_t row = cell / map.columns(), column = cell % map.columns();
      const auto links = links_at(row, column);
      const auto bars = links ? four_bar_of(*links) : std::nullopt;
      if (!bars) continue;
      const MapPoint place{map.input_coordinates()[row], map.output_coordinates()[column]};
      const auto error = pose_error(*bars, family.working_poses(place, *bars), working);
      if (error) values[cell] = static_cast<float>(family.frame().scale * error->combined(working.size));
    }
  });
}

std::vector<RelaxedPosition> drop_one_position(const MotionTask& task, const Requirements& requirements,
                                               const RelaxedPositionOptions& options, const Progress& progress) {
  // The same length limits for all, those of the whole task.
  const Requirements wanted = with_default_lengths(requirements, pose_conditions(task.poses).frame.scale);
  std::vector<RelaxedPosition> found;
  for (std::size_t pose = 0; pose < task.poses.size() && !progress.is_cancelled(); ++pose) {
    progress(static_cast<double>(pose) / static_cast<double>(task.poses.size()));
    if (!task.poses[pose].derivatives.empty()) continue;
    const RelaxedTask relaxed = relaxed_task(task, pose);
    const TaskFamily given = task_family(relaxed.task, wanted, Objective::min_transmission_angle);
    found.push_back({.pose = pose});
    if (given.family)
      find_nearest(found.back(), task, relaxed, given, wanted, options, progress);
    else
      found.back().reason = given.degeneracy;
  }
  std::sort(found.begin(), found.end(), [](const RelaxedPosition& a, const RelaxedPosition& b) {
    if (a.linkage.has_value() != b.linkage.has_value()) return a.linkage.has_value();
    return a.combined != b.combined ? a.combined < b.combined : a.pose < b.pose;
  });
  progress(1);
  return found;
}

}  // namespace linkwright
