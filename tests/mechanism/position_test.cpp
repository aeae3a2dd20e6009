#include "linkwright/mechanism/position.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <set>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/linkage_type.hpp"
#include "support/random_four_bar.hpp"

namespace linkwright::position_test {
namespace {

using testing::four_bar_at;
using testing::loop_gap;
using testing::RandomFourBars;

constexpr std::array<Assembly, 2> assemblies = {Assembly::negative, Assembly::positive};

// The condition of assembly as it is drawn: the circles of coupler and output link meet.
bool circles_meet(const LinkLengths& l, double input_angle) {
  const double diagonal = std::abs(l.input * direction(input_angle) - l.ground);
  return diagonal <= l.coupler + l.output && diagonal >= std::abs(l.coupler - l.output);
}

bool in_ranges(const std::vector<AngleRange>& ranges, double angle) {
  return std::any_of(ranges.begin(), ranges.end(),
                     [&](const AngleRange& r) { return wrap_positive(angle - r.from) <= r.to - r.from; });
}

LinkLengths scaled(const LinkLengths& l, double s) { return {s * l.ground, s * l.input, s * l.coupler, s * l.output}; }

// ---- forward kinematics
// ----------------------------------------------------------------------------------------------

TEST(Assemble, ClosesTheLoopInTheAssemblyAskedFor) {
  RandomFourBars random(11);
  std::set<LinkageType> types;
  for (int i = 0; i < 20000; ++i) {
    const LinkLengths lengths = random.lengths();
    types.insert(linkage_type(lengths));
    const double angle = random.input_angle(lengths);
    for (const Assembly assembly : assemblies) {
      const auto c = assemble(lengths, angle, assembly);
      ASSERT_TRUE(c.has_value());
      EXPECT_EQ(c->input_angle, angle);
      EXPECT_LT(loop_gap(lengths, *c), 1e-14 * lengths.perimeter());
      EXPECT_EQ(assembly_of(four_bar_at(lengths, angle, assembly)), assembly);
    }
  }
  EXPECT_EQ(types.size(), 8u) << "all but change points and degenerate ones";
}

TEST(Assemble, GivesMirrorImagesForMirroredInputs) {
  const LinkLengths lengths{4, 1, 3, 2.5};
  const auto up = assemble(lengths, 1, Assembly::positive), down = assemble(lengths, -1, Assembly::negative);
  EXPECT_NEAR(up->coupler_angle, -down->coupler_angle, 1e-15);
  EXPECT_NEAR(up->output_angle, -down->output_angle, 1e-15);
}

TEST(Assemble, GivesTheSameAnglesAtAnySize) {
  RandomFourBars random(12);
  for (int i = 0; i < 1000; ++i) {
    const LinkLengths lengths = random.lengths();
    const double angle = random.input_angle(lengths);
    const auto c = assemble(lengths, angle, Assembly::positive);
    for (const double scale : {1e-150, 1e-6, 1e6, 1e150}) {
      const auto again = assemble(scaled(lengths, scale), angle, Assembly::positive);
      ASSERT_TRUE(again.has_value());
      EXPECT_NEAR(wrap_signed(again->coupler_angle - c->coupler_angle), 0, 1e-9);
      EXPECT_NEAR(wrap_signed(again->output_angle - c->output_angle), 0, 1e-9);
    }
  }
}

TEST(Assemble, RefusesWhatCannotBeAssembled) {
  const LinkLengths rocker{3, 2, 2.2, 2.1};
  EXPECT_TRUE(assemble(rocker, radians(117.2), Assembly::positive));
  EXPECT_FALSE(assemble(rocker, radians(117.3), Assembly::positive));
  EXPECT_FALSE(assemble({10, 1, 1, 1}, 0, Assembly::positive));
}

// Kinzel's course notes, example 5.1: r₁ = 1, r₂ = 2, r₃ = 3.5, r₄ = 4 in, input angle 0 (θ₄ computed independently).
TEST(Assemble, GivesBothOutputAnglesOfKinzelsExample51) {
  const LinkLengths lengths{1, 2, 3.5, 4};
  EXPECT_NEAR(degrees(assemble(lengths, 0, Assembly::positive)->output_angle), -53.57642635766884, 1e-12);
  EXPECT_NEAR(degrees(assemble(lengths, 0, Assembly::negative)->output_angle), +53.57642635766884, 1e-12);
}

TEST(Assemble, KeepsItsDigitsWhereThePivotsNearlyMeet) {
  const LinkLengths kite{1, 1, 0.5, 0.5};
  for (const double angle : {1e-3, 1e-8, 1e-12}) {
    const auto c = assemble(kite, angle, Assembly::negative);
    ASSERT_TRUE(c.has_value());
    EXPECT_NEAR(std::abs(c->output_angle), pi - angle / 2, 2 * angle + 1e-15) << "output square to the diagonal";
    EXPECT_LT(loop_gap(kite, *c), 1e-15);
  }
  EXPECT_LT(loop_gap(kite, *assemble(kite, 0, Assembly::negative)), 1e-15) << "any output angle will do";
}

TEST(Assemble, AnswersHostileInputWithNothing) {
  const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
  for (const double bad : {0.0, -1.0, nan, infinite, -infinite}) {
    for (const LinkLengths& lengths :
         {LinkLengths{bad, 1, 3, 2.5}, {4, bad, 3, 2.5}, {4, 1, bad, 2.5}, {4, 1, 3, bad}}) {
      EXPECT_FALSE(assemble(lengths, 1, Assembly::positive));
      EXPECT_TRUE(input_ranges(lengths).empty());
      EXPECT_TRUE(dead_points(lengths).empty());
    }
  }
  EXPECT_FALSE(assemble({4, 1, 3, 2.5}, nan, Assembly::positive));
  EXPECT_FALSE(assemble({4, 1, 3, 2.5}, infinite, Assembly::positive));
  EXPECT_TRUE(input_ranges({1e308, 1e308, 1e308, 1e308}).empty()) << "the perimeter overflows";
}

// ---- a four-bar and its configuration
// --------------------------------------------------------------------------------

TEST(Configuration, IsThatInWhichTheFourBarLies) {
  RandomFourBars random(13);
  for (int i = 0; i < 3000; ++i) {
    const FourBar four_bar = random.four_bar();
    const Configuration c = configuration_of(four_bar);
    const FourBar again = placed(four_bar, c);
    EXPECT_LT(std::abs(again.input_moving - four_bar.input_moving), 1e-14);
    EXPECT_LT(std::abs(again.output_moving - four_bar.output_moving), 1e-14);
    EXPECT_EQ(again.input_fixed, four_bar.input_fixed);
    EXPECT_EQ(again.output_fixed, four_bar.output_fixed);
    EXPECT_LT(loop_gap(four_bar.lengths(), c), 1e-14);
    const auto found = assemble(four_bar.lengths(), c.input_angle, assembly_of(four_bar));
    ASSERT_TRUE(found.has_value());
    EXPECT_LT(std::abs(placed(four_bar, *found).output_moving - four_bar.output_moving), 1e-7);
  }
}

// Where a product of coordinates leaves −0, arg gives −π.
TEST(Configuration, PointsBackAtPi) {
  for (const Point axis : {Point{1, 0}, Point{0, 1}, Point{-1, 0}, Point{0, -1}, Point{3, 4}}) {
    const Configuration c = configuration_of({0, -axis, 3.0 * axis, 2.0 * axis});
    EXPECT_EQ(c.input_angle, pi) << axis;
    EXPECT_EQ(c.coupler_angle, 0) << axis;
    EXPECT_EQ(c.output_angle, pi) << axis;
  }
}

TEST(Configuration, OfADegenerateFourBarIsFinite) {
  const Configuration c = configuration_of({{1, 1}, {1, 1}, {1, 1}, {1, 1}});
  EXPECT_TRUE(std::isfinite(c.input_angle) && std::isfinite(c.coupler_angle) && std::isfinite(c.output_angle));
}

TEST(Placed, KeepsTheLengths) {
  RandomFourBars random(14);
  for (int i = 0; i < 3000; ++i) {
    const FourBar reference = random.four_bar();
    const LinkLengths wanted = reference.lengths();
    const double angle = random.input_angle(wanted);
    const LinkLengths l = placed(reference, *assemble(wanted, angle, random.assembly())).lengths();
    EXPECT_NEAR(l.input, wanted.input, 1e-14);
    EXPECT_NEAR(l.coupler, wanted.coupler, 2e-14);
    EXPECT_NEAR(l.output, wanted.output, 1e-14);
  }
}

// ---- where the input can be
// ------------------------------------------------------------------------------------------

TEST(InputRanges, AgreeWithScanningTheConditionOfAssembly) {
  RandomFourBars random(15);
  for (int i = 0; i < 3000; ++i) {
    LinkLengths lengths = random.lengths();
    if (i % 3 == 0) lengths.ground *= random.uniform(1, 3);  // some cannot be assembled
    const auto ranges = input_ranges(lengths);
    for (int step = 0; step < 360; ++step) {
      const double angle = -pi + two_pi * (step + 0.5) / 360;
      ASSERT_EQ(in_ranges(ranges, angle), circles_meet(lengths, angle)) << "linkage " << i << " at " << degrees(angle);
    }
  }
}

TEST(InputRanges, EndWhereAssemblyEnds) {
  RandomFourBars random(16);
  for (int i = 0; i < 3000; ++i) {
    const LinkLengths lengths = random.lengths();
    for (const AngleRange& range : input_ranges(lengths)) {
      if (range.is_full_turn()) continue;
      EXPECT_TRUE(assemble(lengths, range.from, Assembly::positive) && assemble(lengths, range.to, Assembly::positive));
      const double margin = 1e-9;
      EXPECT_FALSE(assemble(lengths, range.from - margin, Assembly::positive));
      EXPECT_FALSE(assemble(lengths, range.to + margin, Assembly::positive));
    }
  }
}

TEST(InputRanges, AreAFullTurnForCranksTwoForRockersOfAGrashofLinkageOneOtherwise) {
  RandomFourBars random(17);
  for (int i = 0; i < 3000; ++i) {
    const LinkLengths lengths = random.lengths();
    const LinkageType type = linkage_type(lengths);
    const auto ranges = input_ranges(lengths);
    ASSERT_EQ(ranges.size(), is_grashof(type) && !input_is_crank(type) ? 2u : 1u);
    EXPECT_EQ(ranges[0].is_full_turn(), input_is_crank(type));
    EXPECT_TRUE(std::all_of(ranges.begin(), ranges.end(), [](const AngleRange& r) { return r.from < r.to; }));
    if (ranges.size() == 2) {
      EXPECT_LT(ranges[0].to, ranges[1].from);
      EXPECT_EQ(ranges[0].from, -ranges[1].to);
      EXPECT_EQ(ranges[0].to, -ranges[1].from);
    }
  }
}

TEST(InputRanges, OfAChangePointAreAsWideAsTheLinksAllow) {
  EXPECT_TRUE(input_ranges({3, 2, 3, 2})[0].is_full_turn()) << "parallelogram";
  EXPECT_TRUE(input_ranges({0.3, 0.2, 0.3, 0.2})[0].is_full_turn()) << "rounding of the lengths does not matter";
  EXPECT_TRUE(input_ranges({4, 1, 3, 2})[0].is_full_turn()) << "flat at 180°";
  EXPECT_TRUE(input_ranges({2, 2, 2, 2})[0].is_full_turn()) << "rhombus";
}

TEST(InputRanges, ShrinkToAPointWhereTheLinksJustReach) {
  const auto ranges = input_ranges({3, 1, 1, 1});
  ASSERT_EQ(ranges.size(), 1u);
  EXPECT_NEAR(ranges[0].from, 0, 1e-7);
  EXPECT_NEAR(ranges[0].to, 0, 1e-7);
  EXPECT_TRUE(input_ranges({3.001, 1, 1, 1}).empty());
}

TEST(InputRanges, DoNotDependOnSize) {
  RandomFourBars random(18);
  for (int i = 0; i < 500; ++i) {
    const LinkLengths lengths = random.lengths();
    const auto ranges = input_ranges(lengths);
    for (const double scale : {1e-6, 1e6}) {
      const auto again = input_ranges(scaled(lengths, scale));
      ASSERT_EQ(again.size(), ranges.size());
      for (std::size_t k = 0; k < ranges.size(); ++k) {
        EXPECT_NEAR(again[k].from, ranges[k].from, 1e-10);
        EXPECT_NEAR(again[k].to, ranges[k].to, 1e-10);
      }
    }
  }
}

// ---- dead points
// -----------------------------------------------------------------------------------------------------

TEST(DeadPoints, HaveCouplerAndOutputInOneLine) {
  RandomFourBars random(19);
  for (int i = 0; i < 3000; ++i) {
    const LinkLengths lengths = random.lengths();
    for (const DeadPoint& dead : dead_points(lengths)) {
      const Configuration& c = dead.configuration;
      EXPECT_LT(loop_gap(lengths, c), 1e-13 * lengths.perimeter());
      const double joint = c.coupler_angle - c.output_angle;
      EXPECT_NEAR(std::sin(joint), 0, 1e-14) << "the joint sign vanishes";
      EXPECT_NEAR(std::cos(joint), dead.extended ? -1 : 1, 1e-14);
      const double diagonal = std::abs(lengths.input * direction(c.input_angle) - lengths.ground);
      EXPECT_NEAR(diagonal,
                  dead.extended ? lengths.coupler + lengths.output : std::abs(lengths.coupler - lengths.output),
                  1e-13 * lengths.perimeter());
    }
  }
}

TEST(DeadPoints, AreTheEndsOfTheInputsRanges) {
  RandomFourBars random(20);
  for (int i = 0; i < 3000; ++i) {
    const LinkLengths lengths = random.lengths();
    const auto ranges = input_ranges(lengths);
    const auto points = dead_points(lengths);
    ASSERT_EQ(points.size(), ranges[0].is_full_turn() ? 0u : 2 * ranges.size());
    for (const DeadPoint& dead : points) {
      const double angle = dead.configuration.input_angle;
      EXPECT_TRUE(std::any_of(ranges.begin(), ranges.end(), [&](const AngleRange& r) {
        return std::abs(wrap_signed(r.from - angle)) < 1e-14 || std::abs(wrap_signed(r.to - angle)) < 1e-14;
      }));
    }
    EXPECT_TRUE(std::is_sorted(points.begin(), points.end(), [](const DeadPoint& a, const DeadPoint& b) {
      return a.configuration.input_angle < b.configuration.input_angle;
    }));
  }
}

TEST(DeadPoints, OfAChangePointAreWhereItLiesFlat) {
  const auto at_pi = dead_points({4, 1, 3, 2});
  ASSERT_EQ(at_pi.size(), 1u);
  EXPECT_EQ(at_pi[0].configuration.input_angle, pi);
  EXPECT_TRUE(at_pi[0].extended);
  const auto parallelogram = dead_points({3, 2, 3, 2});
  ASSERT_EQ(parallelogram.size(), 2u);
  EXPECT_EQ(parallelogram[0].configuration.input_angle, 0);
  EXPECT_FALSE(parallelogram[0].extended);
  EXPECT_EQ(parallelogram[1].configuration.input_angle, pi);
  const auto barely = dead_points({1, 1, 3, 1});  // output reaches the coupler's end only at φ = π
  ASSERT_EQ(barely.size(), 1u);
  EXPECT_EQ(barely[0].configuration.input_angle, pi);
}

using testing::RandomFourBars;

TEST(AngleRates, AgreeWithCentralDifferences) {
  RandomFourBars random(31);
  int compared = 0;
  for (int i = 0; i < 5000; ++i) {
    const LinkLengths lengths = random.lengths();
    const double angle = random.input_angle(lengths), step = 1e-4;
    const Assembly assembly = random.assembly();
    const auto before = assemble(lengths, angle - step, assembly), at = assemble(lengths, angle, assembly),
               after = assemble(lengths, angle + step, assembly);
    if (!before || !after || std::abs(std::sin(at->coupler_angle - at->output_angle)) < 0.2) continue;
    const auto rates = angle_rates(lengths, *at);
    ASSERT_TRUE(rates.has_value());
    const auto back = angle_rates(lengths, *before), ahead = angle_rates(lengths, *after);
    const auto slope = [&](double from, double to) { return (to - from) / (2 * step); };
    // Truncation is step²/6 times the third derivative, which grows with the fifth power of 1/sin μ and with rates.
    const double rate = 1 + std::max(std::abs(rates->coupler), std::abs(rates->output));
    const double tolerance = 1e-3 * rate * rate * rate;
    EXPECT_NEAR(rates->coupler, slope(0, wrap_signed(after->coupler_angle - before->coupler_angle)), tolerance);
    EXPECT_NEAR(rates->output, slope(0, wrap_signed(after->output_angle - before->output_angle)), tolerance);
    EXPECT_NEAR(rates->coupler_acceleration, slope(back->coupler, ahead->coupler), tolerance * rate);
    EXPECT_NEAR(rates->output_acceleration, slope(back->output, ahead->output), tolerance * rate);
    ++compared;
  }
  EXPECT_GT(compared, 3000);
}

// The loop equation differentiated: what the drawing of velocities and accelerations must close to.
TEST(AngleRates, CloseTheVelocityAndTheAccelerationPolygon) {
  RandomFourBars random(32);
  for (int i = 0; i < 5000; ++i) {
    const LinkLengths l = random.lengths();
    const auto c = assemble(l, random.input_angle(l), random.assembly());
    const auto r = angle_rates(l, *c);
    ASSERT_TRUE(r.has_value());
    const Point turn{0, 1};
    const Point a = l.input * direction(c->input_angle), h = l.coupler * direction(c->coupler_angle),
                b = l.output * direction(c->output_angle);
    const Point velocity = turn * (a + r->coupler * h - r->output * b);
    EXPECT_LT(std::abs(velocity), 1e-13 * (1 + std::abs(r->coupler) + std::abs(r->output)));
    const auto acceleration = [&](double rate, double second) { return turn * second - rate * rate; };
    const Point gap = acceleration(1, 0) * a + acceleration(r->coupler, r->coupler_acceleration) * h -
                      acceleration(r->output, r->output_acceleration) * b;
    EXPECT_LT(std::abs(gap), 1e-13 * (1 + std::abs(r->coupler_acceleration) + std::abs(r->output_acceleration)));
  }
}

TEST(AngleRates, OfAParallelogramAreThoseOfATranslatingCoupler) {
  const LinkLengths parallelogram{3, 2, 3, 2};
  const auto rates = angle_rates(parallelogram, {1, 0, 1});
  ASSERT_TRUE(rates.has_value());
  EXPECT_NEAR(rates->coupler, 0, 1e-15);
  EXPECT_NEAR(rates->output, 1, 1e-15);
  EXPECT_NEAR(rates->coupler_acceleration, 0, 1e-15);
  EXPECT_NEAR(rates->output_acceleration, 0, 1e-15);
}

TEST(AngleRates, DoNotExistAtDeadPoints) {
  for (const LinkLengths lengths : {LinkLengths{3, 2, 2.2, 2.1}, {4, 2.5, 3, 1}, {4, 3, 1.5, 3.2}})
    for (const DeadPoint& dead : dead_points(lengths)) EXPECT_FALSE(angle_rates(lengths, dead.configuration));
}

TEST(AngleRates, DoNotDependOnSize) {
  const LinkLengths l{4, 1, 3, 2.5};
  const Configuration c = *assemble(l, 1, Assembly::positive);
  for (const double s : {1e-6, 1e6}) {
    const auto rates = angle_rates({s * l.ground, s * l.input, s * l.coupler, s * l.output}, c);
    EXPECT_NEAR(rates->output_acceleration, angle_rates(l, c)->output_acceleration, 1e-14);
  }
}

TEST(AngleRates, OfHostileInputDoNotExist) {
  const double nan = std::nan("");
  EXPECT_FALSE(angle_rates({4, 1, 0, 2.5}, {1, 2, 3}));
  EXPECT_FALSE(angle_rates({4, 1, 3, nan}, {1, 2, 3}));
  EXPECT_FALSE(angle_rates({4, 1, 3, 2.5}, {nan, 2, 3}));
  EXPECT_FALSE(angle_rates({4, 1, 3, 2.5}, {1, nan, 3}));
}

}  // namespace
}  // namespace linkwright::position_test
