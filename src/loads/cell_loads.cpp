#include "cell_loads.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "linkwright/algebra/line_search.hpp"
#include "linkwright/loads/load_report.hpp"
#include "loads/curve_root.hpp"
#include "loads/free_strength.hpp"
#include "loads/load_kernel.hpp"
#include "loads/load_travel.hpp"

namespace linkwright {
namespace cell_loads {

/// A travel and its stations.
struct TravelledPlaces {
  LoadTravel travel;
  std::vector<double> turns;
  std::vector<LoadedPlace> places;  ///< one to each, fewer where it gets stuck
};

static TravelledPlaces travelled(LoadTravel travel, const Loads& loads, CellLook look, const Pose& body) {
  const int between = steps_between(loads.stations, travel.positions().size());
  TravelledPlaces found{std::move(travel), {}, {}};
  const auto handle = BoundLoads(loads, LoadCase{}, found.travel.first(), body).handle();
  found.turns = look == CellLook::map ? found.travel.stations(between) : found.travel.close_stations(between, handle);
  for (const double turn : found.turns) {
    const auto place = found.travel.at(turn);
    if (!place) break;
    found.places.push_back(*place);
  }
  return found;
}

/// The curves of a case at stations.
class CellCase {
 public:
  CellCase(const Loads& loads, LoadCase of, const TravelledPlaces& on, const Pose& body, CellLook look)
      : loads_(loads), of_(std::move(of)), on_(on), bound_(loads, of_, on.travel.first(), body), look_(look) {}

  [[nodiscard]] bool counts(ReadOut read_out) const { return of_.counts(read_out); }

  [[nodiscard]] std::optional<double> value(ReadOut read_out) {
    switch (read_out) {
      case ReadOut::max_open_force:
        return once(open_, [&] { return largest_of_hand(+1); });
      case ReadOut::max_close_force:
        return once(close_, [&] { return largest_of_hand(-1); });
      case ReadOut::hand_force: {
        const auto open = value(ReadOut::max_open_force), close = value(ReadOut::max_close_force);
        return open && close ? std::optional(std::max(*open, *close)) : std::nullopt;
      }
      case ReadOut::hold_open: {
        const auto open = hand(loaded(on_.places.back()), +1);
        return open ? std::optional(-*open) : std::nullopt;
      }
      case ReadOut::self_rise:
        return self_going(+1);
      case ReadOut::self_close:
        return self_going(-1);
      case ReadOut::max_pin_force:
        return largest_pin();
      case ReadOut::max_torque:
      case ReadOut::cylinder_force:
        return drive_passes_across() ? std::nullopt : largest([&](const Loaded& at) { return drive(at); });
      default:
        return std::nullopt;
    }
  }

  /// The hand's forces at the stations, those of opening before those of closing; nothing where it rests or locks.
  [[nodiscard]] std::optional<std::vector<double>> hand_forces() {
    if (hand_passes_across()) return std::nullopt;
    std::vector<double> forces;
    for (const int sense : {+1, -1})
      for (const Loaded& at : stations()) {
        const auto force = hand(at, sense);
        if (!force || !std::isfinite(*force)) return std::nullopt;
        forces.push_back(*force);
      }
    return forces;
  }
  /// The larger of both, of the positions alone.
  [[nodiscard]] std::optional<double> hand_at_positions() {
    const auto forces = hand_forces();
    if (!forces) return std::nullopt;
    const std::vector<double>& positions = on_.travel.positions();
    double most = -std::numeric_limits<double>::infinity();
    for (const std::size_t way : {std::size_t{0}, on_.turns.size()}) {
      std::vector<double> turns, values;
      for (std::size_t j = 0; j < on_.turns.size(); ++j) {
        if (!std::binary_search(positions.begin(), positions.end(), on_.turns[j])) continue;
        turns.push_back(on_.turns[j]);
        values.push_back((*forces)[way + j]);
      }
      most = std::max(most, largest_with_parabola(turns, values));
    }
    return most;
  }

 private:
  /// A place with all that acts there.
  struct Loaded {
    const LoadedPlace& place;
    Acting acting;
  };
  [[nodiscard]] Loaded loaded(const LoadedPlace& place) const { return {place, bound_.acting(place)}; }

  /// At the stations.
  [[nodiscard]] const std::vector<Loaded>& stations() {
    if (stations_.empty())
      for (const LoadedPlace& place : on_.places) stations_.push_back(loaded(place));
    return stations_;
  }
  template <class Of>
  [[nodiscard]] static std::optional<double> once(std::optional<std::optional<double>>& known, const Of& of) {
    if (!known) known = of();
    return *known;
  }

