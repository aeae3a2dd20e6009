#include "approximate/dyad_scan.hpp"

#include <gtest/gtest.h>

#include "approximate/dyad_scan_kernel.hpp"
#include "approximate/pair_rating.hpp"
#include "approximate/real_cubic.hpp"
#include "support/curve_case.hpp"
#include "support/random_four_bar.hpp"

namespace linkwright::dyad_scan_test {
namespace {

// Dyads at pivots of a random target, as a kernel takes them.
DyadBlock drawn_block(std::uint64_t seed) {
  testing::RandomFourBars draw(seed);
  DyadBlock block{};
  block.count = DyadBlock::size;
  block.points = 5 + draw.below(DyadBlock::most_points - 4);
  for (int j = 0; j < block.points; ++j) {
    const Point to{draw.uniform(-2, 2), draw.uniform(-2, 2)};
    block.distance[j] = std::abs(to);
    block.direction[j][0] = to.real() / std::abs(to);
    block.direction[j][1] = to.imag() / std::abs(to);
    block.weight[j] = draw.uniform(0, 2);
  }
  for (int k = 0; k < DyadBlock::size; ++k) {
    block.input[k] = draw.uniform(0.05, 3);
    block.arm[k] = draw.uniform(0.05, 3);
    block.assembly[k] = draw.below(1 << DyadBlock::most_points);
  }
  return block;
}

// The mean of the squared rows times a vector, by complex numbers.
std::array<double, 7> mean_times(const DyadBlock& block, int k, const std::array<double, 7>& v) {
  std::array<double, 7> sum{};
  double weights = 0;
  for (int j = 0; j < block.points; ++j) {
    const double a = block.input[k], r = block.arm[k], d = block.distance[j];
    const double side = (block.assembly[k] >> j & 1) != 0 ? -1 : 1;
    const double cosine = std::clamp((d * d + a * a - r * r) / (2 * d * a), -1.0, 1.0);
    const Point to = d * Point{block.direction[j][0], block.direction[j][1]};
    const Point e = to / d * Point{cosine, side * std::sqrt(1 - cosine * cosine)};
    const Point u = (to - a * e) / std::abs(to - a * e), difference = std::conj(e) * u;
    const std::array<double, 7> row = {difference.real(), -difference.imag(), e.real(), e.imag(),
                                       u.real(),          u.imag(),           1};
    double product = 0;
    for (std::size_t i = 0; i < 7; ++i) product += row[i] * v[i];
    for (std::size_t i = 0; i < 7; ++i) sum[i] += block.weight[j] * product * row[i];
    weights += block.weight[j];
  }
  for (double& number : sum) number /= weights;
  return sum;
}

TEST(DyadScanKernel, GivesEigenvectorsOfTheSmallestEigenvalues) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    DyadBlock block = drawn_block(seed);
    dyad_scan_kernel.for_simd(Simd::automatic)(block);
    for (int k = 0; k < DyadBlock::size; ++k) {
      std::array<double, 7> v;
      double length = 0, quotient = 0;
      for (std::size_t i = 0; i < 7; ++i) v[i] = block.vector[0][i][k];
      const auto image = mean_times(block, k, v);
      for (std::size_t i = 0; i < 7; ++i) length += v[i] * v[i];
      for (std::size_t i = 0; i < 7; ++i) quotient += v[i] * image[i];
      EXPECT_NEAR(length, 1, 1e-10);
      EXPECT_NEAR(quotient, block.value[0][k], 1e-12);
      EXPECT_LE(block.value[0][k], block.value[1][k]);
      testing::RandomFourBars draw(seed);
      for (int trial = 0; trial < 10; ++trial) {  // no vector has less, but for what three steps leave
        std::array<double, 7> w;
        double square = 0, form = 0;
        for (double& number : w) square += std::pow(number = draw.uniform(-1, 1), 2);
        const auto other = mean_times(block, k, w);
        for (std::size_t i = 0; i < 7; ++i) form += w[i] * other[i];
        EXPECT_GE(form / square, 0.8 * block.value[0][k] - 1e-12);
      }
    }
  }
}

