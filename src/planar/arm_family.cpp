#include "arm_family.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "further_dyads.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/parallel.hpp"
#include "linkwright/core/tolerance.hpp"
#include "linkwright/mechanism/driver_sequence.hpp"
#include "linkwright/planar/four_bar_map.hpp"
#include "mechanism/pair_judge.hpp"
#include "turned_arm.hpp"

namespace linkwright {
namespace {

constexpr auto arm_measures = [] {
  std::array<Measure, planar_measures.size() + 1> all{};
  std::copy(planar_measures.begin(), planar_measures.end(), all.begin());
  all.back() = measures::layer;
  return all;
}();

std::vector<Point> places_of(std::span<const PathJet> path) {
  std::vector<Point> places;
  for (const PathJet& jet : path) places.push_back(jet.front());
  return places;
}

// Root of the mean square of the points' distances from their centroid; of one point its distance from the pivot.
double size_of(const PathTask& task, Point pivot) {
  Point sum{};
  for (const PathPoint& point : task.points) sum += point.point;
  const double count = static_cast<double>(task.points.size());
  double squares = 0;
  for (const PathPoint& point : task.points) squares += std::norm(point.point - sum / count);
  return squares > 0 ? std::sqrt(squares / count) : std::abs(task.points.front().point - pivot);
}

std::size_t dyads_of_pattern(const ArmTask& task) { return task.other ? 1 : FurtherDyadBlock::most; }

int layer_count(const ArmTask& task) {
  return static_cast<int>(pattern_count(task.path.size()) * dyads_of_pattern(task));
}

MapAxis arm_axis(const ArmTask& task) {
  MapAxis axis{AxisQuantity::arm_reach, {{"", 0, 1}}};
  axis.layers = layer_count(task);
  return axis;
}

}  // namespace

ArmTask arm_task(const PathTask& task) {
  ArmTask arms;
  arms.side = task.pivots.input ? Side::input : Side::output;
  const Point pivot = task.pivots.input ? *task.pivots.input : *task.pivots.output;
  arms.frame = {task.points.front().point, size_of(task, pivot)};
  arms.points = task.points;
  arms.pivot = arms.frame.to_working(pivot);
  if (task.pivots.count() == 2) arms.other = arms.frame.to_working(*task.pivots.output);
  for (const PathPoint& point : task.points) {
    arms.path.push_back({arms.frame.to_working(point.point)});
    for (const PathDerivative& d : point.derivatives) arms.path.back().push_back(d.point / arms.frame.scale);
  }
  return arms;
}

// ---- a layer --------------------------------------------------------------------------------------------------------

/// How the elbow stands at the points, and which of the further dyads.
struct ArmFamily::Layer {
  std::uint8_t pattern = 0;
  std::size_t dyad = 0;

  /// From 1.
  [[nodiscard]] double number(const ArmTask& task) const {
    return static_cast<double>(1 + pattern * dyads_of_pattern(task) + dyad);
  }
  /// That of a coordinate; nothing on the branch where the best are.
  [[nodiscard]] static std::optional<Layer> at(double coordinate, const ArmTask& task) {
    if (!(coordinate >= 1 && coordinate < layer_count(task) + 1)) return std::nullopt;
    const auto index = static_cast<std::size_t>(coordinate) - 1;
    return Layer{static_cast<std::uint8_t>(index / dyads_of_pattern(task)), index % dyads_of_pattern(task)};
  }
};

struct ArmFamily::Found {
  MapPoint place;  ///< in its layer
  FourBar bars;    ///< working frame
  PairJudgement judged;
  Point first_arm{}, last_arm{};  ///< of the driver
  std::uint8_t senses = 0;
  // What is shown of several: those that meet the requirements, those without defects, the better score.
  bool passes = false;
  double score = 0;

