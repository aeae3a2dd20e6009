#include "linkwright/loads/load_report.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "linkwright/algebra/line_search.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/loads/spring_charge.hpp"
#include "loads/curve_root.hpp"
#include "loads/load_travel.hpp"

namespace linkwright {
namespace {

/// Steps from position to position between which extremes and roots are looked for.
constexpr int looked_at = 24;

struct Extreme {
  double value = 0, turn = 0;
};

/// The top of a curve between two turns, from one between them that is not below these, to rounding: parabolas, golden
/// sections where they do not help.
Extreme top_between(const line_search::Flank& before, const line_search::Flank& at, const line_search::Flank& after,
                    const Curve& curve) {
  constexpr int most_turns = 100;
  line_search::Flank low = before, top = at, high = after;
  line_search::Section section;
  const double resolution = 1e-9 * (high.at - low.at);
  for (int i = 0; i < most_turns && high.at - low.at > 2 * resolution; ++i) {
    const double turn = section.next(low, top, high, resolution);
    const line_search::Flank here{turn, curve(turn).value_or(line_search::nowhere)};
    const bool is_top = here.score > top.score;
    ((here.at < top.at) == is_top ? high : low) = is_top ? top : here;
    if (is_top) top = here;
  }
  return {top.score, top.at};
}

/// The largest value of a curve: at each station that is not below its neighbours, the top between these.
std::optional<Extreme> largest(const std::vector<double>& turns, const Curve& curve) {
  std::vector<line_search::Flank> stations;
  for (const double turn : turns) stations.push_back({turn, curve(turn).value_or(line_search::nowhere)});
  std::optional<Extreme> best;
  const auto offer = [&](const Extreme& found) {
    if (!best || found.value > best->value) best = found;
  };
  for (std::size_t k = 0; k < stations.size(); ++k) {
    const line_search::Flank& here = stations[k];
    if (here.score == line_search::nowhere) continue;
    offer({here.score, here.at});
    const bool is_first = k == 0, is_last = k + 1 == stations.size();
    const auto before = is_first ? here : stations[k - 1], after = is_last ? here : stations[k + 1];
    if (before.score > here.score || after.score > here.score || before.at == after.at) continue;
    offer(top_between(before, here, after, curve));
  }
  return best;
}

/// What does not depend on the case: stations between which extremes and roots are looked for, and the handle's way.
struct StudiedTravel {
  const LoadTravel& travel;
  std::vector<double> turns;
  std::optional<HandlePath> path;

  StudiedTravel(const Loads& loads, const LoadTravel& on, const Pose& body) : travel(on) {
    const auto handle = BoundLoads(loads, LoadCase{}, on.first(), body).handle();
    turns = on.close_stations(looked_at, handle);
    if (handle) path.emplace(on, *handle);
  }
};

class CaseStudy {
 public:
  CaseStudy(const Loads& loads, const LoadCase& of, const StudiedTravel& studied, const Pose& body)
      : loads_(loads),
        case_(of),
        travel_(studied.travel),
        bound_(loads, of, travel_.first(), body),
        turns_(studied.turns),
        path_(studied.path) {}

  [[nodiscard]] CaseReport report() const {
    CaseReport report;
    report.name = case_.name;
    const bool is_stuck = locks_by_friction(By::drive) || passes_across(By::drive);
    report.locks = is_stuck || (bound_.handle() && passes_across(By::hand));
    if (bound_.handle()) read_hand(report);
    if (bound_.is_dynamic())
      read_shaking(report);
    else
      read_rests(report);
    if (!is_stuck) {
      read_pins(report);
      read_drive(report);
    }
    for (std::size_t k = 0; k < loads_.springs.size(); ++k)
      if (!std::holds_alternative<TorsionSpring>(loads_.springs[k].law)) report.springs.push_back(use_of(k));
    return report;
  }

  [[nodiscard]] LoadStation station(double turn) const;

 private:
  enum class By : unsigned char { hand, drive };

  [[nodiscard]] LoadPlace place_at(double turn) const {
    LoadPlace found{turn, 0, {}};
    if (const auto place = travel_.at(turn)) found.body_turn = place->turn[1];
    if (path_) found.path_share = path_->share(turn);
    return found;
  }

