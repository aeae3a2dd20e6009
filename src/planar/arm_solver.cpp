#include "arm_solver.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/tolerance.hpp"
#include "linkwright/mechanism/driver_sequence.hpp"

namespace linkwright {

// ---- a linkage ------------------------------------------------------------------------------------------------------

namespace {

// Field by field: a cell that is put together and then copied waits for what was just written.
void put_verdict(MapCell& cell, const PairJudgement& judged, MapPoint place, double unit) {
  cell.type = judged.type;
  cell.defects = judged.defects;
  cell.values[0] = judged.versine;
  cell.values[1] = judged.full_versine;
  cell.values[2] = judged.ratio;
  cell.values[3] = unit * judged.longest;
  cell.values[4] = std::floor(place.input);
}

Dyad other_link(const ArmAtPlace& here, const ConditionRows& rows) {
  if (!here.other_moving) return partner_of(rows, *here.other);
  return {Homogeneous::of(*here.other), Homogeneous::of(*here.other_moving), 0};
}

std::uint8_t bit_of(double rate) { return rate > 0 ? DriverSequence::ccw_bit : DriverSequence::cw_bit; }

}  // namespace

DriverTravel ArmLinkage::travel() const {
  return {senses, static_cast<float>(wrap_positive(std::arg(last_arm * std::conj(first_arm))))};
}

MapCell ArmLinkage::verdict(double unit) const {
  MapCell cell;
  put_verdict(cell, judged, place, unit);
  return cell;
}

Cell ArmLinkage::cell(const WorkingFrame& frame) const {
  Cell cell{verdict(frame.scale)};
  cell.hill = static_cast<std::size_t>(judged.type);
  cell.place = place;
  cell.pivots = pivots_of(frame.to_user(bars));
  cell.change_point_margin = change_point_margin(bars.lengths());
  return cell;
}

DyadPair ArmLinkage::links() const {
  return {{Homogeneous::of(bars.input_fixed), Homogeneous::of(bars.input_moving), place.input},
          {Homogeneous::of(bars.output_fixed), Homogeneous::of(bars.output_moving), place.output}};
}

// ---- arms in, linkages out ------------------------------------------------------------------------------------------

ArmSolver::ArmSolver(const ArmTask& task, const ArmLayers& layers, const ArmWishes& wishes, bool respect_direction,
                     Simd simd)
    : task_(task),
      layers_(layers),
      wishes_(wishes),
      respect_direction_(respect_direction),
      judges_pivots_(!wishes.judge.places().empty()),
      all_are_plain_(task.plain_count() == task.path.size()),
      dyads_(task.path, arm_drives(), simd) {}

void ArmSolver::add_all(std::size_t tag, MapPoint place, const ArmAtPlace& here, const Take& take) {
  if (const auto layer = layers_.at(place)) {
    const auto pattern = elbow_pattern(here.elbows, here.bits.value_or(layer->pattern));
    add(arms_of(tag, place, here, pattern, layer->dyad), here, true, take);
    return;
  }
  for_elbow_patterns(here.elbows, wishes_.only_in_order && all_are_plain_, [&](const ElbowPattern& pattern) {
    add(arms_of(tag, place, here, pattern, std::nullopt), here, false, take);
  });
}

void ArmSolver::add_any(std::size_t tag, MapPoint place, const ArmAtPlace& here, const Take& take) {
  if (layers_.at(place)) return;
  for (std::size_t bits = 0; bits < pattern_count(here.elbows.points); ++bits) {
    const auto pattern = elbow_pattern(here.elbows, static_cast<std::uint8_t>(bits));
    if (add(arms_of(tag, place, here, pattern, std::nullopt), here, true, take)) return;
  }
}

ArmSolver::Arms ArmSolver::arms_of(std::size_t tag, MapPoint place, const ArmAtPlace& here, const ElbowPattern& pattern,
                                   std::optional<std::size_t> dyad) const {
  return {tag, place, pattern, dyad, here.arm.pivot, arm_motion(here.arm, task_.path, here.elbows, pattern), {}};
}

// It would have the same position twice.
bool ArmSolver::has_twice(const ArmMotion& motion) const {
  return std::any_of(task_.repeated.begin(), task_.repeated.end(), [&](const std::array<std::size_t, 2>& same) {
    return std::abs(motion.link[same[0]] - motion.link[same[1]]) <= tolerance::repeated_pose;
  });
}

// False where nothing was added.
bool ArmSolver::add(Arms arms, const ArmAtPlace& here, bool out_of_order_too, const Take& take) {
  if (has_twice(arms.motion)) return false;
  if (arm_drives()) arms.senses = of_arm(arms);
  if (wishes_.only_in_order && !out_of_order_too && arms.senses.all == 0) return false;
  if (here.other) {
    take_pair(arms, 0, other_link(here, condition_rows(task_.path, arms.motion)), take);
    return true;
  }
  dyads_.add(arms.pivot, arms.motion, arms.senses.all, arms.senses.half_turn);
  waiting_.push_back(std::move(arms));
  if (dyads_.is_full()) finish(take);
  return true;
}

void ArmSolver::finish(const Take& take) {
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

// Judged among others of its kind already, where the arm drives.
void ArmSolver::take_dyad(std::size_t i, std::size_t number, std::size_t at, const Take& take) {
  const Arms& arms = waiting_[i];
  if (!arm_drives()) return take_pair(arms, number, dyads_.dyad(i, at), take);
  const PairJudgement judged = dyads_.judged(i, at);
  if (judged.type == LinkageType::degenerate) return;
  const MapPoint place = layers_.in(arms.place, {arms.pattern.bits, number});
  // Finite, or it would be degenerate. Most linkages are not taken: only where pivots are judged are they needed
  // first.
  const auto bars = [&] { return bars_of(arms, dyads_.dyad(i, at)).value(); };
  const ArmRating rating = rated(judged, place, judges_pivots_ ? std::optional(bars()) : std::nullopt);
  if (ArmLinkage* const slot = take(arms.tag, rating))
    *slot = {place, bars(), judged, arms.motion.link[0], arms.motion.link[count() - 1], arms.senses.all, rating};
}

// Judged by itself.
void ArmSolver::take_pair(const Arms& arms, std::size_t number, const Dyad& other, const Take& take) {
  const auto bars = bars_of(arms, other);
  if (!bars) return;
  const LinkInPositions arm{arms.pivot, arms.pivot + arms.motion.link[0], arms.motion.link};
  const LinkInPositions found = other_in_positions(arms, *bars);
  const LinkInPositions& driver = arm_drives() ? arm : found;
  const Senses senses = arm_drives() ? arms.senses : of_other(arms.motion, found);
  const PairJudgement judged = judge_pair(driver, arm_drives() ? found : arm, count(), senses.all, senses.half_turn);
  if (judged.type == LinkageType::degenerate) return;
  const MapPoint place = layers_.in(arms.place, {arms.pattern.bits, number});
  const ArmRating rating = rated(judged, place, bars);
  if (ArmLinkage* const slot = take(arms.tag, rating))
    *slot = {place, *bars, judged, driver.arm[0], driver.arm[count() - 1], senses.all, rating};
}

// Nothing of a slider.
std::optional<FourBar> ArmSolver::bars_of(const Arms& arms, const Dyad& other) const {
  const auto center = finite_point(other.center), circle = finite_point(other.circle);
  if (!center || !circle) return std::nullopt;
  const Point moving = arms.pivot + arms.motion.link[0];
  return arm_drives() ? FourBar{arms.pivot, moving, *center, *circle} : FourBar{*center, *circle, arms.pivot, moving};
}

LinkInPositions ArmSolver::other_in_positions(const Arms& arms, const FourBar& bars) const {
  LinkInPositions found{bars.output_fixed, bars.output_moving, {}};
  if (!arm_drives()) found = {bars.input_fixed, bars.input_moving, {}};
  for (std::size_t j = 0; j < count(); ++j)
    found.arm[j] = task_.path[j].jet.front() + arms.motion.turn[j] * found.circle - found.center;
  return found;
}

ArmRating ArmSolver::rated(const PairJudgement& judged, MapPoint place, const std::optional<FourBar>& bars) {
  put_verdict(scratch_, judged, place, task_.frame.scale);
  if (judges_pivots_ && bars) scratch_.pivots = pivots_of(task_.frame.to_user(*bars));
  return {wishes_.judge.passes(scratch_), judged.defects.none(), wishes_.rank.score(scratch_)};
}

// ---- senses ---------------------------------------------------------------------------------------------------------

// Where all points are plain the pattern has them.
ArmSolver::Senses ArmSolver::of_arm(const Arms& arms) const {
  Senses senses{arms.pattern.senses, arms.pattern.half_turn_senses};
  if (!all_are_plain_) senses = of_turns(arms.motion.link);
  for (std::size_t j = 0; j < arms.motion.rates.size() && respect_direction_; ++j)
    if (const auto& rates = arms.motion.rates[j].link; !rates.empty()) senses.all &= bit_of(rates.front());
  if (task_.sense) senses.all &= bit_of(*task_.sense);
  return senses;
}

ArmSolver::Senses ArmSolver::of_turns(const std::array<Point, ArmElbows::most_points>& link) const {
  DriverSequenceBuilder order;
  for (std::size_t j = 0; j < count(); ++j)
    order.meet(j == 0 ? 0 : wrap_positive(std::arg(link[j] * std::conj(link[0]))));
  return {order.sequence().senses(), order.sequence().half_turn_senses()};
}

ArmSolver::Senses ArmSolver::of_other(const ArmMotion& motion, const LinkInPositions& link) const {
  DriverSequenceBuilder order;
  for (std::size_t j = 0; j < count(); ++j) {
    order.meet(j == 0 ? 0 : wrap_positive(std::arg(link.arm[j] * std::conj(link.arm[0]))));
    if (motion.rates.empty() || motion.rates[j].body.empty() || !respect_direction_) continue;
    const Point from_point = link.center + link.arm[j] - task_.path[j].jet.front();
    order.pass(cross(link.arm[j], task_.path[j].jet[1] + Point{0, motion.rates[j].body.front()} * from_point));
  }
  return {order.sequence().senses(), order.sequence().half_turn_senses()};
}

}  // namespace linkwright
