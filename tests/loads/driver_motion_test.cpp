#include "linkwright/loads/driver_motion.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <string>

namespace linkwright::driver_motion_test {
namespace {

using Law = DriverMotion::Law;

DriverMotion of_law(Law law, double duration = 2.5) {
  DriverMotion motion;
  motion.law = law;
  motion.duration = duration;
  return motion;
}
DriverMotion of_table(std::vector<DriverMotion::TimedShare> table) {
  DriverMotion motion;
  motion.law = Law::table;
  motion.table = std::move(table);
  return motion;
}
std::vector<DriverMotion> motions() {
  DriverMotion short_ramp = of_law(Law::trapezoid, 0.7);
  short_ramp.ramp = 0.1;
  return {of_law(Law::uniform),
          of_law(Law::trapezoid),
          short_ramp,
          of_law(Law::cycloid),
          of_law(Law::cycloid, 40),
          of_law(Law::polynomial_345),
          of_table({{0, 0}, {3, 1}}),
          of_table({{0, 0}, {0.4, 0.1}, {1, 0.55}, {1.3, 0.8}, {2, 1}})};
}

/// By five points, of functions without a jump near by.
template <class Of>
double derivative(const Of& of, double at, double step) {
  return (of(at - 2 * step) - 8 * of(at - step) + 8 * of(at + step) - of(at + 2 * step)) / (12 * step);
}

TEST(TimeLaw, HasTheDerivativesOfItsShare) {
  for (const DriverMotion& motion : motions()) {
    const TimeLaw law(motion);
    const double whole = law.duration(), step = 1e-3 * whole;
    for (int i = 1; i < 40; ++i) {
      const double time = (i + 0.37) / 41 * whole;
      const auto near_jump = [&](double jump) { return std::abs(time - jump * whole) < 3 * step; };
      if (motion.law == Law::trapezoid && (near_jump(motion.ramp) || near_jump(1 - motion.ramp))) continue;
      bool by_a_point = false;
      for (const auto& point : motion.table) by_a_point |= std::abs(time - point.time) < 3 * step;
      if (by_a_point) continue;
      const DriverState is = law.at_time(time);
      EXPECT_NEAR(is.speed, derivative([&](double t) { return law.at_time(t).share; }, time, step), 1e-8 / whole)
          << name(motion.law) << " at " << time;
      EXPECT_NEAR(is.acceleration, derivative([&](double t) { return law.at_time(t).speed; }, time, step),
                  1e-7 / (whole * whole))
          << name(motion.law) << " at " << time;
      EXPECT_GT(is.speed, 0);
    }
  }
}

TEST(TimeLaw, GoesFromRestToRestOnceThrough) {
  for (const DriverMotion& motion : motions()) {
    const TimeLaw law(motion);
    EXPECT_EQ(law.at_time(0).share, 0);
    EXPECT_NEAR(law.at_time(law.duration()).share, 1, 1e-15);
    if (motion.law == Law::uniform) continue;
    EXPECT_EQ(law.at_time(0).speed, 0) << name(motion.law);
    EXPECT_NEAR(law.at_time(law.duration()).speed, 0, 1e-15);
  }
}

TEST(TimeLaw, FindsTheTimeOfAShare) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0, 1);
  for (const DriverMotion& motion : motions()) {
    const TimeLaw law(motion);
    for (int i = 0; i < 500; ++i) {
      // Near the ends, where it hardly moves, and between.
      const double wanted = i % 2 == 0 ? share(random) : std::pow(10, -12 * share(random));
      const DriverState is = law.at_share(wanted);
      EXPECT_NEAR(law.at_time(is.time).share, wanted, 4e-16 + 1e-13 * wanted) << name(motion.law) << " " << wanted;
      EXPECT_NEAR(is.speed, law.at_time(is.time).speed, 1e-9 / law.duration());
    }
    EXPECT_EQ(law.at_share(0).time, 0);
    EXPECT_EQ(law.at_share(1).time, law.duration());
  }
}

