#include "linkwright/spherical/five_orientations.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>

#include "algebra/dense.hpp"
#include "linkwright/attitude/rotation_vector.hpp"
#include "linkwright/core/angle.hpp"
#include "support/attitude_case.hpp"
#include "support/draws.hpp"
#include "support/spherical_case.hpp"

namespace linkwright::five_orientations_test {
namespace {

using testing::off_line, testing::random_orientations, testing::vector_from;
using Orientations = std::vector<PrescribedOrientation>;

FiveOrientationDyads dyads_of(const Orientations& orientations) {
  return five_orientation_dyads(orientation_conditions(orientations));
}

int counted(const FiveOrientationDyads& found) {
  int sum = found.complex_roots;
  for (const auto& point : found.points) sum += point.multiplicity;
  return sum;
}

double apart(const SphericalDyad& a, const SphericalDyad& b) {
  return off_line(a.moving_axis, b.moving_axis) + off_line(a.fixed_axis, b.fixed_axis);
}

// How far the nearest of the points is.
double nearest(const FiveOrientationDyads& found, const SphericalDyad& wanted) {
  double best = 2;
  for (const auto& point : found.points) best = std::min(best, apart(point.dyad, wanted));
  return best;
}

TEST(FiveOrientations, HaveTheDyadsOfTheCases) {
  for (const char* name : {"ankle-orthosis-5", "folding-wing-5", "five-six-real"}) {
    const auto c = testing::spherical_case(name);
    const FiveOrientationDyads found = dyads_of(c.orientations);
    const auto& theirs = c.content["output"]["dyads"];
    EXPECT_EQ(found.points.size(), theirs.size()) << name;
    EXPECT_EQ(counted(found), 6) << name;
    for (const auto& dyad : theirs)
      EXPECT_LT(nearest(found, {vector_from(dyad["G"]), vector_from(dyad["W"])}), 1e-12) << name;
  }
}

// Of functions: the output link seen from the input link, R = Rz(−θ) Ry(α) Rz(ψ); the axes of the frame are always one
// of the dyads.
TEST(FiveOrientations, HaveTheLinkagesOfTheFunctionCases) {
  for (const char* name : {"function-five-real-5", "stapler-function-5"}) {
    const auto c = testing::spherical_case(name);
    const auto& input = c.content["input"];
    Orientations orientations;
    for (std::size_t j = 0; j < 5; ++j)
      orientations.push_back({UnitQuaternion::about({0, 0, 1}, -input["theta"][j].get<double>()) *
                                  UnitQuaternion::about({0, 1, 0}, input["frame_angle"].get<double>()) *
                                  UnitQuaternion::about({0, 0, 1}, input["psi"][j].get<double>()),
                              {}});
    const FiveOrientationDyads found = dyads_of(orientations);
    const auto& output = c.content["output"];
    EXPECT_EQ(found.points.size(), output["linkages"].size() + 1) << name;
    EXPECT_LT(nearest(found, {vector_from(output["trivial"]["W1"]), vector_from(output["trivial"]["W2"])}), 1e-11);
    const UnitQuaternion to_input_link = UnitQuaternion::about({0, 0, 1}, -input["theta"][0].get<double>());
    for (const auto& linkage : output["linkages"])
      EXPECT_LT(nearest(found, {to_input_link.apply(vector_from(linkage["W1_at_1"])),
                                to_input_link.apply(vector_from(linkage["W2_at_1"]))}),
                1e-11)
          << name;
  }
}

TEST(FiveOrientations, AreSixInAllAndMeetTheConditions) {
  std::mt19937_64 random(51);
  std::map<std::size_t, int> counts;
  for (int i = 0; i < 3000; ++i) {
    const Orientations orientations = random_orientations(random, 5);
    const FiveOrientationDyads found = dyads_of(orientations);
    ++counts[found.points.size()];
    EXPECT_EQ(counted(found), 6);
    EXPECT_EQ(found.points.size() % 2, 0u);
    EXPECT_FALSE(found.degeneracy);
    for (std::size_t k = 0; k < found.points.size(); ++k) {
      const auto& [dyad, multiplicity, residual, condition] = found.points[k];
      EXPECT_EQ(multiplicity, 1);
      EXPECT_LT(residual, 1e-14);
      EXPECT_GE(condition, 0.5);
      EXPECT_EQ(dyad.coordinate, static_cast<double>(k) + 0.5);
      EXPECT_GE(dot(dyad.fixed_axis, dyad.moving_axis), 0);
      EXPECT_TRUE(k == 0 || found.points[k - 1].dyad.angle() <= dyad.angle());
      for (std::size_t j = 0; j < k; ++j) EXPECT_GT(apart(found.points[j].dyad, dyad), 1e-6);
    }
  }
  // Shares that an independent program had: 78, 2168, 629, 125 of 3000.
  EXPECT_NEAR(counts[0], 78, 40);
  EXPECT_NEAR(counts[2], 2168, 100);
  EXPECT_NEAR(counts[4], 629, 100);
  EXPECT_NEAR(counts[6], 125, 50);
}

// Slow and by itself: Newton's method on the unit vectors from starts all over both spheres.
std::vector<SphericalDyad> by_newton(const Orientations& orientations, std::mt19937_64& random, int starts) {
  std::vector<Matrix3x3> d;
  const Matrix3x3 first = transposed(orientations.front().orientation.matrix());
  for (std::size_t j = 1; j < 5; ++j) d.push_back(orientations[j].orientation.matrix() * first - Matrix3x3::identity());
  std::vector<SphericalDyad> found;
  for (int start = 0; start < starts; ++start) {
    Vector3 g = testing::random_direction(random), w = testing::random_direction(random);
    double last = 1;
    for (int turn = 0; turn < 40 && last > 1e-13; ++turn) {
      SmallMatrix slope(6, 6);
      std::array<double, 6> value{};
      for (std::size_t k = 0; k < 4; ++k) {
        const Vector3 dw = d[k] * w, gd = g * d[k];
        for (std::size_t i = 0; i < 3; ++i) {
          slope(k, i) = dw[i];
          slope(k, i + 3) = gd[i];
        }
        value[k] = dot(g, dw);
      }
      for (std::size_t i = 0; i < 3; ++i) {
        slope(4, i) = g[i];
        slope(5, i + 3) = w[i];
      }
      const auto step = solve(slope, value).x;
      const Vector3 of_fixed{step[0], step[1], step[2]}, of_moving{step[3], step[4], step[5]};
      g = normalized(g - of_fixed);
      w = normalized(w - of_moving);
      last = std::hypot(norm(of_fixed), norm(of_moving));
    }
    const SphericalDyad dyad{g, w, 0};
    if (!(last < 1e-12)) continue;
    if (std::none_of(found.begin(), found.end(), [&](const auto& other) { return apart(other, dyad) < 1e-7; }))
      found.push_back(dyad);
  }
  return found;
}

TEST(FiveOrientations, AreAllThatNewtonFindsFromAnywhere) {
  std::mt19937_64 random(52);
  int missed_by_newton = 0;
  for (int i = 0; i < testing::draws(200); ++i) {
    const Orientations orientations = random_orientations(random, 5);
    const FiveOrientationDyads found = dyads_of(orientations);
    const auto theirs = by_newton(orientations, random, 300);
    for (const SphericalDyad& dyad : theirs) EXPECT_LT(nearest(found, dyad), 1e-9) << i;
    missed_by_newton += static_cast<int>(found.points.size()) - static_cast<int>(theirs.size());
  }
  EXPECT_LE(missed_by_newton, 2);
}

// Turned as a whole on either side, or given by antipodal quaternions, a task keeps its list.
TEST(FiveOrientations, KeepTheirOrderWhenTheTaskIsTurned) {
  std::mt19937_64 random(53);
  for (int i = 0; i < 200; ++i) {
    const Orientations orientations = random_orientations(random, 5);
    const UnitQuaternion left = testing::random_rotation(random), right = testing::random_rotation(random);
    Orientations moved;
    for (const auto& there : orientations) moved.push_back({-(left * there.orientation * right), {}});
    const FiveOrientationDyads found = dyads_of(orientations), other = dyads_of(moved);
    ASSERT_EQ(found.points.size(), other.points.size());
    for (std::size_t k = 0; k < found.points.size(); ++k) {
      const auto &a = found.points[k], &b = other.points[k];
      EXPECT_LT(apart({left.apply(a.dyad.fixed_axis), left.apply(a.dyad.moving_axis)}, b.dyad), 1e-14 * a.condition);
      EXPECT_NEAR(a.condition / b.condition, 1, 1e-9 * a.condition);
    }
  }
}

// Rows all of which lie on one side of a linkage that was there first.
TEST(FiveOrientations, HoldADyadThatTheTaskWasMadeFrom) {
  std::mt19937_64 random(54);
  std::uniform_real_distribution<double> angle(-3, 3);
  for (int i = 0; i < 200; ++i) {
    const Vector3 fixed = testing::random_direction(random), moving = testing::random_direction(random);
    Orientations orientations = {{UnitQuaternion(), {}}};
    while (orientations.size() < 5)
      orientations.push_back(
          {UnitQuaternion::about(fixed, angle(random)) * UnitQuaternion::about(moving, angle(random)), {}});
    const FiveOrientationDyads found = dyads_of(orientations);
    double best = 1;
    for (const auto& point : found.points) best = std::min(best, apart(point.dyad, {fixed, moving}) / point.condition);
    EXPECT_LT(best, 1e-14) << i;
  }
}

TEST(FiveOrientations, MoveNoFurtherThanTheirConditionSays) {
  std::mt19937_64 random(55);
  constexpr double nudge = 1e-9;
  double most = 0;
  for (int i = 0; i < 300; ++i) {
    const OrientationConditions conditions = orientation_conditions(random_orientations(random, 5));
    std::vector<UnitQuaternion> turns;
    for (const UnitQuaternion& turn : conditions.turns)
      turns.push_back(RotationVector::of(nudge * testing::random_direction(random))->quaternion() * turn);
    const FiveOrientationDyads before = five_orientation_dyads(conditions),
                               after = five_orientation_dyads(conditions_of_turns(turns));
    for (const auto& point : before.points)
      if (point.condition < 1e4) most = std::max(most, nearest(after, point.dyad) / (nudge * point.condition));
  }
  EXPECT_LT(most, 4);
  EXPECT_GT(most, 0.01);  // and no idle bound
}

// Turns by ε about given axes tend to six dyads of their own.
TEST(FiveOrientations, OfSmallTurnsAreTheirLimit) {
  std::mt19937_64 random(56);
  int tried = 0;
  for (int i = 0; i < 100; ++i) {
    std::array<Vector3, 4> axes;
    for (Vector3& axis : axes) axis = testing::random_direction(random);
    const auto of_turns_by = [&](double turn) {
      std::vector<UnitQuaternion> turns;
      for (std::size_t k = 0; k < 4; ++k)
        turns.push_back(RotationVector::of((1 + 0.5 * static_cast<double>(k)) * turn * axes[k])->quaternion());
      return five_orientation_dyads(conditions_of_turns(turns));
    };
    const double small = 1e-5;
    const FiveOrientationDyads limit = of_turns_by(small);
    // Where two of them are about to meet, the limit has them earlier or later.
    if (std::any_of(limit.points.begin(), limit.points.end(), [&](const auto& p) { return p.condition * small > 100; }))
      continue;
    ++tried;
    for (const double turn : {1e-3, 1e-6}) {
      const FiveOrientationDyads found = of_turns_by(turn);
      EXPECT_EQ(counted(found), 6);
      EXPECT_EQ(found.points.size(), limit.points.size()) << turn;
      for (const auto& point : found.points) {
        EXPECT_LT(point.residual, 1e-15);
        EXPECT_LT(nearest(limit, point.dyad), 10 * std::max(turn, small) * (1 + turn * point.condition)) << turn;
      }
    }
  }
  EXPECT_GT(tried, 80);
}

// Of R(t) = exp((t p₁ + t² p₂ / 2 + …)×) R: ω, ω′, ω″, ω‴ at t = 0 by the series ω = Σ (φ×)ᵐ φ′ / (m + 1)!.
std::vector<Vector3> derivatives_of(const std::vector<Vector3>& p) {
  std::vector<Vector3> found;
  if (!p.empty()) found.push_back(p[0]);
  if (p.size() > 1) found.push_back(p[1]);
  if (p.size() > 2) found.push_back(p[2] + 0.5 * cross(p[0], p[1]));
  if (p.size() > 3) found.push_back(p[3] + cross(p[0], p[2]) + 0.5 * cross(p[0], cross(p[0], p[1])));
  return found;
}

// A pair of orientations that meet is one with its angular velocity, three are one with its acceleration, too.
TEST(FiveOrientations, OfMixedPositionsAreTheLimitOfFiniteOnes) {
  std::mt19937_64 random(57);
  const double step = 1e-3;
  int tried = 0;
  for (const std::vector<int>& pattern : {std::vector{2, 1, 1, 1}, {2, 2, 1}, {3, 2}, {1, 4}, {5}})
    for (int i = 0; i < 20; ++i) {
      Orientations mixed, finite;
      for (const int multiplicity : pattern) {
        const UnitQuaternion there = testing::random_rotation(random);
        std::vector<Vector3> rate;
        for (int k = 1; k < multiplicity; ++k) rate.push_back(testing::random_direction(random));
        mixed.push_back({there, derivatives_of(rate)});
        for (int k = 0; k < multiplicity; ++k) {
          const double t = step * (k - 0.5 * (multiplicity - 1));
          Vector3 turn{};
          double factor = 1;
          for (std::size_t m = 0; m < rate.size(); ++m) {
            factor *= t / static_cast<double>(m + 1);
            turn = turn + factor * rate[m];
          }
          finite.push_back({RotationVector::of(turn)->quaternion() * there, {}});
        }
      }
      const FiveOrientationDyads limit = dyads_of(mixed), near = dyads_of(finite);
      EXPECT_EQ(counted(limit), 6);
      double worst = 0;
      for (const auto& point : limit.points) worst = std::max(worst, point.condition);
      if (worst > 100) continue;
      ++tried;
      EXPECT_EQ(limit.points.size(), near.points.size());
      for (const auto& point : limit.points) {
        EXPECT_LT(point.residual, 1e-14);
        EXPECT_LT(nearest(near, point.dyad), 10 * step * point.condition);
      }
    }
  EXPECT_GT(tried, 60);
}

// Between two tasks whose counts differ, two of the dyads meet.
TEST(FiveOrientations, ThatMeetAreOneOfMultiplicityTwo) {
  std::mt19937_64 random(58);
  int tried = 0, doubles = 0;
  for (int trial = 0; tried < 40 && trial < 400; ++trial) {
    const Orientations from = random_orientations(random, 5);
    const Vector3 turn = 2.0 * testing::random_direction(random);
    const auto at = [&](double s) {
      Orientations orientations = from;
      orientations[4].orientation = RotationVector::of(s * turn)->quaternion() * from[4].orientation;
      return dyads_of(orientations);
    };
    const int first = at(0).complex_roots;
    if (first == at(1).complex_roots) continue;
    double low = 0, high = 1;
    FiveOrientationDyads found;
    for (int step = 0; step < 60; ++step) {
      found = at((low + high) / 2);
      ASSERT_EQ(counted(found), 6);
      if (std::any_of(found.points.begin(), found.points.end(), [](const auto& p) { return p.multiplicity > 1; }))
        break;
      (found.complex_roots == first ? low : high) = (low + high) / 2;
    }
    ++tried;
    if (found.warnings.empty()) continue;
    ++doubles;
    ASSERT_EQ(found.warnings.size(), 1u);
    EXPECT_EQ(found.warnings[0].code, "double_point");
    const auto which = static_cast<std::size_t>(std::get<double>(found.warnings[0].values[0].value)) - 1;
    EXPECT_EQ(found.points[which].multiplicity, 2);
    EXPECT_LT(found.points[which].residual, 1e-11);
    EXPECT_GT(found.points[which].condition, 1e5);
  }
  EXPECT_EQ(tried, 40);
  EXPECT_EQ(doubles, 40);
}

TEST(FiveOrientations, OfOneAxisAreAllAxes) {
  Orientations orientations;
  for (const double angle : {0.0, 0.3, 0.8, 1.1, 2.0})
    orientations.push_back({UnitQuaternion::about(normalized(Vector3{1, -2, 2}), angle), {}});
  const FiveOrientationDyads found = dyads_of(orientations);
  ASSERT_TRUE(found.degeneracy);
  EXPECT_EQ(found.degeneracy->code, "common_axis");
  EXPECT_TRUE(found.points.empty());
  EXPECT_FALSE(found.curve);
}

TEST(FiveOrientations, OfARepeatedOrientationAreTheCurveOfTheOthers) {
  std::mt19937_64 random(59);
  for (const std::size_t repeated : {0u, 2u}) {
    Orientations orientations = random_orientations(random, 4);
    orientations.push_back(orientations[repeated]);
    const FiveOrientationDyads found = dyads_of(orientations);
    ASSERT_TRUE(found.degeneracy);
    EXPECT_EQ(found.degeneracy->code, "dependent_rows");
    ASSERT_TRUE(found.curve);
    const AxisCurve four(orientation_conditions({orientations.begin(), orientations.begin() + 4}));
    EXPECT_EQ(found.curve->kind(), four.kind());
    EXPECT_LT(off_line(four.dyad(*four.coordinate_of(found.curve->dyad(0.3).moving_axis)).moving_axis,
                       found.curve->dyad(0.3).moving_axis),
              1e-12);
  }
}

TEST(FiveOrientations, OfTwoRepeatedOrientationsAreAllAxes) {
  std::mt19937_64 random(60);
  Orientations orientations = random_orientations(random, 3);
  orientations.push_back(orientations[1]);
  orientations.push_back(orientations[2]);
  const FiveOrientationDyads found = dyads_of(orientations);
  ASSERT_TRUE(found.degeneracy);
  EXPECT_EQ(found.degeneracy->code, "every_axis");
}

// An axis of the body that has only two places is at equal angles to all axes of a plane.
TEST(FiveOrientations, OfAnAxisWithTwoPlacesAreMoreThanSeparateOnes) {
  std::mt19937_64 random(61);
  for (int i = 0; i < 20; ++i) {
    const Vector3 axis = testing::random_direction(random);
    const UnitQuaternion away = testing::random_rotation(random);
    const auto turn = [&](double angle) { return UnitQuaternion::about(axis, angle); };
    const FiveOrientationDyads found =
        dyads_of({{turn(0), {}}, {turn(0.7), {}}, {turn(1.9), {}}, {away * turn(0.4), {}}, {away * turn(-1.2), {}}});
    ASSERT_TRUE(found.degeneracy);
    EXPECT_EQ(found.degeneracy->code, "common_component");
    EXPECT_TRUE(found.points.empty());
  }
}

// Four turns about one axis leave the other orientation to choose: a curve of dyads.
TEST(FiveOrientations, OfFourAboutOneAxisAreACurve) {
  std::mt19937_64 random(62);
  Orientations orientations;
  for (const double angle : {0.0, 0.3, 0.8, 1.7})
    orientations.push_back({UnitQuaternion::about(normalized(Vector3{1, -2, 2}), angle), {}});
  orientations.push_back({testing::random_rotation(random), {}});
  const FiveOrientationDyads found = dyads_of(orientations);
  ASSERT_TRUE(found.degeneracy);
  EXPECT_EQ(found.degeneracy->code, "dependent_rows");
  ASSERT_TRUE(found.curve);
}

std::vector<FiveOrientations> random_tasks(std::mt19937_64& random, int count) {
  std::vector<FiveOrientations> tasks(static_cast<std::size_t>(count));
  for (FiveOrientations& task : tasks)
    for (UnitQuaternion& there : task) there = testing::random_rotation(random);
  return tasks;
}

FiveOrientationDyads carefully(const FiveOrientations& task) {
  Orientations orientations;
  for (const UnitQuaternion& there : task) orientations.push_back({there, {}});
  return dyads_of(orientations);
}

bool has_a_link_as_long(const FiveOrientationDyads& found, std::size_t k) {
  const auto cosine = [&](std::size_t i) {
    const SphericalDyad& dyad = found.points[i].dyad;
    return std::abs(dot(dyad.fixed_axis, dyad.moving_axis));
  };
  for (std::size_t i = 0; i < found.points.size(); ++i)
    if (i != k && std::abs(cosine(i) - cosine(k)) < 1e-12) return true;
  return false;
}

// Those of one task by the quick way are those by the careful one. Half turns alone have dyads in pairs whose axes have
// changed places: nothing orders two links of one length.
void compare(const SphericalDyads& quick, const FiveOrientations& task) {
  const FiveOrientationDyads found = carefully(task);
  ASSERT_EQ(quick.count, static_cast<int>(found.points.size()));
  EXPECT_EQ(quick.complex_roots, found.complex_roots);
  EXPECT_EQ(quick.degenerate, found.degeneracy.has_value());
  for (std::size_t k = 0; k < found.points.size(); ++k) {
    EXPECT_EQ(quick.dyads[k].coordinate, found.points[k].dyad.coordinate);
    EXPECT_EQ(quick.multiplicity[k], found.points[k].multiplicity);
    EXPECT_GE(dot(quick.dyads[k].fixed_axis, quick.dyads[k].moving_axis), 0);
    const double off =
        has_a_link_as_long(found, k) ? nearest(found, quick.dyads[k]) : apart(quick.dyads[k], found.points[k].dyad);
    EXPECT_LT(off, 2e-15 * found.points[k].condition);
  }
}

TEST(FiveOrientations, OfManyTasksAtOnceAreTheSame) {
  std::mt19937_64 random(63);
  std::vector<FiveOrientations> tasks =
      random_tasks(random, testing::draws(64'000) + 1);  // no multiple of a pack or a block
  const Vector3 axis = testing::random_direction(random);
  for (std::size_t i = 0; i < 5; ++i) tasks[1][i] = UnitQuaternion::about(axis, 0.3 * static_cast<double>(i));
  tasks[2][4] = tasks[2][0];
  tasks[3][4] = -tasks[3][2];
  for (std::size_t i = 1; i < 5; ++i)
    tasks[4][i] = RotationVector::of(1e-6 * testing::random_direction(random))->quaternion() * tasks[4][0];
  for (std::size_t i = 1; i < 5; ++i)
    tasks[5][i] = UnitQuaternion::about(testing::random_direction(random), pi) * tasks[5][0];
  std::vector<SphericalDyads> quick(tasks.size());
  five_orientation_dyads_of_all(tasks, quick);
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    compare(quick[i], tasks[i]);
    ASSERT_FALSE(HasFatalFailure()) << i;
  }
}

// A body that turns on in steps of a few degrees: conditions that nearly depend on each other.
TEST(FiveOrientations, OfManySweepsAtOnceAreTheSame) {
  std::mt19937_64 random(64);
  std::vector<FiveOrientations> tasks(2000);
  for (FiveOrientations& task : tasks) {
    const Orientations sweep = testing::random_sweep(random, 5);
    for (std::size_t i = 0; i < 5; ++i) task[i] = sweep[i].orientation;
  }
  std::vector<SphericalDyads> quick(tasks.size());
  five_orientation_dyads_of_all(tasks, quick);
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    compare(quick[i], tasks[i]);
    ASSERT_FALSE(HasFatalFailure()) << i;
  }
}

TEST(FiveOrientations, OfManyTasksAtOnceHaveTheSameBitsOnEveryMachine) {
  std::mt19937_64 random(65);
  const std::vector<FiveOrientations> tasks = random_tasks(random, 2000);
  std::vector<SphericalDyads> scalar(tasks.size()), other(tasks.size());
  five_orientation_dyads_of_all(tasks, scalar, Simd::scalar);
  for (const Simd simd : {Simd::baseline, Simd::avx2, Simd::avx512}) {
    if (!is_supported(simd)) continue;
    five_orientation_dyads_of_all(tasks, other, simd);
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      ASSERT_EQ(other[i].count, scalar[i].count) << name(simd) << i;
      EXPECT_EQ(other[i].dyads, scalar[i].dyads) << name(simd) << i;
    }
  }
}

// Around tasks with a double dyad the quick way gives up in time.
TEST(FiveOrientations, OfManyTasksAtOnceAreCountedWhereTwoMeet) {
  std::mt19937_64 random(66);
  for (int tried = 0; tried < 40;) {
    FiveOrientations from = random_tasks(random, 1).front();
    const Vector3 turn = 2.0 * testing::random_direction(random);
    const auto at = [&](double s) {
      FiveOrientations task = from;
      task[4] = RotationVector::of(s * turn)->quaternion() * from[4];
      return task;
    };
    double low = 0, high = 1;
    const int first = carefully(at(0)).complex_roots;
    if (first == carefully(at(1)).complex_roots) continue;
    ++tried;
    for (int step = 0; step < 50; ++step) {
      const FiveOrientations middle = at((low + high) / 2);
      SphericalDyads quick;
      five_orientation_dyads_of_all(std::span(&middle, 1), std::span(&quick, 1));
      const FiveOrientationDyads found = carefully(middle);
      EXPECT_EQ(quick.complex_roots, found.complex_roots);
      EXPECT_EQ(quick.count, static_cast<int>(found.points.size()));
      (found.complex_roots == first ? low : high) = (low + high) / 2;
    }
  }
}

TEST(FiveOrientations, ConditionIsTheNormOfTheInverseOfTheSlope) {
  std::mt19937_64 random(8);
  int compared = 0;
  for (int task = 0; task < 200; ++task) {
    const OrientationConditions conditions = orientation_conditions(random_orientations(random, 5));
    for (const SphericalDyadPoint& point : five_orientation_dyads(conditions).points) {
      const Vector3 g = point.dyad.fixed_axis, w = point.dyad.moving_axis;
      const auto across = [](Vector3 axis) {
        const Vector3 one = normalized(cross(axis, std::abs(axis.x) < 0.8 ? Vector3{1, 0, 0} : Vector3{0, 1, 0}));
        return std::array{one, cross(axis, one)};
      };
      DenseMatrix<4, 4> slope;
      for (std::size_t k = 0; k < 4; ++k) {
        const Matrix3x3& d = conditions.rows[k];
        slope[k] = {dot(across(g)[0], d * w), dot(across(g)[1], d * w), dot(g, d * across(w)[0]),
                    dot(g, d * across(w)[1])};
      }
      const double least = singular_values(slope).values.back();
      if (least < 1e-5) continue;
      EXPECT_NEAR(point.condition * least, 1, 1e-8);
      ++compared;
    }
  }
  EXPECT_GT(compared, 300);
}

}  // namespace
}  // namespace linkwright::five_orientations_test
