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

MapAxis with_layers(MapAxis axis, int layers) {
  axis.layers = layers;
  return axis;
}

std::size_t dyads_of(const ArmChoice& choice) { return choice.knows_other() ? 1 : ArmBlock::most_dyads; }

int layer_count(const ArmTask& task, const ArmChoice& choice) {
  if (choice.layers() != LayersOf::input_axis) return 0;
  return static_cast<int>(pattern_count(task.plain_places().size()) * dyads_of(choice));
}

}  // namespace

// ---- a layer --------------------------------------------------------------------------------------------------------

/// How the elbow stands at the points, and which of the further dyads.
struct ArmFamily::Layer {
  std::uint8_t pattern = 0;
  std::size_t dyad = 0;

  [[nodiscard]] static Layer of(std::size_t index, std::size_t dyads_of_pattern) {
    return {static_cast<std::uint8_t>(index / dyads_of_pattern), index % dyads_of_pattern};
  }
  [[nodiscard]] std::size_t index(std::size_t dyads_of_pattern) const { return pattern * dyads_of_pattern + dyad; }
};

namespace {

/// Of a coordinate in [0, 1) as many digits as it keeps in the layer farthest on, so that a linkage has the same arm to
/// the bit whether its place or its layer is asked for.
double kept_in_layers(double coordinate) {
  constexpr double beyond_all_layers = 128, step = 0x1p-45;
  return std::min((coordinate + beyond_all_layers) - beyond_all_layers, 1 - step);
}

}  // namespace

std::size_t ArmFamily::dyads_of_pattern() const { return dyads_of(*choice_); }

// Nothing on the branch where the best are.
std::optional<ArmFamily::Layer> ArmFamily::layer_at(MapPoint place) const {
  const auto layer = [&](double index) { return Layer::of(static_cast<std::size_t>(index), dyads_of_pattern()); };
  const MapAxis& along = axis(Side::input);
  switch (choice_->layers()) {
    case LayersOf::nothing:
      return Layer{};
    case LayersOf::output_branch:
      return layer(std::clamp(place.output, 0.0, axis(Side::output).coordinate_length() - 0.5));
    default:
      if (!(place.input >= 1 && place.input < along.layers + 1)) return std::nullopt;
      return layer(place.input - 1);
  }
}

MapPoint ArmFamily::in_layer(MapPoint place, Layer layer) const {
  const auto index = static_cast<double>(layer.index(dyads_of_pattern()));
  switch (choice_->layers()) {
    case LayersOf::nothing:
      return place;
    case LayersOf::output_branch:
      return {place.input, index + 0.5};
    default:
      return {1 + index + without_layer(place).input, place.output};
  }
}

MapPoint ArmFamily::without_layer(MapPoint place) const {
  if (choice_->layers() != LayersOf::input_axis) return place;
  const double coordinate = axis(Side::input).onto(place.input);
  const bool is_on = coordinate >= 0 && coordinate < 1;
  return {is_on ? kept_in_layers(coordinate) : coordinate, place.output};
}

/// What is shown of several: those that meet the requirements, those without defects, the better score.
struct ArmFamily::Rated {
  bool passes = false, is_clean = false;
  double score = 0;

  [[nodiscard]] bool is_better_than(const Rated& other) const {
    if (passes != other.passes) return passes;
    if (is_clean != other.is_clean) return is_clean;
    return score > other.score;
  }
};

struct ArmFamily::Found {
  MapPoint place;  ///< in its layer
  FourBar bars;    ///< working frame
  PairJudgement judged;
  Point first_arm{}, last_arm{};  ///< of the driver
  std::uint8_t senses = 0;
  Rated rated;

