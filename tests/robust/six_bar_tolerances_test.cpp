#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>

#include "linkwright/core/angle.hpp"
#include "linkwright/robust/tolerance_report.hpp"
#include "linkwright/robust/tolerance_sampling.hpp"
#include "robust/six_bar_distances.hpp"
#include "robust/tolerance_error.hpp"
#include "support/central_difference.hpp"
#include "support/draws.hpp"
#include "support/random_six_bar.hpp"

namespace linkwright::six_bar_tolerances_test {
namespace {

using Joints = std::array<Point, SixBar::joint_count>;

// A six-bar by what it is made of, assembled by the angles of bodies 2 … 5: nothing of it knows of distances alone.
class Built {
 public:
  explicit Built(const SixBar& six_bar, const Pose& reference) : six_bar_(six_bar) {
    for (const SixBarLength& length : six_bar.lengths())
      if (length.body != 0) values.push_back(length.length);
    lengths_ = values.size();
    for (std::size_t j = 0; j < SixBar::joint_count; ++j)
      if (is_on_ground(six_bar.joints[j])) {
        values.push_back(six_bar.joints[j].point.real());
        values.push_back(six_bar.joints[j].point.imag());
      }
    const auto own = six_bar.joints_of(SixBar::guided);
    const Point from = six_bar.joints[own[0]].point, to = six_bar.joints[own[1]].point;
    const Point arm = (reference.origin - from) * std::conj(to - from) / std::abs(to - from);
    values.insert(values.end(), {arm.real(), arm.imag(), 0});
  }

  std::vector<double> values;  ///< in the order of the parameters; the driver's is its turn

  struct State {
    Joints joints{};
    Pose guided;  ///< its angle that of the body's first two hinges
  };
  // Near `turns`, the driver's turn added to theirs.
  [[nodiscard]] std::optional<State> near(const SixBarTurns& turns) const {
    std::array<double, 5> angle{};
    for (int body = 1; body < SixBar::bodies; ++body) {
      const auto own = six_bar_.joints_of(body);
      const Point base = six_bar_.joints[own[1]].point - six_bar_.joints[own[0]].point;
      angle[static_cast<std::size_t>(body) - 1] = std::arg(base * turns[static_cast<std::size_t>(body)]);
    }
    angle[0] += values.back();
    for (int step = 0; step < 40; ++step) {
      const auto open = opening(angle);
      double jacobian[4][5];
      for (std::size_t i = 0; i < 4; ++i) {
        auto changed = angle;
        changed[i + 1] += 1e-6;
        const auto more = opening(changed);
        changed[i + 1] -= 2e-6;
        const auto less = opening(changed);
        for (std::size_t k = 0; k < 4; ++k) jacobian[k][i] = (more[k] - less[k]) / 2e-6;
      }
      for (std::size_t k = 0; k < 4; ++k) jacobian[k][4] = open[k];
      const auto change = solved(jacobian);
      double size = 0;
      for (std::size_t i = 0; i < 4; ++i) {
        angle[i + 1] -= change[i];
        size = std::max(size, std::abs(change[i]));
      }
      if (!(size < 10)) return std::nullopt;
      if (size < 1e-14) break;
    }
    const auto open = opening(angle);
    if (std::any_of(open.begin(), open.end(), [](double o) { return !(std::abs(o) < 1e-11); })) return std::nullopt;
    return state(angle);
  }