  [[nodiscard]] bool is_better_than(const Found& other) const {
    if (passes != other.passes) return passes;
    if (judged.defects.none() != other.judged.defects.none()) return judged.defects.none();
    return score > other.score;
  }
  [[nodiscard]] DriverTravel travel() const {
    return {senses, static_cast<float>(wrap_positive(std::arg(last_arm * std::conj(first_arm))))};
  }
  [[nodiscard]] MapCell verdict(double unit) const {
    MapCell cell;
    cell.type = judged.type;
    cell.defects = judged.defects;
    cell.values = {judged.versine, judged.full_versine, judged.ratio, unit * judged.longest, std::floor(place.input)};
    return cell;
  }
  [[nodiscard]] Cell cell(const WorkingFrame& frame) const {
    Cell cell{verdict(frame.scale)};
    cell.hill = static_cast<std::size_t>(judged.type);
    cell.place = place;
    cell.pivots = pivots_of(frame.to_user(bars));
    cell.change_point_margin = change_point_margin(bars.lengths());
    return cell;
  }
  [[nodiscard]] DyadPair links() const {
    return {{Homogeneous::of(bars.input_fixed), Homogeneous::of(bars.input_moving), place.input},
            {Homogeneous::of(bars.output_fixed), Homogeneous::of(bars.output_moving), place.output}};
  }
};

// ---- all linkages of some arms --------------------------------------------------------------------------------------

/// Arms are added, and their linkages come out some time later, each with what was said of its arm.
class ArmFamily::Solver {
 public:
  Solver(const ArmFamily& family, bool respect_direction, Simd simd)
      : family_(family), task_(family.task_), respect_direction_(respect_direction), dyads_(simd) {}

  /// `place`: on the map. Only the dyad of that number, where there is one.
  void add(std::size_t tag, MapPoint place, const ArmElbows& elbows, const ElbowPattern& pattern,
           std::optional<std::size_t> dyad, const Take& take) {
    Arms arms{tag, place, pattern, dyad, arm_motion(task_.pivot, task_.path, elbows, pattern)};
    const ConditionRows rows = condition_rows(task_.path, arms.motion);
    if (task_.other) return take_dyad(arms, 0, partner_of(rows, *task_.other), take);
    dyads_.add(rows, task_.pivot, task_.pivot + arms.motion.link.front());
    waiting_.push_back(std::move(arms));
    if (dyads_.is_full()) finish(take);
  }
  void finish(const Take& take) {
    if (waiting_.empty()) return;
    dyads_.solve();
    for (std::size_t i = 0; i < waiting_.size(); ++i) {
      const FurtherDyads found = dyads_.of(i);
      for (std::size_t k = 0; k < found.count; ++k) take_dyad(waiting_[i], k, found.dyads[k], take);
    }
    dyads_.clear();
    waiting_.clear();
  }

 private:
  struct Arms {
    std::size_t tag;
    MapPoint place;
    ElbowPattern pattern;
    std::optional<std::size_t> dyad;
    ArmMotion motion;
  };
  struct Senses {
    std::uint8_t all = 0, half_turn = 0;
  };

  [[nodiscard]] std::size_t count() const { return task_.path.size(); }

  void take_dyad(const Arms& arms, std::size_t number, const Dyad& other, const Take& take) const {
    if (arms.dyad && *arms.dyad != number) return;
    const auto center = finite_point(other.center), circle = finite_point(other.circle);
    if (!center || !circle) return;  // a slider
    LinkInPositions arm{task_.pivot, task_.pivot + arms.motion.link[0], arms.motion.link};
    LinkInPositions found{*center, *circle, {}};
    for (std::size_t j = 0; j < count(); ++j)
      found.arm[j] = task_.path[j].front() + arms.motion.turn[j] * *circle - *center;
    const bool arm_drives = task_.side == Side::input;
    const LinkInPositions& driver = arm_drives ? arm : found;
    const Senses senses = arm_drives ? of_arm(arms) : of_other(arms.motion, found);
    const PairJudgement judged = judge_pair(driver, arm_drives ? found : arm, count(), senses.all, senses.half_turn);
    if (judged.type == LinkageType::degenerate) return;
    Found made;
    made.place = {Layer{arms.pattern.bits, number}.number(task_) + arms.place.input - std::floor(arms.place.input),
                  arms.place.output};
    made.bars = arm_drives ? FourBar{arm.center, arm.circle, *center, *circle}
                           : FourBar{*center, *circle, arm.center, arm.circle};
    made.judged = judged;
    made.first_arm = driver.arm[0];
    made.last_arm = driver.arm[count() - 1];
    made.senses = senses.all;
    rank(made);
    take(arms.tag, made);
  }

  void rank(Found& made) const {
    static_cast<MapCell&>(scratch_) = made.verdict(task_.frame.scale);
    if (!family_.judge_.places().empty()) scratch_.pivots = pivots_of(task_.frame.to_user(made.bars));
    made.passes = family_.judge_.passes(scratch_);
    made.score = family_.rank_.score(scratch_);
  }

