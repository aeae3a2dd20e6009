#include "planar/five_point_four_bars.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <optional>
#include <random>
#include <vector>

#include "linkwright/core/angle.hpp"
#include "support/path_case.hpp"

namespace linkwright::five_point_four_bars_test {
namespace {

constexpr std::size_t size = FivePointSystem::size;
using Task = FivePointSystem::Task;
using Unknowns = ComplexVector<size>;

double in(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

Point random_number(std::mt19937_64& random) { return std::polar(in(random, 0.6, 1.4), in(random, -pi, pi)); }

Task random_task(std::mt19937_64& random) {
  Task task;
  for (Point* number : {&task.input, &task.input_conjugate, &task.output, &task.output_conjugate})
    *number = random_number(random);
  for (Point& place : task.place) place = random_number(random);
  for (Point& place : task.place_conjugate) place = random_number(random);
  return task;
}

double residual(const Unknowns& z, const Task& task) {
  const SystemAt<size> at = FivePointSystem{task, task}(z, 0);
  double largest = 0;
  for (std::size_t j = 0; j < size; ++j) {
    double sum = 0;
    for (std::size_t k = 0; k < size; ++k) sum += std::abs(at.by_unknown[j][k] * z[k]);
    largest = std::max(largest, std::abs(at.value[j]) / sum);
  }
  return largest;
}

bool add(std::vector<Unknowns>& known, const Unknowns& z) {
  for (const Unknowns& one : known) {
    Unknowns difference = one;
    for (std::size_t i = 0; i < size; ++i) difference[i] -= z[i];
    if (relative_step(difference, one) < 1e-6) return false;
  }
  known.push_back(z);
  return true;
}

std::optional<Unknowns> led_round(const Unknowns& z, const Task& base, const std::vector<Task>& way) {
  std::optional<Unknowns> at = z;
  Task from = base;
  for (std::size_t i = 0; i <= way.size() && at; ++i) {
    const Task to = i < way.size() ? way[i] : base;
    at = followed(*at, FivePointSystem{from, to});
    from = to;
  }
  if (at && polish(*at, FivePointSystem{base, base}, 1) > 1e-10) at.reset();
  return at;
}

void write_start(const FivePointStart& start, const std::vector<Unknowns>& solutions) {
  std::ofstream file(LINKWRIGHT_DATA_DIR "/../src/planar/five_point_start.cpp");
  const auto text = [](Point p) { return fmt::format("{{{}, {}}}", p.real(), p.imag()); };
  const auto list = [&](const std::array<Point, size>& numbers) {
    return fmt::format("{{{{{}, {}, {}, {}}}}}", text(numbers[0]), text(numbers[1]), text(numbers[2]),
                       text(numbers[3]));
  };
  const Task& task = start.task;
  file << "#include \"five_point_four_bars.hpp\"\n\n"
          "// Found by following solutions round closed ways (monodromy): tests/planar/five_point_four_bars_test.cpp "
          "does it\n"
          "// again, and writes this file.\n\nnamespace linkwright {\n\n"
          "const FivePointStart& five_point_start() {\n  static const FivePointStart start = {\n"
       << fmt::format("      {{{}, {}, {}, {},\n       {},\n       {}}},\n      {{{{\n", text(task.input),
                      text(task.input_conjugate), text(task.output), text(task.output_conjugate), list(task.place),
                      list(task.place_conjugate));
  for (const Unknowns& z : solutions) file << "          " << list(z) << ",\n";
  file << "      }}};\n  return start;\n}\n\n}  // namespace linkwright\n";
}

// One solution led round closed ways of tasks comes to all others, and to none that is not known: 36, as the counts of
// path.md say.
TEST(FivePointFourBars, WaysRoundLeadFromOneSolutionToAll) {
  const FivePointStart& start = five_point_start();
  std::mt19937_64 random(1);
  std::vector<Unknowns> found = {start.solutions.front()};
  int without_new = 0;
  for (int round = 0; round < 60 && without_new < 6; ++round) {
    const std::vector<Task> way = {random_task(random), random_task(random)};
    const std::size_t before = found.size();
    const std::vector<Unknowns> known = found;
    for (const Unknowns& z : known)
      if (const auto end = led_round(z, start.task, way)) add(found, *end);
    without_new = found.size() == before ? without_new + 1 : 0;
  }
  if (std::getenv("LINKWRIGHT_GENERATE")) write_start(start, found);
  EXPECT_EQ(found.size(), FivePointSystem::solutions);
  std::vector<Unknowns> stored;
  for (const Unknowns& z : start.solutions) {
    EXPECT_LT(residual(z, start.task), 1e-13);
    EXPECT_TRUE(add(stored, z));
    EXPECT_FALSE(add(found, z));
  }
}

TEST(FivePointFourBars, DerivativesAreThose) {
  std::mt19937_64 random(2);
  const FivePointSystem system{random_task(random), random_task(random)};
  const Unknowns z = {random_number(random), random_number(random), random_number(random), random_number(random)};
  const SystemAt<size> at = system(z, 0.4);
  constexpr double step = 1e-6;
  const auto expect_slope = [&](const SystemAt<size>& one, const SystemAt<size>& other, std::size_t j, Point slope) {
    EXPECT_LT(std::abs((one.value[j] - other.value[j]) / (2 * step) - slope), 1e-7 * (1 + std::abs(slope)));
  };
  for (std::size_t j = 0; j < size; ++j) {
    for (std::size_t k = 0; k < size; ++k) {
      Unknowns above = z, below = z;
      above[k] += step;
      below[k] -= step;
      expect_slope(system(above, 0.4), system(below, 0.4), j, at.by_unknown[j][k]);
    }
    expect_slope(system(z, 0.4 + step), system(z, 0.4 - step), j, at.by_t[j]);
  }
}

struct Given {
  std::array<Point, 5> places;
  Point input, output;
};

Given given_of(const PathTask& task) {
  Given given{{}, task.pivots.input.value(), task.pivots.output.value()};
  for (std::size_t j = 0; j < 5; ++j) given.places[j] = task.points[j].point;
  return given;
}

/// How far from closing a four-bar is with its point at a place, of the better elbow of its input link: of the length
/// of its output link.
double gap_at(const FourBar& bars, Point first, Point place) {
  const Point along = (bars.output_moving - bars.input_moving) / (first - bars.input_moving);
  const double link = std::abs(bars.input_moving - bars.input_fixed), arm = std::abs(first - bars.input_moving);
  const Point reach = place - bars.input_fixed;
  const double share = (std::norm(reach) + link * link - arm * arm) / (2 * std::norm(reach));
  const double across = std::sqrt(std::max(link * link / std::norm(reach) - share * share, 0.0));
  const double output = std::abs(bars.output_moving - bars.output_fixed);
  double least = std::numeric_limits<double>::infinity();
  for (const double side : {across, -across}) {
    const Point moving = bars.input_fixed + reach * Point{share, side};
    least = std::min(least, std::abs(std::abs(moving + along * (place - moving) - bars.output_fixed) / output - 1));
  }
  return least;
}

void expect_all_close(const Given& given, const FivePointFourBars& found) {
  EXPECT_EQ(found.real.size() % 2, 0u);
  for (const FivePointFourBar& one : found.real)
    for (const Point place : given.places) EXPECT_LT(gap_at(one.bars, given.places[0], place), 1e-8);
}

TEST(FivePointFourBars, FindsThePublishedOnes) {
  const testing::PathCase c = testing::path_case("five_points_fbrfive12");
  const Given given = given_of(c.task);
  const FivePointFourBars found = five_point_four_bars(given.places, given.input, given.output);
  EXPECT_EQ(found.ends, c.json.at("complex_solutions").get<int>());
  ASSERT_EQ(found.real.size(), c.json.at("real_moving_pivots").size());
  for (const auto& published : c.json.at("real_moving_pivots")) {
    const Point input{published.at("input")[0], published.at("input")[1]};
    const Point output{published.at("output")[0], published.at("output")[1]};
    double least = std::numeric_limits<double>::infinity();
    for (const FivePointFourBar& one : found.real)
      least = std::min(least, std::abs(one.bars.input_moving - input) + std::abs(one.bars.output_moving - output));
    EXPECT_LT(least, 1e-9) << "its task has twelve digits";
  }
  expect_all_close(given, found);
}

TEST(FivePointFourBars, FindsAllOfTheWalkingLeg) {
  const testing::PathCase c = testing::path_case("walking_leg_pivots_five");
  const Given given = given_of(c.task);
  const FivePointFourBars found = five_point_four_bars(given.places, given.input, given.output);
  EXPECT_EQ(found.ends, FivePointSystem::solutions);
  EXPECT_EQ(found.real.size(), c.json.at("linkages").size());
  for (const auto& linkage : c.json.at("linkages")) {
    const FourBar wanted = testing::bars_of(linkage);
    double least = std::numeric_limits<double>::infinity();
    for (const FivePointFourBar& one : found.real)
      least = std::min(least, std::abs(one.bars.input_moving - wanted.input_moving) +
                                  std::abs(one.bars.output_moving - wanted.output_moving));
    EXPECT_LT(least, 1e-9 * wanted.lengths().longest());
  }
  expect_all_close(given, found);
}

// Of tasks of no special kind all 36, and an even number of them real; wherever they lie and however large they are.
TEST(FivePointFourBars, FindsThirtySix) {
  std::mt19937_64 random(3);
  int real = 0;
  for (int i = 0; i < 25; ++i) {
    const double scale = std::pow(10, in(random, -3, 3));
    const Point shift = scale * Point{in(random, -5, 5), in(random, -5, 5)};
    const auto place = [&] { return shift + scale * Point{in(random, -1, 1), in(random, -1, 1)}; };
    const Given given{{place(), place(), place(), place(), place()}, place(), place()};
    const FivePointFourBars found = five_point_four_bars(given.places, given.input, given.output);
    EXPECT_EQ(found.ends, FivePointSystem::solutions) << i;
    expect_all_close(given, found);
    real += static_cast<int>(found.real.size());
  }
  EXPECT_GT(real, 50);
}

// The order of the places, and which link is called the input, change nothing.
TEST(FivePointFourBars, NamesDoNotMatter) {
  const Given given = given_of(testing::path_case("walking_leg_pivots_five").task);
  const FivePointFourBars one = five_point_four_bars(given.places, given.input, given.output);
  const FivePointFourBars exchanged = five_point_four_bars(given.places, given.output, given.input);
  ASSERT_EQ(exchanged.real.size(), one.real.size());
  std::array<Point, 5> other_order = given.places;
  std::reverse(other_order.begin(), other_order.end());
  EXPECT_EQ(five_point_four_bars(other_order, given.input, given.output).real.size(), one.real.size());
  for (const FivePointFourBar& each : one.real) {
    double least = std::numeric_limits<double>::infinity();
    for (const FivePointFourBar& other : exchanged.real)
      least = std::min(least, std::abs(other.bars.output_moving - each.bars.input_moving) +
                                  std::abs(other.bars.input_moving - each.bars.output_moving));
    EXPECT_LT(least, 1e-8 * each.bars.lengths().longest());
  }
}

}  // namespace
}  // namespace linkwright::five_point_four_bars_test
