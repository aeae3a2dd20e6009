#pragma once

// The forces in four-bars over their travel, one linkage to each lane. In the positions of a task the body is where the
// task has it, and what acts on it is in tables; between them a station costs a root where the linkage is assembled and
// one a spring.

#include "loads/lane_curves.hpp"
#include "loads/lane_efforts.hpp"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"  // only stations that were looked at are read
#endif

namespace linkwright::LINKWRIGHT_ISA::load_lanes {

template <class R>
struct BothWays {
  Pushed<R> open, close;
};

/// Squares of the least rates of the efforts, and the last rates.
template <class R>
struct Rests {
  R hand, drive, hold;
  R last_hand, last_drive;
};

template <int Width>
LINKWRIGHT_INLINE Mask in_sense(const LoadRow& row, int at) {
  Mask mask = 0;
  const signed char sense = row.sense < 0 ? -1 : 1;
  for (int lane = 0; lane < Width; ++lane) mask |= Mask{row.senses[at + lane] == sense} << lane;
  return mask;
}

template <int Width, class W>
struct Travel {
  using R = Real<Width>;
  LoadRow& row;
  const Asked asked;
  int at;
  Mask told;  ///< lanes in which the row has linkages of its sense
  Linkages<R> of;
  AtStation<W, R> acting;
  Ends<R> ends[LaneLoads::most_cases];
  Rests<R> rests[LaneLoads::most_cases];
  Vector<R> turned;  ///< of the body at the last station
  R turn;

  LINKWRIGHT_INLINE Travel(LoadRow& of_row, int from)
      : row(of_row), asked(of_row), at(from), told(in_sense<Width>(of_row, from)) {
    set_linkages<Width>(row, at, of);
  }

  LINKWRIGHT_INLINE void go() {
    if constexpr (!W::has_forces)
      if (asks_hand_in_tables(row, asked)) {
        pass_by_hand_in_tables();
        return fold_all();
      }
    for (int j = 0; j < row.stations; ++j) {
      const Station<R> s = station<Width>(row, of, j, at);
      at_station<Width>(row, of, s, row.position[j], at, acting);
      if (asked.turns) keep_turn(s, j);
      if (asked.hand) pass_by_hand(s, j);
      if (asked.drive && row.drive != LoadRow::by_hand) pass_by_drive(s, j);
    }
    if (row.hand_forces) keep_forces();
    fold_all();
  }

 private:
  [[nodiscard]] LINKWRIGHT_INLINE int cases() const { return row.tables->loads->cases; }
  LINKWRIGHT_INLINE void keep(int c, int curve, int j, R value) const {
    store<Width>(value, curve_of<Width>(row, c, curve) + j * Width);
  }

  /// From station to station it turns by less than half a turn.
  LINKWRIGHT_INLINE void keep_turn(const Station<R>& s, int j) {
    turn = j == 0 ? R{} : R(turn + angle_between<Width>(turned, s.turned));
    turned = s.turned;
    store<Width>(turn, turns_of<Width>(row) + j * Width);
  }
  LINKWRIGHT_INLINE void keep_forces() const {
    for (int lane = 0; lane < Width; ++lane) {
      if (!(told >> lane & 1U)) continue;
      double* to = row.hand_forces + (at + lane) * cases() * 2 * row.stations;
      for (int c = 0; c < cases(); ++c)
        for (const int curve : {open_curve, close_curve})
          for (int j = 0; j < row.stations; ++j) *to++ = curve_of<Width>(row, c, curve)[j * Width + lane];
    }
  }