 private:
  // The joints of a body in its own frame: the first at its origin, the second along x.
  [[nodiscard]] Point own_place(int body, std::size_t joint) const {
    const auto own = six_bar_.joints_of(body);
    if (joint == own[0]) return 0;
    if (joint == own[1]) return made_length(body, own[0], own[1]);
    const double base = made_length(body, own[0], own[1]), p = made_length(body, own[0], own[2]),
                 q = made_length(body, own[1], own[2]);
    const double x = (base * base + p * p - q * q) / (2 * base);
    const Point o = six_bar_.joints[own[0]].point, e = six_bar_.joints[own[1]].point - o,
                third = six_bar_.joints[own[2]].point - o;
    return {x, std::copysign(std::sqrt(p * p - x * x), cross(e, third))};
  }
  [[nodiscard]] double made_length(int body, std::size_t from, std::size_t to) const {
    std::size_t k = 0;
    for (const SixBarLength& length : six_bar_.lengths()) {
      if (length.body == 0) continue;
      if (length.body == body && length.joints == std::array{from, to}) return values[k];
      ++k;
    }
    throw std::runtime_error("no such length");
  }
  [[nodiscard]] Point ground(std::size_t joint) const {
    std::size_t at = lengths_;
    for (std::size_t j = 0; j < joint; ++j)
      if (is_on_ground(six_bar_.joints[j])) at += 2;
    return {values[at], values[at + 1]};
  }
  [[nodiscard]] Point on_body(int body, std::size_t joint, const Joints& joints,
                              const std::array<double, 5>& angle) const {
    constexpr std::array<std::size_t, 6> hanging = {0, SixBar::a, SixBar::b, SixBar::d, SixBar::c4, SixBar::c5};
    if (body == 0) return ground(joint);
    const auto b = static_cast<std::size_t>(body);
    return joints[hanging[b]] + (own_place(body, joint) - own_place(body, hanging[b])) * direction(angle[b - 1]);
  }
  [[nodiscard]] Joints hinges(const std::array<double, 5>& angle) const {
    Joints joints{};
    joints[SixBar::a] = ground(SixBar::a);
    joints[SixBar::b] = on_body(1, SixBar::b, joints, angle);
    joints[SixBar::d] = on_body(2, SixBar::d, joints, angle);
    for (const std::size_t c : {SixBar::c4, SixBar::c5}) {
      joints[c] = on_body(six_bar_.joints[c].bodies[0], c, joints, angle);
      joints[c + 1] = on_body(six_bar_.joints[c].bodies[1], c + 1, joints, angle);
    }
    return joints;
  }
  [[nodiscard]] std::array<double, 4> opening(const std::array<double, 5>& angle) const {
    const Joints joints = hinges(angle);
    std::array<double, 4> open{};
    for (const std::size_t k : {0, 1}) {
      const std::size_t z = k == 0 ? SixBar::z4 : SixBar::z5;
      const Point missed = on_body(six_bar_.joints[z].bodies[1], z, joints, angle) - joints[z];
      open[2 * k] = missed.real();
      open[2 * k + 1] = missed.imag();
    }
    return open;
  }
  [[nodiscard]] State state(const std::array<double, 5>& angle) const {
    const Joints joints = hinges(angle);
    const auto own = six_bar_.joints_of(SixBar::guided);
    const Point arm{values[values.size() - 3], values[values.size() - 2]};
    const Point from = on_body(SixBar::guided, own[0], joints, angle);
    return {joints, {from + arm * direction(angle[2]), angle[2]}};
  }
  // By Gauss's elimination.
  static std::array<double, 4> solved(double m[4][5]) {
    for (int i = 0; i < 4; ++i) {
      int pivot = i;
      for (int r = i; r < 4; ++r)
        if (std::abs(m[r][i]) > std::abs(m[pivot][i])) pivot = r;
      std::swap_ranges(m[i], m[i] + 5, m[pivot]);
      for (int r = 0; r < 4; ++r) {
        if (r == i) continue;
        const double factor = m[r][i] / m[i][i];
        for (int c = i; c < 5; ++c) m[r][c] -= factor * m[i][c];
      }
    }
    return {m[0][4] / m[0][0], m[1][4] / m[1][1], m[2][4] / m[2][2], m[3][4] / m[3][3]};
  }

