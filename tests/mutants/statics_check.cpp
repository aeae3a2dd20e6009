// Judges one build of the forces in a four-bar: their work by differences of energies, inertia by differences of the
// kinetic energy, and pins by the balance of each link cut free. Prints the number of disagreements, and exits with 1
// when there are any, or when too few of the checks could be made to say anything. mutants.py builds it with wrong
// signs.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/position.hpp"
#include "loads/statics.hpp"
#include "support/random_four_bar.hpp"

namespace linkwright {
namespace {

constexpr double step = 1e-5, alike = 1e-6;

/// What a check says; nothing where it cannot be made.
using Verdict = std::optional<bool>;

bool differ(double one, double other, double scale) { return !(std::abs(one - other) <= alike * scale); }

/// A linkage with a body, as it lies first and wherever its input turns.
struct Travelling {
  FourBar first;
  Configuration start;
  Assembly assembly;

  explicit Travelling(const FourBar& bars) : first(bars), start(configuration_of(bars)), assembly(assembly_of(bars)) {}
  [[nodiscard]] std::optional<LoadedPlace> at(double turn) const {
    const auto there = assemble(first.lengths(), start.input_angle + turn, assembly);
    if (!there) return std::nullopt;
    const FourBar bars = placed(first, *there);
    const auto twist = twist_of(bars, 1);
    if (!twist) return std::nullopt;
    const bool opens = twist->input > 0;  // the sense in which the input turns on
    return LoadedPlace{bars,
                       opens ? *twist : *twist_of(bars, -1),
                       {turn, wrap_signed(there->coupler_angle - start.coupler_angle),
                        wrap_signed(there->output_angle - start.output_angle)}};
  }
};

CarriedPoint on(testing::RandomFourBars& random, LoadedBody body) {
  return {body, {random.uniform(-2, 2), random.uniform(-2, 2)}};
}

Loads random_loads(testing::RandomFourBars& random) {
  Loads loads;
  loads.gravity->direction = random.uniform(-3, 3);
  loads.body = BodyMass{random.uniform(1, 5), {random.uniform(-1, 1), random.uniform(-1, 1)}, random.uniform(0, 2)};
  loads.input = LinkMass{.mass = random.uniform(0.5, 3), .kg_per_m = {}, .center = Point{0.3, 0.4}, .inertia = 0.7};
  loads.output = LinkMass{.mass = {}, .kg_per_m = random.uniform(0.5, 3), .center = {}};
  loads.coupler = LinkMass{.mass = random.uniform(0.5, 3), .kg_per_m = {}, .center = {}};
  loads.extra.push_back({"wind", on(random, LoadedBody::output), {}, {random.uniform(-9, 9), 3}, false, true});
  loads.handle = Handle{{random.uniform(-1, 1), random.uniform(-1, 1)}, Handle::Direction::tangential, 0};
  const auto spring = [&](LoadedBody from, LoadedBody to, double rate) {
    CoilSpring coil{rate, random.uniform(0, 2), CoilSpring::Acts::both};
    loads.springs.push_back({"", 2, on(random, from), on(random, to), coil});
  };
  spring(LoadedBody::ground, LoadedBody::body, 3);
  spring(LoadedBody::input, LoadedBody::output, 2);
  spring(LoadedBody::coupler, LoadedBody::ground, 1);
  for (const FourBarJoint joint : {FourBarJoint::input_ground, FourBarJoint::input_coupler,
                                   FourBarJoint::output_coupler, FourBarJoint::output_ground})
    loads.springs.push_back({"", 1, {}, {}, TorsionSpring{joint, random.uniform(0, 0.1), random.uniform(-3, 3)}});
  loads.metres = 1;
  return loads;
}

/// Power of what acts is what its energy loses; velocities are what positions change by.
Verdict does_its_work(const Travelling& on, const Loads& loads, double turn) {
  const BoundLoads bound(loads, LoadCase{}, on.first, {{0.3, -0.2}, 0.4});
  const auto here = on.at(turn), high = on.at(turn + step), low = on.at(turn - step);
  if (!here || !high || !low || testing::transmission_sine(here->bars) < 0.3) return std::nullopt;
  const double power = bound.resultants(*here).power(*here) / here->twist.input;
  const double energy = (bound.energy(*high) - bound.energy(*low)) / (2 * step);
  if (differ(power, -energy, 200 + std::abs(energy))) return false;
  const Point moved = (high->position(*bound.handle()) - low->position(*bound.handle())) / (2 * step);
  return !differ(std::abs(here->velocity(*bound.handle()) / here->twist.input - moved), 0, 1 + std::abs(moved));
}

/// Of all masses while the input turns by one radian in a unit of time.
double kinetic_energy(const Travelling& on, const Loads& loads, double turn) {
  constexpr double step = 1e-4;
  const BoundLoads bound(loads, LoadCase{}, on.first, {{0.3, -0.2}, 0.4});
  const auto high = on.at(turn + step), low = on.at(turn - step);
  if (!high || !low) return NAN;
  const Point handle = (high->position(*bound.handle()) - low->position(*bound.handle())) / (2 * step);
  const double rate = wrap_signed(high->turn[1] - low->turn[1]) / (2 * step);
  return loads.body->mass * std::norm(handle) / 2 + loads.body->inertia * rate * rate / 2;
}

/// Inertia takes from the drive what the body's motion gains; its centre is where the hand is.
Verdict keeps_energy_in_motion(const Travelling& on, Loads loads) {
  constexpr double wide = 2e-4, coarse = 1e-3;
  const Handle handle = *loads.handle;
  const double mass = loads.body->mass, inertia = loads.body->inertia;
  loads = Loads{};
  loads.gravity.reset();
  loads.handle = handle;
  loads.metres = 1;
  loads.body = BodyMass{mass, handle.point, inertia};
  loads.rpm = 60 / two_pi;
  const BoundLoads bound(loads, LoadCase{}, on.first, {{0.3, -0.2}, 0.4});
  const auto here = on.at(0);
  const double gained = (kinetic_energy(on, loads, wide) - kinetic_energy(on, loads, -wide)) / (2 * wide);
  if (!here || !std::isfinite(gained)) return std::nullopt;
  const double power = bound.resultants(*here).power(*here) / here->twist.input;
  return std::abs(power + gained) <= coarse * (1 + std::abs(gained) + kinetic_energy(on, loads, 0));
}

struct Cut {
  Point force{};
  double moment = 0;
  void add(Point acting, Point place) {
    force += acting;
    moment += cross(place, acting);
  }
};

/// Each link is in balance under what acts on it, the forces of its joints, the hand, and the moments of friction,
/// which oppose the turning of their joints.
Verdict is_in_balance(const Travelling& on, Loads loads, int sense) {
  loads.springs.clear();
  loads.pins = PinFriction{0.02, 0.3};
  constexpr double slope = 0.2;
  const BoundLoads bound(loads, LoadCase{.name = "", .slope = slope}, on.first, {{0.3, -0.2}, 0.4});
  const auto place = on.at(0);
  const auto hand = place ? bound.hand(*place) : std::nullopt;
  if (!hand) return std::nullopt;
  const Push push = bound.push(*place, *hand, sense, PinFrictionModel::exact);
  if (push.locks) return std::nullopt;
  const FourBar& bars = place->bars;
  const Point gravity = std::polar(loads.gravity->acceleration, loads.gravity->direction - slope);
  std::array<Cut, 3> links;
  const auto weigh = [&](std::size_t link, double mass, LinkPoint::Link carrier, Point at) {
    links[link].add(mass * gravity, place->position({carrier, at}));
  };
  const LinkLengths l = bars.lengths();
  weigh(0, *loads.input->mass, LinkPoint::Link::input, *loads.input->center);
  weigh(1, *loads.coupler->mass, LinkPoint::Link::coupler, l.coupler / 2);
  weigh(2, *loads.output->kg_per_m * l.output, LinkPoint::Link::output, l.output / 2);
  const Pose body = {{0.3, -0.2}, 0.4};
  links[1].add(loads.body->mass * gravity, body.origin + direction(body.angle) * loads.body->center);
  links[2].add(loads.extra[0].force, place->position({LinkPoint::Link::output, loads.extra[0].at.at}));
  const Point handle = place->position(*bound.handle()), velocity = place->velocity(*bound.handle());
  links[1].add(push.effort * sense * velocity / std::abs(velocity), handle);
  const auto& [input_ground, input_coupler, output_coupler, output_ground] = push.joints;
  links[0].add(input_ground, bars.input_fixed);
  links[0].add(-input_coupler, bars.input_moving);
  links[1].add(input_coupler, bars.input_moving);
  links[1].add(output_coupler, bars.output_moving);
  links[2].add(-output_coupler, bars.output_moving);
  links[2].add(output_ground, bars.output_fixed);
  const double circle = 0.02 * 0.3 / std::sqrt(1 + 0.3 * 0.3);
  const auto rub = [&](std::size_t moving, std::size_t other, Point joint, double turning) {
    const double moment = -std::copysign(circle * std::abs(joint), sense * turning);
    links[moving].moment += moment;
    if (other < 3) links[other].moment -= moment;
  };
  const FourBarTwist& t = place->twist;
  rub(0, 3, input_ground, t.input);
  rub(1, 0, input_coupler, t.coupler - t.input);
  rub(1, 2, output_coupler, t.coupler - t.output);
  rub(2, 3, output_ground, t.output);
  double scale = 100;
  for (const Point joint : push.joints) scale += std::abs(joint);
  return std::none_of(links.begin(), links.end(), [&](const Cut& link) {
    return differ(std::abs(link.force), 0, scale) || differ(link.moment, 0, scale * (1 + std::abs(bars.input_fixed)));
  });
}

struct Tally {
  int made = 0, disagree = 0;

  void add(const Verdict& verdict) {
    made += verdict.has_value();
    disagree += verdict == false;
  }
};

/// Of work, motion and balance.
std::array<Tally, 3> tallies() {
  testing::RandomFourBars random(35);
  std::array<Tally, 3> found;
  for (int i = 0; i < 300; ++i) {
    const FourBar bars = random.four_bar();
    const Loads loads = random_loads(random);
    if (testing::transmission_sine(bars) < 0.3 || bars.lengths().shortest() < 0.3) continue;
    const Travelling on(bars);
    found[0].add(does_its_work(on, loads, random.uniform(-0.2, 0.2)));
    found[1].add(keeps_energy_in_motion(on, loads));
    found[2].add(is_in_balance(on, loads, i % 2 == 0 ? 1 : -1));
  }
  return found;
}

}  // namespace
}  // namespace linkwright

int main() {
  constexpr int least = 150;
  bool is_right = true;
  for (const auto& [made, disagree] : linkwright::tallies()) {
    std::printf("%d checks, %d disagreements\n", made, disagree);
    is_right = is_right && made >= least && disagree == 0;
  }
  return is_right ? 0 : 1;
}
