#include "linkwright/loads/spring_charge.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "linkwright/loads/load_report.hpp"
#include "loads/free_strength.hpp"
#include "loads/gas_charge.hpp"
#include "loads/line_envelope.hpp"
#include "loads/small_program.hpp"
#include "loads/spring_rows.hpp"

namespace linkwright {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();
/// Steps from position to position at first, and how often stations are added where a force decides.
constexpr int first_steps = 24, refinements = 3;
/// Turns until the friction of pins, which depends on the strength, has settled: each leaves some 5 % of the error.
constexpr int most_turns = 40;
constexpr double agreed_to = 1e-10;
/// Free length of a coil, of the longest that it is: longer ones push with ever the same force and are no coils.
constexpr double longest_free = 3;

Notice locked() {
  return {"locks_by_friction", "The linkage locks by the friction of its pins with such a spring.", {}};
}
Notice no_such_coil() { return {"demands_conflict", "No rate and free length of the coil meet the demands.", {}}; }
Notice unsettled_program() {
  return {"not_settled", "No best rate and free length of the coil were settled on: the demands leave too little.", {}};
}
Notice not_settled() {
  return {"not_settled", "The friction of the pins grows with the spring faster than the spring helps the hand.", {}};
}

std::string told(const SpringRows::Row& row, const std::vector<LoadCase>& cases) {
  const std::string which = row.sense > 0 ? (*row.demanded.limit < 0 ? "holding it open" : "opening it")
                                          : (*row.demanded.limit == 0 ? "closing by itself" : "closing it");
  return fmt::format("{} in case \"{}\"", which, cases[row.of_case].name);
}

/// A bound on the charge, and the row that makes it.
struct Bound {
  double charge = 0;
  std::optional<std::size_t> row;
};

/// What one look at the rows finds.
struct Look {
  Bound low, high;
  LeastTop least;
  std::array<std::size_t, 2> deciding{};  ///< rows that meet in the least
};

class ChargeSearch {
 public:
  ChargeSearch(const Loads& loads, const LoadTravel& travel, const Pose& body, const Spring& spring,
               const SpringDemands& demands)
      : loads_(loads),
        demands_(demands),
        spring_(spring),
        study_(loads, travel, body),
        gas_(std::get<GasSpring>(spring.law), 0.005 / metres_of(loads)),
        rows_(loads, study_, body, spring, demands,
              [this](std::size_t of_case, double length) { return force(of_case, length); }) {
    const auto& given = std::get<GasSpring>(spring.law);
    const double rest = length_at_rest(body);
    for (const LoadCase& each : study_.cases())
      states_.push_back({GasLaw::heat(given, each.temperature), each.gas_exponent, given.extended_length - rest});
  }

  FoundOrNot<SpringCharge> found() {
    if (auto notice = rows_.add(study_.travel().stations(first_steps))) return {{}, notice};
    if (auto notice = out_of_stroke()) return {{}, notice};
    FoundOrNot<SpringCharge> answer = at_stations();
    for (int k = 0; k < refinements && answer.found; ++k) {
      if (auto notice = refine()) return {{}, notice};
      answer = at_stations();
    }
    return answer;
  }

 private:
  SpringRows::Force force(std::size_t of_case, double length) const {
    const double x = std::get<GasSpring>(spring_.law).extended_length - length;
    const double each = spring_.count * study_.cases()[of_case].spring_percent / 100;
    return {-each * gas_.air(), {each * gas_.shape(x, states_[of_case]), 0}};
  }
  [[nodiscard]] double length_at_rest(const Pose& body) const {
    Loads alone;
    alone.springs = {spring_};
    alone.metres = loads_.metres;
    const BoundLoads bound(alone, LoadCase{}, study_.travel().first(), body);
    return bound.springs({study_.travel().first(), {}, {}}).front()->length;
  }

  [[nodiscard]] std::optional<Notice> out_of_stroke() const {
    const auto& gas = std::get<GasSpring>(spring_.law);
    const double most = gas.extended_length - rows_.shortest(), least = gas.extended_length - rows_.longest();
    if (least >= 0 && most <= gas.stroke && most < gas_.full()) return std::nullopt;
    return Notice{
        "spring_stroke",
        fmt::format("Between these studs it would be {:.6g} to {:.6g} long, and with a stroke of {:.6g} it is "
                    "from {:.6g} to {:.6g}.",
                    rows_.shortest(), rows_.longest(), gas.stroke, gas.extended_length - gas.stroke,
                    gas.extended_length),
        {{"shortest", rows_.shortest()}, {"longest", rows_.longest()}}};
  }

