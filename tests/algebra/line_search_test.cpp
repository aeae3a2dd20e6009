#include "linkwright/algebra/line_search.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace linkwright::line_search_test {
namespace {

struct Value {
  double score = 0;
};

template <class Function>
LineSearchResult<Value> top_of(const Function& f, double from, const LineSearchOptions& options) {
  return climb_line(LinePlace<Value>{from, {f(from)}}, options, [&](double x, const LinePlace<Value>&) {
    const double score = f(x);
    return std::isnan(score) ? std::nullopt : std::optional(Value{score});
  });
}

constexpr double none = std::numeric_limits<double>::quiet_NaN();

TEST(LineSearch, FindsSmoothTopsFastAndSharpOnesAsClose) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> place(-5, 5), slope(0.1, 10);
  for (int i = 0; i < 500; ++i) {
    const double top = place(random), up = slope(random), down = slope(random), from = top + 0.3 * place(random);
    const auto smooth = top_of([&](double x) { return -std::cosh(up * (x - top) / 10); }, from, {0.1, 1e-6});
    EXPECT_NEAR(smooth.top.at, top, 2e-6 + 1e-7 / up);
    EXPECT_LT(smooth.turns, 50);
    const auto sharp =
        top_of([&](double x) { return x < top ? up * (x - top) : -down * (x - top); }, from, {0.1, 1e-9});
    EXPECT_NEAR(sharp.top.at, top, 2e-9);
    EXPECT_EQ(sharp.end, SearchEnd::settled);
  }
}

TEST(LineSearch, TheEndOfWhatIsAllowedCanBeTheTop) {
  const auto rising = [](double x) { return x <= 1 ? x : none; };
  const auto found = top_of(rising, 0.2, {0.05, 1e-10});
  EXPECT_NEAR(found.top.at, 1, 1e-9);
  EXPECT_LE(found.top.at, 1);
}

TEST(LineSearch, NeverEndsWorseThanItBegan) {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> at(-3, 3);
  for (int i = 0; i < 300; ++i) {
    const double from = at(random), pitch = 3 * at(random);
    const auto wild = [&](double x) { return std::sin(pitch * x * x) > 0.9 ? none : std::sin(pitch * x) + 0.1 * x; };
    if (std::isnan(wild(from))) continue;
    const auto found = top_of(wild, from, {0.3, 1e-8});
    EXPECT_GE(found.top.found.score, wild(from));
    EXPECT_EQ(found.top.found.score, wild(found.top.at));
  }
}

// Rounding makes gains up: a search that believes in them creeps on for ever at the length of its shortest step.
TEST(LineSearch, NoiseBelowRoundingIsNoGain) {
  double creep = 1;
  const auto creeping = [&](double) { return creep = std::nextafter(creep, 2.0); };
  const auto found = top_of(creeping, 0, {1, 1e-10});
  EXPECT_LE(std::abs(found.top.at), 2);
  EXPECT_EQ(found.end, SearchEnd::settled);
}

TEST(LineSearch, EndsAfterItsTurnsWhateverTheFunction) {
  const auto endless = [](double x) { return x; };
  const auto found = top_of(endless, 0, {1e-10, 1e-20, 80});
  EXPECT_EQ(found.end, SearchEnd::evaluation_limit);
  EXPECT_LE(found.turns, 82);
  double better = 0;
  const auto always = [&](double) { return better += 1; };
  EXPECT_LE(top_of(always, 0, {1, 1e-12, 80}).turns, 82);
}

TEST(LineSearch, LooksNowhereElseOnAPlain) {
  const auto found = top_of([](double) { return 2.0; }, 0.5, {0.1, 1e-6});
  EXPECT_EQ(found.top.at, 0.5);
}

TEST(LineSearch, GoldenSectionFindsTheLeastBetweenTwoPlaces) {
  EXPECT_NEAR(least_between(-1, 4, 40, [](double x) { return std::abs(x - 1.25); }), 1.25, 1e-7);
  EXPECT_NEAR(least_between(0, 1, 40, [](double x) { return x; }), 0, 1e-7) << "an end";
}

}  // namespace
}  // namespace linkwright::line_search_test
