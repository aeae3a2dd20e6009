// Judges one build of the sensitivities by differences of linkages that are assembled anew, planar and spherical, and
// of the best line by what its remainder must be. Prints the number of disagreements; exits with 1 when there are any.
// mutants.py builds it with wrong signs.

#include <cmath>
#include <cstdio>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/position.hpp"
#include "linkwright/mechanism/spherical_position.hpp"
#include "linkwright/robust/sensitivity.hpp"
#include "support/random_four_bar.hpp"

namespace linkwright {
namespace {

constexpr double step = 1e-5, alike = 1e-5;

/// Turns of coupler and output, and the point.
struct State {
  double coupler = 0, output = 0;
  Point point{};
};

std::optional<State> planar_state(const PlanarValues& values, Assembly assembly) {
  const auto& [a, h, b, ax, ay, bx, by, along, across, phi] = values;
  const Point ground = Point{bx, by} - Point{ax, ay};
  const auto c = assemble(LinkLengths{std::abs(ground), a, h, b}, phi - std::arg(ground), assembly);
  if (!c) return std::nullopt;
  const double theta = c->coupler_angle + std::arg(ground);
  return State{theta, c->output_angle + std::arg(ground),
               Point{ax, ay} + a * direction(phi) + Point{along, across} * direction(theta)};
}

bool agrees(const TracingFourBar& linkage) {
  const FourBar& bars = linkage.bars;
  const LinkLengths l = bars.lengths();
  const Point arm = (linkage.point - bars.input_moving) * std::conj(bars.output_moving - bars.input_moving) / l.coupler;
  const PlanarValues values = {l.input,
                               l.coupler,
                               l.output,
                               bars.input_fixed.real(),
                               bars.input_fixed.imag(),
                               bars.output_fixed.real(),
                               bars.output_fixed.imag(),
                               arm.real(),
                               arm.imag(),
                               std::arg(bars.input_moving - bars.input_fixed)};
  const auto by = sensitivity_of(linkage);
  for (std::size_t i = 0; by && i < planar_parameters; ++i) {
    PlanarValues more = values, less = values;
    more[i] += step;
    less[i] -= step;
    const auto high = planar_state(more, assembly_of(bars)), low = planar_state(less, assembly_of(bars));
    if (!high || !low) return true;
    const auto differs = [](double one, double other) {
      return !(std::abs(one - other) <= alike * (1 + std::abs(one)));
    };
    if (differs(by->coupler_angle[i], wrap_signed(high->coupler - low->coupler) / (2 * step)) ||
        differs(by->output_angle[i], wrap_signed(high->output - low->output) / (2 * step)) ||
        differs(0, std::abs(by->point[i] - (high->point - low->point) / (2 * step))))
      return false;
  }
  return true;
}

std::optional<SphericalFourBar> sphere_at(const LinkAngles& of, double input, Assembly assembly) {
  const SphericalFourBar frame{{0, 0, 1},
                               {std::sin(of.input), 0, std::cos(of.input)},
                               {std::sin(of.ground + of.output), 0, std::cos(of.ground + of.output)},
                               {std::sin(of.ground), 0, std::cos(of.ground)}};
  const auto configuration = assemble(of, input, assembly);
  return configuration ? std::optional(placed(frame, *configuration)) : std::nullopt;
}

Vector3 turn_between(const SphericalFourBar& from, const SphericalFourBar& to) {
  const UnitQuaternion turn = coupler_turn(from, to);
  return (turn.w() < 0 ? -2.0 : 2.0) * turn.v();
}

bool agrees(const LinkAngles& arcs, double input, Assembly assembly) {
  const auto here = sphere_at(arcs, input, assembly);
  if (!here || std::abs(determinant(here->input_moving, here->output_moving, here->output_fixed)) < 0.3) return true;
  const auto by = sensitivity_of(*here);
  if (!by) return false;
  for (std::size_t i = 0; i < spherical_parameters; ++i) {
    const auto at = [&](double change) {
      LinkAngles made = arcs;
      double* const arc[] = {&made.input, &made.coupler, &made.output, &made.ground};
      if (i < 4) *arc[i] += change;
      return sphere_at(made, input + (i == 4 ? change : 0), assembly);
    };
    const auto high = at(step), low = at(-step);
    if (!high || !low) return true;
    if (norm(by->coupler[i] - (1 / (2 * step)) * turn_between(*low, *high)) > alike * (1 + norm(by->coupler[i])))
      return false;
  }
  return true;
}

bool leaves_no_line(testing::RandomFourBars& random) {
  std::vector<double> places, values;
  for (int j = 0; j < 9; ++j) {
    places.push_back(random.uniform(-3, 3));
    values.push_back(random.uniform(-1, 1));
  }
  take_away_best_line(places, values);
  double sum = 0, moment = 0;
  for (std::size_t j = 0; j < places.size(); ++j) {
    sum += values[j];
    moment += values[j] * places[j];
  }
  return std::abs(sum) < 1e-12 && std::abs(moment) < 1e-11;
}

int disagreements() {
  testing::RandomFourBars random(15);
  int found = 0;
  for (int i = 0; i < 400; ++i) {
    const FourBar bars = random.four_bar();
    if (testing::transmission_sine(bars) > 0.3 && bars.lengths().shortest() > 0.3)
      found += !agrees(TracingFourBar{bars, {random.uniform(-3, 3), random.uniform(-3, 3)}});
    const LinkAngles arcs{random.uniform(0.4, 1.4), random.uniform(0.4, 1.4), random.uniform(0.4, 1.4),
                          random.uniform(0.4, 1.4)};
    found += !agrees(arcs, random.uniform(-3, 3), i % 2 == 0 ? Assembly::positive : Assembly::negative);
    found += !leaves_no_line(random);
  }
  return found;
}

}  // namespace
}  // namespace linkwright

int main() {
  const int found = linkwright::disagreements();
  std::printf("%d disagreements\n", found);
  return found > 0 ? 1 : 0;
}