TEST(DyadScanKernel, HasTheSameBitsOnAllInstructionSets) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    DyadBlock scalar = drawn_block(seed);
    dyad_scan_kernel.for_simd(Simd::scalar)(scalar);
    for (const Simd simd : {Simd::baseline, Simd::avx2, Simd::avx512}) {
      if (!is_supported(simd)) continue;
      DyadBlock other = drawn_block(seed);
      dyad_scan_kernel.for_simd(simd)(other);
      for (int k = 0; k < DyadBlock::size; ++k)
        for (std::size_t v = 0; v < 2; ++v) {
          EXPECT_EQ(scalar.value[v][k], other.value[v][k]);
          for (std::size_t i = 0; i < 7; ++i) EXPECT_EQ(scalar.vector[v][i][k], other.vector[v][i][k]);
        }
    }
  }
}

// A scan of a curve at a fixed pivot of the linkage that traced it finds that linkage, if the dyad is among those
// tried: here it is given.
TEST(SecondDyads, AreTheOtherDyadOfTheLinkageThatTracedTheCurve) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const TracingFourBar linkage = testing::drawn_linkage(seed, true);
    const CurveTarget target = testing::traced_target(linkage, true, DyadBlock::most_points);
    const Point pivot = linkage.bars.input_fixed;
    const LinkLengths lengths = linkage.bars.lengths();
    DyadBlock block{};
    block.count = 8;
    block.points = DyadBlock::most_points;
    const double arm = std::abs(linkage.point - linkage.bars.input_moving);
    const double turn = 2 * 3.14159265358979323846 / DyadBlock::most_points;
    for (int j = 0; j < block.points; ++j) {
      const Point to = target.points[static_cast<std::size_t>(j)] - pivot;
      const Point link = (linkage.bars.input_moving - pivot) * direction(turn * j);
      block.distance[j] = std::abs(to);
      block.direction[j][0] = to.real() / std::abs(to);
      block.direction[j][1] = to.imag() / std::abs(to);
      block.weight[j] = 1;
      for (int k = 0; k < 8; ++k) block.assembly[k] |= static_cast<long long>(cross(to, link) < 0) << j;
    }
    for (int k = 0; k < DyadBlock::size; ++k) {
      block.input[k] = lengths.input;
      block.arm[k] = arm;
    }
    dyad_scan_kernel.for_simd(Simd::automatic)(block);
    std::array<std::array<double, 7>, 2> vectors;
    for (std::size_t v = 0; v < 2; ++v)
      for (std::size_t i = 0; i < 7; ++i) vectors[v][i] = block.vector[v][i][0];
    const SecondDyads seconds = second_dyads(pivot, lengths.input, arm, vectors);
    double nearest = 1e9;
    for (std::size_t k = 0; k < seconds.count; ++k)
      nearest = std::min(nearest, std::abs(seconds.linkages[k].b0 - linkage.bars.output_fixed) +
                                      std::abs(seconds.linkages[k].h - lengths.coupler));
    EXPECT_LT(nearest, 1e-4) << seed;
  }
}

TEST(RealCubic, HasTheRootsItIsMadeOf) {
  testing::RandomFourBars draw(1);
  for (int k = 0; k < 2000; ++k) {
    std::array<double, 3> roots = {draw.uniform(-3, 3), draw.uniform(-3, 3), draw.uniform(-3, 3)};
    std::sort(roots.begin(), roots.end());
    if (std::min(roots[1] - roots[0], roots[2] - roots[1]) < 1e-3) continue;
    const auto [p, q, r] = roots;
    const double lead = draw.uniform(-2, 2);
    const RealRoots found =
        real_cubic_roots({-lead * p * q * r, lead * (p * q + q * r + r * p), -lead * (p + q + r), lead});
    ASSERT_EQ(found.count, 3);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found.values[i], roots[i], 1e-7);
    const double away = draw.uniform(0.1, 2);  // (t − p)((t − q)² + away)
    const RealRoots one = real_cubic_roots({-p * (q * q + away), q * q + away + 2 * p * q, -p - 2 * q, 1});
    ASSERT_EQ(one.count, 1);
    EXPECT_NEAR(one.values[0], p, 1e-7);
  }
}

TEST(RealCubic, OfLowerDegreeIsAnsweredToo) {
  EXPECT_EQ(real_cubic_roots({0, 0, 0, 0}).count, 0);
  EXPECT_EQ(real_cubic_roots({1, 0, 0, 0}).count, 0);
  ASSERT_EQ(real_cubic_roots({-6, 2, 0, 0}).count, 1);
  EXPECT_NEAR(real_cubic_roots({-6, 2, 0, 0}).values[0], 3, 1e-7);
}

}  // namespace
}  // namespace linkwright::dyad_scan_test