  [[nodiscard]] Push push(const Loaded& at, const UnitEffort& by, int sense) const {
    return bound_.push(at.place, at.acting, by, sense,
                       look_ == CellLook::map ? PinFrictionModel::first_order : PinFrictionModel::close);
  }
  [[nodiscard]] std::optional<double> hand(const Loaded& at, int sense) const {
    const auto by = bound_.hand(at.place);
    if (!by) return std::nullopt;
    const Push pushed = push(at, *by, sense);
    return pushed.locks ? std::nullopt : std::optional(by->way() * pushed.effort);
  }
  /// Somewhere it moves across what moves it, which then takes any force.
  template <class EffortAt>
  [[nodiscard]] bool passes_across(const EffortAt& effort_at) const {
    double before = 0;
    return std::any_of(on_.places.begin(), on_.places.end(), [&](const LoadedPlace& place) {
      const auto by = effort_at(place);
      const bool turns_round = by && by->rate * before < 0;
      if (by) before = by->rate;
      return turns_round;
    });
  }
  [[nodiscard]] bool hand_passes_across() const {
    return passes_across([&](const LoadedPlace& place) { return bound_.hand(place); });
  }
  [[nodiscard]] bool drive_passes_across() const {
    return passes_across([&](const LoadedPlace& place) { return bound_.drive(place); });
  }
  [[nodiscard]] std::optional<double> largest_of_hand(int sense) {
    if (hand_passes_across()) return std::nullopt;
    return largest([&](const Loaded& at) { return hand(at, sense); });
  }

  /// How far the body has turned where it begins to go by itself: to rise from the last position back as far as
  /// opening takes a force below 0, to close from position 1 on. Linear between stations.
  [[nodiscard]] std::optional<double> self_going(int sense) {
    if (hand_passes_across()) return std::nullopt;
    const auto force = [&](const Loaded& at) { return hand(at, sense); };
    std::vector<double> values;
    for (const Loaded& at : stations()) {
      const auto here = force(at);
      if (!here || !std::isfinite(*here)) return std::nullopt;
      values.push_back(*here);
    }
    const std::size_t last = values.size() - 1;
    const auto station = [&](std::size_t k) { return sense > 0 ? last - k : k; };
    std::size_t k = 0;
    while (k <= last && values[station(k)] < 0) ++k;
    if (k == 0 || k > last) return std::abs(on_.places[station(std::min(k, last))].turn[1]);
    return std::abs(turn_between(station(k - 1), station(k), values, force));
  }
  /// Of the body, where a force passes 0 between two stations.
  template <class Of>
  [[nodiscard]] double turn_between(std::size_t below, std::size_t above, const std::vector<double>& values,
                                    const Of& force) const {
    const double from = on_.places[below].turn[1], to = on_.places[above].turn[1];
    if (look_ == CellLook::map) return from + (to - from) * values[below] / (values[below] - values[above]);
    const auto [low, high] = std::minmax(on_.turns[below], on_.turns[above]);
    const auto place = on_.travel.at(root_between(low, high, [&](double turn) { return at_turn(turn, force); }));
    return place ? place->turn[1] : from;
  }

  struct BothWays {
    Push open, close;
  };
  [[nodiscard]] std::optional<BothWays> both_ways(const Loaded& at) const {
    const auto by = bound_.drive(at.place);
    if (!by) return std::nullopt;
    const BothWays ways{push(at, *by, +1), push(at, *by, -1)};
    return ways.open.locks || ways.close.locks ? std::nullopt : std::optional(ways);
  }
  [[nodiscard]] std::optional<double> drive(const Loaded& at) const {
    const double unit = loads_.drive == LoadDrive::cylinder ? 1 : metres_of(loads_);
    const auto ways = both_ways(at);
    return ways ? std::optional(unit * std::max(std::abs(ways->open.effort), std::abs(ways->close.effort)))
                : std::nullopt;
  }
  [[nodiscard]] std::optional<double> largest_pin() {
    if (drive_passes_across()) return std::nullopt;
    std::vector<BothWays> ways;
    for (const Loaded& at : stations()) {
      const auto here = both_ways(at);
      if (!here) return std::nullopt;
      ways.push_back(*here);
    }
    double most = 0;
    for (std::size_t joint = 0; joint < four_bar_joints; ++joint) {
      const auto of = [&](const BothWays& is) {
        return std::max(std::abs(is.open.joints[joint]), std::abs(is.close.joints[joint]));
      };
      std::vector<double> values;
      for (const BothWays& here : ways) values.push_back(of(here));
      most = std::max(most, top_of(values, [&](const Loaded& at) {
                        const auto here = both_ways(at);
                        return here ? std::optional(of(*here)) : std::nullopt;
                      }));
    }
    return most;
  }

