#define LINKWRIGHT_ISA isa_judge
#include <cmath>
#include <memory>
#include <numeric>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/tolerance.hpp"
#include "six_bar_dyads.hpp"
#include "six_bar_judge.hpp"

namespace linkwright {
namespace {

/// The positions as the driver comes by them in one sense, from position 1 on.
struct DriverRound {
  int sense = 1;
  std::vector<std::size_t> position;
  bool in_order = false;
  bool distinct = true;
  double sweep = 0;  ///< to the last position

  DriverRound() = default;
  DriverRound(std::span<const SixBarTurns> wanted, int sense) : sense(sense), position(wanted.size()) {
    constexpr double least_turn = 1e-6;  // below it positions share an angle of the driver
    std::iota(position.begin(), position.end(), std::size_t{0});
    std::vector<double> turn;
    for (const SixBarTurns& turns : wanted)
      turn.push_back(
          wrap_positive(sense * std::arg(std::conj(wanted.front()[SixBar::driver]) * turns[SixBar::driver])));
    turn.front() = 0;
    std::sort(position.begin(), position.end(), [&](std::size_t i, std::size_t k) { return turn[i] < turn[k]; });
    in_order = std::is_sorted(position.begin(), position.end());
    sweep = turn.back();
    for (std::size_t i = 0; i < position.size(); ++i) {
      const double next = i + 1 < position.size() ? turn[position[i + 1]] : two_pi;
      distinct = distinct && next - turn[position[i]] > least_turn;
    }
  }
};

/// A six-bar on its round: arcs between neighbouring positions, of which at most one may hold dead points.
struct Round {
  std::size_t six_bar = 0;
  std::size_t arc = 0;
  int broken_arcs = 0;
  std::array<double, 2> least_squares{1, 1};  ///< of the sines of samples that are gone
  int times_full = 0;
};

class DyadJudge {
 public:
  DyadJudge(std::span<const SixBarToDrive> six_bars, Simd simd, SixBarReports& reports)
      : six_bars_(six_bars),
        kernel_(dyad_kernel.for_simd(simd)),
        middles_kernel_(dyad_middles_kernel.for_simd(simd)),
        reports_(reports) {
    middles_->lanes = lanes_.get();
  }

  void judge(std::vector<std::size_t> open) {
    open_ = std::move(open);
    for (std::size_t lane = 0; lane < six_bar_lanes; ++lane) take_next(lane);
    while (running_ > 0) {
      kernel_(*lanes_);
      for (std::size_t lane = 0; lane < six_bar_lanes; ++lane) attend(lane);
    }
  }

 private:
  void take_next(std::size_t lane) {
    lanes_->idle[lane] = true;
    lanes_->event[lane] = TravelEvent::none;
    while (!open_.empty()) {
      const std::size_t index = open_.back();
      open_.pop_back();
      const std::optional<DriverRound> round = round_of(six_bars_[index].wanted);
      if (!round || !closes(six_bars_[index]) || !lay(lane, six_bars_[index].loops)) continue;
      rounds_[lane] = *round;
      on_[lane] = {.six_bar = index};
      lanes_->idle[lane] = false;
      lanes_->samples[lane] = 0;
      lanes_->sense.of[lane] = round->sense;
      begin_arc(lane);
      ++running_;
      return;
    }
    rest(lane);
  }

  /// At all positions: what follows knows of them the driver's turns and the sides on which the dyads lie.
  static bool closes(const SixBarToDrive& given) {
    return std::all_of(given.wanted.begin(), given.wanted.end(), [&](const SixBarTurns& turns) {
      const LoopValues values(given.loops, turns);
      return std::max(std::abs(values.f), std::abs(values.g)) <= tolerance::closed;
    });
  }

  /// In the sense in which the positions come in order, if any; nothing where some share an angle.
  static std::optional<DriverRound> round_of(std::span<const SixBarTurns> wanted) {
    constexpr std::size_t least_positions = 3;  // fewer come in order in both senses
    if (wanted.size() < least_positions) return std::nullopt;
    DriverRound ccw(wanted, +1);
    if (!ccw.distinct) return std::nullopt;
    if (ccw.in_order) return ccw;
    DriverRound cw(wanted, -1);
    return cw.in_order ? cw : ccw;
  }