TEST(TimeLaw, IsTheOneOfTheTextbooks) {
  const TimeLaw trapezoid(of_law(Law::trapezoid, 3)), cycloid(of_law(Law::cycloid, 1)),
      cubic(of_table({{0, 0}, {2, 1}}));
  // A third to speed up, a third at one speed, a third to slow down.
  EXPECT_NEAR(trapezoid.at_time(1.5).speed, 0.5, 1e-15);
  EXPECT_NEAR(trapezoid.at_time(0.5).acceleration, 0.5, 1e-15);
  EXPECT_NEAR(trapezoid.at_time(1).share, 0.25, 1e-15);
  EXPECT_NEAR(cycloid.at_time(0.5).speed, 2, 1e-15);
  EXPECT_NEAR(cycloid.at_time(0.25).acceleration, 2 * 3.14159265358979, 1e-13);
  EXPECT_NEAR(TimeLaw(of_law(Law::polynomial_345, 1)).at_time(0.5).speed, 1.875, 1e-15);
  for (const double u : {0.1, 0.5, 0.8}) EXPECT_NEAR(cubic.at_time(2 * u).share, u * u * (3 - 2 * u), 1e-15);
}

// A spline of the given shares, without a jump of the acceleration at any of them.
TEST(TimeLaw, PassesTheSharesOfATableSmoothly) {
  const auto table = motions().back().table;
  const TimeLaw law(of_table(table));
  for (std::size_t k = 1; k + 1 < table.size(); ++k) {
    EXPECT_NEAR(law.at_time(table[k].time).share, table[k].share, 1e-15);
    const double step = 1e-9;
    EXPECT_NEAR(law.at_time(table[k].time - step).acceleration, law.at_time(table[k].time + step).acceleration, 1e-6);
    EXPECT_NEAR(law.at_time(table[k].time - step).speed, law.at_time(table[k].time + step).speed, 1e-7);
  }
}

std::string told(const DriverMotion& motion) {
  std::string text;
  for (const Error& error : mistakes_in(motion)) text += error.code + " " + error.place + " ";
  return text;
}

TEST(DriverMotion, TellsMistakes) {
  for (const DriverMotion& motion : motions()) EXPECT_EQ(told(motion), "");
  EXPECT_EQ(told(of_law(Law::cycloid, 0)), "load_range loads.motion.duration_s ");
  EXPECT_EQ(told(of_law(Law::cycloid, NAN)), "load_range loads.motion.duration_s ");
  DriverMotion steep = of_law(Law::trapezoid);
  steep.ramp = 0.6;
  EXPECT_EQ(told(steep), "load_range loads.motion.ramp ");
  EXPECT_EQ(told(of_table({{0, 0}})), "motion_table loads.motion.table ");
  EXPECT_EQ(told(of_table({{0, 0.1}, {1, 1}})), "motion_ends loads.motion.table ");
  EXPECT_EQ(told(of_table({{0, 0}, {1, 0.9}})), "motion_ends loads.motion.table ");
  EXPECT_EQ(told(of_table({{0, 0}, {1, 0.5}, {1, 1}})), "motion_order loads.motion.table[2] ");
  EXPECT_EQ(told(of_table({{0, 0}, {1, NAN}, {2, 1}})), "motion_order loads.motion.table[1] ");
  EXPECT_EQ(told(of_table({{0, 0}, {1e9, 1}})), "load_range loads.motion.table ");
}

// A sudden start: the smooth curve through it swings, and is refused just where its speed falls below 0.
TEST(DriverMotion, RefusesTablesThatTurnBack) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> step(0.02, 1);
  int refused = 0, taken = 0;
  for (int i = 0; i < 400; ++i) {
    std::vector<DriverMotion::TimedShare> table = {{0, 0}};
    const int points = 2 + i % 5;
    for (int k = 0; k < points; ++k)
      table.push_back({table.back().time + step(random), table.back().share + step(random)});
    for (auto& point : table) point.share /= table.back().share;
    table.back().share = 1;
    const DriverMotion motion = of_table(table);
    const TimeLaw law(motion);
    double least = 1;
    constexpr int places = 4000;
    for (int k = 0; k <= places; ++k) least = std::min(least, law.at_time(law.duration() * k / places).speed);
    const bool is_refused = !mistakes_in(motion).empty();
    if (std::abs(least) > 1e-4) {
      EXPECT_EQ(is_refused, least < 0) << i;
    }
    ++(is_refused ? refused : taken);
  }
  EXPECT_GT(refused, 50);
  EXPECT_GT(taken, 50);
}

}  // namespace
}  // namespace linkwright::driver_motion_test