  LINKWRIGHT_INLINE void pass_by_hand(const Station<R>& s, int j) {
    Effort<W, R> by;
    for (int c = 0; c < cases(); ++c) {
      if (c == 0 || row.hand_way == LoadRow::along) by = hand<Width, W>(row, of.links, s, row.position[j], c);
      const BothWays<R> ways = both_ways(s, j, c, by);
      keep_rest(rests[c].hand, rests[c].last_hand, ends[c].hand_checked, by, ways, j);
      rests[c].hold = by.rate * by.rate;
      const R way = with_sign_of<Width>(of_all<R>(1.0), by.rate);  // efforts are told the way that the motion goes
      keep(c, open_curve, j, way * ways.open.effort);
      keep(c, close_curve, j, way * ways.close.effort);
      ends[c].hold = -(way * ways.open.effort);
      if (!asked.drive || row.drive != LoadRow::by_hand) continue;
      rests[c].drive = rests[c].hand;
      ends[c].drive_checked = ends[c].hand_checked;
      keep_drive(ways, j, c);
    }
  }
  /// What pass_by_hand() keeps, to the last bit, where the hand goes along with its point and all that acts is in
  /// tables.
  LINKWRIGHT_INLINE void pass_by_hand_in_tables() {
    const LoadTables& tables = *row.tables;
    const bool on_body = tables.loads->column_springs > tables.loads->row_springs;
    const bool by_column = on_body || tables.loads->on_output;
    const int count = cases();
    for (int j = 0; j < row.stations; ++j) {
      const Station<R> s = station_in_position<Width>(row, of, j, at);
      W rubbing{};
      add_tabled_rubbing<Width>(row, s, j, at, rubbing);
      const Effort<W, R> by = hand<Width, W>(row, of.links, s, j, 0);
      const R square = by.rate * by.rate;
      for (int c = 0; c < count; ++c) {
        W still{};
        still.add(s, row.acting[j * count + c]);
        if (by_column) add_column<Width>(row, s, tables.acting(j, c) + at, on_body, j, still);
        const R open = -(still.all + rubbing.all) * by.over_rate, close = -(rubbing.all - still.all) * by.over_rate;
        rests[c].hand = j == 0 ? square : smaller(rests[c].hand, square);
        ends[c].hand_checked = j == 0 ? R(open + close) : R(ends[c].hand_checked + (open + close));
        keep(c, open_curve, j, open);
        keep(c, close_curve, j, close);
        if (j + 1 < row.stations) continue;
        rests[c].hold = square;
        ends[c].hold = -open;
      }
    }
  }
  LINKWRIGHT_INLINE void pass_by_drive(const Station<R>& s, int j) {
    const Effort<W, R> by = drive<Width, W>(row, of.links, s);
    for (int c = 0; c < cases(); ++c) {
      const BothWays<R> ways = both_ways(s, j, c, by);
      keep_rest(rests[c].drive, rests[c].last_drive, ends[c].drive_checked, by, ways, j);
      keep_drive(ways, j, c);
    }
  }
  LINKWRIGHT_INLINE void keep_drive(const BothWays<R>& by, int j, int c) const {
    keep(c, effort_curve, j, larger(magnitude<Width>(by.open.effort), magnitude<Width>(by.close.effort)));
    for (int k = 0; k < 4 && asked.joints; ++k)
      keep(c, joint_curve + k, j, larger(by.open.joints.size[k], by.close.joints.size[k]));
  }

  [[nodiscard]] LINKWRIGHT_INLINE BothWays<R> both_ways(const Station<R>& s, int j, int c,
                                                        const Effort<W, R>& by) const {
    const W still = still_in<Width>(row, of, s, acting, j, c, at);
    return {pushed<Width>(row, s, acting.rows, still, acting.rubbing, by, 1.0),
            pushed<Width>(row, s, acting.rows, still, acting.rubbing, by, -1.0)};
  }
  /// Efforts that are no numbers make no number of the sum of both ways; nor does a rate that changes its sign leave
  /// one: between the stations any effort was too small.
  LINKWRIGHT_INLINE void keep_rest(R& rest, R& last, R& checked, const Effort<W, R>& by, const BothWays<R>& ways,
                                   int j) const {
    const R square = by.rate * by.rate, sum = ways.open.effort + ways.close.effort;
    rest = j == 0 ? square : smaller(rest, square);
    checked = j == 0 ? sum : checked + sum;
    if (j > 0) checked += where<Width>(less<Width>(by.rate * last, R{}), of_all<R>(__builtin_huge_val()));
    last = by.rate;
  }