  /// False where a link has no length.
  bool lay(std::size_t lane, const SixBarLoops& loops) {
    constexpr double rounding = 1e-13;  // of sums of coefficients, which are of order one
    DyadLanes& l = *lanes_;
    const auto& [bodies, loop] = *loops.dyads;
    const auto& first = loops.coefficient[loop[0]];
    const auto& second = loops.coefficient[loop[1]];
    const Point x = first[bodies[0][0]], y = first[bodies[0][1]];
    const double xx = std::norm(x), yy = std::norm(y), x_length = std::sqrt(xx), y_length = std::sqrt(yy);
    const double p = std::abs(second[bodies[1][0]]), q = std::abs(second[bodies[1][1]]);
    if (!(x_length > 0 && y_length > 0 && p > 0 && q > 0)) return false;
    const Point gx = second[bodies[0][0]] / x, gy = second[bodies[0][1]] / y;
    const double arm = std::abs(first[1]);
    put(l.c0, lane, first[0]);
    put(l.c1, lane, first[1]);
    put(l.d0, lane, second[0]);
    put(l.d1, lane, second[1]);
    put(l.gx, lane, gx);
    put(l.gy, lane, gy);
    l.xx.of[lane] = xx;
    l.yy.of[lane] = yy;
    l.pp_and_qq.of[lane] = p * p + q * q;
    l.two_pq.of[lane] = 2 * p * q;
    l.shortest.of[lane] = std::abs(p - q) + rounding;
    l.longest.of[lane] = p + q - rounding;
    l.per_two_xy.of[lane] = 1 / (2 * x_length * y_length);
    l.beyond_reach[0].of[lane] = -std::max(1e-11, rounding * (1 + xx + yy) * l.per_two_xy.of[lane]);
    l.beyond_reach[1].of[lane] = -std::max(1e-11, rounding * (1 + p * p + q * q) / (2 * p * q));
    l.bend_of_u.of[lane] = 2 * std::abs(first[0]) * arm * l.per_two_xy.of[lane];
    l.turned.of[lane] = arm;
    l.slope.of[lane] = arm * arm * (1 / x_length + 1 / y_length);
    l.bend.of[lane] = std::abs(second[1]);
    l.first_bend.of[lane] = arm * arm * (std::abs(gx) / x_length + std::abs(gy) / y_length);
    l.second_bend.of[lane] = std::abs(gx) + std::abs(gy);
    return true;
  }

  /// From the position at which the arc begins, whose configuration is known.
  void begin_arc(std::size_t lane) {
    DyadLanes& l = *lanes_;
    const Round& on = on_[lane];
    const auto& [loops, wanted] = six_bars_[on.six_bar];
    const std::vector<std::size_t>& position = rounds_[lane].position;
    const SixBarTurns& turns = wanted[position[on.arc]];
    const auto& [bodies, loop] = *loops.dyads;
    const LoopValues values(loops, turns);
    const auto& first = loop[0] == 0 ? values.u : values.v;
    const Point x = first[bodies[0][0] - 1], y = first[bodies[0][1] - 1], u = -(x + y), arm = first[0];
    const Point w = at(l.d0, lane) + at(l.d1, lane) * turns[1] + at(l.gx, lane) * x + at(l.gy, lane) * y;
    const double per = l.per_two_xy.of[lane];
    l.side.of[lane] = cross(x, y) > 0 ? 1 : -1;
    put(l.turn, lane, turns[1]);
    put(l.goal, lane, wanted[position[(on.arc + 1) % position.size()]][1]);
    put(l.w, lane, w);
    l.ww.of[lane] = std::norm(w);
    l.cosine.of[lane] = (std::norm(u) - l.xx.of[lane] - l.yy.of[lane]) * per;
    l.cosine_rate.of[lane] = std::abs(2 * cross(u, arm) * per);
    constexpr double first_step = 0.2;
    l.step.of[lane] = first_step;
    if (l.samples[lane] > 0) return;  // it has come there
    const double other = (l.ww.of[lane] - l.pp_and_qq.of[lane]) / l.two_pq.of[lane];
    note(lane, turns[1], 1 - l.cosine.of[lane] * l.cosine.of[lane], 1 - other * other);
  }