  [[nodiscard]] DriverTravel travel() const {
    return {senses, static_cast<float>(wrap_positive(std::arg(last_arm * std::conj(first_arm))))};
  }
  // Field by field: a cell that is put together and then copied waits for what was just written.
  static void put_verdict(MapCell& cell, const PairJudgement& judged, MapPoint place, double unit) {
    cell.type = judged.type;
    cell.defects = judged.defects;
    cell.values[0] = judged.versine;
    cell.values[1] = judged.full_versine;
    cell.values[2] = judged.ratio;
    cell.values[3] = unit * judged.longest;
    cell.values[4] = std::floor(place.input);
  }
  [[nodiscard]] MapCell verdict(double unit) const {
    MapCell cell;
    put_verdict(cell, judged, place, unit);
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

/// Arms are added, and their linkages come out some time later, in the order in which their arms came: each is put
/// where `Take` wants it that is told how it is rated.
class ArmFamily::Solver {
 public:
  Solver(const ArmFamily& family, bool respect_direction, Simd simd)
      : family_(family),
        task_(family.task_),
        respect_direction_(respect_direction),
        judges_pivots_(!family.judge_.places().empty()),
        dyads_(family.task_.path, arm_drives(), simd) {}

  /// `place`: on the map. Only the dyad of that number, where there is one. Where the arm drives and does not come in
  /// order nothing is solved, unless that is to be seen. False where nothing was added.
  bool add(std::size_t tag, MapPoint place, const ArmAtPlace& here, const ElbowPattern& pattern,
           std::optional<std::size_t> dyad, bool out_of_order_too, const Take& take) {
    Arms arms{tag, place, pattern, dyad, here.arm.pivot, arm_motion(here.arm, task_.path, here.elbows, pattern), {}};
    if (family_.has_twice(arms.motion)) return false;
    if (arm_drives()) arms.senses = of_arm(arms);
    if (family_.only_in_order_ && !out_of_order_too && arms.senses.all == 0) return false;
    if (here.other) {
      take_pair(arms, 0, other_link(here, condition_rows(task_.path, arms.motion)), take);
      return true;
    }
    dyads_.add(arms.pivot, arms.motion, arms.senses.all, arms.senses.half_turn);
    waiting_.push_back(std::move(arms));
    if (dyads_.is_full()) finish(take);
    return true;
  }
  void finish(const Take& take) {
    if (waiting_.empty()) return;
    dyads_.solve();
    for (std::size_t i = 0; i < waiting_.size(); ++i) {
      const FurtherDyads found = dyads_.of(i);
      for (std::size_t k = 0; k < found.count; ++k)
        if (!waiting_[i].dyad || *waiting_[i].dyad == k) take_dyad(i, k, found.at[k], take);
    }
    dyads_.clear();
    waiting_.clear();
  }

 private:
  struct Senses {
    std::uint8_t all = 0, half_turn = 0;
  };
  struct Arms {
    std::size_t tag;
    MapPoint place;
    ElbowPattern pattern;
    std::optional<std::size_t> dyad;
    Point pivot;
    ArmMotion motion;
    Senses senses;  ///< of an arm that drives
  };

  [[nodiscard]] std::size_t count() const { return task_.path.size(); }
  [[nodiscard]] bool arm_drives() const { return task_.side == Side::input; }

  [[nodiscard]] static Dyad other_link(const ArmAtPlace& here, const ConditionRows& rows) {
    if (!here.other_moving) return partner_of(rows, *here.other);
    return {Homogeneous::of(*here.other), Homogeneous::of(*here.other_moving), 0};
  }

  // Judged among others of its kind already, where the arm drives.
  void take_dyad(std::size_t i, std::size_t number, std::size_t at, const Take& take) {
    const Arms& arms = waiting_[i];
    if (!arm_drives()) return take_pair(arms, number, dyads_.dyad(i, at), take);
    const PairJudgement judged = dyads_.judged(i, at);
    if (judged.type == LinkageType::degenerate) return;
    const MapPoint place = family_.in_layer(arms.place, {arms.pattern.bits, number});
    // Finite, or it would be degenerate. Most linkages are not taken: only where pivots are judged are they needed
    // first.
    const auto bars = [&] { return bars_of(arms, dyads_.dyad(i, at)).value(); };
    const Rated rated = rated_by(judged, place, judges_pivots_ ? std::optional(bars()) : std::nullopt);
    if (Found* const slot = take(arms.tag, rated))
      *slot = {place, bars(), judged, arms.motion.link[0], arms.motion.link[count() - 1], arms.senses.all, rated};
  }
  // Judged by itself.
  void take_pair(const Arms& arms, std::size_t number, const Dyad& other, const Take& take) {
    const auto bars = bars_of(arms, other);
    if (!bars) return;
    const LinkInPositions arm{arms.pivot, arms.pivot + arms.motion.link[0], arms.motion.link};
    const LinkInPositions found = other_in_positions(arms, *bars);
    const LinkInPositions& driver = arm_drives() ? arm : found;
    const Senses senses = arm_drives() ? arms.senses : of_other(arms.motion, found);
    const PairJudgement judged = judge_pair(driver, arm_drives() ? found : arm, count(), senses.all, senses.half_turn);
    if (judged.type == LinkageType::degenerate) return;
    const MapPoint place = family_.in_layer(arms.place, {arms.pattern.bits, number});
    const Rated rated = rated_by(judged, place, bars);
    if (Found* const slot = take(arms.tag, rated))
      *slot = {place, *bars, judged, driver.arm[0], driver.arm[count() - 1], senses.all, rated};
  }

  // Nothing of a slider.
  [[nodiscard]] std::optional<FourBar> bars_of(const Arms& arms, const Dyad& other) const {
    const auto center = finite_point(other.center), circle = finite_point(other.circle);
    if (!center || !circle) return std::nullopt;
    const Point moving = arms.pivot + arms.motion.link[0];
    return arm_drives() ? FourBar{arms.pivot, moving, *center, *circle} : FourBar{*center, *circle, arms.pivot, moving};
  }
  [[nodiscard]] LinkInPositions other_in_positions(const Arms& arms, const FourBar& bars) const {
    LinkInPositions found{bars.output_fixed, bars.output_moving, {}};
    if (!arm_drives()) found = {bars.input_fixed, bars.input_moving, {}};
    for (std::size_t j = 0; j < count(); ++j)
      found.arm[j] = task_.path[j].jet.front() + arms.motion.turn[j] * found.circle - found.center;
    return found;
  }

  [[nodiscard]] Rated rated_by(const PairJudgement& judged, MapPoint place, const std::optional<FourBar>& bars) {
    Found::put_verdict(scratch_, judged, place, task_.frame.scale);
    if (judges_pivots_ && bars) scratch_.pivots = pivots_of(task_.frame.to_user(*bars));
    return {family_.judge_.passes(scratch_), judged.defects.none(), family_.rank_.score(scratch_)};
  }

  // Where all points are plain the pattern has them.
  [[nodiscard]] Senses of_arm(const Arms& arms) const {
    Senses senses{arms.pattern.senses, arms.pattern.half_turn_senses};
    if (family_.plain_count_ < count()) senses = of_turns(arms.motion.link);
    for (std::size_t j = 0; j < arms.motion.rates.size() && respect_direction_; ++j)
      if (const auto& rates = arms.motion.rates[j].link; !rates.empty()) senses.all &= bit_of(rates.front());
    if (task_.sense) senses.all &= bit_of(*task_.sense);
    return senses;
  }
  [[nodiscard]] Senses of_turns(const std::array<Point, ArmElbows::most_points>& link) const {
    DriverSequenceBuilder order;
    for (std::size_t j = 0; j < count(); ++j)
      order.meet(j == 0 ? 0 : wrap_positive(std::arg(link[j] * std::conj(link[0]))));
    return {order.sequence().senses(), order.sequence().half_turn_senses()};
  }
  [[nodiscard]] static std::uint8_t bit_of(double rate) {
    return rate > 0 ? DriverSequence::ccw_bit : DriverSequence::cw_bit;
  }
  [[nodiscard]] Senses of_other(const ArmMotion& motion, const LinkInPositions& link) const {
    DriverSequenceBuilder order;
    for (std::size_t j = 0; j < count(); ++j) {
      order.meet(j == 0 ? 0 : wrap_positive(std::arg(link.arm[j] * std::conj(link.arm[0]))));
      if (motion.rates.empty() || motion.rates[j].body.empty() || !respect_direction_) continue;
      const Point from_point = link.center + link.arm[j] - task_.path[j].jet.front();
      order.pass(cross(link.arm[j], task_.path[j].jet[1] + Point{0, motion.rates[j].body.front()} * from_point));
    }
    return {order.sequence().senses(), order.sequence().half_turn_senses()};
  }

  const ArmFamily& family_;
  const ArmTask& task_;
  bool respect_direction_;
  bool judges_pivots_;
  FurtherDyadSolver dyads_;
  std::vector<Arms> waiting_;
  Cell scratch_;
};

// ---- the family -----------------------------------------------------------------------------------------------------

ArmFamily::ArmFamily(ArmTask task, std::shared_ptr<const ArmChoice> choice, const Requirements& requirements,
                     Objective objective)
    : PathFamily(task.frame, with_layers(choice->axis(Side::input), layer_count(task, *choice)),
                 choice->axis(Side::output)),
      task_(std::move(task)),
      choice_(std::move(choice)),
      plain_count_(task_.plain_places().size()),
      requirements_(requirements),
      judge_(requirements, path_linkages, measures()),
      rank_(rank_of(objective, measures())),
      only_in_order_(task_.side == Side::input && requirements.no_defects) {
  for (std::size_t i = 0; i < task_.path.size(); ++i)
    for (std::size_t j = i + 1; j < task_.path.size(); ++j)
      if (std::abs(task_.path[i].jet.front() - task_.path[j].jet.front()) <= tolerance::repeated_pose)
        repeated_.push_back({i, j});
}

bool ArmFamily::is_timed() const {
  return std::all_of(task_.path.begin(), task_.path.end(),
                     [](const PathPlace& place) { return place.known == PathPlace::Angle::of_link; });
}

std::span<const Measure> ArmFamily::measures() const {
  if (choice_->layers() == LayersOf::input_axis) return arm_measures;
  return planar_measures;
}

double ArmFamily::axis_value(Side side, double coordinate) const {
  return choice_->axis_value(side, side == Side::input ? without_layer({coordinate, 0}).input : coordinate);
}

// It would have the same position twice.
bool ArmFamily::has_twice(const ArmMotion& motion) const {
  return std::any_of(repeated_.begin(), repeated_.end(), [&](const std::array<std::size_t, 2>& same) {
    return std::abs(motion.link[same[0]] - motion.link[same[1]]) <= tolerance::repeated_pose;
  });
}

void ArmFamily::add_all(Solver& solver, std::size_t tag, MapPoint place, const Take& take) const {
  const auto here = choice_->at(without_layer(place));
  if (!here) return;
  if (const auto layer = layer_at(place)) {
    const auto pattern = elbow_pattern(here->elbows, here->bits.value_or(layer->pattern));
    solver.add(tag, place, *here, pattern, layer->dyad, true, take);
    return;
  }
  const bool prune_early = only_in_order_ && plain_count_ == task_.path.size();
  for_elbow_patterns(here->elbows, prune_early, [&](const ElbowPattern& pattern) {
    solver.add(tag, place, *here, pattern, std::nullopt, false, take);
  });
}

// Where no pattern is in order, one of them shows what is wrong with all.
void ArmFamily::add_any(Solver& solver, std::size_t tag, MapPoint place, const Take& take) const {
  const auto here = choice_->at(without_layer(place));
  if (!here || layer_at(place)) return;
  for (std::size_t bits = 0; bits < pattern_count(here->elbows.points); ++bits) {
    const auto pattern = elbow_pattern(here->elbows, static_cast<std::uint8_t>(bits));
    if (solver.add(tag, place, *here, pattern, std::nullopt, true, take)) return;
  }
}

std::vector<std::optional<ArmFamily::Found>> ArmFamily::best_of(std::span<const MapPoint> places,
                                                                bool respect_direction, Simd simd) const {
  std::vector<std::optional<Found>> best(places.size());
  const auto take = [&](std::size_t tag, const Rated& rated) -> Found* {
    std::optional<Found>& shown = best[tag];
    if (shown && !rated.is_better_than(shown->rated)) return nullptr;
    return &shown.emplace();
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
  const auto take = [&](std::size_t, const Rated&) { return &all.emplace_back(); };
  Solver solver(*this, respect_direction, Simd::automatic);
  add_all(solver, 0, place, take);
  solver.finish(take);
  std::stable_sort(all.begin(), all.end(),
                   [](const Found& a, const Found& b) { return a.rated.is_better_than(b.rated); });
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
  map.lay(input, output, measures(), of_pairs, options);
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
        for (std::size_t k = 0; k < measures().size(); ++k)
          cells.measures[k][column] = static_cast<float>(cell.values[k]);
        map.set_driver(row, column, best[column]->travel());
      }
    }
  });
}