  [[nodiscard]] Spring with(double charge) const {
    Spring spring = spring_;
    spring.law = gas_.with(charge);
    return spring;
  }

  /// With the friction that pins have under a charge; nothing where they lock.
  [[nodiscard]] std::optional<Look> look(std::optional<double> charge) const {
    std::vector<double> added(rows_.rows().size(), 0.0);
    if (charge && loads_.pins) {
      const auto friction = rows_.friction_of_pins(with(*charge));
      if (!friction) return std::nullopt;
      added = *friction;
    }
    Look seen;
    seen.low.charge = gas_.of_f1(std::max(least_f1, demands_.min_f1.value_or(0)));
    seen.high.charge = demands_.max_f1 ? gas_.of_f1(*demands_.max_f1) : endless;
    std::vector<double> a, b;
    std::vector<std::size_t> of;
    for (std::size_t i = 0; i < rows_.rows().size(); ++i) {
      const SpringRows::Row& row = rows_.rows()[i];
      const double constant = row.constant + added[i], slope = row.by[0];
      if (row.demanded.limit) keep_within(seen, i, constant - *row.demanded.limit, slope);
      if (!row.demanded.is_objective) continue;
      a.push_back(constant);
      b.push_back(slope);
      of.push_back(i);
    }
    // Beyond the largest place at which two of the lines meet nothing changes.
    const double far = std::min(seen.high.charge, far_of(a, b, seen.low.charge));
    seen.least = least_top({a.data(), b.data(), a.size()}, seen.low.charge, std::max(far, seen.low.charge));
    seen.deciding = {of[seen.least.falling], of[seen.least.rising]};
    return seen;
  }
  static void keep_within(Look& seen, std::size_t row, double constant, double slope) {
    // constant + slope s ≤ 0
    if (slope == 0) {
      if (constant > 0) seen.low = {endless, row};
      return;
    }
    const double bound = -constant / slope;
    if (slope < 0 && bound > seen.low.charge) seen.low = {bound, row};
    if (slope > 0 && bound < seen.high.charge) seen.high = {bound, row};
  }
  static double far_of(const std::vector<double>& a, const std::vector<double>& b, double low) {
    double largest = 0, steepest = 0;
    for (const double constant : a) largest = std::max(largest, std::abs(constant));
    for (const double slope : b) steepest = std::max(steepest, std::abs(slope));
    return steepest > 0 ? low + 4 * (largest + steepest * low) / steepest : low;
  }

  /// A look of which one number, by `of`, is what the pins' friction was worked out with.
  template <class Of>
  [[nodiscard]] FoundOrNot<Look> agreed(const Look& start, const Of& of) const {
    Look seen = start;
    if (!loads_.pins || !std::isfinite(of(seen))) return {seen, {}};
    for (int turn = 0; turn < most_turns; ++turn) {
      const double before = of(seen);
      const auto next = look(before);
      if (!next) return {{}, locked()};
      seen = *next;
      if (!(std::abs(of(seen)) < 1e12)) return {seen, {}};
      if (std::abs(of(seen) - before) <= agreed_to * std::abs(before)) return {seen, {}};
    }
    return {{}, not_settled()};
  }

  FoundOrNot<SpringCharge> at_stations() {
    const Look start = *look({});
    const auto low = agreed(start, [](const Look& seen) { return seen.low.charge; });
    if (!low.found) return {{}, low.why_not};
    const auto high = agreed(start, [](const Look& seen) { return seen.high.charge; });
    if (!high.found) return {{}, high.why_not};
    const Bound least = low.found->low, most = high.found->high;
    near_ = {};
    for (const Bound& bound : {least, most})
      if (bound.row) near_.push_back(*bound.row);
    if (!(least.charge <= most.charge)) return {{}, conflict(least, most)};
    const auto best = agreed(start, [](const Look& seen) { return seen.least.s; });
    if (!best.found) return {{}, best.why_not};
    near_.insert(near_.end(), best.found->deciding.begin(), best.found->deciding.end());
    SpringCharge found{gas_.f1(least.charge), gas_.f1(most.charge), gas_.f1(best.found->least.s),
                       best.found->least.value, with(best.found->least.s)};
    return {found, {}};
  }