  void note(std::size_t lane, Point turn, double first, double second) {
    const auto sample = static_cast<std::size_t>(lanes_->samples[lane]++);
    put(lanes_->passed[sample], lane, turn);
    lanes_->sine_squares[0][sample].of[lane] = first;
    lanes_->sine_squares[1][sample].of[lane] = second;
  }

  void attend(std::size_t lane) {
    if (lanes_->idle[lane] || lanes_->event[lane] == TravelEvent::none) return;
    Round& on = on_[lane];
    const DriverRound& round = rounds_[lane];
    const std::size_t arcs = round.position.size();
    if (lanes_->event[lane] == TravelEvent::undecided) return finish(lane, std::nullopt);
    if (lanes_->event[lane] == TravelEvent::full) {
      constexpr int patience = 32;
      return ++on.times_full < patience ? make_room(lane) : finish(lane, std::nullopt);
    }
    if (lanes_->event[lane] == TravelEvent::dead_point && ++on.broken_arcs > 1)
      return finish(lane, with_defect(Defects::branch_bit));
    ++on.arc;
    if (on.arc + 1 == arcs && round.in_order && on.broken_arcs == 0)
      return finish(lane, without_defects(round.sense, round.sweep, least_sines(lane)));
    if (on.arc == arcs) return finish(lane, with_defect(Defects::order_bit));
    if (on.broken_arcs > 0 || !round.in_order) lanes_->samples[lane] = 0;
    if (is_full(lane)) make_room(lane);
    begin_arc(lane);
  }

  void finish(std::size_t lane, const std::optional<SixBarDriveReport>& report) {
    reports_[on_[lane].six_bar] = report;
    --running_;
    take_next(lane);
  }

  [[nodiscard]] std::array<double, 2> least_sines(std::size_t lane) const {
    const std::array<double, 2> squares = least_squares(lane);
    return {std::sqrt(std::max(squares[0], 0.0)), std::sqrt(std::max(squares[1], 0.0))};
  }

  [[nodiscard]] bool is_full(std::size_t lane) const { return lanes_->samples[lane] + 1 >= DyadLanes::most_samples; }
  /// The last two samples go on.
  void make_room(std::size_t lane) {
    on_[lane].least_squares = least_squares(lane);
    const auto last = static_cast<std::size_t>(lanes_->samples[lane]) - 1;
    lanes_->samples[lane] = 0;
    for (std::size_t i = last - 1; i <= last; ++i)
      note(lane, at(lanes_->passed[i], lane), lanes_->sine_squares[0][i].of[lane], lanes_->sine_squares[1][i].of[lane]);
  }

  /// Squared sines of the samples of the way, and of lower places between them.
  [[nodiscard]] std::array<double, 2> least_squares(std::size_t lane) const {
    std::array<double, 2> least = on_[lane].least_squares;
    const auto count = static_cast<std::size_t>(lanes_->samples[lane]);
    middles_->lane = static_cast<int>(lane);
    middles_kernel_(*middles_);
    for (std::size_t dyad = 0; dyad < 2; ++dyad) {
      const auto lower = [&](double square) { least[dyad] = std::min(least[dyad], square); };
      const auto square = [&](std::size_t i) { return lanes_->sine_squares[dyad][i].of[lane]; };
      for (std::size_t i = 0; i < count; ++i) {
        lower(square(i));
        if (i > 0 && i + 1 < count && square(i) <= square(i - 1) && square(i) <= square(i + 1))
          lower(Valley(*this, lane, dyad, i).lowest(i - 1, i + 1));
        if (i + 1 == count) continue;
        const double halfway = middles_->sine_squares[dyad][i];
        if (halfway < square(i) && halfway < square(i + 1))
          lower(Valley(*this, lane, dyad, i).lowest_before(i + 1, halfway));
      }
      for (const auto& [end, next] : {std::pair{std::size_t{0}, std::size_t{1}}, std::pair{count - 1, count - 2}})
        if (count > 1) lower(Valley(*this, lane, dyad, end).lowest_from_end(next));
    }
    return least;
  }

  /// The squared sine of a dyad about a sample, by the driver's way from there (twice the tangent of half the angle).
  class Valley {
   public:
    Valley(const DyadJudge& judge, std::size_t lane, std::size_t dyad, std::size_t middle)
        : lanes_(*judge.lanes_),
          lane_(lane),
          dyad_(dyad),
          middle_(at(lanes_.passed[middle], lane)),
          here_{0, lanes_.sine_squares[dyad][middle].of[lane]} {}

