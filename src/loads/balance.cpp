#include "linkwright/loads/balance.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <fmt/format.h>
#include <string>

#include "linkwright/core/angle.hpp"
#include "loads/carried.hpp"

namespace linkwright {
namespace {

/// The three links and the sums over what acts on them: the energy is Σ ⟨g, e⟩ of their directions e.
class LinkSums {
 public:
  LinkSums(const FourBar& bars, const Pose& body) : bars_(bars), body_(body), lengths_(bars.lengths()) {}

  /// A force that keeps its direction, at a point of a body.
  void add(const CarriedPoint& at, Point force) {
    switch (at.on) {
      case LoadedBody::ground:
        return;
      case LoadedBody::input:
        g_[0] -= force * std::conj(at.at);
        return;
      case LoadedBody::output:
        g_[2] -= force * std::conj(at.at);
        return;
      default:
        g_[0] -= force * lengths_.input;
        g_[1] -= force * std::conj(at.on == LoadedBody::coupler ? at.at : of_body(at.at));
    }
  }
  /// h e₂ = f + b e₃ − a e₁ leaves input and output.
  [[nodiscard]] std::array<Point, 2> reduced() const {
    return {g_[0] - g_[1] * (lengths_.input / lengths_.coupler), g_[2] + g_[1] * (lengths_.output / lengths_.coupler)};
  }
  [[nodiscard]] const LinkLengths& lengths() const { return lengths_; }

 private:
  [[nodiscard]] Point of_body(Point at) const {
    const Point along = bars_.output_moving - bars_.input_moving;
    return (body_.origin + direction(body_.angle) * at - bars_.input_moving) / (along / std::abs(along));
  }

  const FourBar& bars_;
  const Pose& body_;
  LinkLengths lengths_;
  std::array<Point, 3> g_{};
};

std::vector<Error> mistakes_in_balance(const Loads& loads, const LoadCase& of, const BalanceOptions& options) {
  std::vector<Error> found;
  constexpr std::array names = {"input", "output"};
  for (std::size_t k = 0; k < 2; ++k) {
    const auto add = [&](const char* what, const char* message) {
      found.push_back({std::string("bad_") + what, fmt::format("balance.{}.{}", names[k], what), message, {}});
    };
    if (options.rate[k] && !(*options.rate[k] > 0 && std::isfinite(*options.rate[k]))) add("rate", "a rate above 0");
    if (options.lever[k] && !(*options.lever[k] > 0 && std::isfinite(*options.lever[k])))
      add("lever", "a length above 0");
    if (options.stud[k] && !(std::abs(*options.stud[k]) > 0 && is_finite(*options.stud[k])))
      add("stud", "a stud stands away from the fixed pivot, where it would have no lever");
  }
  for (std::size_t k = 0; k < loads.extra.size(); ++k) {
    const ExtraLoad& extra = loads.extra[k];
    if (acts_in(extra, of) && !extra.mass && extra.turns_with_body)
      found.push_back({"turning_force",
                       fmt::format("loads.extra[{}]", k),
                       "a force that turns with the body has no energy, so that no spring balances it everywhere",
                       {}});
  }
  return found;
}

/// The two springs: k s̄ (Q − fixed pivot) = G.
BalanceSpring at_side(LoadedBody on, Point fixed, Point stud, Point reduced, std::optional<double> rate) {
  const double k = rate.value_or(std::abs(reduced) / std::norm(stud));
  return {k, {LoadedBody::ground, fixed + reduced / (k * std::conj(stud))}, {on, stud}};
}

/// By Stewart's theorem a spring at a share ρ of the coupler is one of k (1 − ρ) at its pivot at the input and one of k
/// ρ at the other; both to the same point Q: u G₁/a − w G₃/b = f in u = 1/(k (1 − ρ)), w = 1/(k ρ).
void find_one_spring(Balance& balance, const FourBar& bars, const LinkLengths& lengths) {
  constexpr double parallel = 1e-12;
  const Point f = bars.output_fixed - bars.input_fixed;
  const Point x = balance.reduced[0] / lengths.input, y = balance.reduced[1] / lengths.output;
  const double area = cross(x, y);
  if (!(std::abs(area) > parallel * std::abs(x) * std::abs(y))) {
    balance.why_not_one = Notice{
        "no_single_spring", "No single spring balances it: what acts on input and output has one direction.", {}};
    return;
  }
  const double u = cross(f, y) / area, w = cross(f, x) / area;
  const double sum = u + w;  // k = 1/u + 1/w, ρ = u/(u + w)
  if (!(std::abs(u * w) > 0) || !(std::abs(sum) > parallel * std::abs(u))) {
    balance.why_not_one = Notice{"no_single_spring", "No single spring balances it: its stud would be far away.", {}};
    return;
  }
  balance.one_share = u / sum;
  balance.one_spring = BalanceSpring{sum / (u * w),
                                     {LoadedBody::ground, bars.input_fixed + u * x},
                                     {LoadedBody::coupler, {balance.one_share * lengths.coupler, 0}}};
  if (balance.one_spring->rate < 0)
    balance.why_not_one =
        Notice{"negative_rate",
               fmt::format("A single spring would have to push with {:.4g} N per unit of its length: there is no such "
                           "spring.",
                           -balance.one_spring->rate),
               {{"rate", balance.one_spring->rate}}};
}

}  // namespace

Spring BalanceSpring::spring() const { return {"", 1, from, to, CoilSpring{rate, 0, CoilSpring::Acts::both}}; }

Result<Balance> exact_balance(const Loads& loads, const LoadCase& of, const FourBar& bars, const Pose& body,
                              const BalanceOptions& options) {
  if (auto mistakes = mistakes_in_balance(loads, of, options); !mistakes.empty()) return mistakes;
  const Point gravity = gravity_in(loads, of);
  LinkSums sums(bars, body);
  const LinkLengths& lengths = sums.lengths();
  for (const CarriedMass& mass : masses_in(loads, of, bars)) sums.add(mass.at, mass.mass * gravity);
  for (const ExtraLoad& extra : loads.extra)
    if (!extra.mass && acts_in(extra, of)) sums.add(extra.at, extra.force);

  Balance balance;
  balance.reduced = sums.reduced();
  const std::array<double, 2> length = {lengths.input, lengths.output};
  const std::array<Point, 2> fixed = {bars.input_fixed, bars.output_fixed};
  for (std::size_t k = 0; k < 2; ++k) {
    const Point reduced = balance.reduced[k];
    if (!(std::abs(reduced) > 0)) continue;
    const LoadedBody on = k == 0 ? LoadedBody::input : LoadedBody::output;
    const Point stud = options.stud[k].value_or(Point{length[k], 0});
    balance.two_springs.push_back(at_side(on, fixed[k], stud, reduced, options.rate[k]));
    if (!(std::abs(gravity) > 0)) continue;
    const double mass = std::abs(reduced) / (std::abs(gravity) * options.lever[k].value_or(length[k]));
    balance.counterweights.push_back({on, mass, std::conj(reduced / (mass * gravity))});
  }
  find_one_spring(balance, bars, lengths);
  return balance;
}

}  // namespace linkwright