  template <class Of>
  [[nodiscard]] std::optional<double> largest(const Of& of) {
    std::vector<double> values;
    for (const Loaded& at : stations()) {
      const auto here = of(at);
      if (!here || !std::isfinite(*here)) return std::nullopt;
      values.push_back(*here);
    }
    return top_of(values, of);
  }
  template <class Of>
  [[nodiscard]] double top_of(const std::vector<double>& values, const Of& of) const {
    return look_ == CellLook::map ? largest_with_parabola(on_.turns, values) : largest_by_parabolas(values, of);
  }
  template <class Of>
  [[nodiscard]] std::optional<double> at_turn(double turn, const Of& of) const {
    const auto place = on_.travel.at(turn);
    return place ? of(loaded(*place)) : std::nullopt;
  }

  /// A largest value and what stands on either side of it.
  struct Bracket {
    line_search::Flank low, top, high;
  };
  /// About the largest station; at an end of the travel from there inwards, nothing where it only falls.
  template <class Of>
  [[nodiscard]] std::optional<Bracket> bracket_of(const std::vector<double>& values, std::size_t k,
                                                  const Of& of) const {
    const auto station = [&](std::size_t i) { return line_search::Flank{on_.turns[i], values[i]}; };
    if (k > 0 && k + 1 < values.size()) return Bracket{station(k - 1), station(k), station(k + 1)};
    if (values.size() < 2) return std::nullopt;
    constexpr int halvings = 4;
    const line_search::Flank end = station(k);
    line_search::Flank inner = station(k == 0 ? 1 : k - 1);
    for (int i = 0; i < halvings; ++i) {
      const double middle = (end.at + inner.at) / 2;
      const auto value = at_turn(middle, of);
      if (!value) return std::nullopt;
      const line_search::Flank here{middle, *value};
      if (*value > end.score) return k == 0 ? Bracket{end, here, inner} : Bracket{inner, here, end};
      inner = here;
    }
    return std::nullopt;
  }

  /// The top between the neighbours of the largest, by the tops of three parabolas one after the other.
  template <class Of>
  [[nodiscard]] double largest_by_parabolas(const std::vector<double>& values, const Of& of) const {
    constexpr int parabolas = 3;
    const auto k = static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin());
    auto found = bracket_of(values, k, of);
    if (!found) return values[k];
    auto& [low, top, high] = *found;
    for (int i = 0; i < parabolas; ++i) {
      const auto turn = line_search::vertex(low, top, high);
      const auto value = turn && *turn != top.at ? at_turn(*turn, of) : std::nullopt;
      if (!value) break;
      const line_search::Flank here{*turn, *value};
      const bool is_top = here.score > top.score;
      ((here.at < top.at) == is_top ? high : low) = is_top ? top : here;
      if (is_top) top = here;
    }
    return top.score;
  }

  const Loads& loads_;
  LoadCase of_;
  const TravelledPlaces& on_;
  BoundLoads bound_;
  CellLook look_;
  std::vector<Loaded> stations_;
  std::optional<std::optional<double>> open_, close_;
};

}  // namespace cell_loads

namespace cell_loads {

static std::vector<CellCase> cases_on(const TravelledPlaces& on, const Loads& loads, const Pose& body, CellLook look) {
  std::vector<CellCase> cases;
  for (LoadCase& of : cases_of(loads)) cases.emplace_back(loads, std::move(of), on, body, look);
  return cases;
}

/// The hand's forces at the stations under one strength of the free spring: in the cases that count, and those
/// of opening the last position.
struct HandUnder {
  std::vector<double> hand, last;
};

static std::optional<HandUnder> hand_under(double f1, const TravelledPlaces& on, const Loads& given, const Pose& body,
                                           CellLook look) {
  const Loads loads = with_f1(given, f1);
  HandUnder found;
  for (CellCase& each : cases_on(on, loads, body, look)) {
    const bool counts = each.counts(ReadOut::hand_force), holds = each.counts(ReadOut::hold_open);
    if (!counts && !holds) continue;
    const auto forces = each.hand_forces();
    if (!forces) return std::nullopt;
    if (counts) found.hand.insert(found.hand.end(), forces->begin(), forces->end());
    if (holds) found.last.push_back((*forces)[on.places.size() - 1]);
  }
  return found;
}

/// Lines through forces under some strength, as they rise by the strength without the friction of pins.
static StrengthLines lines_of(const std::vector<double>& forces, const std::vector<double>& weakest,
                              const std::vector<double>& strongest, double share) {
  StrengthLines lines;
  for (std::size_t i = 0; i < forces.size(); ++i) lines.add(forces[i], share, {weakest[i], strongest[i]});
  return lines;
}

/// F1 with which the largest force of the hand at the stations is least; the friction of pins, which goes by
/// it, is that under the answer.
static std::optional<double> best_f1(const TravelledPlaces& on, const Loads& loads, const Pose& body, CellLook look) {
  constexpr double near_enough = 1e-8;
  const double agreed = look == CellLook::map ? agreed_strength : near_enough;
  const FreeStrength& free = *std::get<GasSpring>(loads.springs[*free_spring(loads)].law).free;
  const StrengthRange range = strengths_of(free);
  Loads smooth = loads;
  smooth.pins.reset();
  const auto weakest = hand_under(range.weakest, on, smooth, body, look);
  const auto strongest = hand_under(range.strongest, on, smooth, body, look);
  if (!weakest || !strongest) return std::nullopt;
  HandUnder now = *weakest;
  double share = 0;
  for (int turn = 0; turn < most_strengths; ++turn) {
    const auto next = best_share(lines_of(now.hand, weakest->hand, strongest->hand, share),
                                 lines_of(now.last, weakest->last, strongest->last, share), held_open(free));
    if (!next) return std::nullopt;
    if (!loads.pins || (turn > 0 && std::abs(*next - share) <= agreed)) return range.f1(*next);
    share = *next;
    const auto under = hand_under(range.f1(share), on, loads, body, look);
    if (!under) return std::nullopt;
    now = *under;
  }
  return std::nullopt;
}

}  // namespace cell_loads