  /// A turn that was looked at, with what was worked out there.
  struct Looked {
    std::optional<LoadedPlace> place;
    Acting acting;
    std::array<std::optional<std::optional<Push>>, 4> pushes;
  };
  [[nodiscard]] Looked& looked(double turn) const {
    const auto [known, is_new] = looked_.try_emplace(turn);
    Looked& at = known->second;
    if (!is_new) return at;
    at.place = travel_.at(turn);
    if (at.place) at.acting = bound_.acting(*at.place);
    return at;
  }
  [[nodiscard]] const std::optional<Push>& push(double turn, By by, int sense) const {
    Looked& at = looked(turn);
    const bool of_hand = by == By::hand || loads_.drive == LoadDrive::hand;
    auto& known = at.pushes[(of_hand ? 0 : 2) + (sense > 0 ? 0 : 1)];
    if (known) return *known;
    known.emplace();
    const auto effort = at.place ? unit_effort(*at.place, by) : std::nullopt;
    if (effort) *known = bound_.push(*at.place, at.acting, *effort, sense, PinFrictionModel::exact);
    return *known;
  }
  [[nodiscard]] Curve effort(By by, int sense) const {
    return [this, by, sense](double turn) -> std::optional<double> {
      const auto& pushed = push(turn, by, sense);
      return pushed && !pushed->locks ? std::optional(pushed->effort) : std::nullopt;
    };
  }
  [[nodiscard]] std::optional<UnitEffort> unit_effort(const LoadedPlace& place, By by) const {
    return by == By::hand || loads_.drive == LoadDrive::hand ? bound_.hand(place) : bound_.drive(place);
  }
  /// What it takes, the way that the motion goes.
  [[nodiscard]] Curve needed(By by, int sense) const {
    return [this, by, force = effort(by, sense)](double turn) -> std::optional<double> {
      const auto& place = looked(turn).place;
      const auto unit = place ? unit_effort(*place, by) : std::nullopt;
      const auto is = force(turn);
      return unit && is ? std::optional(unit->way() * *is) : std::nullopt;
    };
  }
  /// Somewhere it moves across what moves it, as a hand of a given direction or a crank that turns back: no effort,
  /// however large, does it there.
  [[nodiscard]] bool passes_across(By by) const {
    double before = 0;
    return std::any_of(turns_.begin(), turns_.end(), [&](double turn) {
      const auto& place = looked(turn).place;
      const auto effort = place ? unit_effort(*place, by) : std::nullopt;
      if (!effort) return false;
      const bool turns_round = effort->rate * before < 0;
      before = effort->rate;
      return turns_round;
    });
  }
  /// No effort moves it.
  [[nodiscard]] bool locks_by_friction(By by) const {
    const auto locks = [&](double turn, int sense) {
      const auto& pushed = push(turn, by, sense);
      return pushed && pushed->locks;
    };
    return loads_.pins &&
           std::any_of(turns_.begin(), turns_.end(), [&](double turn) { return locks(turn, +1) || locks(turn, -1); });
  }
  /// Power of all loads per twist: it rises by itself where it is positive.
  [[nodiscard]] Curve power() const {
    return [this](double turn) -> std::optional<double> {
      const Looked& at = looked(turn);
      return at.place ? std::optional(at.acting.still.power(*at.place)) : std::nullopt;
    };
  }

  void read_hand(CaseReport& report) const {
    if (locks_by_friction(By::hand)) return;
    const Curve open = needed(By::hand, +1), close = needed(By::hand, -1);
    const auto largest_of = [&](const Curve& force) {
      const auto found = passes_across(By::hand) ? std::nullopt : largest(turns_, force);
      return found ? std::optional(found->value) : std::nullopt;
    };
    report.max_open_force = largest_of(open);
    report.max_close_force = largest_of(close);
    if (const auto last = open(travel_.end())) report.hold_open = -*last;
    if (const auto first = open(0)) report.pop_up = -*first;
    report.close_start = close(travel_.end());
    if (report.close_start && report.max_close_force) report.hump = *report.max_close_force - *report.close_start;
    if (const auto from = self_going(open, turns_.rbegin(), turns_.rend())) report.self_rise = place_at(*from);
    if (const auto from = self_going(close, turns_.begin(), turns_.end())) report.self_close = place_at(*from);
  }

