#include "linkwright/robust/sensitivity.hpp"

#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/position.hpp"
#include "linkwright/mechanism/spherical_position.hpp"
#include "support/central_difference.hpp"
#include "support/draws.hpp"
#include "support/random_four_bar.hpp"

namespace linkwright::sensitivity_test {
namespace {

constexpr double step = 2e-4;  // of a length beside one, and of an angle: h⁶ of the difference is below rounding

// A linkage by what it is made of.
struct Built {
  PlanarValues values{};
  Assembly assembly = Assembly::positive;

  struct State {
    double coupler_angle = 0, output_angle = 0;
    Point point{};
  };
  [[nodiscard]] State state() const {
    const auto& [a, h, b, ax, ay, bx, by, along, across, phi] = values;
    const Point ground = Point{bx, by} - Point{ax, ay};
    const auto c = assemble(LinkLengths{std::abs(ground), a, h, b}, phi - std::arg(ground), assembly);
    if (!c) throw std::runtime_error("does not assemble");
    const double theta = c->coupler_angle + std::arg(ground);
    return {theta, c->output_angle + std::arg(ground),
            Point{ax, ay} + a * direction(phi) + Point{along, across} * direction(theta)};
  }
};

Built built_of(const TracingFourBar& linkage) {
  const FourBar& bars = linkage.bars;
  const LinkLengths l = bars.lengths();
  const Point arm = (linkage.point - bars.input_moving) * std::conj(bars.output_moving - bars.input_moving) / l.coupler;
  return {{l.input, l.coupler, l.output, bars.input_fixed.real(), bars.input_fixed.imag(), bars.output_fixed.real(),
           bars.output_fixed.imag(), arm.real(), arm.imag(), std::arg(bars.input_moving - bars.input_fixed)},
          assembly_of(bars)};
}

// How near a dead point it is: derivatives grow as its inverse's powers, and the differences' error with them.
double joint_sine(const FourBar& bars) {
  const LinkLengths l = bars.lengths();
  return std::abs(cross(bars.output_moving - bars.input_moving, bars.output_moving - bars.output_fixed)) /
         (l.coupler * l.output);
}

TEST(Sensitivity, IsTheDerivativeOfThePosition) {
  testing::RandomFourBars random(1501);
  int tried = 0;
  while (tried < testing::draws(5000)) {
    const FourBar bars = random.four_bar();
    if (joint_sine(bars) < 0.3 || bars.lengths().shortest() < 0.3) continue;
    ++tried;
    const TracingFourBar linkage{bars, {random.uniform(-3, 3), random.uniform(-3, 3)}};
    const auto by = sensitivity_of(linkage);
    ASSERT_TRUE(by);
    const Built built = built_of(linkage);
    for (std::size_t i = 0; i < planar_parameters; ++i) {
      const auto at = [&](double change) {
        Built changed = built;
        changed.values[i] += change;
        return changed.state();
      };
      const Built::State now = built.state();
      const auto turned = [&](auto angle) {
        return testing::first_difference([&](double t) { return wrap_signed(angle(at(t)) - angle(now)); }, 0, step);
      };
      EXPECT_NEAR(by->coupler_angle[i], turned([](const auto& s) { return s.coupler_angle; }), 1e-8) << i;
      EXPECT_NEAR(by->output_angle[i], turned([](const auto& s) { return s.output_angle; }), 1e-8) << i;
      const Point moved = testing::first_difference([&](double t) { return at(t).point - linkage.point; }, 0, step);
      EXPECT_NEAR(std::abs(by->point[i] - moved), 0, 1e-8) << i;
    }
    if (HasFailure()) FAIL() << "linkage " << tried;
  }
}

TEST(Sensitivity, EndsAtDeadPoints) {
  const FourBar flat{{0, 0}, {1, 0}, {4, 0}, {2, 0}};
  EXPECT_FALSE(sensitivity_of(TracingFourBar{flat, {1, 1}}));
  const FourBar no_coupler{{0, 0}, {1, 0}, {2, 0}, {1, 0}};
  EXPECT_FALSE(sensitivity_of(TracingFourBar{no_coupler, {1, 1}}));
  EXPECT_FALSE(sensitivities(angle_output(std::vector{flat})));
  EXPECT_FALSE(sensitivity_of(SphericalFourBar{{0, 0, 1}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}}));
}

// The input's angle is counted from the ground link, whose first axis stays: the frame of assemble().
SphericalFourBar sphere_at(const LinkAngles& angles, double input_angle, Assembly assembly) {
  const Vector3 output_fixed{std::sin(angles.ground), 0, std::cos(angles.ground)};
  const SphericalFourBar frame{{0, 0, 1},
                               {std::sin(angles.input), 0, std::cos(angles.input)},
                               {std::sin(angles.ground + angles.output), 0, std::cos(angles.ground + angles.output)},
                               output_fixed};
  const auto configuration = assemble(angles, input_angle, assembly);
  if (!configuration) throw std::runtime_error("does not assemble");
  return placed(frame, *configuration);
}

// The rotation vector by which the coupler's axes have turned, to second order: exact in a central difference.
Vector3 turn_between(const SphericalFourBar& from, const SphericalFourBar& to) {
  const UnitQuaternion turn = coupler_turn(from, to);
  return (turn.w() < 0 ? -2.0 : 2.0) * turn.v();
}

TEST(Sensitivity, IsTheDerivativeOfTheSphere) {
  testing::RandomFourBars random(1502);
  int tried = 0;
  while (tried < testing::draws(2000)) {
    const auto arc = [&] { return random.uniform(0.4, 2.4); };
    const LinkAngles angles{arc(), arc(), arc(), arc()};
    const double theta = random.uniform(-pi, pi);
    const Assembly assembly = random.assembly();
    if (!linkwright::assemble(angles, theta, assembly)) continue;
    const SphericalFourBar bars = sphere_at(angles, theta, assembly);
    if (transmission_angle(bars) < 0.4) continue;
    ++tried;
    const auto by = sensitivity_of(bars);
    ASSERT_TRUE(by);
    const std::array<double, 5> values = {angles.input, angles.coupler, angles.output, angles.ground, theta};
    for (std::size_t i = 0; i < spherical_parameters; ++i) {
      const auto at = [&](double change) {
        auto changed = values;
        changed[i] += change;
        return sphere_at({changed[3], changed[0], changed[1], changed[2]}, changed[4], assembly);
      };
      // The coupler's own shape changes with its arc: its first axis and the arc's plane are what turns.
      if (i != 1) {
        const Vector3 turned = testing::first_difference([&](double t) { return turn_between(bars, at(t)); }, 0, step);
        EXPECT_NEAR(norm(by->coupler[i] - turned), 0, 1e-8) << i;
      }
      const auto moved = testing::first_difference([&](double t) { return at(t).input_moving; }, 0, step);
      EXPECT_NEAR(norm(cross(by->coupler[i], bars.input_moving) - moved), 0, 1e-8) << i;
      const auto normal = [](const SphericalFourBar& b) { return normalized(cross(b.input_moving, b.output_moving)); };
      const auto tilted = testing::first_difference([&](double t) { return normal(at(t)); }, 0, step);
      EXPECT_NEAR(norm(cross(by->coupler[i], normal(bars)) - tilted), 0, 1e-8) << i;
      const double now = configuration_of(bars).output_angle;
      const double output = testing::first_difference(
          [&](double t) { return wrap_signed(configuration_of(at(t)).output_angle - now); }, 0, step);
      EXPECT_NEAR(by->output_angle[i], output, 1e-8) << i;
    }
    if (HasFailure()) FAIL() << "linkage " << tried;
  }
}

TEST(Sensitivity, OfALineIsAcrossIt) {
  testing::RandomFourBars random(1503);
  std::vector<TracingFourBar> stroke;
  const FourBar bars = testing::four_bar_at({3, 1, 2.6, 2.4}, 0.4, Assembly::positive);
  const TracingFourBar linkage{bars, bars.input_moving + Point{1.2, 0.9}};
  for (int k = 0; k < 9; ++k)
    stroke.push_back(linkage.moved_to(placed(bars, *assemble(bars.lengths(), 0.4 + 0.1 * k, Assembly::positive))));
  const DirectedLine line{linkage.point, direction(0.7)};
  const auto fixed = sensitivities(line_output(stroke, line, false));
  const auto realigned = sensitivities(line_output(stroke, line, true));
  ASSERT_TRUE(fixed && realigned);
  EXPECT_EQ(fixed->components(), 1u);
  for (std::size_t i = 0; i < planar_parameters; ++i) {
    double sum = 0, moment = 0;
    for (std::size_t j = 0; j < stroke.size(); ++j) {
      const Point moved = sensitivity_of(stroke[j])->point[i];
      EXPECT_NEAR(fixed->row(j, 0)[i], dot(line.left(), moved), 1e-15);
      sum += realigned->row(j, 0)[i];
      moment += realigned->row(j, 0)[i] * line.to_line(stroke[j].point).real();
    }
    // No line is left in what is realigned.
    EXPECT_NEAR(sum, 0, 1e-13);
    EXPECT_NEAR(moment, 0, 1e-13);
  }
}

// Moving all of the frame moves all of the linkage: no angle changes.
TEST(Sensitivity, KnowsThatFramesMoveAsOne) {
  testing::RandomFourBars random(1504);
  for (int n = 0; n < testing::draws(1000); ++n) {
    const TracingFourBar linkage{random.four_bar(), {random.uniform(-3, 3), random.uniform(-3, 3)}};
    const auto by = sensitivity_of(linkage);
    if (!by || joint_sine(linkage.bars) < 1e-2) continue;
    for (const std::size_t x : {3, 4}) {
      EXPECT_NEAR(by->coupler_angle[x] + by->coupler_angle[x + 2], 0, 1e-9);
      EXPECT_NEAR(by->output_angle[x] + by->output_angle[x + 2], 0, 1e-9);
      EXPECT_NEAR(std::abs(by->point[x] + by->point[x + 2] - (x == 3 ? Point{1, 0} : Point{0, 1})), 0, 1e-8);
    }
  }
}

}  // namespace
}  // namespace linkwright::sensitivity_test