struct CellLoads::Cases {
  CellLook look;
  cell_loads::TravelledPlaces on;
  Loads settled;  ///< where a spring leaves its strength free: with that of the linkage
  std::optional<double> best_f1;
  std::vector<cell_loads::CellCase> cases;
};

CellLoads::CellLoads(const Loads& loads, const PlanarOutput& output, CellLook look) {
  const std::vector<PrescribedPose> poses = poses_of(output);
  const FourBar& bars = output.positions.front().bars;
  auto travel = LoadTravel::of(bars, poses);
  if (!travel) return;
  const Pose body = poses.front().pose;
  auto cases =
      std::make_unique<Cases>(Cases{look, cell_loads::travelled(*std::move(travel), loads, look, body), {}, {}, {}});
  if (cases->on.places.size() < cases->on.turns.size()) return;
  const bool is_free = free_spring(loads).has_value();
  if (is_free) {
    cases->best_f1 = cell_loads::best_f1(cases->on, loads, body, look);
    if (!cases->best_f1) return;
    cases->settled = with_f1(loads, *cases->best_f1);
  }
  cases->cases = cell_loads::cases_on(cases->on, is_free ? cases->settled : loads, body, look);
  cases_ = std::move(cases);
}

CellLoads::~CellLoads() = default;

std::optional<double> CellLoads::read_out(ReadOut read_out) {
  if (!cases_) return std::nullopt;
  if (read_out == ReadOut::best_f1) return cases_->best_f1;
  if (read_out == ReadOut::hand_force_error) return hand_force_error();
  return worst_of(read_out, [&](cell_loads::CellCase& of) { return of.value(read_out); });
}

template <class Of>
std::optional<double> CellLoads::worst_of(ReadOut read_out, const Of& of) {
  std::optional<double> worst;
  for (cell_loads::CellCase& each : cases_->cases) {
    if (!each.counts(read_out)) continue;
    const auto value = of(each);
    if (!value) return std::nullopt;
    if (!worst || (larger_is_worse(read_out) ? *value > *worst : *value < *worst)) worst = value;
  }
  return worst;
}

std::optional<double> CellLoads::hand_force_error() {
  if (cases_->look == CellLook::search) return std::nullopt;  // it looks where forces have peaks
  const auto fine = read_out(ReadOut::hand_force);
  const auto coarse = worst_of(ReadOut::hand_force, [](cell_loads::CellCase& of) { return of.hand_at_positions(); });
  if (!fine || !coarse) return std::nullopt;
  return station_error(*coarse, *fine);
}

int steps_between(int stations, std::size_t positions) {
  const int intervals = std::max(1, static_cast<int>(positions) - 1);
  return std::max(1, (stations - 1 + intervals - 1) / intervals);
}

double largest_with_parabola(const std::vector<double>& turns, const std::vector<double>& values) {
  const double most = *std::max_element(values.begin(), values.end());
  double top = most;
  for (std::size_t k = 1; k + 1 < values.size(); ++k) {
    if (values[k] < most - as_large * (1 + std::abs(most))) continue;
    const double before = turns[k] - turns[k - 1], after = turns[k + 1] - turns[k];
    const double rise = (values[k] - values[k - 1]) / before, fall = (values[k + 1] - values[k]) / after;
    const double curvature = (fall - rise) / (before + after);
    const double slope = (rise * after + fall * before) / (before + after);
    // The vertex between the neighbours: of rounding alone it would stand anywhere.
    const bool is_between = slope <= -2 * curvature * after && slope >= 2 * curvature * before;
    if (curvature < 0 && is_between) top = std::max(top, values[k] - slope * slope / (4 * curvature));
  }
  return top;
}

}  // namespace linkwright
