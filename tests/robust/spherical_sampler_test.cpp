#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/spherical_position.hpp"
#include "linkwright/robust/tolerance_report.hpp"
#include "linkwright/robust/tolerance_sampling.hpp"
#include "robust/tolerance_error.hpp"
#include "support/draws.hpp"

namespace linkwright::spherical_sampler_test {
namespace {

using Kind = SphericalOutput::Kind;

// A linkage by its arcs, and the angles of its input in the positions, counted from the ground's arc.
struct Built {
  LinkAngles angles;
  std::vector<double> inputs;
  Assembly assembly = Assembly::positive;

  [[nodiscard]] std::optional<SphericalFourBar> at(double input) const {
    const auto configuration = assemble(angles, input, assembly);
    if (!configuration) return std::nullopt;
    const auto on_arc = [](double angle) { return Vector3{std::sin(angle), 0, std::cos(angle)}; };
    const SphericalFourBar frame{on_arc(0), on_arc(angles.input), on_arc(angles.ground + angles.output),
                                 on_arc(angles.ground)};
    return placed(frame, *configuration);
  }
};

const Built built{{1.3, 0.5, 1.1, 0.9}, {0.3, 0.8, 1.7, 2.9}, Assembly::positive};
const Built other{{0.8, 1.9, 0.7, 2.0}, {-2.2, -1.8, -1.3}, Assembly::negative};

SphericalOutput output_of(const Built& from, Kind kind) {
  SphericalOutput output{kind, {}};
  for (const double input : from.inputs) output.positions.push_back(from.at(input).value());
  return output;
}

using Frame = std::array<Vector3, 3>;
Frame coupler_frame(const SphericalFourBar& bars) {
  const Vector3 normal = normalized(cross(bars.input_moving, bars.output_moving));
  return {bars.input_moving, normal, cross(bars.input_moving, normal)};
}

// By the trace and the skew part of the rotation Σ b aᵀ.
double angle_of(const Frame& a, const Frame& b) {
  double trace = 0;
  Vector3 skew{};
  for (std::size_t k = 0; k < 3; ++k) {
    trace += dot(a[k], b[k]);
    skew = skew + cross(a[k], b[k]);
  }
  return std::atan2(norm(skew), trace - 1);
}

struct SlowErrors {
  double mean = 0, error = 0;
  int not_assembled = 0, good = 0;
};
SlowErrors slow_errors(const Built& nominal, Kind kind, const std::vector<std::vector<double>>& samples, double limit) {
  SlowErrors errors;
  double sum = 0, squares = 0;
  for (const auto& off : samples) {
    const LinkAngles& a = nominal.angles;
    const Built made{
        {a.ground + off[3], a.input + off[0], a.coupler + off[1], a.output + off[2]}, {}, nominal.assembly};
    double worst = 0, own = 0;
    bool assembled = true;
    for (const double input : nominal.inputs) {
      const auto is = nominal.at(input), becomes = made.at(input + off[4]);
      assembled = assembled && becomes;
      if (!assembled) break;
      const double error =
          kind == Kind::orientation
              ? angle_of(coupler_frame(*is), coupler_frame(*becomes))
              : std::abs(wrap_signed(configuration_of(*is).output_angle - configuration_of(*becomes).output_angle));
      worst = std::max(worst, error);
      own += error * error;
    }
    errors.not_assembled += !assembled;
    if (!assembled) continue;
    sum += worst;
    squares += own;
    errors.good += worst <= limit;
  }
  const auto count = static_cast<double>(samples.size()) - errors.not_assembled;
  errors.mean = sum / count;
  errors.error = std::sqrt(squares / count / static_cast<double>(nominal.inputs.size()));
  return errors;
}

// Fine tolerances, and such that many samples do not assemble.
TEST(SphericalSampler, DoesWhatAssemblingEachSampleDoes) {
  int not_assembled = 0;
  for (const double size : {0.003, 0.3})
    for (const Built& from : {built, other})
      for (const Kind kind : {Kind::orientation, Kind::angle}) {
        Tolerances t{.driver = size / 2, .link_angle = size};
        t.samples = testing::draws(3000);
        t.limit = {ToleranceLimit::Kind::angle, 0.8 * size};
        const SphericalOutput output = output_of(from, kind);
        const SampledErrors errors = sample_errors(output, t);
        const auto deviations = sampled_deviations(output, t, static_cast<std::size_t>(t.samples));
        const SlowErrors slow = slow_errors(from, kind, deviations, t.limit->value);
        EXPECT_EQ(errors.not_assembled, slow.not_assembled);
        EXPECT_NEAR(errors.mean, slow.mean, 1e-9 * slow.mean);
        EXPECT_NEAR(errors.error, slow.error, 1e-9 * slow.error);
        EXPECT_EQ(errors.yield->share, slow.good / static_cast<double>(t.samples));
        EXPECT_GT(errors.yield->share, 0);
        EXPECT_LT(errors.yield->share, 1);
        EXPECT_TRUE(size > 0.1 || slow.not_assembled == 0);
        not_assembled += slow.not_assembled;
      }
  EXPECT_GT(not_assembled, testing::draws(3000) / 100);
}

// Nothing shared with the sampler: the standard's generator and distribution.
TEST(SphericalSampler, HasTheStatisticsOfAnotherSampler) {
  std::mt19937_64 engine(1531);
  std::normal_distribution<double> normal;
  const double size = 0.02;
  std::vector<std::vector<double>> samples;
  for (int k = 0; k < testing::draws(20'000); ++k) {
    std::vector<double> off(spherical_parameters);
    for (double& one : off) one = size / 3 * normal(engine);
    samples.push_back(off);
  }
  const double spread = 3 / std::sqrt(2.0 * static_cast<double>(samples.size()));
  for (const Kind kind : {Kind::orientation, Kind::angle}) {
    const SampledErrors errors = sample_errors(output_of(built, kind), {.driver = size, .link_angle = size});
    const SlowErrors slow = slow_errors(built, kind, samples, 1);
    EXPECT_NEAR(errors.mean / slow.mean, 1, 2 * spread);
    EXPECT_NEAR(errors.error / slow.error, 1, spread);
  }
}

TEST(SphericalSampler, HasTheStandardDeviationsOfFirstOrderWhereTheyAreSmall) {
  const Tolerances t{.driver = 1e-4, .link_angle = 1e-4};
  for (const Built& from : {built, other})
    for (const Kind kind : {Kind::orientation, Kind::angle}) {
      const auto report = tolerance_report(output_of(from, kind), t);
      ASSERT_TRUE(report);
      const auto linear =
          standard_deviations(sensitivities(LinkageOutput(output_of(from, kind))).value(), spherical_variances(t));
      for (std::size_t j = 0; j < linear.size(); ++j)
        EXPECT_NEAR(report->sampled.deviations[j] / linear[j], 1, 0.01) << j;
      EXPECT_FALSE(report->beyond_first_order);
      EXPECT_EQ(report->shares.size(), 5u);
    }
}

TEST(SphericalSampler, HasTheSameBitsWhoeverDraws) {
  Tolerances t{.driver = 0.2, .link_angle = 0.3};
  t.limit = {ToleranceLimit::Kind::angle, 0.2};
  t.samples = 3001;
  for (const Kind kind : {Kind::orientation, Kind::angle}) {
    const SphericalOutput output = output_of(built, kind);
    const SampledErrors one = sample_errors(output, t, 1, Simd::scalar);
    const auto same = [&](const SampledErrors& errors) {
      return errors.not_assembled == one.not_assembled && errors.deviations == one.deviations &&
             errors.mean == one.mean && errors.standard_deviation == one.standard_deviation &&
             errors.yield->share == one.yield->share;
    };
    for (const Simd simd : {Simd::baseline, Simd::avx2, Simd::avx512})
      if (is_supported(simd)) {
        EXPECT_TRUE(same(sample_errors(output, t, 1, simd))) << name(simd);
      }
    EXPECT_TRUE(same(sample_errors(output, t, 2)));
    EXPECT_TRUE(same(ToleranceSampler(output, t).errors_of(output)));
  }
}

}  // namespace
}  // namespace linkwright::spherical_sampler_test
