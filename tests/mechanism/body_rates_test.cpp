#include "linkwright/mechanism/body_rates.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/position.hpp"
#include "support/machine_cases.hpp"
#include "support/random_four_bar.hpp"

namespace linkwright::body_rates_test {
namespace {

const HingedBodies four_bar{4, {{0, 1}, {1, 2}, {3, 2}, {0, 3}}, false};

std::array<Vector3, 4> hinges_of(const LinkLengths& l, const Configuration& c, Point from, double size) {
  const Point at[] = {0, std::polar(l.input, c.input_angle), l.ground + std::polar(l.output, c.output_angle), l.ground};
  std::array<Vector3, 4> hinges;
  for (std::size_t i = 0; i < hinges.size(); ++i) hinges[i] = in_space(from + size * at[i]);
  return hinges;
}

// The closed form of four-bars, wherever the linkage lies and however large it is.
TEST(HingedBodyRates, OfFourBarsAreTheRatesOfTheirAngles) {
  testing::RandomFourBars random(71);
  int compared = 0;
  for (int i = 0; i < 3000; ++i) {
    const LinkLengths lengths = random.lengths();
    const auto c = assemble(lengths, random.input_angle(lengths), random.assembly());
    const auto expected = angle_rates(lengths, *c);
    if (!expected || std::abs(std::sin(c->coupler_angle - c->output_angle)) < 0.05) continue;
    const double size = std::pow(10, i % 7 - 3);
    const auto at = hinges_of(lengths, *c, size * Point{3, -7}, size);
    const auto rates = body_rates(four_bar, at);
    ASSERT_TRUE(rates.has_value());
    const double enough = 1e-9 * (1 + std::pow(std::max(std::abs(expected->coupler), std::abs(expected->output)), 3));
    EXPECT_NEAR((*rates)[2].turning.z, expected->coupler, enough);
    EXPECT_NEAR((*rates)[3].turning.z, expected->output, enough);
    EXPECT_NEAR((*rates)[2].turning_up.z, expected->coupler_acceleration, 100 * enough);
    EXPECT_NEAR((*rates)[3].turning_up.z, expected->output_acceleration, 100 * enough);
    // A fixed pivot does not move, the driver's pin runs on its circle.
    EXPECT_LT(norm((*rates)[3].velocity(at[3])) + norm((*rates)[3].acceleration(at[3])), 1e3 * enough * size);
    EXPECT_NEAR(norm((*rates)[1].velocity(at[1])), lengths.input * size, 1e-9 * size * (1 + lengths.input));
    EXPECT_LT(norm((*rates)[2].acceleration(at[1]) + (at[1] - at[0])), 1e3 * enough * size);
    ++compared;
  }
  EXPECT_GT(compared, 2000);
}

TEST(HingedBodyRates, AreUnboundedAtADeadPoint) {
  // Ground 4, input 3, coupler 1.5, output 2.5: coupler and output in one line.
  const double angle = std::acos((16.0 + 9.0 - 16.0) / 24.0);
  const Point a = std::polar(3.0, angle), b = 4.0 + 2.5 * (a - 4.0) / std::abs(a - 4.0);
  EXPECT_FALSE(body_rates(four_bar, std::array{Vector3{}, in_space(a), in_space(b), Vector3{4, 0, 0}}).has_value());
}

struct Compared {
  double velocity = 0, acceleration = 0;
  int states = 0;
};
/// The hinges as the bodies carry them over the travel, by differences.
Compared compared(const MovingLinkage& linkage) {
  HingedBodies hinged{static_cast<int>(linkage.bodies.size()), {}, linkage.spherical};
  for (const Hinge& hinge : linkage.hinges) hinged.hinges.push_back(hinge.bodies);
  const auto place = [&](std::size_t state, std::size_t hinge) {
    const auto& [name, bodies, point] = linkage.hinges[hinge];
    return linkage.travel[state].bodies[static_cast<std::size_t>(bodies[1])].apply_to_point(point);
  };
  Compared worst;
  for (std::size_t k = 1; k + 1 < linkage.travel.size(); k += 7) {
    const double before = linkage.travel[k].driver_turn - linkage.travel[k - 1].driver_turn,
                 after = linkage.travel[k + 1].driver_turn - linkage.travel[k].driver_turn;
    if (std::abs(after - before) > 1e-9) continue;  // a position lies between
    std::vector<Vector3> at;
    for (std::size_t hinge = 0; hinge < linkage.hinges.size(); ++hinge) at.push_back(place(k, hinge));
    const auto rates = body_rates(hinged, at);
    if (!rates) continue;
    double fastest = 0;
    for (const HingedBodyRates& body : *rates) fastest = std::max(fastest, norm(body.turning));
    if (fastest > 3) continue;  // differences are rough near dead points
    const double size = linkage.spherical ? 1 : linkage.longest_link();
    for (std::size_t hinge = 0; hinge < at.size(); ++hinge)
      for (const int body : linkage.hinges[hinge].bodies) {
        const HingedBodyRates& of = (*rates)[static_cast<std::size_t>(body)];
        const Vector3 last = place(k - 1, hinge), next = place(k + 1, hinge);
        worst.velocity = std::max(worst.velocity, norm(of.velocity(at[hinge]) - (next - last) / (2 * after)) / size);
        const Vector3 curving = (next + last - 2 * at[hinge]) / (after * after);
        worst.acceleration = std::max(worst.acceleration, norm(of.acceleration(at[hinge]) - curving) / size);
      }
    ++worst.states;
  }
  return worst;
}

// Both bodies of every hinge, of four-bars, six-bars and spherical linkages.
TEST(HingedBodyRates, AreThoseOfTheTravelOfTheExamples) {
  int linkages = 0;
  for (const AnyStoredLinkage& stored : testing::stored_linkages_of_examples()) {
    const MovingLinkage linkage = moving_linkage(stored);
    const Compared worst = compared(linkage);
    if (worst.states == 0) continue;
    EXPECT_LT(worst.velocity, 2e-3) << linkage.title;
    EXPECT_LT(worst.acceleration, 5e-2) << linkage.title;
    ++linkages;
  }
  EXPECT_GT(linkages, 12);
}

}  // namespace
}  // namespace linkwright::body_rates_test