  LINKWRIGHT_INLINE void fold_all() const {
    const unsigned* counted = row.counted;
    const bool both_counted =
        counted[LoadRow::open] == counted[LoadRow::hand] && counted[LoadRow::close] == counted[LoadRow::hand];
    R worst[LoadRow::whats];
    for (int what = 0; what < LoadRow::whats; ++what) {
      if (counted[what] == 0) continue;
      const bool is_known = what == LoadRow::hand && both_counted;
      worst[what] = is_known ? larger(worst[LoadRow::open], worst[LoadRow::close]) : worst_of(what);
      if (what == LoadRow::error) worst[what] = station_error(worst[what], worst[LoadRow::hand]);
      if (row.value[what]) put(row.unit[what] * worst[what], row.value[what] + at);
    }
  }
  /// CellLoads has it.
  [[nodiscard]] LINKWRIGHT_INLINE static R station_error(R at_positions, R at_stations) {
    const R most = of_all<R>(1e300);
    const Mask is_number =
        less<Width>(magnitude<Width>(at_positions), most) & less<Width>(magnitude<Width>(at_stations), most);
    return select<Width>(is_number, R(0.25 * magnitude<Width>(at_stations - at_positions) + 0.01),
                         of_all<R>(__builtin_huge_val()));
  }
  /// Of the cases.
  [[nodiscard]] LINKWRIGHT_INLINE R worst_of(int what) const {
    const bool holds = what == LoadRow::hold, is_least = holds || what == LoadRow::shut;
    const bool drives = what == LoadRow::pin || what == LoadRow::effort;
    const bool is_torque = drives && (row.drive == LoadRow::by_input || row.drive == LoadRow::by_output);
    const R least = is_torque ? of.least_torque_square : of.least_square;
    const R worst_of_all = of_all<R>(is_least ? -__builtin_huge_val() : __builtin_huge_val());
    R worst = R{} - worst_of_all;
    for (int c = 0; c < cases(); ++c) {
      if (!(row.counted[what] >> c & 1U)) continue;
      const R found = found_in<Width>(row, c, what, ends[c]);
      const R rest = holds ? rests[c].hold : drives ? rests[c].drive : rests[c].hand;
      const R checked = holds ? found : drives ? ends[c].drive_checked : ends[c].hand_checked;
      const R most = of_all<R>(1e300);
      const Mask is_number = less<Width>(magnitude<Width>(found), most) & less<Width>(magnitude<Width>(checked), most);
      const R value = select<Width>(less<Width>(least, rest) & is_number, found, worst_of_all);
      worst = is_least ? smaller(worst, value) : larger(worst, value);
    }
    return worst;
  }
  LINKWRIGHT_INLINE void put(R found, float* to) const {
    const typename Pack<Width>::Single values = single<Width>(found);
    if (told == all_lanes<Width>) return store<Width>(values, to);
    float each[Width];
    store<Width>(values, each);
    for (int lane = 0; lane < Width; ++lane)
      if (told >> lane & 1U) to[lane] = each[lane];
  }
};

/// Forces are kept where pins have a say.
template <int Width, class W>
void follow_row(LoadRow& row) {
  for (int at = 0; at < row.columns;) {
    if (in_sense<1>(row, at)) {
      Travel<Width, W>(row, at).go();
      at += Width;
    } else {
      ++at;
    }
  }
}

template <int Width>
void load_kernel(LoadRow& row) {
  if (row.counted[LoadRow::pin] != 0 || row.friction_circle > 0)
    follow_row<Width, Sums<Real<Width>>>(row);
  else
    follow_row<Width, Power<Real<Width>>>(row);
}

}  // namespace linkwright::LINKWRIGHT_ISA::load_lanes
