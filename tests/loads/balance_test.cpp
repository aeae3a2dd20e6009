#include "linkwright/loads/balance.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/position.hpp"
#include "loads/statics.hpp"
#include "support/load_cases.hpp"

namespace linkwright::balance_test {
namespace {

using testing::load_file;
using testing::loaded_case;
using testing::LoadedCase;
using testing::point_from;

struct Asked {
  nlohmann::json file = load_file("exact_balance");
  LoadedCase of = loaded_case(file);
  LoadCase each;

  [[nodiscard]] Balance balance(const BalanceOptions& options = {}) const {
    return exact_balance(of.loads, each, of.bars, of.poses.front().pose, options).value();
  }
};

/// Of the energy over the turns that the input can make: the largest less the least, by the largest of its parts.
double spread(const Asked& of, const Loads& loads) {
  const BoundLoads bound(loads, of.each, of.of.bars, of.of.poses.front().pose);
  const Configuration first = configuration_of(of.of.bars);
  double least = 1e300, most = -1e300;
  int places = 0;
  for (int i = 0; i < 360; ++i) {
    const auto there = assemble(of.of.bars.lengths(), first.input_angle + radians(i), assembly_of(of.of.bars));
    if (!there) continue;
    const double energy = bound.energy({placed(of.of.bars, *there), {}, {}});
    least = std::min(least, energy);
    most = std::max(most, energy);
    ++places;
  }
  EXPECT_GT(places, 300);
  return (most - least) / std::max(std::abs(most), std::abs(least));
}

TEST(Balance, IsThatOfTheFile) {
  const Asked of;
  const auto& two = of.file["two_springs"];
  BalanceOptions options;
  for (std::size_t k = 0; k < 2; ++k) options.rate[k] = two["stiffness_N_per_m"][k].get<double>() / 1000;
  const Balance found = of.balance(options);
  EXPECT_NEAR(std::abs(found.reduced[0] / 1000.0 - point_from(of.file["reduced"]["G1_Nm"])), 0, 1e-9);
  EXPECT_NEAR(std::abs(found.reduced[1] / 1000.0 - point_from(of.file["reduced"]["G3_Nm"])), 0, 1e-9);
  const auto& one = of.file["one_spring"];
  ASSERT_TRUE(found.one_spring);
  EXPECT_NEAR(found.one_spring->rate * 1000, one["stiffness_N_per_m"].get<double>(), 1e-9);
  EXPECT_NEAR(found.one_share, one["share_rho_along_coupler"].get<double>(), 1e-9);
  EXPECT_NEAR(std::abs(found.one_spring->from.at - point_from(one["anchor_mm"])), 0, 1e-9);
  ASSERT_TRUE(found.why_not_one);
  EXPECT_EQ(found.why_not_one->code, "negative_rate");
  ASSERT_EQ(found.two_springs.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k)
    EXPECT_NEAR(std::abs(found.two_springs[k].from.at - point_from(two["anchors_mm"][k])), 0, 1e-9);
}

TEST(Balance, LeavesNoEnergyToChange) {
  Asked of;
  of.each.slope = 0.2;
  of.of.loads.body = BodyMass{2.5, {30, -20}};
  of.of.loads.extra = {{.name = "tool", .at = {LoadedBody::coupler, {40, 10}}, .mass = 0.3, .always = true},
                       {.name = "rope", .at = {LoadedBody::body, {-10, 60}}, .force = {3, 5}, .always = true},
                       {.name = "snow", .at = {LoadedBody::body, {0, 0}}, .mass = 9}};
  EXPECT_GT(spread(of, of.of.loads), 0.1);
  BalanceOptions options;
  options.stud[0] = Point{30, 12};
  const Balance found = of.balance(options);
  Loads loads = of.of.loads;
  for (const BalanceSpring& spring : found.two_springs) loads.springs.push_back(spring.spring());
  EXPECT_LT(spread(of, loads), 1e-12);
  loads.springs.front().from.at += Point{0.01, 0};
  EXPECT_GT(spread(of, loads), 1e-7);

  loads = of.of.loads;
  for (std::size_t k = 0; k < found.counterweights.size(); ++k) {
    const CounterWeight& weight = found.counterweights[k];
    loads.extra.push_back(
        {.name = std::to_string(k), .at = {weight.on, weight.at}, .mass = weight.mass, .always = true});
    EXPECT_NEAR(std::abs(weight.at), k == 0 ? of.of.bars.lengths().input : of.of.bars.lengths().output, 1e-9);
  }
  EXPECT_LT(spread(of, loads), 1e-12);
}

// Where it is positive, one spring does: the weights turned upside down make it so.
TEST(Balance, IsDoneByOneSpringWhereItPulls) {
  Asked of;
  int usable = 0;
  for (int i = 0; i < 12; ++i) {
    of.each.slope = radians(30.0 * i);
    const Balance found = of.balance();
    if (!found.one_spring || found.why_not_one) continue;
    Loads loads = of.of.loads;
    loads.springs = {found.one_spring->spring()};
    EXPECT_LT(spread(of, loads), 1e-12) << i;
    ++usable;
  }
  EXPECT_GT(usable, 2);
}

// Two springs by default are as long on the ground as on their links.
TEST(Balance, ChoosesRatesByTheLinks) {
  const Asked of;
  const Balance found = of.balance();
  EXPECT_NEAR(std::abs(found.two_springs[0].from.at - of.of.bars.input_fixed), of.of.bars.lengths().input, 1e-9);
  EXPECT_NEAR(std::abs(found.two_springs[1].from.at - of.of.bars.output_fixed), of.of.bars.lengths().output, 1e-9);
}

TEST(Balance, HasNothingToDoWithoutWeights) {
  Asked of;
  of.of.loads.gravity.reset();
  const Balance found = of.balance();
  EXPECT_TRUE(found.two_springs.empty());
  EXPECT_TRUE(found.counterweights.empty());
  EXPECT_EQ(found.why_not_one->code, "no_single_spring");
}

TEST(Balance, TellsMistakes) {
  Asked of;
  of.of.loads.extra = {{.name = "jet", .force = {1, 2}, .turns_with_body = true, .always = true}};
  BalanceOptions options;
  options.rate[0] = 0;
  options.stud[1] = Point{0, 0};
  options.lever[1] = -1;
  const auto found = exact_balance(of.of.loads, of.each, of.of.bars, of.of.poses.front().pose, options);
  ASSERT_FALSE(found);
  std::string places;
  for (const Error& error : found.errors()) places += error.place + " ";
  EXPECT_EQ(places, "balance.input.rate balance.output.lever balance.output.stud loads.extra[0] ");
}

}  // namespace
}  // namespace linkwright::balance_test