  /// Going from one end of the travel, as far as the force stays below 0; nothing where it is not there.
  template <class Iterator>
  [[nodiscard]] static std::optional<double> self_going(const Curve& force, Iterator from, Iterator to) {
    const auto goes = [&](double turn) {
      const auto value = force(turn);
      return value && *value < 0;
    };
    if (!goes(*from)) return std::nullopt;
    for (Iterator last = from++; from != to; last = from++)
      if (!goes(*from)) return root_between(std::min(*last, *from), std::max(*last, *from), force);
    return *std::prev(to);
  }

  void read_rests(CaseReport& report) const {
    const Curve q = power();
    for (std::size_t k = 1; k < turns_.size(); ++k) {
      const auto before = q(turns_[k - 1]), here = q(turns_[k]);
      if (!before || !here || (*before < 0) == (*here < 0)) continue;
      const double turn = root_between(turns_[k - 1], turns_[k], q);
      report.equilibria.push_back({place_at(turn), *before > 0, stiffness_at(turn)});
    }
    if (has_friction()) read_bands(report);
  }
  [[nodiscard]] bool has_friction() const {
    if (loads_.pins && loads_.pins->friction > 0) return true;
    return std::any_of(turns_.begin(), turns_.end(), [&](double turn) {
      const auto& place = looked(turn).place;
      return place && bound_.spring_friction(*place) > 0;
    });
  }

  /// Where it takes an effort both ways.
  void read_bands(CaseReport& report) const {
    const By by = bound_.handle() ? By::hand : By::drive;
    const Curve least = [open = needed(by, +1), close = needed(by, -1)](double turn) -> std::optional<double> {
      const auto up = open(turn), down = close(turn);
      return up && down ? std::optional(std::min(*up, *down)) : std::nullopt;
    };
    bool is_held = false;
    double from = 0;
    for (std::size_t k = 0; k < turns_.size(); ++k) {
      const bool rests = least(turns_[k]).value_or(-1) >= 0;
      if (rests == is_held) continue;
      const double here = k == 0 ? turns_[0] : root_between(turns_[k - 1], turns_[k], least);
      if (rests)
        from = here;
      else
        report.rests.push_back({place_at(from), place_at(here)});
      is_held = rests;
    }
    if (is_held) report.rests.push_back({place_at(from), place_at(travel_.end())});
  }

  /// d²V/dφ² by differences of the torque, extrapolated to step 0 (Richardson).
  [[nodiscard]] double stiffness_at(double turn) const {
    const auto torque = [&](double at) {
      const auto place = travel_.at(at);
      return place && place->twist.input != 0 ? -bound_.resultants(*place).power(*place) / std::abs(place->twist.input)
                                              : 0;
    };
    const auto slope = [&](double step) { return (torque(turn + step) - torque(turn - step)) / (2 * step); };
    constexpr double step = 2e-3;
    const double coarse = slope(step), fine = slope(step / 2), finest = slope(step / 4);
    const double once = (4 * fine - coarse) / 3, twice = (4 * finest - fine) / 3;
    const double found = (16 * twice - once) / 15 * metres_of(loads_);
    return std::isfinite(found) ? found : 0;
  }

  void read_pins(CaseReport& report) const {
    for (std::size_t joint = 0; joint < four_bar_joints; ++joint) {
      const auto found = largest(turns_, [&](double turn) -> std::optional<double> {
        const auto &open = push(turn, By::drive, +1), &close = push(turn, By::drive, -1);
        if (!open || !close) return std::nullopt;
        return std::max(std::abs(open->joints[joint]), std::abs(close->joints[joint]));
      });
      if (found) report.pins[joint] = ForcePeak{found->value, place_at(found->turn)};
    }
  }

  void read_shaking(CaseReport& report) const {
    const auto found = largest(turns_, [&](double turn) -> std::optional<double> {
      const auto& place = looked(turn).place;
      return place ? std::optional(std::abs(bound_.shaking_force(*place))) : std::nullopt;
    });
    if (found) report.shaking = ForcePeak{found->value, place_at(found->turn)};
  }