// ---- linkages of a map ----------------------------------------------------------------------------------------------

// The place of the linkage that a cell shows.
MapPoint ArmFamily::shown_at(const RegionMap& map, std::size_t row, std::size_t column) const {
  const MapPoint place{map.input_coordinates()[row], map.output_coordinates()[column]};
  if (choice_->layers() != LayersOf::input_axis) return place;
  const double layer = static_cast<double>(map.values(measures::layer)[map.index(row, column)]);
  return {layer + without_layer(place).input, place.output};
}

MapPivots ArmFamily::pivots(const RegionMap& map) const {
  MapPivots pivots;
  pivots.of_cell = [this, &map](std::size_t row, std::size_t column) -> std::optional<Pivots> {
    const auto links = dyad_pair(shown_at(map, row, column));
    return links ? std::optional(pivots_of(frame().to_user(*four_bar_of(*links)))) : std::nullopt;
  };
  return pivots;
}

LinkageFamily::OutputOfCells ArmFamily::outputs_of(const RegionMap& map) const {
  return [this, &map](std::size_t row, std::size_t column) { return output(shown_at(map, row, column)); };
}

std::string ArmFamily::elbows_at(MapPoint place) const {
  const auto here = choice_->at(without_layer(place));
  const auto layer = layer_at(place);
  if (!layer || !here || plain_count_ == 0) return {};
  const std::uint8_t bits = here->bits.value_or(layer->pattern);
  std::string sides;
  for (std::size_t j = 0; j < plain_count_; ++j) sides += (bits >> j) & 1 ? '-' : '+';
  return here->other ? sides : fmt::format("{} {}", sides, layer->dyad + 1);
}