  [[nodiscard]] std::optional<Notice> refine() {
    const std::vector<std::size_t> near = near_;
    std::vector<double> turns;
    for (const std::size_t row : near) {
      const auto more = rows_.turns_near(row);
      turns.insert(turns.end(), more.begin(), more.end());
    }
    return rows_.add(turns);
  }

  [[nodiscard]] Notice conflict(const Bound& least, const Bound& most) const {
    const auto why = [&](const Bound& bound) {
      return bound.row ? told(rows_.rows()[*bound.row], study_.cases()) : std::string("the spring itself");
    };
    const double from = gas_.f1(least.charge), to = gas_.f1(most.charge);
    if (!std::isfinite(from))
      return {"demands_conflict", fmt::format("No F1 meets what is demanded for {}.", why(least)), {}};
    return {"demands_conflict",
            fmt::format("No F1 meets the demands: {} takes at least {:.1f} N, and {} at most {:.1f} N.", why(least),
                        from, why(most), to),
            {{"at_least", from}, {"at_most", to}}};
  }

  const Loads& loads_;
  const SpringDemands& demands_;
  Spring spring_;
  HandStudy study_;
  GasCharge gas_;
  std::vector<GasLaw::State> states_;
  SpringRows rows_;
  std::vector<std::size_t> near_;  ///< rows that decide
};

/// The worst of hand_force with one spring more; nothing where it has no value.
std::optional<double> reported(const Loads& loads, const FourBar& bars, std::span<const PrescribedPose> poses,
                               const Spring& spring) {
  Loads with = loads;
  with.springs.push_back(spring);
  const auto report = load_report(with, bars, poses);
  if (!report) return std::nullopt;
  const auto& worst = report->worst_of(ReadOut::hand_force);
  return worst ? std::optional(worst->value) : std::nullopt;
}

/// The rate and the free length by a linear program of rate · length, rate · free length and the largest force.
class CoilSearch {
 public:
  CoilSearch(const Loads& loads, const LoadTravel& travel, const Pose& body, const Spring& spring,
             const SpringDemands& demands)
      : loads_(loads),
        spring_(as_coil(spring)),
        study_(loads, travel, body),
        rows_(loads, study_, body, spring_, demands,
              [this](std::size_t of_case, double length) { return force(of_case, length); }) {}

  FoundOrNot<Spring> found() {
    if (auto notice = rows_.add(study_.travel().stations(first_steps))) return {{}, notice};
    auto best = at_stations();
    for (int k = 0; k < refinements && best.found; ++k) {
      std::vector<double> turns;
      for (const std::size_t row : near_) {
        const auto more = rows_.turns_near(row);
        turns.insert(turns.end(), more.begin(), more.end());
      }
      if (auto notice = rows_.add(turns)) return {{}, notice};
      best = at_stations();
    }
    return best;
  }

 private:
  static Spring as_coil(Spring spring) {
    spring.law = CoilSpring{};
    return spring;
  }
  SpringRows::Force force(std::size_t of_case, double length) const {
    const double each = spring_.count * study_.cases()[of_case].spring_percent / 100;
    return {0, {-each * length, each}};
  }

  FoundOrNot<Spring> at_stations() {
    Spring best = spring_;
    for (int turn = 0; turn < most_turns; ++turn) {
      const auto added = rows_.friction_of_pins(best);
      if (!added) return {{}, locked()};
      const auto next = program(*added);
      if (!next.found) return {{}, next.why_not};
      const CoilSpring &before = std::get<CoilSpring>(best.law), &now = *next.found;
      const double change = std::abs(now.rate - before.rate) * rows_.longest() +
                            std::abs(now.rate * now.free_length - before.rate * before.free_length);
      const double size = now.rate * rows_.longest();
      best.law = now;
      if (!loads_.pins || change <= 1e-9 * size) return {best, {}};
    }
    return {{}, not_settled()};
  }

