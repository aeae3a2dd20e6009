#include "linkwright/files/number_text.hpp"

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <random>

#include "linkwright/core/angle.hpp"

namespace linkwright::number_text_test {
namespace {

std::uint64_t bits(double value) {
  std::uint64_t result = 0;
  std::memcpy(&result, &value, sizeof result);
  return result;
}

TEST(NumberText, ExactTextReadsBackBitIdentical) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 200'000; ++i) {
    std::uint64_t pattern = random();
    double value = 0;
    std::memcpy(&value, &pattern, sizeof value);
    if (!std::isfinite(value)) continue;
    EXPECT_EQ(bits(std::strtod(exact_text(value).c_str(), nullptr)), pattern) << exact_text(value);
  }
}

TEST(NumberText, ExactTextIsShortAndKeepsTheSignOfZero) {
  EXPECT_EQ(exact_text(0), "0");
  EXPECT_EQ(exact_text(-0.0), "-0.0");
  EXPECT_EQ(exact_text(0.1), "0.1");
  EXPECT_EQ(exact_text(-125), "-125");
  EXPECT_EQ(exact_text(1e22), "1e+22");
  EXPECT_EQ(exact_text(5e-324), "5e-324");
}

TEST(NumberText, RoundedTextHasNoNegativeZero) {
  EXPECT_EQ(rounded_text(-0.0004, 2), "0.00");
  EXPECT_EQ(rounded_text(-0.006, 2), "-0.01");
  EXPECT_EQ(rounded_text(-0.4, 0), "0");
  EXPECT_EQ(rounded_text(12.345678, 3), "12.346");
  EXPECT_EQ(rounded_text(1e300, 3), "1e+300");
  EXPECT_EQ(rounded_text(1, 99).size(), 17u);  // no more than 15 decimals
}

TEST(NumberText, SignificantTextDropsTrailingZeros) {
  EXPECT_EQ(significant_text(0.002114803, 3), "0.00211");
  EXPECT_EQ(significant_text(30, 6), "30");
  EXPECT_EQ(significant_text(133.25, 4), "133.2");
  EXPECT_EQ(significant_text(25144238, 4), "25144238");
  EXPECT_EQ(significant_text(-100000, 1), "-100000");
  EXPECT_EQ(significant_text(1.8e-14, 2), "1.8e-14");
  EXPECT_EQ(significant_text(0, 3), "0");
}

TEST(NumberText, RoundingBesideASizeIsZero) {
  EXPECT_EQ(significant_text(-3.7e-17, 4, 1), "0");
  EXPECT_EQ(significant_text(-3.7e-17, 4, 1e-6), "-3.7e-17");
}

TEST(NumberText, LengthsHaveFourOrFiveDigits) {
  EXPECT_EQ(length_decimals(250), 2);
  EXPECT_EQ(length_decimals(0.25), 5);
  EXPECT_EQ(length_decimals(2.5e6), 0);
  EXPECT_EQ(length_decimals(0), 2);
  EXPECT_EQ(length_decimals(std::numeric_limits<double>::infinity()), 2);
}

TEST(NumberText, DegreesForFilesReturnTheDegreesThatWereGiven) {
  std::mt19937_64 random(2);
  std::uniform_int_distribution<int> hundredths(-72'000, 72'000);
  for (int i = 0; i < 50'000; ++i) {
    const double given = hundredths(random) / 100.0;
    EXPECT_EQ(degrees_for_files(radians(given)), given);
  }
  EXPECT_EQ(bits(degrees_for_files(0)), bits(0));
}

TEST(NumberText, DegreesForFilesReadBackAsTheSameRadians) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> angle(-400, 400);
  for (int i = 0; i < 50'000; ++i) {
    const double stored = radians(angle(random));
    EXPECT_EQ(bits(radians(degrees_for_files(stored))), bits(stored));
  }
}

}  // namespace
}  // namespace linkwright::number_text_test