  SixBar six_bar_;
  std::size_t lengths_ = 0;
};

SixBarOutput output_of(const testing::RandomSixBar& drawn, double turning_length) {
  SixBarOutput output{drawn.member.six_bar, {}, drawn.task.poses[0].pose, turning_length};
  for (const SixBarTurns& turns : drawn.member.turns)
    if (const auto exact = closed(output.six_bar, turns)) output.positions.push_back(*exact);
  return output;
}

// Links of one size, no dead point near, no flat triangle: no hinge moves by more than some times an error.
SixBarOutput well_made(std::mt19937_64& random, const SixBarRow& row, double turning_length) {
  for (;;) {
    SixBarOutput output = output_of(testing::random_six_bar(random, row), turning_length);
    if (output.positions.size() < 4) continue;
    const SixBarDistances distances(output.six_bar);
    double least = 1, most = 0;
    for (const SixBarLength& length : output.six_bar.lengths()) {
      least = std::min(least, length.length);
      most = std::max(most, length.length);
    }
    double largest = 0;
    for (const SixBarTurns& turns : output.positions)
      if (const auto inverse = distances.inverse(joints_at(output.six_bar, turns)))
        for (std::size_t row_of = 0; row_of < inverse->rows(); ++row_of)
          for (std::size_t column = 0; column < inverse->columns(); ++column)
            largest = std::max(largest, std::abs((*inverse)(row_of, column)));
    if (least > 0.3 && most < 12 && largest > 0 && largest < 5) return output;
  }
}

TEST(SixBarTolerances, SensitivitiesAreTheDerivativesOfThePose) {
  constexpr double step = 1e-4;
  std::mt19937_64 random(1541);
  std::set<SixBarTopology> seen;
  for (const SixBarRow& row : six_bar_rows())
    for (int n = 0; n < testing::draws(2); ++n) {
      const SixBarOutput output = well_made(random, row, 2);
      seen.insert(output.six_bar.topology().value());
      const auto matrix = sensitivities(LinkageOutput(output));
      ASSERT_TRUE(matrix);
      const Built built(output.six_bar, output.reference);
      ASSERT_EQ(matrix->parameters(), built.values.size());
      for (std::size_t j = 0; j < output.positions.size(); ++j)
        for (std::size_t i = 0; i < built.values.size(); ++i) {
          const auto at = [&](double change) {
            Built changed = built;
            changed.values[i] += change;
            return changed.near(output.positions[j]).value().guided;
          };
          const Pose now = at(0);
          const Point moved = testing::first_difference([&](double t) { return at(t).origin - now.origin; }, 0, step);
          const double turned =
              testing::first_difference([&](double t) { return wrap_signed(at(t).angle - now.angle); }, 0, step);
          EXPECT_NEAR(matrix->row(j, 0)[i], moved.real(), 1e-8) << i;
          EXPECT_NEAR(matrix->row(j, 1)[i], moved.imag(), 1e-8) << i;
          EXPECT_NEAR(matrix->row(j, 2)[i], 2 * turned, 1e-8) << i;
        }
      if (HasFailure()) FAIL() << text(row.added[0]) << " " << text(row.added[1]);
    }
  EXPECT_EQ(seen.size(), 4u);
}

struct SlowErrors {
  double mean = 0, error = 0;
  int not_assembled = 0, good_points = 0, good_angles = 0;
};
// Each sample by itself, its deviations made in steps.
SlowErrors slow_errors(const SixBarOutput& output, const std::vector<std::vector<double>>& samples, double limit) {
  SlowErrors errors;
  double sum = 0, squares = 0;
  const Built built(output.six_bar, output.reference);
  for (const auto& off : samples) {
    double worst = 0, own = 0, point = 0, angle = 0;
    bool assembled = true;
    for (const SixBarTurns& turns : output.positions) {
      const auto nominal = built.near(turns);
      Built made = built;
      for (std::size_t i = 0; i < off.size(); ++i) made.values[i] += off[i];
      const auto becomes = made.near(turns);
      assembled = assembled && becomes;
      if (!assembled) break;
      const double moved = std::abs(becomes->guided.origin - nominal->guided.origin);
      const double turned = std::abs(wrap_signed(becomes->guided.angle - nominal->guided.angle));
      const double error = std::hypot(moved, output.turning_length * turned);
      worst = std::max(worst, error);
      own += error * error;
      point = std::max(point, moved);
      angle = std::max(angle, turned);
    }
    errors.not_assembled += !assembled;
    if (!assembled) continue;
    sum += worst;
    squares += own;
    errors.good_points += point <= limit;
    errors.good_angles += angle <= limit;
  }
  const auto count = static_cast<double>(samples.size()) - errors.not_assembled;
  errors.mean = sum / count;
  errors.error = std::sqrt(squares / count / static_cast<double>(output.positions.size()));
  return errors;
}

TEST(SixBarTolerances, SamplesAreWhatAssemblingEachOfThemGives) {
  std::mt19937_64 random(1542);
  for (const SixBarRow& row : six_bar_rows()) {
    const SixBarOutput output = well_made(random, row, 1.5);
    Tolerances t{.length = {0.001, 0.002, 0.001, 0.002, 0.003}, .clearance = 0.0004, .driver = 0.001};
    t.samples = testing::draws(40);
    const auto samples = sampled_deviations(output, t, static_cast<std::size_t>(t.samples));
    t.limit = {ToleranceLimit::Kind::position, 0.003};
    const SampledErrors errors = sample_errors(output, t);
    const SlowErrors slow = slow_errors(output, samples, 0.003);
    EXPECT_EQ(errors.not_assembled, 0);
    EXPECT_NEAR(errors.mean, slow.mean, 1e-9 * slow.mean);
    EXPECT_NEAR(errors.error, slow.error, 1e-9 * slow.error);
    EXPECT_EQ(errors.yield->share, slow.good_points / static_cast<double>(t.samples));
    t.limit->kind = ToleranceLimit::Kind::angle;
    EXPECT_EQ(sample_errors(output, t).yield->share, slow.good_angles / static_cast<double>(t.samples));
  }
}

// The standard's generator and normal distribution.
TEST(SixBarTolerances, SamplesHaveTheStatisticsOfOthers) {
  std::mt19937_64 random(1543);
  std::normal_distribution<double> normal;
  const SixBarOutput output = well_made(random, six_bar_rows()[0], 1.5);
  const Tolerances t{.length = {0.002, 0.004, 0.002, 0.004, 0.005}, .driver = 0.001};
  const auto dimensions = made_dimensions(output, t);
  std::vector<std::vector<double>> samples(static_cast<std::size_t>(testing::draws(600)));
  for (auto& off : samples)
    for (const MadeDimension& made : dimensions) off.push_back(made.tolerance / 3 * normal(random));
  const SlowErrors slow = slow_errors(output, samples, 1);
  const SampledErrors errors = sample_errors(output, t);
  const double spread = 3 / std::sqrt(2.0 * static_cast<double>(samples.size()));
  EXPECT_NEAR(errors.mean / slow.mean, 1, 2 * spread);
  EXPECT_NEAR(errors.error / slow.error, 1, spread);
}

TEST(SixBarTolerances, SamplesHaveTheDeviationsOfFirstOrderWhereTheyAreSmall) {
  std::mt19937_64 random(1544);
  for (const SixBarRow& row : six_bar_rows()) {
    const SixBarOutput output = well_made(random, row, 1.5);
    Tolerances t{.length = LengthTolerances::all(1e-4), .clearance = 1e-4, .driver = 1e-4};
    t.samples = 20'000;
    t.cost_exponent = 1;
    const auto report = tolerance_report(output, t);
    ASSERT_TRUE(report);
    EXPECT_NEAR(report->sampled.error / report->error, 1, 0.015);
    EXPECT_GT(report->worst_case, report->error);
    EXPECT_EQ(report->shares.size(), 16u);
    double sum = 0;
    for (const ParameterShare& share : report->shares) sum += share.share;
    EXPECT_NEAR(sum, 1, 1e-14);
    ASSERT_TRUE(report->allocation);
  }
}

// Assembling each by itself may jump over a dead point to another branch, where the deviations do not lead.
TEST(SixBarTolerances, SamplesThatDoNotAssembleAreCounted) {
  std::mt19937_64 random(1545);
  int not_assembled = 0;
  for (int n = 0; n < 4; ++n) {
    const SixBarOutput output = well_made(random, six_bar_rows()[static_cast<std::size_t>(n)], 1);
    Tolerances t{.length = LengthTolerances::all(0.2)};
    t.samples = testing::draws(100);
    t.limit = {ToleranceLimit::Kind::position, 1e6};
    const SampledErrors errors = sample_errors(output, t);
    const SlowErrors slow =
        slow_errors(output, sampled_deviations(output, t, static_cast<std::size_t>(t.samples)), 1e6);
    EXPECT_NEAR(static_cast<double>(errors.not_assembled), slow.not_assembled, 0.15 * slow.not_assembled + 2);
    EXPECT_EQ(errors.yield->share, static_cast<double>(errors.assembled()) / t.samples);
    not_assembled += slow.not_assembled;
  }
  EXPECT_GT(not_assembled, testing::draws(100) / 4);
}

TEST(SixBarTolerances, AreTheSameOnAnyNumberOfThreads) {
  std::mt19937_64 random(1546);
  const SixBarOutput output = well_made(random, six_bar_rows()[2], 1);
  Tolerances t{.length = LengthTolerances::all(0.2), .clearance = 0.05, .driver = 0.05};
  t.samples = 1001;
  const SampledErrors one = sample_errors(output, t, 1), two = sample_errors(output, t, 2),
                      drawn = ToleranceSampler(output, t).errors_of(output);
  EXPECT_EQ(one.deviations, two.deviations);
  EXPECT_EQ(one.mean, two.mean);
  EXPECT_EQ(one.not_assembled, two.not_assembled);
  EXPECT_EQ(one.deviations, drawn.deviations);
}

TEST(SixBarTolerances, NameTheirDimensions) {
  std::mt19937_64 random(1547);
  const Tolerances t{.length = {1, 2, 3, 4, 5}, .driver = 0.1};
  for (const SixBarRow& row : six_bar_rows()) {
    const SixBarOutput output = output_of(testing::random_six_bar(random, row), 1);
    const auto dimensions = made_dimensions(output, t);
    ASSERT_EQ(dimensions.size(), 16u);
    EXPECT_EQ(dimensions[0].name, "length 1:a-b");
    EXPECT_EQ(dimensions[0].tolerance, 1);
    EXPECT_EQ(dimensions[0].pins, 2);
    for (const MadeDimension& made : dimensions) {
      const bool of_guided = made.name.starts_with("length 3:"), of_pivot = made.name.starts_with("center_"),
                 of_point = made.name.starts_with("point_");
      const double expected = of_guided ? 2 : of_pivot ? 4 : of_point ? 5 : made.tolerance;
      EXPECT_EQ(made.tolerance, expected) << made.name;
    }
    EXPECT_TRUE(dimensions.back().is_driver);
    const auto outputs =
        std::count_if(dimensions.begin(), dimensions.end(), [](const auto& made) { return made.tolerance == 3; });
    EXPECT_GE(outputs, 1);
  }
}

}  // namespace
}  // namespace linkwright::six_bar_tolerances_test
