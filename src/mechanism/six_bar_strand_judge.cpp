#include <cmath>
#include <limits>
#include <memory>

#include "linkwright/core/tolerance.hpp"
#include "six_bar_judge.hpp"
#include "six_bar_walk.hpp"

namespace linkwright {
namespace {

/// Of six-bars that do not fall apart into dyads: the walks of drive_six_bar(), there, and back where that does not do.
class StrandJudge {
 public:
  StrandJudge(std::span<const SixBarToDrive> six_bars, Simd simd, SixBarReports& reports)
      : six_bars_(six_bars), kernel_(strand_kernel.for_simd(simd)), reports_(reports) {}

  void judge(std::vector<std::size_t> open) {
    open_ = std::move(open);
    for (std::size_t lane = 0; lane < six_bar_lanes; ++lane) take_next(lane);
    while (running_ > 0) {
      kernel_(*lanes_);
      for (std::size_t lane = 0; lane < six_bar_lanes; ++lane)
        if (!lanes_->idle[lane] && lanes_->event[lane] != TravelEvent::none) attend(lane);
    }
  }

 private:
  struct Walking {
    std::size_t six_bar = 0;
    int sense = 1;
    SixBarProgress walk;
    std::optional<SixBarProgress> there;
    std::optional<SixBarStrand> home;
  };

  void take_next(std::size_t lane) {
    lanes_->idle[lane] = true;
    lanes_->event[lane] = TravelEvent::none;
    while (!open_.empty()) {
      const std::size_t index = open_.back();
      open_.pop_back();
      const auto& [loops, wanted] = six_bars_[index];
      if (wanted.size() > StrandLanes::places) continue;
      const auto home = corrected(loops, wanted.front(), tolerance::on_curve);
      if (!home || !(home->reach > tolerance::crossing_strands_radius)) continue;
      on_[lane] = {index, likelier_sense(wanted), {}, {}, home};
      lay(lane, loops);
      lanes_->idle[lane] = false;
      ++running_;
      if (begin_walk(lane)) return;
    }
    if (lanes_->idle[lane]) rest(lane);
  }

  void lay(std::size_t lane, const SixBarLoops& loops) {
    for (std::size_t l = 0; l < 2; ++l) {
      put(lanes_->ground[l], lane, loops.coefficient[l][0]);
      for (std::size_t i = 0; i < 5; ++i) put(lanes_->coefficient[l][i], lane, loops.coefficient[l][i + 1]);
    }
    lanes_->least_reach.of[lane] = tolerance::crossing_strands_radius;
  }

  /// False where the six-bar is done with.
  bool begin_walk(std::size_t lane) {
    StrandLanes& l = *lanes_;
    Walking& on = on_[lane];
    on.walk = SixBarProgress(six_bars_[on.six_bar].wanted.size());
    for (std::size_t i = 0; i < 5; ++i) {
      put(l.turn[i], lane, on.home->turns[i + 1]);
      l.tangent[i].of[lane] = on.home->tangent[i];
      l.correction[i].of[lane] = on.home->correction[i];
    }
    l.reach.of[lane] = on.home->reach;
    l.home_sign.of[lane] = on.home->positive() ? 1 : -1;
    l.along.of[lane] = l.home_sign.of[lane] * on.sense;
    l.length.of[lane] = l.turned.of[lane] = 0;
    l.steps[lane] = 0;
    const double sine = sines_of(six_bars_[on.six_bar].loops, on.home->values)[0];
    l.least_sine_4th.of[lane] = sine * sine * sine * sine;
    look_out(lane);
    return go_on(lane);
  }

  void look_out(std::size_t lane) {
    const Walking& on = on_[lane];
    const auto wanted = six_bars_[on.six_bar].wanted;
    for (std::size_t p = 0; p < StrandLanes::places; ++p)
      for (std::size_t i = 0; i < 5; ++i) {
        constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
        const bool is_home = p == 0;
        const bool wants = is_home || (p < wanted.size() && !on.walk.meetings[p]);
        put(lanes_->place[p][i], lane,
            !wants    ? Point{nowhere, nowhere}
            : is_home ? on.home->turns[i + 1]
                      : wanted[p][i + 1]);
      }
  }

  [[nodiscard]] SixBarStrand here(std::size_t lane) const {
    SixBarTurns turns;
    turns[0] = 1;
    for (std::size_t i = 0; i < 5; ++i) turns[i + 1] = at(lanes_->turn[i], lane);
    SixBarStrand strand{turns, {}, {}, lanes_->reach.of[lane], LoopValues(six_bars_[on_[lane].six_bar].loops, turns)};
    for (std::size_t i = 0; i < 5; ++i) strand.tangent[i] = lanes_->tangent[i].of[lane];
    return strand;
  }

