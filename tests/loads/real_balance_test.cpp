#include "linkwright/loads/real_balance.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "linkwright/core/angle.hpp"
#include "linkwright/loads/load_report.hpp"
#include "support/load_cases.hpp"

namespace linkwright::real_balance_test {
namespace {

using testing::load_file;
using testing::loaded_case;
using testing::LoadedCase;

LoadedCase tailgate() {
  LoadedCase of = loaded_case(load_file("tailgate_weight"));
  of.loads.cases = {{.name = "room", .slope = 0.05}};
  return of;
}

RealBalances balances_of(const LoadedCase& of, const RealBalanceOptions& options = {}) {
  return real_balance(of.loads, of.loads.cases.front(), of.bars, of.poses, options).found.value();
}

/// Forces of the hand at the stations under some springs, by the curves of the report.
std::vector<double> hand_under(const LoadedCase& of, const std::vector<Spring>& springs, int between = 12) {
  Loads loads = of.loads;
  loads.springs = springs;
  std::vector<double> forces;
  for (const LoadStation& at : load_curve(loads, of.loads.cases.front(), of.bars, of.poses, between))
    forces.push_back(at.frictionless.value());
  return forces;
}
double square_of(const std::vector<double>& forces) {
  double sum = 0;
  for (const double force : forces) sum += force * force;
  return sum;
}
CoilSpring& coil_of(Spring& spring) { return std::get<CoilSpring>(spring.law); }

/// The shortest that a spring gets at the stations.
double shortest(const LoadedCase& of, const Spring& spring) {
  Loads loads = of.loads;
  loads.springs = {spring};
  double least = 1e300;
  for (const LoadStation& at : load_curve(loads, of.loads.cases.front(), of.bars, of.poses, 12))
    least = std::min(least, at.springs.front()->length);
  return least;
}

/// Other ends near by, with the free length that they want: of the given rates scaled one after the other, the best.
double best_near(const LoadedCase& of, std::vector<Spring> springs, double free_share) {
  for (Spring& spring : springs) coil_of(spring).free_length = free_share * shortest(of, spring);
  double best = square_of(hand_under(of, springs));
  for (int turn = 0; turn < 4; ++turn)
    for (Spring& spring : springs) {
      // The square is a parabola of a rate: its lowest point by three of them.
      const double rate = coil_of(spring).rate, by = 0.1 * rate;
      const auto at = [&](double wanted) {
        coil_of(spring).rate = wanted;
        return square_of(hand_under(of, springs));
      };
      const double low = at(rate - by), middle = at(rate), high = at(rate + by);
      const double lowest = rate + by * (low - high) / (2 * (low - 2 * middle + high));
      best = std::min(best, at(std::max(0.0, lowest)));
    }
  return best;
}

TEST(RealBalance, TellsTheLargestForceThatItLeaves) {
  const LoadedCase of = tailgate();
  const RealBalances found = balances_of(of);
  EXPECT_EQ(found.free_share, 0.75);
  const auto largest = [](const std::vector<double>& forces) {
    double most = 0;
    for (const double force : forces) most = std::max(most, std::abs(force));
    return most;
  };
  EXPECT_NEAR(found.hand_force_without, largest(hand_under(of, {}, 400)), 1e-3);
  for (const auto& each : {found.two, found.one}) {
    ASSERT_TRUE(each);
    EXPECT_NEAR(each->residual_hand_force, largest(hand_under(of, each->springs, 400)), 1e-3);
    EXPECT_GE(each->residual_hand_force, largest(hand_under(of, each->springs, 400)) - 1e-9);
    EXPECT_LT(each->residual_hand_force, 0.4 * found.hand_force_without);
    for (Spring spring : each->springs) {
      EXPECT_NEAR(coil_of(spring).free_length, 0.75 * shortest(of, spring), 1e-9);
      EXPECT_EQ(spring.from.on, LoadedBody::ground);
    }
  }
}

// Without a free length, and studs where the exact balance has them, nothing is left.
TEST(RealBalance, IsExactWithoutAFreeLength) {
  const LoadedCase of = tailgate();
  RealBalanceOptions options;
  options.free_share = 0;
  options.ground = StudBox{{-2000, -2000}, {2000, 2000}};
  const RealBalances found = balances_of(of, options);
  ASSERT_TRUE(found.two);
  EXPECT_LT(found.two->residual_hand_force, 1e-4 * found.hand_force_without);
}

// Studs at random in the box and near the answer, each with its best rates: none leaves less.
TEST(RealBalance, IsNotBetteredByStudsAtRandom) {
  const LoadedCase of = tailgate();
  std::mt19937 random(5);
  std::normal_distribution<double> near(0, 1);
  std::uniform_real_distribution<double> share(0, 1);
  RealBalanceOptions options;
  options.ground = StudBox{{-50, 150}, {260, 420}};
  options.body = StudBox{{-20, 50}, {120, 320}};
  const RealBalances found = balances_of(of, options);
  const auto within = [](const StudBox& box, Point p) {
    return Point{std::clamp(p.real(), box.low.real(), box.high.real()),
                 std::clamp(p.imag(), box.low.imag(), box.high.imag())};
  };
  const auto anywhere = [&](const StudBox& box) {
    return Point{box.low.real() + share(random) * (box.high.real() - box.low.real()),
                 box.low.imag() + share(random) * (box.high.imag() - box.low.imag())};
  };
  for (const auto& each : {found.two, found.one}) {
    ASSERT_TRUE(each);
    const double told = square_of(hand_under(of, each->springs));
    for (int i = 0; i < 300; ++i) {
      std::vector<Spring> others = each->springs;
      const bool is_near = i % 2 == 0;
      const double by = std::pow(10, 2 - 4 * share(random));
      for (Spring& spring : others) {
        const Point there{by * near(random), by * near(random)};
        spring.from.at = is_near ? within(*options.ground, spring.from.at + there) : anywhere(*options.ground);
        if (spring.to.on == LoadedBody::body)
          spring.to.at = is_near ? within(*options.body, spring.to.at + std::conj(there)) : anywhere(*options.body);
      }
      EXPECT_GE(best_near(of, others, 0.75), told * (1 - 1e-6)) << i;
    }
  }
}

// A given free length is that of all; a slack spring does nothing.
TEST(RealBalance, TakesAGivenFreeLength) {
  const LoadedCase of = tailgate();
  RealBalanceOptions options;
  options.free_length = 120;
  const RealBalances found = balances_of(of, options);
  EXPECT_EQ(found.free_share, 0);
  ASSERT_TRUE(found.one);
  for (Spring spring : found.one->springs) {
    EXPECT_EQ(coil_of(spring).free_length, 120);
    EXPECT_EQ(coil_of(spring).acts, CoilSpring::Acts::tension);
  }
  options.free_length = 1e5;
  EXPECT_FALSE(balances_of(of, options).one || balances_of(of, options).two);
}

// Studs that are given stay where they are.
TEST(RealBalance, LeavesGivenStuds) {
  const LoadedCase of = tailgate();
  const Point ground{180, 380}, body{60, 200};
  RealBalanceOptions options;
  options.ground = StudBox{ground, ground};
  options.body = StudBox{body, body};
  options.stud[0] = Point{70, 15};
  const RealBalances found = balances_of(of, options);
  ASSERT_TRUE(found.two && found.one);
  for (const auto& each : {found.two, found.one})
    for (const Spring& spring : each->springs) {
      EXPECT_EQ(spring.from.at, ground);
      if (spring.to.on == LoadedBody::input) {
        EXPECT_EQ(spring.to.at, (Point{70, 15}));
      }
      if (spring.to.on == LoadedBody::body) {
        EXPECT_EQ(spring.to.at, body);
      }
    }
}

TEST(RealBalance, SaysWhyThereIsNone) {
  LoadedCase of = tailgate();
  const auto code = [&] {
    const auto found = real_balance(of.loads, of.loads.cases.front(), of.bars, of.poses);
    return found.why_not ? found.why_not->code : "";
  };
  of.loads.gravity.reset();
  EXPECT_EQ(code(), "");
  EXPECT_FALSE(balances_of(of).one || balances_of(of).two);
  of = tailgate();
  of.loads.handle.reset();
  of.loads.drive = LoadDrive::input;
  EXPECT_EQ(code(), "no_handle");
  of = tailgate();
  std::swap(of.poses[1], of.poses[2]);
  EXPECT_EQ(code(), "no_travel");
  RealBalanceOptions options;
  options.free_share = 1.5;
  options.free_length = -1;
  options.ground = StudBox{{1, 0}, {0, 0}};
  std::string places;
  for (const Error& error : mistakes_in(options)) places += error.place + " ";
  EXPECT_EQ(places, "balance.free_share balance.free_length balance.ground ");
}

}  // namespace
}  // namespace linkwright::real_balance_test
