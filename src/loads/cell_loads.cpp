#include "cell_loads.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "linkwright/algebra/line_search.hpp"
#include "linkwright/loads/load_report.hpp"
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
      case ReadOut::max_pin_force:
        return largest_pin();
      case ReadOut::max_torque:
      case ReadOut::cylinder_force:
        return drive_passes_across() ? std::nullopt : largest([&](const Loaded& at) { return drive(at); });
      default:
        return std::nullopt;
    }
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

struct CellLoads::Cases {
  cell_loads::TravelledPlaces on;
  std::vector<cell_loads::CellCase> cases;
};

CellLoads::CellLoads(const Loads& loads, const PlanarOutput& output, CellLook look) {
  const std::vector<PrescribedPose> poses = poses_of(output);
  auto travel = LoadTravel::of(output.positions.front().bars, poses);
  if (!travel) return;
  const Pose body = poses.front().pose;
  auto cases = std::make_unique<Cases>(Cases{cell_loads::travelled(*std::move(travel), loads, look, body), {}});
  if (cases->on.places.size() < cases->on.turns.size()) return;
  for (LoadCase& of : cases_of(loads)) cases->cases.emplace_back(loads, std::move(of), cases->on, body, look);
  cases_ = std::move(cases);
}

CellLoads::~CellLoads() = default;

std::optional<double> CellLoads::read_out(ReadOut read_out) {
  std::optional<double> worst;
  if (!cases_) return worst;
  for (cell_loads::CellCase& each : cases_->cases) {
    if (!each.counts(read_out)) continue;
    const auto value = each.value(read_out);
    if (!value) return std::nullopt;
    if (!worst || (larger_is_worse(read_out) ? *value > *worst : *value < *worst)) worst = value;
  }
  return worst;
}

int steps_between(int stations, std::size_t positions) {
  const int intervals = std::max(1, static_cast<int>(positions) - 1);
  return std::max(1, (stations - 1 + intervals - 1) / intervals);
}

double largest_with_parabola(const std::vector<double>& turns, const std::vector<double>& values) {
  const auto top = std::max_element(values.begin(), values.end());
  const auto k = static_cast<std::size_t>(top - values.begin());
  if (k == 0 || k + 1 == values.size()) return *top;
  const double before = turns[k] - turns[k - 1], after = turns[k + 1] - turns[k];
  const double rise = (values[k] - values[k - 1]) / before, fall = (values[k + 1] - values[k]) / after;
  const double curvature = (fall - rise) / (before + after);
  const double slope = (rise * after + fall * before) / (before + after);
  return curvature < 0 ? *top - slope * slope / (4 * curvature) : *top;
}

}  // namespace linkwright