  void read_drive(CaseReport& report) const {
    if (loads_.drive == LoadDrive::hand) return;
    const auto found = largest(turns_, [&](double turn) -> std::optional<double> {
      const auto &open = push(turn, By::drive, +1), &close = push(turn, By::drive, -1);
      if (!open || !close) return std::nullopt;
      return std::max(std::abs(open->effort), std::abs(close->effort));
    });
    if (!found) return;
    if (loads_.drive == LoadDrive::cylinder)
      report.cylinder_force = found->value;
    else
      report.max_torque = found->value * metres_of(loads_);
  }

  [[nodiscard]] SpringUse use_of(std::size_t k) const {
    const Spring& spring = loads_.springs[k];
    const auto length = [&](double sign) -> Curve {
      return [this, k, sign](double turn) -> std::optional<double> {
        const auto& place = looked(turn).place;
        return place ? std::optional(sign * bound_.springs(*place)[k]->length) : std::nullopt;
      };
    };
    SpringUse use;
    use.name = spring_name(loads_, k);
    if (const auto longest = largest(turns_, length(+1))) use.longest = longest->value;
    if (const auto shortest = largest(turns_, length(-1))) use.shortest = -shortest->value;
    if (path_) {
      const auto lever = largest(turns_, [&](double turn) -> std::optional<double> {
        const auto& place = looked(turn).place;
        const double speed = place ? std::abs(place->velocity(*bound_.handle())) : 0;
        return speed > 0 ? std::optional(-std::abs(bound_.springs(*place)[k]->rate) / speed) : std::nullopt;
      });
      if (lever) use.least_lever = -lever->value;
    }
    if (const auto* gas = std::get_if<GasSpring>(&spring.law)) {
      use.stroke_left = gas->stroke - (gas->extended_length - use.shortest);
      use.bottoms_at = bottoms_at(length(+1), *gas);
    }
    return use;
  }

  [[nodiscard]] std::optional<LoadPlace> bottoms_at(const Curve& length, const GasSpring& gas) const {
    const Curve room = [&](double turn) -> std::optional<double> {
      const auto is = length(turn);
      if (!is) return std::nullopt;
      return std::min(*is - (gas.extended_length - gas.stroke), gas.extended_length - *is);
    };
    if (room(turns_.front()).value_or(0) < 0) return place_at(turns_.front());
    for (std::size_t k = 1; k < turns_.size(); ++k)
      if (room(turns_[k]).value_or(0) < 0) return place_at(root_between(turns_[k - 1], turns_[k], room));
    return std::nullopt;
  }

  const Loads& loads_;
  const LoadCase& case_;
  const LoadTravel& travel_;
  BoundLoads bound_;
  const std::vector<double>& turns_;
  const std::optional<HandlePath>& path_;
  mutable std::unordered_map<double, Looked> looked_;
};

LoadStation CaseStudy::station(double turn) const {
  LoadStation station;
  station.at = place_at(turn);
  const auto place = travel_.at(turn);
  if (!place) return station;
  station.open = effort(By::hand, +1)(turn);
  station.close = effort(By::hand, -1)(turn);
  const double power = bound_.resultants(*place).power(*place);
  if (const auto hand = bound_.hand(*place)) station.frictionless = -power / hand->rate;
  const auto crank = loads_.drive == LoadDrive::output ? LinkPoint::Link::output : LinkPoint::Link::input;
  if (const auto torque = bound_.torque(*place, crank)) station.torque = -power / torque->rate * metres_of(loads_);
  if (loads_.drive == LoadDrive::cylinder) {
    if (const auto cylinder = bound_.cylinder(*place)) station.cylinder_force = -power / cylinder->rate;
    station.pressure_angle = bound_.pressure_angle(*place);
  }
  if (bound_.has_energy())
    if (const auto start = travel_.at(0))
      station.energy = (bound_.energy(*place) - bound_.energy(*start)) * metres_of(loads_);
  for (const auto& spring : bound_.springs(*place))
    station.springs.push_back(spring ? std::optional(LoadStation::SpringAt{spring->length, spring->force})
                                     : std::nullopt);
  if (const auto driven = push(turn, By::drive, +1)) station.joints = driven->joints;
  if (bound_.is_dynamic()) {
    const auto driver = bound_.driver_rates(*place);
    station.motion = {driver.time, driver.speed, driver.acceleration, bound_.shaking_force(*place)};
  }
  return station;
}

/// The worst of the cases that count; nothing where one of them has no value: it locks there, or has no such force.
std::optional<WorstOfCases> worst_of(ReadOut read_out, const LoadReport& report, const std::vector<LoadCase>& cases) {
  std::optional<WorstOfCases> worst;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    if (!cases[k].counts(read_out)) continue;
    const auto value = report.cases[k].value(read_out);
    if (!value) return std::nullopt;
    if (!worst || (larger_is_worse(read_out) ? *value > worst->value : *value < worst->value))
      worst = WorstOfCases{*value, k};
  }
  return worst;
}

}  // namespace