  [[nodiscard]] Senses of_arm(const Arms& arms) const {
    Senses senses{arms.pattern.senses, arms.pattern.half_turn_senses};
    for (std::size_t j = 0; j < arms.motion.rates.size() && respect_direction_; ++j)
      if (const auto& rates = arms.motion.rates[j].link; !rates.empty())
        senses.all &= rates.front() > 0 ? DriverSequence::ccw_bit : DriverSequence::cw_bit;
    return senses;
  }
  [[nodiscard]] Senses of_other(const ArmMotion& motion, const LinkInPositions& link) const {
    DriverSequenceBuilder order;
    for (std::size_t j = 0; j < count(); ++j) {
      order.meet(j == 0 ? 0 : wrap_positive(std::arg(link.arm[j] * std::conj(link.arm[0]))));
      if (motion.rates.empty() || motion.rates[j].body.empty() || !respect_direction_) continue;
      const Point from_point = link.center + link.arm[j] - task_.path[j].front();
      order.pass(cross(link.arm[j], task_.path[j][1] + Point{0, motion.rates[j].body.front()} * from_point));
    }
    return {order.sequence().senses(), order.sequence().half_turn_senses()};
  }

  const ArmFamily& family_;
  const ArmTask& task_;
  bool respect_direction_;
  FurtherDyadSolver dyads_;
  std::vector<Arms> waiting_;
  mutable Cell scratch_;
};

// ---- the family -----------------------------------------------------------------------------------------------------

ArmFamily::ArmFamily(const PathTask& task, const Requirements& requirements, Objective objective)
    : ArmFamily(arm_task(task), requirements, objective) {}

ArmFamily::ArmFamily(ArmTask task, const Requirements& requirements, Objective objective)
    : PathFamily(task.frame, arm_axis(task), {AxisQuantity::arm_difference, {{"", 0, 1}}}),
      task_(std::move(task)),
      reach_(task_.pivot, places_of(task_.path)),
      requirements_(requirements),
      judge_(requirements, path_linkages, arm_measures),
      rank_(rank_of(objective, arm_measures)),
      only_in_order_(task_.side == Side::input && requirements.no_defects) {
  for (std::size_t i = 0; i < task_.path.size(); ++i)
    for (std::size_t j = i + 1; j < task_.path.size(); ++j)
      if (std::abs(task_.path[i].front() - task_.path[j].front()) <= tolerance::repeated_pose)
        repeated_.push_back({i, j});
}

std::span<const Measure> ArmFamily::measures() const { return arm_measures; }

double ArmFamily::axis_value(Side side, double coordinate) const {
  return side == Side::input ? axis(side).onto(coordinate) : 2 * coordinate - 1;
}

// With equal elbows it would have the same position twice.
bool ArmFamily::is_repeated(const ElbowPattern& pattern) const {
  return std::any_of(repeated_.begin(), repeated_.end(), [&](const std::array<std::size_t, 2>& same) {
    return ((pattern.bits >> same[0]) & 1) == ((pattern.bits >> same[1]) & 1);
  });
}

namespace {

/// The elbows of the arm at a place; nothing off the rectangle of arms.
std::optional<ArmElbows> arm_elbows(const ArmReach& reach, const MapAxis& input, MapPoint place) {
  const double u = input.onto(place.input), v = 2 * place.output - 1;
  if (!(u > 0 && u <= 1 && v >= -1 && v <= 1)) return std::nullopt;
  return reach.elbows(reach.arm(u, v));
}

}  // namespace

// Patterns of which the arm does not come in order need not be solved.
void ArmFamily::add_all(Solver& solver, std::size_t tag, MapPoint place, const Take& take) const {
  const auto elbows = arm_elbows(reach_, axis(Side::input), place);
  if (!elbows) return;
  if (const auto layer = Layer::at(place.input, task_)) {
    const ElbowPattern pattern = elbow_pattern(*elbows, layer->pattern);
    if (!is_repeated(pattern)) solver.add(tag, place, *elbows, pattern, layer->dyad, take);
    return;
  }
  for_elbow_patterns(*elbows, only_in_order_, [&](const ElbowPattern& pattern) {
    if (!is_repeated(pattern)) solver.add(tag, place, *elbows, pattern, std::nullopt, take);
  });
}

// Where no pattern is in order, one of them shows what is wrong with all.
void ArmFamily::add_any(Solver& solver, std::size_t tag, MapPoint place, const Take& take) const {
  const auto elbows = arm_elbows(reach_, axis(Side::input), place);
  if (!elbows || Layer::at(place.input, task_)) return;
  for (std::size_t bits = 0; bits < pattern_count(elbows->points); ++bits) {
    const ElbowPattern pattern = elbow_pattern(*elbows, static_cast<std::uint8_t>(bits));
    if (!is_repeated(pattern)) return solver.add(tag, place, *elbows, pattern, std::nullopt, take);
  }
}

std::vector<std::optional<ArmFamily::Found>> ArmFamily::best_of(std::span<const MapPoint> places,
                                                                bool respect_direction, Simd simd) const {
  std::vector<std::optional<Found>> best(places.size());
  const auto take = [&](std::size_t tag, const Found& found) {
    if (!best[tag] || found.is_better_than(*best[tag])) best[tag] = found;
  };
  Solver solver(*this, respect_direction, simd);
  for (std::size_t i = 0; i < places.size(); ++i) add_all(solver, i, places[i], take);
  solver.finish(take);
  for (std::size_t i = 0; i < places.size(); ++i)
    if (!best[i]) add_any(solver, i, places[i], take);
  solver.finish(take);
  return best;
}

std::vector<Cell> ArmFamily::all_at(MapPoint place, bool respect_direction) const {
  std::vector<Found> all;
  const auto take = [&](std::size_t, const Found& found) { all.push_back(found); };
  Solver solver(*this, respect_direction, Simd::automatic);
  add_all(solver, 0, place, take);
  solver.finish(take);
  std::stable_sort(all.begin(), all.end(), [](const Found& a, const Found& b) { return a.is_better_than(b); });
  std::vector<Cell> cells;
  for (const Found& found : all) cells.push_back(found.cell(frame()));
  return cells;
}

LinkageFamily::CellAt ArmFamily::cells(bool respect_direction) const {
  return [this, respect_direction](MapPoint place, const auto& is_worth_it) -> std::optional<Cell> {
    const auto found = best_of(std::array{place}, respect_direction, Simd::automatic).front();
    if (!found) return std::nullopt;
    const Cell cell = found->cell(frame());
    return is_worth_it(cell) ? std::optional(cell) : std::nullopt;
  };
}

std::optional<DyadPair> ArmFamily::dyad_pair(MapPoint place) const {
  const auto found = best_of(std::array{place}, requirements_.respect_direction, Simd::automatic).front();
  return found ? std::optional(found->links()) : std::nullopt;
}

void ArmFamily::fill(RegionMap& map, std::span<const double> input, std::span<const double> output,
                     bool respect_direction, const RegionOptions& options, const Progress& progress) const {
  constexpr bool of_pairs = false;
  map.lay(input, output, arm_measures, of_pairs, options);
  map.give_each_cell_a_driver();
  parallel_for(map.rows(), options.threads, [&](std::size_t begin, std::size_t end) {
    std::vector<MapPoint> places(output.size());
    for (std::size_t row = begin; row < end; ++row) {
      map.leave_empty(row, row + 1);
      if (progress.is_cancelled()) continue;
      for (std::size_t column = 0; column < output.size(); ++column) places[column] = {input[row], output[column]};
      const auto best = best_of(places, respect_direction, options.simd);
      const RegionMap::Cells cells = map.cells(row);
      for (std::size_t column = 0; column < output.size(); ++column) {
        if (!best[column]) continue;
        const MapCell cell = best[column]->verdict(frame().scale);
        cells.type[column] = static_cast<std::uint8_t>(cell.type);
        cells.defects[column] = cell.defects.bits;
        for (std::size_t k = 0; k < arm_measures.size(); ++k)
          cells.measures[k][column] = static_cast<float>(cell.values[k]);
        map.set_driver(row, column, best[column]->travel());
      }
    }
  });
}

// ---- linkages of a map ----------------------------------------------------------------------------------------------

namespace {

// That of the linkage which a cell shows.
MapPoint place_in_layer(const RegionMap& map, std::size_t row, std::size_t column) {
  const double layer = static_cast<double>(map.values(measures::layer)[map.index(row, column)]);
  const double coordinate = map.input_coordinates()[row];
  return {layer + coordinate - std::floor(coordinate), map.output_coordinates()[column]};
}

}  // namespace

MapPivots ArmFamily::pivots(const RegionMap& map) const {
  MapPivots pivots;
  pivots.of_cell = [this, &map](std::size_t row, std::size_t column) -> std::optional<Pivots> {
    const auto links = dyad_pair(place_in_layer(map, row, column));
    return links ? std::optional(pivots_of(frame().to_user(*four_bar_of(*links)))) : std::nullopt;
  };
  return pivots;
}

LinkageFamily::OutputOfCells ArmFamily::outputs_of(const RegionMap& map) const {
  return [this, &map](std::size_t row, std::size_t column) { return output(place_in_layer(map, row, column)); };
}

std::string ArmFamily::elbows_at(MapPoint place) const {
  const auto layer = Layer::at(place.input, task_);
  if (!layer) return {};
  std::string sides;
  for (std::size_t j = 0; j < task_.path.size(); ++j) sides += (layer->pattern >> j) & 1 ? '-' : '+';
  return task_.other ? sides : fmt::format("{} {}", sides, layer->dyad + 1);
}

// ---- one linkage ----------------------------------------------------------------------------------------------------

std::optional<ArmMotion> ArmFamily::motion_at(MapPoint place) const {
  if (!Layer::at(place.input, task_)) {
    const auto links = dyad_pair(place);
    if (!links) return std::nullopt;
    place.input = links->input.coordinate;
  }
  const auto layer = Layer::at(place.input, task_);
  const auto elbows = arm_elbows(reach_, axis(Side::input), place);
  if (!layer || !elbows) return std::nullopt;
  return arm_motion(task_.pivot, task_.path, *elbows, elbow_pattern(*elbows, layer->pattern));
}

std::vector<PrescribedPose> ArmFamily::working_poses(MapPoint place, const FourBar& bars) const {
  return frame().to_working(user_poses(place, bars));
}

std::vector<PrescribedPose> ArmFamily::user_poses(MapPoint place, const FourBar& /*bars*/) const {
  const auto motion = motion_at(place);
  std::vector<PrescribedPose> poses;
  for (std::size_t j = 0; motion && j < task_.points.size(); ++j) {
    poses.push_back({{task_.points[j].point, j == 0 ? 0 : std::arg(motion->turn[j])}, {}});
    for (std::size_t m = 0; m < task_.points[j].derivatives.size(); ++m)
      poses.back().derivatives.push_back({task_.points[j].derivatives[m].point, motion->rates[j].body[m]});
  }
  return poses;
}

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

std::vector<PrescribedPose> ArmFamily::crank_poses(MapPoint place, const FourBar& bars) const {
  std::vector<PrescribedPose> poses = user_poses(place, bars);
  if (poses.empty()) return poses;
  const DriverSequence order = driver_sequence(bars.input_fixed, bars.input_moving, poses, true);
  const Pose first = poses.front().pose;
  const Point first_crank = bars.input_moving - bars.input_fixed;
  for (PrescribedPose& there : poses) {
    const Point moving = displaced(bars.input_moving, first, there.pose), crank = moving - bars.input_fixed;
    const bool is_first = &there == &poses.front();
    const double ccw = is_first ? 0 : wrap_positive(std::arg(crank * std::conj(first_crank)));
    const std::vector<double> rates = crank_rates(there, crank, there.pose.origin - moving);
    there.pose.angle = order.ccw || is_first ? ccw : order.cw ? ccw - two_pi : wrap_signed(ccw);
    for (std::size_t m = 0; m < rates.size(); ++m) there.derivatives[m].angle = rates[m];
  }
  return poses;
}

std::optional<double> ArmFamily::rate_residual(MapPoint place) const {
  const auto links = dyad_pair(place);
  const auto rows = links ? derivative_conditions(user_poses({links->input.coordinate, place.output}, {}), frame())
                          : std::vector<HomogeneousMatrix>{};
  if (rows.empty()) return std::nullopt;
  return std::max(residual_of(links->input, rows), residual_of(links->output, rows));
}

TaskFamily family_of_arms(const PathTask& task, const Requirements& requirements, Objective objective) {
  ArmTask arms = arm_task(task);
  TaskFamily given;
  given.pattern = pattern(task.points);
  given.conditions.frame = arms.frame;
  given.size = given.frame().scale;
  given.has_directions = std::any_of(task.points.begin(), task.points.end(),
                                     [](const PathPoint& point) { return !point.derivatives.empty(); });
  given.paths =
      std::make_shared<const ArmFamily>(std::move(arms), with_default_lengths(requirements, given.size), objective);
  given.family = given.paths;
  return given;
}

}  // namespace linkwright
