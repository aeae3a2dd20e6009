#include "linkwright/sweep/sampling.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace linkwright {
namespace sampling_test {
namespace {

TEST(Sampling, HaltonsPointsAreRadicalInverses) {
  EXPECT_EQ(halton_coordinate(0, 0), 0);
  EXPECT_DOUBLE_EQ(halton_coordinate(6, 0), 3 / 8.0);    // 110 -> 0.011
  EXPECT_DOUBLE_EQ(halton_coordinate(5, 1), 7 / 9.0);    // 12 -> 0.21
  EXPECT_DOUBLE_EQ(halton_coordinate(7, 2), 11 / 25.0);  // 12 -> 0.21
  EXPECT_LT(halton_coordinate(~std::uint64_t{0}, 0), 1);
}

TEST(Sampling, SobolsPointsBeginAsInTheTables) {
  const PointSequence sequence(Sampling::sobol, 2, 0);
  using Point = std::vector<double>;
  EXPECT_EQ(sequence.point(0), (Point{0, 0}));
  EXPECT_EQ(sequence.point(1), (Point{0.5, 0.5}));
  EXPECT_EQ(sequence.point(2), (Point{0.75, 0.25}));
  EXPECT_EQ(sequence.point(3), (Point{0.25, 0.75}));
  EXPECT_EQ(sequence.point(4), (Point{0.375, 0.375}));
}

// Of the first 2^k points each elementary interval of one dimension has one: what a jump must not break.
TEST(Sampling, SobolsPointsAreEvenInEachDimensionWhereverOneStarts) {
  const PointSequence sequence(Sampling::sobol, 20, 0);
  constexpr std::uint64_t points = 256;
  for (std::size_t k = 0; k < 20; ++k) {
    std::vector<int> hits(points, 0);
    for (std::uint64_t i = 7 * points; i < 8 * points; ++i)
      ++hits[static_cast<std::size_t>(sequence.point(i)[k] * static_cast<double>(points))];
    EXPECT_EQ(std::count(hits.begin(), hits.end(), 1), static_cast<std::ptrdiff_t>(points)) << k;
  }
}

TEST(Sampling, AnyPointOfAnySequenceIsThereAtOnce) {
  for (const Sampling method : {Sampling::sobol, Sampling::halton, Sampling::random}) {
    const PointSequence sequence(method, max_coordinates, 5);
    const auto last = sequence.point((std::uint64_t{1} << 53) - 1);
    EXPECT_EQ(last, sequence.point((std::uint64_t{1} << 53) - 1));
    EXPECT_TRUE(std::all_of(last.begin(), last.end(), [](double x) { return x >= 0 && x < 1; })) << name(method);
  }
}

TEST(Sampling, ASeedMovesAllPointsByOneVector) {
  const PointSequence plain(Sampling::halton, 3, 0), moved(Sampling::halton, 3, 9);
  const auto shift = [&](std::uint64_t i, std::size_t k) {
    const double difference = moved.point(i)[k] - plain.point(i)[k];
    return difference < 0 ? difference + 1 : difference;
  };
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(shift(0, k), shift(1234, k), 1e-12);
  EXPECT_NE(plain.point(3), moved.point(3));
}

TEST(Sampling, RandomNumbersHaveMeanAndVarianceOfEvenOnes) {
  double sum = 0, squares = 0, products = 0;
  constexpr int count = 100'000;
  for (std::uint64_t i = 0; i < count; ++i) {
    const double x = random_coordinate(1, i, 0) - 0.5, y = random_coordinate(1, i, 1) - 0.5;
    sum += x;
    squares += x * x;
    products += x * y;
  }
  EXPECT_NEAR(sum / count, 0, 4 * std::sqrt(1.0 / 12 / count));
  EXPECT_NEAR(squares / count, 1.0 / 12, 1e-3);
  EXPECT_NEAR(products / count, 0, 1e-3);
  EXPECT_NE(random_coordinate(1, 0, 0), random_coordinate(2, 0, 0));
}

}  // namespace
}  // namespace sampling_test
}  // namespace linkwright