bool larger_is_worse(ReadOut read_out) {
  return read_out != ReadOut::hold_open && read_out != ReadOut::pop_up && read_out != ReadOut::self_close;
}

std::optional<double> CaseReport::value(ReadOut read_out) const {
  switch (read_out) {
    case ReadOut::max_open_force:
      return max_open_force;
    case ReadOut::max_close_force:
      return max_close_force;
    case ReadOut::hand_force:
      return max_open_force && max_close_force ? std::optional(std::max(*max_open_force, *max_close_force))
                                               : std::nullopt;
    case ReadOut::hold_open:
      return hold_open;
    case ReadOut::close_start:
      return close_start;
    case ReadOut::hump:
      return hump;
    case ReadOut::pop_up:
      return pop_up;
    case ReadOut::max_torque:
      return max_torque;
    case ReadOut::cylinder_force:
      return cylinder_force;
    case ReadOut::max_pin_force: {
      std::optional<double> most;
      for (const auto& pin : pins)
        if (pin) most = std::max(most.value_or(0), pin->force);
      return most;
    }
    case ReadOut::self_rise:
      return self_rise ? std::optional(std::abs(self_rise->body_turn)) : std::nullopt;
    case ReadOut::self_close:
      return self_close ? std::optional(std::abs(self_close->body_turn)) : std::nullopt;
    default:
      return std::nullopt;  // of no case
  }
}

namespace {

LoadReport report_of(const Loads& loads, const LoadTravel& travel, const Pose& body) {
  const StudiedTravel studied(loads, travel, body);
  LoadReport report;
  const std::vector<LoadCase> cases = cases_of(loads);
  for (const LoadCase& each : cases) report.cases.push_back(CaseStudy(loads, each, studied, body).report());
  for (std::size_t r = 0; r < read_outs; ++r) report.worst[r] = worst_of(static_cast<ReadOut>(r), report, cases);
  return report;
}

}  // namespace

std::optional<LoadReport> load_report(const Loads& loads, const FourBar& bars, std::span<const PrescribedPose> poses) {
  const auto travel = LoadTravel::of(bars, poses);
  if (!travel) return std::nullopt;
  const Pose& body = poses.front().pose;
  const auto free = free_spring(loads);
  if (!free) return report_of(loads, *travel, body);
  const auto settled = settled_loads(loads, bars, poses);
  LoadReport report = report_of(settled.found.value_or(loads), *travel, body);
  if (settled.found)
    report.best_f1 = std::get<GasSpring>(settled.found->springs[*free].law).f1;
  else
    report.worst = {};
  report.why_no_f1 = settled.why_not;
  return report;
}

std::vector<LoadStation> load_curve(const Loads& given, const LoadCase& of, const FourBar& bars,
                                    std::span<const PrescribedPose> poses, int between) {
  const auto travel = LoadTravel::of(bars, poses);
  if (!travel) return {};
  const Loads loads = loads_as_used(given, bars, poses);
  const StudiedTravel studied(loads, *travel, poses.front().pose);
  const CaseStudy study(loads, of, studied, poses.front().pose);
  std::vector<LoadStation> stations;
  for (const double turn : travel->stations(between)) {
    stations.push_back(study.station(turn));
    for (std::size_t k = 0; k < travel->positions().size(); ++k)
      if (travel->positions()[k] == turn) stations.back().position = static_cast<int>(k);
  }
  return stations;
}

}  // namespace linkwright