// ---- one linkage ----------------------------------------------------------------------------------------------------

std::optional<ArmMotion> ArmFamily::motion_at(MapPoint place) const {
  if (!layer_at(place)) {
    const auto links = dyad_pair(place);
    if (!links) return std::nullopt;
    place.input = links->input.coordinate;
  }
  const auto layer = layer_at(place);
  const auto here = choice_->at(without_layer(place));
  if (!layer || !here) return std::nullopt;
  return arm_motion(here->arm, task_.path, here->elbows,
                    elbow_pattern(here->elbows, here->bits.value_or(layer->pattern)));
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

// In the sense of the task where it has one; otherwise in that in which it meets the points in order.
std::vector<PrescribedPose> ArmFamily::crank_poses(MapPoint place, const FourBar& bars) const {
  std::vector<PrescribedPose> poses = user_poses(place, bars);
  if (poses.empty()) return poses;
  const DriverSequence order = driver_sequence(bars.input_fixed, bars.input_moving, poses, true);
  const bool goes_ccw = task_.sense ? *task_.sense > 0 : order.ccw, goes_cw = task_.sense ? *task_.sense < 0 : order.cw;
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

std::optional<double> ArmFamily::rate_residual(MapPoint place) const {
  const auto links = dyad_pair(place);
  const auto rows = links ? derivative_conditions(user_poses({links->input.coordinate, place.output}, {}), frame())
                          : std::vector<HomogeneousMatrix>{};
  if (rows.empty()) return std::nullopt;
  return std::max(residual_of(links->input, rows), residual_of(links->output, rows));
}

TaskFamily family_of_arms(const PathTask& task, const Requirements& requirements, Objective objective) {
  ArmTask arms = arm_task(task);
  ArmChoiceSetup setup = arm_choice(task, arms);
  TaskFamily given;
  given.pattern = pattern(task.points);
  given.conditions.frame = arms.frame;
  given.size = given.frame().scale;
  given.has_directions = std::any_of(task.points.begin(), task.points.end(),
                                     [](const PathPoint& point) { return !point.derivatives.empty(); });
  given.warnings = std::move(setup.warnings);
  given.degeneracy = std::move(setup.degeneracy);
  given.has_no_dyads = setup.has_none;
  if (!setup.choice) return given;
  given.paths = std::make_shared<const ArmFamily>(std::move(arms), std::move(setup.choice),
                                                  with_default_lengths(requirements, given.size), objective);
  given.family = given.paths;
  return given;
}

}  // namespace linkwright
