#include "linkwright/robust/tolerance_sampling.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

#define LINKWRIGHT_ISA isa_sampling_test
#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/position.hpp"
#include "robust/draw_lanes.hpp"
#include "robust/tolerance_error.hpp"
#include "straight_line/symmetric_lambda.hpp"
#include "support/draws.hpp"
#include "support/robust_cases.hpp"

namespace linkwright::tolerance_sampling_test {
namespace {

constexpr std::array simds = {Simd::baseline, Simd::avx2, Simd::avx512};

std::vector<FourBar> bars_of(const std::vector<TracingFourBar>& positions) {
  std::vector<FourBar> bars;
  for (const auto& linkage : positions) bars.push_back(linkage.bars);
  return bars;
}

PlanarOutput function_output() {
  const auto file = testing::robust_file("function");
  return angle_output(bars_of(testing::robust_positions(file["par"], file["phis"], file["sign"])));
}

PlanarOutput guidance_output(int cell) {
  const auto file = testing::robust_file("guidance");
  const auto& result = file["results"][static_cast<std::size_t>(cell)];
  return pose_output(testing::robust_positions(result["par"], result["phis"], result["sign"]), file["Lth"]);
}

PlanarOutput lambda_output(double crank_range, bool realigned) {
  const auto lambda = near_minimax_lambda(crank_range, 100);
  const TracingFourBar middle = lambda_linkage(*lambda, {}, false);
  const Configuration now = configuration_of(middle.bars);
  std::vector<TracingFourBar> stroke;
  double low = 0, high = 0;
  for (int k = -20; k <= 20; ++k) {
    const auto there =
        assemble(middle.bars.lengths(), now.input_angle + k * crank_range / 40, assembly_of(middle.bars));
    stroke.push_back(middle.moved_to(placed(middle.bars, there.value())));
    low = std::min(low, stroke.back().point.imag());
    high = std::max(high, stroke.back().point.imag());
  }
  return line_output(stroke, {{0, (low + high) / 2}, {1, 0}}, realigned);
}

// The known answers of Random123, its authors' library.
TEST(ToleranceSampling, DrawsTheNumbersOfPhilox) {
  struct Known {
    std::array<unsigned, 4> counter;
    std::array<unsigned, 2> key;
    std::array<unsigned, 4> answer;
  };
  constexpr unsigned ones = 0xffffffff;
  const std::array<Known, 3> all = {
      {{{0, 0, 0, 0}, {0, 0}, {0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}},
       {{ones, ones, ones, ones}, {ones, ones}, {0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}},
       {{0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344},
        {0xa4093822, 0x299f31d0},
        {0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}}}};
  for (const Known& known : all) {
    isa_sampling_test::draw::Words<1> counter{};
    for (std::size_t i = 0; i < 4; ++i) counter.word[i] = known.counter[i];
    const auto words = isa_sampling_test::draw::philox<1>(counter, known.key[0], known.key[1]);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(static_cast<unsigned>(words.word[i]), known.answer[i]);
  }
}

TEST(ToleranceSampling, HasALogarithm) {
  for (double a = 0x1p-33; a < 1; a *= 1.00037) {
    EXPECT_DOUBLE_EQ(isa_sampling_test::draw::logarithm<1>(a), std::log(a));
  }
  EXPECT_NEAR(isa_sampling_test::draw::logarithm<1>(1 - 0x1p-33), std::log1p(-0x1p-33), 1e-25);
}

// Moments and tails of the numbers themselves, by the distributions' own.
TEST(ToleranceSampling, DrawsTheDistributions) {
  const int n = testing::draws(200'000);
  for (const auto distribution :
       {ToleranceDistribution::normal, ToleranceDistribution::truncated_normal, ToleranceDistribution::uniform}) {
    Tolerances t{.length = LengthTolerances::all(1), .driver = 1};
    t.distribution = distribution;
    const double sigma = standard_deviation(distribution);
    const double fourth = distribution == ToleranceDistribution::normal    ? 3
                          : distribution == ToleranceDistribution::uniform ? 1.8
                                                                           : 2.8304;
    std::array<double, planar_parameters> sum{}, square{}, power{};
    std::array<std::array<double, planar_parameters>, planar_parameters> product{};
    double largest = 0;
    int beyond = 0;
    for (const auto& values : sampled_deviations(PlanarOutput{}, t, static_cast<std::size_t>(n))) {
      for (std::size_t i = 0; i < values.size(); ++i) {
        sum[i] += values[i];
        square[i] += values[i] * values[i];
        power[i] += std::pow(values[i], 4);
        largest = std::max(largest, std::abs(values[i]));
        beyond += std::abs(values[i]) > 2 * sigma;
        for (std::size_t j = 0; j < i; ++j) product[i][j] += values[i] * values[j];
      }
    }
    for (std::size_t i = 0; i < sum.size(); ++i) {
      EXPECT_NEAR(sum[i] / n, 0, 4.5 * sigma / std::sqrt(n)) << i;
      EXPECT_NEAR(std::sqrt(square[i] / n), sigma, 4.5 * sigma / std::sqrt(2.0 * n)) << i;
      EXPECT_NEAR(power[i] / n / std::pow(sigma, 4), fourth, 45 / std::sqrt(n)) << i;
      for (std::size_t j = 0; j < i; ++j)
        EXPECT_NEAR(product[i][j] / n / (sigma * sigma), 0, 4.5 / std::sqrt(n)) << i << " " << j;
    }
    if (distribution != ToleranceDistribution::normal) {
      EXPECT_LE(largest, 1);
      EXPECT_GT(largest, 0.999);
    } else {
      EXPECT_GT(largest, 1);
      EXPECT_NEAR(beyond / (10.0 * n), 0.0455003, 4.5 * std::sqrt(0.0455 / (10.0 * n)));
    }
  }
}

// To the bit, on every machine and in the page.
TEST(ToleranceSampling, DrawsTheSameNumbersForEver) {
  Tolerances t{.length = LengthTolerances::all(1), .driver = 1};
  const auto normal = sampled_deviations(PlanarOutput{}, t, 1000);
  EXPECT_EQ(normal[0][0], 0x1.03afd8c1df35ap-3);
  EXPECT_EQ(normal[17][4], -0x1.fe9bc6f2e8ea9p-3);
  EXPECT_EQ(normal[999][9], -0x1.70ca75d27ced4p-6);
  t.distribution = ToleranceDistribution::truncated_normal;
  const auto truncated = sampled_deviations(PlanarOutput{}, t, 1000);
  EXPECT_GT(std::abs(normal[7][5]), 1);
  EXPECT_EQ(truncated[7][5], -0x1.c98ba90cadab4p-3);
  t.distribution = ToleranceDistribution::uniform;
  t.clearance = 1;
  const auto uniform = sampled_deviations(PlanarOutput{}, t, 1000);
  EXPECT_EQ(uniform[0][0], 0x1.1c0c8ff8a5754p+1);
  EXPECT_EQ(uniform[17][4], 0x1.a102b9ap-5);
  EXPECT_EQ(uniform[999][9], 0x1.d4b7edb6p-1);
  // The others of a truncated sample stay as they were.
  EXPECT_EQ(truncated[7][4], normal[7][4]);
}

// Along a link, each of two pins evenly in its disc: variance c²/4, never beyond ± 2c.
TEST(ToleranceSampling, MovesPinsWithinTheirClearance) {
  const Tolerances t{.clearance = 0.3};
  const int n = testing::draws(100'000);
  std::array<double, 3> square{};
  double largest = 0;
  for (const auto& values : sampled_deviations(PlanarOutput{}, t, static_cast<std::size_t>(n))) {
    for (std::size_t i = 0; i < 3; ++i) {
      square[i] += values[i] * values[i];
      largest = std::max(largest, std::abs(values[i]));
    }
    for (std::size_t i = 3; i < planar_parameters; ++i) EXPECT_EQ(values[i], 0);
  }
  for (const double sum : square) EXPECT_NEAR(sum / n, 0.09 / 2, 0.002);
  EXPECT_LT(largest, 0.6);
  EXPECT_GT(largest, 0.5);
}

TEST(ToleranceSampling, HasTheFiguresOfTheFunctions) {
  const auto file = testing::robust_file("function");
  for (const auto& result : file["results"]) {
    Tolerances t{.length = LengthTolerances::all(0.005), .clearance = result["clearance"]};
    t.distribution = tolerance_distribution_named(result["dist"].get<std::string>()).value();
    t.limit = {ToleranceLimit::Kind::angle, result["limit"]};
    t.samples = 400'000;
    const SampledErrors errors = sample_errors(function_output(), t);
    EXPECT_EQ(errors.not_assembled, 0);
    for (std::size_t j = 0; j < errors.deviations.size(); ++j)
      EXPECT_NEAR(errors.deviations[j] / result["mc_sigma"][j].get<double>(), 1, 0.01) << j;
    ASSERT_TRUE(errors.yield);
    // Both are samples: 2.9 σ of the other's, which are the fewer.
    EXPECT_NEAR(errors.yield->share, result["P_mc"], 1.5 * result["P_mc_ci95"].get<double>());
    EXPECT_LT(errors.yield->low, errors.yield->share);
    EXPECT_GE(errors.yield->high, errors.yield->share);
    EXPECT_NEAR(errors.signal_to_noise(), result["SN_db"], 0.05);
    EXPECT_NEAR(errors.mean_plus_3_sigma() / result["mean_plus_3sigma"].get<double>(), 1, 0.01);
  }
}

TEST(ToleranceSampling, HasTheFiguresOfTheGuidanceCells) {
  const auto file = testing::robust_file("guidance");
  for (const int cell : {0, 1}) {
    const SampledErrors errors = sample_errors(guidance_output(cell), {.length = LengthTolerances::all(0.01)});
    const auto& result = file["results"][static_cast<std::size_t>(cell)];
    EXPECT_NEAR(errors.error / result["mc_sigma"].get<double>(), 1, 3 * result["mc_relative_ci95"].get<double>());
    EXPECT_FALSE(errors.yield);
  }
}

TEST(ToleranceSampling, HasTheFiguresOfLambdaLinkages) {
  const auto file = testing::robust_file("lambda");
  for (const auto& result : file["results"]) {
    const double range = radians(result["beta_deg"].get<double>());
    Tolerances t{.length = LengthTolerances::all(0.05)};
    t.limit = {ToleranceLimit::Kind::deviation, 0.15};
    const SampledErrors fixed = sample_errors(lambda_output(range, false), t);
    EXPECT_NEAR(fixed.mean / result["fixed_mean"].get<double>(), 1, 0.02);
    EXPECT_NEAR(fixed.mean_plus_3_sigma() / result["fixed_mean3s"].get<double>(), 1, 0.02);
    EXPECT_NEAR(fixed.yield->share, result["P_fixed_le_0p15"], 0.004);
    const SampledErrors realigned = sample_errors(lambda_output(range, true), t);
    EXPECT_NEAR(realigned.mean / result["realigned_mean"].get<double>(), 1, 0.02);
    EXPECT_NEAR(realigned.mean_plus_3_sigma() / result["realigned_mean3s"].get<double>(), 1, 0.03);
  }
}

// A linkage as it is made, by assemble(): the long way.
TracingFourBar made(const TracingFourBar& nominal, const std::vector<double>& off, bool& assembled) {
  const FourBar& bars = nominal.bars;
  const LinkLengths l = bars.lengths();
  const Point input_fixed = bars.input_fixed + Point{off[3], off[4]};
  const Point output_fixed = bars.output_fixed + Point{off[5], off[6]};
  const Point ground = output_fixed - input_fixed;
  const LinkLengths lengths{std::abs(ground), l.input + off[0], l.coupler + off[1], l.output + off[2]};
  const double turned = std::arg(bars.input_moving - bars.input_fixed) + off[9];
  const auto c = assemble(lengths, turned - std::arg(ground), assembly_of(bars));
  if (!c) {
    assembled = false;
    return nominal;
  }
  const Point input_moving = input_fixed + lengths.input * direction(turned);
  const Point along = direction(c->coupler_angle + std::arg(ground));
  const Point arm = (nominal.point - bars.input_moving) * l.coupler / (bars.output_moving - bars.input_moving);
  return {{input_fixed, input_moving, output_fixed, input_moving + lengths.coupler * along},
          input_moving + (arm + Point{off[7], off[8]}) * along};
}

double angle_of(Point from, Point to) { return std::abs(std::arg(to / from)); }

// In one position: what the output's kind asks for.
double error_in(const PlanarOutput& output, const TracingFourBar& nominal, const TracingFourBar& actual) {
  const FourBar &a = nominal.bars, &b = actual.bars;
  if (output.kind == PlanarOutput::Kind::line) return std::abs(output.line.to_line(actual.point).imag());
  if (output.kind == PlanarOutput::Kind::angle)
    return angle_of(a.output_moving - a.output_fixed, b.output_moving - b.output_fixed);
  const double turn = angle_of(a.output_moving - a.input_moving, b.output_moving - b.input_moving);
  return std::hypot(std::abs(actual.point - nominal.point), output.turning_length * turn);
}

struct SlowErrors {
  double mean = 0, standard_deviation = 0, yield = 0, error = 0;
  int not_assembled = 0;
};
SlowErrors slow_errors(const PlanarOutput& output, const std::vector<std::vector<double>>& samples, double limit) {
  SlowErrors errors;
  double sum = 0, squares = 0, all_squares = 0;
  int count = 0, good = 0;
  for (const std::vector<double>& off : samples) {
    double worst = 0, own_squares = 0;
    bool assembled = true;
    for (const TracingFourBar& nominal : output.positions) {
      const double error = error_in(output, nominal, made(nominal, off, assembled));
      worst = std::max(worst, error);
      own_squares += error * error;
    }
    if (!assembled) {
      ++errors.not_assembled;
      continue;
    }
    ++count;
    sum += worst;
    squares += worst * worst;
    all_squares += own_squares;
    good += worst <= limit;
  }
  errors.mean = sum / count;
  errors.standard_deviation = std::sqrt(squares / count - errors.mean * errors.mean);
  errors.yield = good / static_cast<double>(samples.size());
  errors.error = std::sqrt(all_squares / count / static_cast<double>(output.positions.size()));
  return errors;
}

// Fine tolerances, and such that many samples do not assemble.
TEST(ToleranceSampling, DoesWhatAssemblingEachSampleDoes) {
  for (const double size : {0.004, 0.3}) {
    int not_assembled = 0;
    Tolerances t{.length = {size, 2 * size, 1.5 * size, size, 0.5 * size}, .clearance = size / 2, .driver = size};
    t.samples = testing::draws(5000);
    const auto samples = sampled_deviations(PlanarOutput{}, t, static_cast<std::size_t>(t.samples));
    for (const PlanarOutput& output : {function_output(), guidance_output(0), guidance_output(1)}) {
      const double limit = output.kind == PlanarOutput::Kind::angle ? 3 * size : 10 * size;
      t.limit = {ToleranceLimit::Kind::deviation, limit};
      const SampledErrors errors = sample_errors(output, t);
      const SlowErrors slow = slow_errors(output, samples, limit);
      EXPECT_EQ(errors.not_assembled, slow.not_assembled);
      not_assembled += static_cast<int>(errors.not_assembled);
      EXPECT_NEAR(errors.mean, slow.mean, 1e-9 * slow.mean);
      EXPECT_NEAR(errors.standard_deviation, slow.standard_deviation, 1e-8 * slow.mean);
      EXPECT_NEAR(errors.error, slow.error, 1e-9 * slow.error);
      if (output.kind == PlanarOutput::Kind::angle) {
        EXPECT_EQ(errors.yield->share, slow.yield);
      }
    }
    EXPECT_EQ(not_assembled > 0, size > 0.1);
  }
}

// Nothing shared with the sampler: the standard's generator and distributions, pins as vectors in their holes.
TEST(ToleranceSampling, HasTheStatisticsOfAnotherSampler) {
  const double size = 0.01;
  const Tolerances t{.length = {size, 2 * size, size, size, 3 * size}, .clearance = size, .driver = size};
  std::mt19937_64 engine(1521);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> even(-1, 1);
  const auto radial = [&] {
    for (;;) {
      const double x = even(engine), y = even(engine);
      if (x * x + y * y <= 1) return size * x;
    }
  };
  std::vector<std::vector<double>> samples;
  const PlanarValues half = planar_half_tolerances(t);
  for (int k = 0; k < testing::draws(40'000); ++k) {
    std::vector<double> off(half.size());
    for (std::size_t i = 0; i < off.size(); ++i) off[i] = half[i] / 3 * normal(engine);
    for (std::size_t i = 0; i < 3; ++i) off[i] += radial() + radial();
    samples.push_back(off);
  }
  const double spread = 3 / std::sqrt(2.0 * static_cast<double>(samples.size()));
  for (const PlanarOutput& output : {function_output(), guidance_output(0), lambda_output(2, false)}) {
    const SampledErrors errors = sample_errors(output, t);
    const SlowErrors slow = slow_errors(output, samples, 0);
    EXPECT_NEAR(errors.mean / slow.mean, 1, 2 * spread);
    EXPECT_NEAR(errors.standard_deviation / slow.standard_deviation, 1, 2 * spread);
    if (output.kind != PlanarOutput::Kind::line) {
      EXPECT_NEAR(errors.error / slow.error, 1, spread);
    }
  }
}

TEST(ToleranceSampling, HasTheStandardDeviationsOfFirstOrderWhereTheyAreSmall) {
  const Tolerances t{.length = LengthTolerances::all(1e-4), .clearance = 1e-4, .driver = 1e-4};
  for (const PlanarOutput& output :
       {function_output(), guidance_output(0), guidance_output(1), lambda_output(2, false), lambda_output(2, true)}) {
    const SampledErrors errors = sample_errors(output, t);
    const auto linear = standard_deviations(sensitivities(output).value(), planar_variances(t));
    for (std::size_t j = 0; j < linear.size(); ++j) EXPECT_NEAR(errors.deviations[j] / linear[j], 1, 0.01) << j;
  }
}

// The best cell of the guidance map bears tolerances of 0.01 well, the median one does not, the second order of which
// is 1.5 %; and of less than a tenth of it both do.
TEST(ToleranceSampling, TellsWhereTheFirstOrderIsNotEnough) {
  const auto is_beyond = [](int cell, double size) {
    const Tolerances t{.length = LengthTolerances::all(size)};
    const PlanarOutput output = guidance_output(cell);
    const SampledErrors errors = sample_errors(output, t);
    EXPECT_NEAR(errors.error_interval() / errors.error, 0.00438, 1e-5);
    return errors.is_beyond_first_order(tolerance_error(sensitivities(output).value(), planar_variances(t)));
  };
  EXPECT_FALSE(is_beyond(0, 0.01));
  EXPECT_TRUE(is_beyond(1, 0.01));
  EXPECT_FALSE(is_beyond(0, 0.0005));
  EXPECT_FALSE(is_beyond(1, 0.0005));
}

bool same(const SampledErrors& a, const SampledErrors& b) {
  return a.not_assembled == b.not_assembled && a.deviations == b.deviations && a.error == b.error && a.mean == b.mean &&
         a.standard_deviation == b.standard_deviation && a.yield->share == b.yield->share;
}

TEST(ToleranceSampling, HasTheSameBitsWhoeverDraws) {
  for (const auto distribution :
       {ToleranceDistribution::normal, ToleranceDistribution::truncated_normal, ToleranceDistribution::uniform}) {
    Tolerances t{.length = LengthTolerances::all(0.3), .clearance = 0.1, .driver = 0.2};
    t.distribution = distribution;
    t.limit = {ToleranceLimit::Kind::position, 0.5};
    t.samples = 3001;
    t.seed = 0x1234'5678'9abc'def0;
    for (const PlanarOutput& output :
         {function_output(), guidance_output(0), lambda_output(2, false), lambda_output(2, true)}) {
      const SampledErrors one = sample_errors(output, t, 1, Simd::scalar);
      EXPECT_TRUE(std::isfinite(one.mean) && std::isfinite(one.error));
      for (const Simd simd : simds)
        if (is_supported(simd)) {
          EXPECT_TRUE(same(sample_errors(output, t, 1, simd), one)) << name(simd);
        }
      EXPECT_TRUE(same(sample_errors(output, t, 2), one));
      EXPECT_TRUE(same(ToleranceSampler(t).errors_of(output), one));
      Tolerances other = t;
      other.seed += 1;
      EXPECT_FALSE(same(sample_errors(output, other), one));
    }
  }
}

TEST(ToleranceSampling, YieldsLessWithCoarserTolerancesAndMoreWithWiderLimits) {
  for (const PlanarOutput& output : {function_output(), guidance_output(1), lambda_output(2, false)}) {
    double last = 1;
    for (const double size : {0.0, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1}) {
      Tolerances t{.length = LengthTolerances::all(size)};
      t.limit = {ToleranceLimit::Kind::deviation, 0.02};
      t.samples = 20'000;
      const double yield = sample_errors(output, t).yield->share;
      EXPECT_LE(yield, last);
      if (size == 0) {
        EXPECT_EQ(yield, 1);
      }
      last = yield;
      t.limit->value = 0.03;
      EXPECT_GE(sample_errors(output, t).yield->share, yield);
    }
    EXPECT_LT(last, 0.5);
  }
}

TEST(ToleranceSampling, JudgesPointAndAngleOfAPoseEachByItsLimit) {
  Tolerances t{.length = LengthTolerances::all(0.01)};
  t.samples = 20'000;
  const PlanarOutput output = guidance_output(0);
  t.limit = {ToleranceLimit::Kind::position, 0.02};
  const double of_point = sample_errors(output, t).yield->share;
  t.limit = {ToleranceLimit::Kind::angle, 0.005};
  const double of_angle = sample_errors(output, t).yield->share;
  int points = 0, angles = 0;
  for (const std::vector<double>& off : sampled_deviations(PlanarOutput{}, t, 20'000)) {
    double point = 0, angle = 0;
    bool assembled = true;
    for (const TracingFourBar& nominal : output.positions) {
      const TracingFourBar actual = made(nominal, off, assembled);
      point = std::max(point, std::abs(actual.point - nominal.point));
      angle = std::max(angle, angle_of(nominal.bars.output_moving - nominal.bars.input_moving,
                                       actual.bars.output_moving - actual.bars.input_moving));
    }
    points += point <= 0.02;
    angles += angle <= 0.005;
  }
  EXPECT_EQ(of_point, points / 20'000.0);
  EXPECT_EQ(of_angle, angles / 20'000.0);
  EXPECT_GT(of_point, 0.3);
  EXPECT_LT(of_point, 0.999);
  EXPECT_GT(of_angle, 0.3);
  EXPECT_LT(of_angle, 0.999);
}

// A share of 0.3 with 60 samples: its interval by the root of (p̂ − p)² = z² p (1 − p) / n.
TEST(ToleranceSampling, CountsSharesWithTheirIntervals) {
  const CountedShare share = counted_share(18, 60);
  EXPECT_DOUBLE_EQ(share.share, 0.3);
  for (const double end : {share.low, share.high})
    EXPECT_NEAR(std::pow(0.3 - end, 2), std::pow(1.959963984540054, 2) * end * (1 - end) / 60, 1e-15);
  EXPECT_EQ(counted_share(0, 60).low, 0);
  EXPECT_GT(counted_share(0, 60).high, 0.05);
  EXPECT_EQ(counted_share(60, 60).high, 1);
}

}  // namespace
}  // namespace linkwright::tolerance_sampling_test
