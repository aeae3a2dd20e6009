#include "approximate/curve_least_squares.hpp"

#include <gtest/gtest.h>

#include "approximate/fit_hinges.hpp"
#include "support/random_four_bar.hpp"

namespace linkwright::curve_least_squares_test {
namespace {

struct Drawn {
  CouplerLinkage linkage;
  LoopState state;
  Point target;
};

Drawn drawn(testing::RandomFourBars& draw) {
  const LinkLengths lengths = draw.lengths();
  const FourBar bars = draw.four_bar(lengths);
  Drawn d;
  d.linkage = {bars.input_fixed, bars.output_fixed, lengths.input,
               lengths.coupler,  lengths.output,    {draw.uniform(-1, 1), draw.uniform(-1, 1)}};
  d.state = {(bars.input_moving - bars.input_fixed) / lengths.input,
             (bars.output_moving - bars.input_moving) / lengths.coupler};
  d.target = traced_point(d.linkage, d.state) + Point{draw.uniform(-0.02, 0.02), draw.uniform(-0.02, 0.02)};
  return d;
}

CouplerLinkage moved(CouplerLinkage l, std::size_t number, double by) {
  switch (number) {
    case 0:
    case 1:
      l.a0 += by * (number == 0 ? Point{1, 0} : Point{0, 1});
      break;
    case 2:
    case 3:
      l.b0 += by * (number == 2 ? Point{1, 0} : Point{0, 1});
      break;
    case 4:
      l.a += by;
      break;
    case 5:
      l.h += by;
      break;
    case 6:
      l.b += by;
      break;
    default:
      l.p += by * (number == 7 ? Point{1, 0} : Point{0, 1});
  }
  return l;
}

// The state slid to where its point is nearest.
LoopState nearest(const CouplerLinkage& linkage, LoopState state, Point target) {
  const std::vector<Point> points = {target};
  const std::vector<double> weights = {1};
  CurveStart start{linkage, {state}};
  EXPECT_TRUE(close_loop(linkage, start.states[0]));
  slide_to_nearest({points, weights, {}}, start);
  return start.states[0];
}

double sine_at(const CouplerLinkage& linkage, const LoopState& at) {
  return cross(at.u, LoopGradient(linkage, at).g) / linkage.b;
}

// Far enough from cusps and crossing strands that differences mean something.
bool is_plain(const Drawn& d) {
  const LoopGradient loop(d.linkage, d.state);
  const Point by_e = d.linkage.a * quarter_turn(d.state.e), by_u = quarter_turn(product(d.linkage.p, d.state.u));
  return std::sqrt(loop.square()) > 0.1 && std::abs(loop.f_e * by_u - loop.f_u * by_e) / std::sqrt(loop.square()) > 0.3;
}

TEST(CurveLeastSquares, RowIsTheDerivativeOfTheDistanceToThePath) {
  testing::RandomFourBars draw(1);
  int tried = 0;
  while (tried < 100) {
    Drawn d = drawn(draw);
    if (!is_plain(d)) continue;
    ++tried;
    d.state = nearest(d.linkage, d.state, d.target);
    const auto rows = distance_rows(d.linkage, d.state, d.target);
    const double distance = rows[0].residual;
    EXPECT_NEAR(std::abs(distance), std::abs(traced_point(d.linkage, d.state) - d.target), 1e-9);
    for (std::size_t i = 0; i < fit_dimensions; ++i) {
      constexpr double step = 1e-6;
      const auto at = [&](double by) {
        const CouplerLinkage there = moved(d.linkage, i, by);
        return std::abs(traced_point(there, nearest(there, d.state, d.target)) - d.target);
      };
      const double difference = (at(step) - at(-step)) / (2 * step);
      EXPECT_NEAR(std::copysign(1, distance) * rows[0].row[i], difference, 1e-4 * (1 + std::abs(difference))) << i;
    }
  }
}

TEST(CurveLeastSquares, SineRowIsItsDerivativeWhileTheStateSlides) {
  testing::RandomFourBars draw(2);
  int tried = 0;
  while (tried < 100) {
    Drawn d = drawn(draw);
    if (!is_plain(d)) continue;
    ++tried;
    d.target = traced_point(d.linkage, d.state);  // off the path the row leaves out how the path bends
    const FitRow row = transmission_sine_row(d.linkage, d.state, d.target);
    EXPECT_NEAR(row.residual, sine_at(d.linkage, d.state), 1e-12);
    for (std::size_t i = 0; i < fit_dimensions; ++i) {
      constexpr double step = 1e-6;
      const auto at = [&](double by) {
        const CouplerLinkage there = moved(d.linkage, i, by);
        return sine_at(there, nearest(there, d.state, d.target));
      };
      const double difference = (at(step) - at(-step)) / (2 * step);
      EXPECT_NEAR(row.row[i], difference, 1e-4 * (1 + std::abs(difference))) << i;
    }
  }
}

TEST(CurveLeastSquares, ReturnsToALinkageThatItWasTakenFrom) {
  testing::RandomFourBars draw(3);
  int back = 0;
  constexpr int draws = 50;
  for (int k = 0; k < draws; ++k) {
    Drawn d = drawn(draw);
    CurveStart start{d.linkage, {}};
    std::vector<Point> points;
    for (int j = 0; j < 14; ++j) {  // along the circuit, by a step of the state each
      const LoopGradient loop(d.linkage, d.state);
      const double by = 0.25 / std::sqrt(loop.square());
      d.state = turned(d.state, -by * loop.f_u, by * loop.f_e);
      ASSERT_TRUE(close_loop(d.linkage, d.state));
      points.push_back(traced_point(d.linkage, d.state));
      start.states.push_back(d.state);
    }
    for (std::size_t i = 0; i < fit_dimensions; ++i) start.linkage = moved(start.linkage, i, draw.uniform(-1e-3, 1e-3));
    bool closes = true;
    for (LoopState& state : start.states) closes = close_loop(start.linkage, state) && closes;
    if (!closes) continue;
    const std::vector<double> weights(points.size(), 1.0);
    const FitTask task{points, weights, {}};
    evaluate(task, start);
    const double before = start.cost();
    improve(task, start, 500);
    EXPECT_LE(start.cost(), before);
    if (start.squares < 1e-24 &&
        farthest_pivot(placed(start.linkage, start.states.back()).bars, placed(d.linkage, d.state).bars) < 1e-4)
      ++back;
  }
  EXPECT_GE(back, draws * 4 / 5);
}

TEST(CurveLeastSquares, LeavesWhatIsHeld) {
  testing::RandomFourBars draw(4);
  const Drawn d = drawn(draw);
  const std::vector<Point> points = {d.target + Point{0.1, 0}};
  const std::vector<double> weights = {1};
  CurveStart start{d.linkage, {d.state}};
  start.held = 0b0'0000'1010;
  evaluate({points, weights, {}}, start);
  improve({points, weights, {}}, start, 20);
  EXPECT_LT(start.squares, 1e-20);
  EXPECT_EQ(start.linkage.a0.imag(), d.linkage.a0.imag());
  EXPECT_EQ(start.linkage.b0.imag(), d.linkage.b0.imag());
  EXPECT_NE(start.linkage.a0.real(), d.linkage.a0.real());
}

TEST(CouplerLinkage, ItsCognateTracesTheSamePoint) {
  testing::RandomFourBars draw(5);
  for (int k = 0; k < 500; ++k) {
    const Drawn d = drawn(draw);
    const CouplerLinkage other = cognate(d.linkage);
    const LoopState there = cognate(d.linkage, d.state);
    const double size = std::max(d.linkage.lengths().longest(), other.lengths().longest());
    EXPECT_LT(std::abs(traced_point(other, there) - traced_point(d.linkage, d.state)), 1e-13 * size);
    EXPECT_LT(std::abs(LoopGradient(other, there).f), 1e-13 * size * size);
    const CouplerLinkage turned_round = swapped(d.linkage);
    const LoopState at = swapped(d.linkage, d.state);
    EXPECT_LT(std::abs(traced_point(turned_round, at) - traced_point(d.linkage, d.state)), 1e-13 * size);
    EXPECT_LT(std::abs(LoopGradient(turned_round, at).f), 1e-13 * size * size);
    EXPECT_LT(std::abs(third_pivot(turned_round) - third_pivot(d.linkage)), 1e-12 * size);
  }
}

}  // namespace
}  // namespace linkwright::curve_least_squares_test