  [[nodiscard]] FoundOrNot<CoilSpring> program(const std::vector<double>& added) {
    const double unit = rows_.longest();
    double largest = 1, reach = 0;
    for (const auto& row : rows_.rows()) {
      largest = std::max(largest, std::abs(row.constant));
      reach = std::max(reach, std::abs(row.by[1]));
    }
    // A thousand times what the hand feels without it is as good as no limit.
    const double most = 1e3 * largest, strongest = reach > 0 ? most / reach : 1;
    const std::array<double, 3> low = {0, 0, -most}, high = {strongest, strongest, most};
    SmallProgram program(low, high);
    program.add({-longest_free, 1, 0}, 0);
    for (std::size_t i = 0; i < rows_.rows().size(); ++i) {
      const auto& row = rows_.rows()[i];
      const double constant = row.constant + added[i];
      if (row.demanded.is_objective) program.add({row.by[0] / unit, row.by[1], -1}, -constant);
      if (row.demanded.limit) program.add({row.by[0] / unit, row.by[1], 0}, *row.demanded.limit - constant);
    }
    const auto y = program.least();
    if (!y) return {{}, program.has_room() ? unsettled_program() : no_such_coil()};
    const double rate = std::max(0.0, (*y)[0]) / unit, pull = std::max(0.0, (*y)[1]);
    near_.clear();
    for (std::size_t i = 0; i < rows_.rows().size(); ++i) {
      const auto& row = rows_.rows()[i];
      const double value = row.constant + added[i] + row.by[0] * rate + row.by[1] * pull;
      const double slack = 1e-9 * (std::abs(value) + 1);
      if ((row.demanded.is_objective && value >= (*y)[2] - slack) ||
          (row.demanded.limit && value >= *row.demanded.limit - slack))
        near_.push_back(i);
    }
    return {CoilSpring{rate, rate > 0 ? pull / rate : 0, CoilSpring::Acts::both}, {}};
  }

  const Loads& loads_;
  Spring spring_;
  HandStudy study_;
  SpringRows rows_;
  std::vector<std::size_t> near_;
};

}  // namespace

FoundOrNot<SpringCharge> best_charge(const Loads& loads, const FourBar& bars, std::span<const PrescribedPose> poses,
                                     const Spring& spring, const SpringDemands& demands) {
  if (auto notice = hand_missing(loads)) return {{}, notice};
  const auto travel = LoadTravel::of(bars, poses);
  if (!travel) return {{}, no_travel()};
  auto answer = ChargeSearch(loads, *travel, poses.front().pose, spring, demands).found();
  if (!answer.found) return answer;
  const auto force = reported(loads, bars, poses, answer.found->spring);
  if (!force) return {{}, locked()};
  answer.found->max_hand_force = *force;
  return answer;
}

FoundOrNot<Loads> settled_loads(const Loads& loads, const FourBar& bars, std::span<const PrescribedPose> poses) {
  const auto free = free_spring(loads);
  if (!free) return {loads, {}};
  Loads others = with_f1(loads, strengths_of(*std::get<GasSpring>(loads.springs[*free].law).free).strongest);
  const Spring spring = others.springs[*free];
  others.springs.erase(others.springs.begin() + static_cast<std::ptrdiff_t>(*free));
  const FreeStrength& asked = *std::get<GasSpring>(loads.springs[*free].law).free;
  const SpringDemands demands{
      .min_hold_open = held_open(asked), .min_f1 = strengths_of(asked).weakest, .max_f1 = asked.max_f1};
  auto charge = best_charge(others, bars, poses, spring, demands);
  if (!charge.found) return {{}, charge.why_not};
  return {with_f1(loads, charge.found->best), {}};
}

Loads loads_as_used(const Loads& loads, const FourBar& bars, std::span<const PrescribedPose> poses) {
  if (auto settled = settled_loads(loads, bars, poses); settled.found) return *std::move(settled.found);
  Loads given = loads;
  std::get<GasSpring>(given.springs[*free_spring(given)].law).free.reset();
  return given;
}

FoundOrNot<CoilRate> best_coil(const Loads& loads, const FourBar& bars, std::span<const PrescribedPose> poses,
                               const Spring& spring, const SpringDemands& demands) {
  if (auto notice = hand_missing(loads)) return {{}, notice};
  const auto travel = LoadTravel::of(bars, poses);
  if (!travel) return {{}, no_travel()};
  const auto best = CoilSearch(loads, *travel, poses.front().pose, spring, demands).found();
  if (!best.found) return {{}, best.why_not};
  const auto force = reported(loads, bars, poses, *best.found);
  if (!force) return {{}, locked()};
  return {CoilRate{*force, *best.found}, {}};
}

}  // namespace linkwright