  /// What the next step meets; false where the six-bar is done with.
  bool go_on(std::size_t lane) {
    Walking& on = on_[lane];
    const auto& [loops, wanted] = six_bars_[on.six_bar];
    const SixBarStrand strand = here(lane);
    const TurnVector ahead = times(lanes_->along.of[lane], strand.tangent);
    const double step = step_in_reach * strand.reach;
    on.walk.length = lanes_->length.of[lane];
    on.walk.turn = lanes_->turned.of[lane];
    const auto met =
        std::count_if(on.walk.meetings.begin(), on.walk.meetings.end(), [](const auto& m) { return m.has_value(); });
    on.walk.meet(loops, wanted, strand, ahead, step, SixBarDriveOptions{}.pose_tolerance);
    const auto now =
        std::count_if(on.walk.meetings.begin(), on.walk.meetings.end(), [](const auto& m) { return m.has_value(); });
    if (now != met) look_out(lane);
    const bool home = lanes_->steps[lane] > 0 && distance_to(on.home->turns, strand, ahead, step);
    return on.walk.met_all() || home ? end_walk(lane) : true;
  }

  /// False where the six-bar is done with.
  bool end_walk(std::size_t lane) {
    Walking& on = on_[lane];
    if (on.walk.met_all_in_order()) return finish(lane, free_of_defects(lane));
    if (on.there) {
      const bool one_branch = met_all_between_them(*on.there, on.walk);
      return finish(lane, with_defect(one_branch ? Defects::order_bit : Defects::branch_bit));
    }
    on.there = std::move(on.walk);
    on.sense = -on.sense;
    return begin_walk(lane);
  }

  [[nodiscard]] SixBarDriveReport free_of_defects(std::size_t lane) const {
    const Walking& on = on_[lane];
    double least = lanes_->least_sine_4th.of[lane];
    for (const SixBarTurns& turns : six_bars_[on.six_bar].wanted) {
      const double sine = sines_of(six_bars_[on.six_bar].loops, LoopValues(six_bars_[on.six_bar].loops, turns))[0];
      least = std::min(least, sine * sine * sine * sine);
    }
    const double sine = std::min(1.0, std::sqrt(std::sqrt(least)));
    return without_defects(on.sense, std::abs(on.walk.meetings.back()->turn), {sine, sine});
  }

  void attend(std::size_t lane) {
    switch (lanes_->event[lane]) {
      case TravelEvent::undecided:
        finish(lane, undecided());  // driving would come to the same place
        return take_next(lane);
      case TravelEvent::dead_point:
        if (!end_walk(lane)) take_next(lane);
        return;
      default:
        if (!go_on(lane)) take_next(lane);
    }
  }

  static SixBarDriveReport undecided() {
    SixBarDriveReport report = with_defect(Defects::branch_bit | Defects::circuit_bit);
    report.completed = false;
    return report;
  }

  bool finish(std::size_t lane, const std::optional<SixBarDriveReport>& report) {
    reports_[on_[lane].six_bar] = report;
    lanes_->idle[lane] = true;
    --running_;
    return false;
  }

  /// Something harmless, so that the kernel may work on it.
  void rest(std::size_t lane) {
    StrandLanes& l = *lanes_;
    for (std::size_t i = 0; i < 5; ++i) {
      for (auto& coefficients : l.coefficient) put(coefficients[i], lane, 1);
      put(l.turn[i], lane, 1);
      for (LaneReal* v : {&l.tangent[i], &l.correction[i]}) v->of[lane] = 0;
    }
    for (LaneReal* v : {&l.along, &l.home_sign, &l.least_reach, &l.reach, &l.length, &l.turned, &l.least_sine_4th})
      v->of[lane] = 0;
    for (auto& place : l.place)
      for (LaneVector& turn : place) put(turn, lane, 1);
  }

  std::span<const SixBarToDrive> six_bars_;
  void (*kernel_)(StrandLanes&);
  SixBarReports& reports_;
  std::unique_ptr<StrandLanes> lanes_ = std::make_unique<StrandLanes>();
  std::array<Walking, six_bar_lanes> on_{};
  std::vector<std::size_t> open_;
  int running_ = 0;
};

}  // namespace

void judge_strands(std::span<const SixBarToDrive> six_bars, std::vector<std::size_t> open, Simd simd,
                   SixBarReports& reports) {
  StrandJudge(six_bars, simd, reports).judge(std::move(open));
}

}  // namespace linkwright