    /// Where the sample itself is lower than both others.
    [[nodiscard]] double lowest(std::size_t before, std::size_t after) const {
      return lowest(sample(before), here_, sample(after));
    }
    /// On the way to the next sample, where halfway it is lower than at both.
    [[nodiscard]] double lowest_before(std::size_t next, double halfway) const {
      const Place beyond = sample(next);
      return lowest(here_, {beyond.way / 2, halfway}, beyond);
    }
    /// Where the way begins or ends: it may go down from there before it goes up to the next sample.
    [[nodiscard]] double lowest_from_end(std::size_t next) const {
      constexpr double a_little = 1e-3;
      const Place beyond = sample(next), inside = place_at(a_little * beyond.way);
      return inside.square < here_.square && inside.square < beyond.square ? lowest(here_, inside, beyond)
                                                                           : here_.square;
    }

   private:
    struct Place {
      double way, square;
    };
    [[nodiscard]] Place place_at(double way) const {
      const Point turn = middle_ * Point{1 - way * way / 4, way} / (1 + way * way / 4);
      const isa_judge::OneLane<1> own{static_cast<int>(lane_)};
      const isa_judge::DyadsAt<1> found(lanes_, own, {turn.real(), turn.imag()});
      return {way, found.sine_square[dyad_]};
    }
    [[nodiscard]] Place sample(std::size_t i) const {
      const Point turn = std::conj(middle_) * at(lanes_.passed[i], lane_);
      return {2 * turn.imag() / (1 + turn.real()), lanes_.sine_squares[dyad_][i].of[lane_]};
    }
    /// By parabolas.
    [[nodiscard]] double lowest(Place before, Place middle, Place after) const {
      constexpr int parabolas = 4;
      for (int round = 0; round < parabolas; ++round) {
        const double h0 = before.way - middle.way, h1 = after.way - middle.way;
        const double s0 = (before.square - middle.square) / h0, s1 = (after.square - middle.square) / h1;
        const double bend = (s1 - s0) / (h1 - h0), way = middle.way - (s0 - bend * h0) / (2 * bend);
        if (!(std::abs(way - middle.way) > 1e-9) || (way - before.way) * (way - after.way) >= 0) break;
        Place next = place_at(way);
        if (next.square < middle.square) std::swap(next, middle);
        ((next.way - middle.way) * h0 > 0 ? before : after) = next;
      }
      return middle.square;
    }

    const DyadLanes& lanes_;
    std::size_t lane_, dyad_;
    Point middle_;
    Place here_;
  };

  /// Something harmless, so that the kernel may work on it.
  void rest(std::size_t lane) {
    DyadLanes& l = *lanes_;
    for (LaneVector* v : {&l.c0, &l.c1, &l.d0, &l.d1, &l.gx, &l.gy, &l.turn, &l.goal, &l.w}) put(*v, lane, 1);
    for (LaneReal* v : {&l.xx, &l.yy, &l.side, &l.pp_and_qq, &l.two_pq, &l.shortest, &l.longest, &l.per_two_xy,
                        &l.bend_of_u, &l.turned, &l.slope, &l.bend, &l.first_bend, &l.second_bend, &l.sense, &l.step,
                        &l.cosine, &l.cosine_rate, &l.ww})
      v->of[lane] = 1;
    l.samples[lane] = 0;
  }

  std::span<const SixBarToDrive> six_bars_;
  void (*kernel_)(DyadLanes&);
  void (*middles_kernel_)(DyadMiddles&);
  SixBarReports& reports_;
  std::unique_ptr<DyadLanes> lanes_ = std::make_unique<DyadLanes>();
  std::unique_ptr<DyadMiddles> middles_ = std::make_unique<DyadMiddles>();
  std::array<Round, six_bar_lanes> on_{};
  std::array<DriverRound, six_bar_lanes> rounds_;
  std::vector<std::size_t> open_;
  int running_ = 0;
};

}  // namespace

void judge_dyads(std::span<const SixBarToDrive> six_bars, std::vector<std::size_t> open, Simd simd,
                 SixBarReports& reports) {
  DyadJudge(six_bars, simd, reports).judge(std::move(open));
}

}  // namespace linkwright
