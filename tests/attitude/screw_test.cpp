#include "linkwright/attitude/screw.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>
#include <string>

#include "linkwright/core/angle.hpp"
#include "support/attitude_case.hpp"

namespace linkwright::screw_test {
namespace {

using testing::random_direction;
using testing::ulps_between;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Screw screw(const Displacement& t, double no_turn = tolerance::no_turn) {
  const Result<Screw> result = screw_of(t, no_turn);
  EXPECT_TRUE(result.ok());
  return result ? *result : Screw{};
}

Displacement displacement(const Screw& s) {
  const Result<Displacement> result = screw_displacement(s);
  EXPECT_TRUE(result.ok());
  return result ? *result : Displacement{};
}

/// Of a line at a distance of 1 or so from the origin, the point the nearest.
Screw random_screw(std::mt19937_64& random, double angle) {
  std::uniform_real_distribution<double> length(-2, 2);
  Screw s;
  s.kind = ScrewKind::general;
  s.direction = random_direction(random);
  s.point = length(random) * normalized(cross(s.direction, random_direction(random)));
  s.angle = angle;
  s.translation = length(random);
  return s;
}

/// 10^(−12 … 0) and π less that, in turns.
double random_angle(std::mt19937_64& random, int i) {
  std::uniform_real_distribution<double> exponent(-12, 0);
  const double small = std::pow(10, exponent(random));
  return i % 3 == 0 ? small : i % 3 == 1 ? pi - small : pi * small;
}

double ulps(const Displacement& a, const Displacement& b) {
  return std::max(ulps_between(a.rotation, b.rotation), ulps_between(a.translation, b.translation));
}

TEST(Screw, AgreesWithSixtyDigits) {
  const auto json = nlohmann::json::parse(std::ifstream(LINKWRIGHT_DATA_DIR "/attitude/screws.json"));
  const auto vector_of = [](const nlohmann::json& list, std::size_t from = 0) {
    return Vector3{list.at(from), list.at(from + 1), list.at(from + 2)};
  };
  double worst = 0;
  for (const auto& row : json.at("rows")) {
    const auto& q = row.at("quaternion");
    const Vector3 d = vector_of(row.at("translation"));
    const double size = norm(d);
    const Screw found = screw({Rotation(*UnitQuaternion::of(q.at(0), vector_of(q, 1))), d});
    // The point is known to an ulp of the translation, over the angle.
    const double of_point = size / std::sin(found.angle / 2);
    const double ulps = std::max({ulps_between(found.angle, row.at("angle").get<double>()),
                                  ulps_between(found.direction, vector_of(row.at("direction"))),
                                  ulps_between(found.translation / size, row.at("slide").get<double>() / size),
                                  ulps_between(found.point / of_point, vector_of(row.at("point")) / of_point)});
    EXPECT_LE(ulps, 4) << row.at("name");
    EXPECT_NEAR(*found.pitch(), row.at("pitch").get<double>(), 4 * testing::ulp * size / found.angle);
    worst = std::max(worst, ulps);
  }
  EXPECT_EQ(json.at("rows").size(), 86U);
  RecordProperty("worst_ulps", std::to_string(worst));
}

TEST(Screw, ComesBackFromItsDisplacement) {
  std::mt19937_64 random(1);
  double worst_angle = 0, worst_direction = 0, worst_translation = 0, worst_point = 0;
  for (int i = 0; i < 20000; ++i) {
    const Screw given = random_screw(random, random_angle(random, i));
    const Screw found = screw(displacement(given));
    ASSERT_EQ(found.kind, ScrewKind::general);
    worst_angle = std::max(worst_angle, ulps_between(found.angle, given.angle));
    worst_direction = std::max(worst_direction, ulps_between(found.direction, given.direction));
    worst_translation = std::max(worst_translation, ulps_between(found.translation, given.translation));
    // d carries an ulp of its size, 2 sin ½θ |c| + |s|: over 2 sin ½θ that is what the point can be known to.
    const double limit = 1 + std::fabs(given.translation) / (2 * std::sin(given.angle / 2));
    worst_point = std::max(worst_point, ulps_between(found.point, given.point) / limit);
  }
  EXPECT_LE(worst_angle, 4);
  EXPECT_LE(worst_direction, 4);
  EXPECT_LE(worst_translation, 8);
  EXPECT_LE(worst_point, 6);
  RecordProperty("ulps_of_angle", std::to_string(worst_angle));
  RecordProperty("ulps_of_direction", std::to_string(worst_direction));
  RecordProperty("ulps_of_translation", std::to_string(worst_translation));
  RecordProperty("ulps_of_point", std::to_string(worst_point));
}

TEST(Screw, MakesItsDisplacementAgain) {
  std::mt19937_64 random(2);
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const Result<Rotation> turn = Rotation::about_axis(random_direction(random), random_angle(random, i));
    const Displacement given{*turn, random_direction(random)};
    worst = std::max(worst, ulps(displacement(screw(given)), given));
  }
  EXPECT_LE(worst, 6);
  RecordProperty("worst_ulps", std::to_string(worst));
}

TEST(Screw, MovesPointsAsRodriguesFormulaSays) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 1000; ++i) {
    const Screw s = random_screw(random, 0.003 * i);
    const Vector3 before = random_direction(random), after = displacement(s).apply_to_point(before);
    // r₂ − r₁ = tan ½θ p × (r₂ + r₁ − 2c) + s p (Rodrigues, 1840).
    const Vector3 chord = std::tan(s.angle / 2) * cross(s.direction, after + before - 2.0 * s.point);
    EXPECT_LE(norm(after - before - chord - s.translation * s.direction), 2e-15 * (1 + std::tan(s.angle / 2)));
  }
}

TEST(Screw, SlidesThePointsOfItsAxisAlongIt) {
  std::mt19937_64 random(4);
  for (int i = 0; i < 1000; ++i) {
    const Displacement t{Rotation(testing::random_rotation(random)), random_direction(random)};
    const Screw s = screw(t);
    const Vector3 on_axis = s.point + 0.7 * s.direction;
    const double size = 1 + norm(s.point);
    EXPECT_LE(norm(t.apply_to_point(on_axis) - on_axis - s.translation * s.direction), 4e-15 * size);
    EXPECT_LE(std::fabs(dot(s.point, s.direction)), 1e-15 * size) << "the point is the nearest to the origin";
  }
}

TEST(Screw, GoesWithTheFrame) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 1000; ++i) {
    const Screw in_j = random_screw(random, 0.1 + 0.003 * i);
    const Displacement frame{Rotation(testing::random_rotation(random)), random_direction(random)};
    const Screw in_i = screw(frame * displacement(in_j) * frame.inverse());
    EXPECT_NEAR(in_i.angle, in_j.angle, 1e-14);
    EXPECT_NEAR(in_i.translation, in_j.translation, 1e-13);
    EXPECT_LE(norm(in_i.direction - frame.apply_to_direction(in_j.direction)), 2e-14);
    const Vector3 off_axis = frame.apply_to_point(in_j.point) - in_i.point;
    EXPECT_LE(norm(cross(off_axis, in_i.direction)), 1e-12);
  }
}

TEST(Screw, OfAPureTranslationHasItsDirectionAndNoPitch) {
  for (const Vector3 d : {Vector3{3, -4, 12}, Vector3{0, 0, -1e-200}, Vector3{1e200, 1e200, 0}}) {
    const Screw s = screw(Displacement::translated(d));
    EXPECT_EQ(s.kind, ScrewKind::pure_translation);
    EXPECT_EQ(s.angle, 0);
    EXPECT_EQ(s.point, Vector3{});
    EXPECT_EQ(s.pitch(), std::nullopt);
    EXPECT_LE(norm(s.translation * s.direction - d), 4e-16 * norm(d));
    EXPECT_EQ(displacement(s).rotation, Rotation());
    EXPECT_LE(norm(displacement(s).translation - d), 4e-16 * norm(d));
  }
}

TEST(Screw, OfTheIdentityIsNamedSo) {
  const Screw s = screw(Displacement());
  EXPECT_EQ(s.kind, ScrewKind::identity);
  EXPECT_EQ(s.angle, 0);
  EXPECT_EQ(s.translation, 0);
  EXPECT_EQ(s.direction, (Vector3{0, 0, 1}));
  EXPECT_EQ(s.pitch(), std::nullopt);
  EXPECT_EQ(displacement(s), Displacement());
}

TEST(Screw, OfAHalfTurnIsOneOfTwoThatAreTheSame) {
  std::mt19937_64 random(6);
  for (int i = 0; i < 1000; ++i) {
    const Screw given = random_screw(random, pi);
    const Screw found = screw(displacement(given));
    ASSERT_EQ(found.kind, ScrewKind::half_turn);
    EXPECT_LE(ulps_between(found.angle, pi), 4);
    const double sign = dot(found.direction, given.direction) < 0 ? -1 : 1;
    EXPECT_LE(ulps_between(sign * found.direction, given.direction), 4);
    EXPECT_LE(ulps_between(sign * found.translation, given.translation), 8);
    EXPECT_LE(ulps_between(found.point, given.point), 8);
    EXPECT_LE(ulps(displacement(found), displacement(given)), 8);
  }
  EXPECT_EQ(screw({Rotation::about_x(pi), {}}).kind, ScrewKind::half_turn);
  EXPECT_EQ(screw({Rotation::about_x(pi - 1e-14), {}}).kind, ScrewKind::general);
}

TEST(Screw, OfTwoHalfTurnsIsAlongTheirCommonNormal) {
  // Halfturns about two lines, at an angle of φ and a distance of h, make the screw of 2φ and 2h.
  std::mt19937_64 random(7);
  for (int i = 1; i < 1000; ++i) {
    const double phi = 0.0015 * i, h = 0.5 + 0.001 * i;
    const Result<Displacement> first = screw_displacement({1, 0, 0}, {}, pi, 0);
    const Result<Displacement> second = screw_displacement({std::cos(phi), std::sin(phi), 0}, {0, 0, h}, pi, 0);
    const Displacement frame{Rotation(testing::random_rotation(random)), random_direction(random)};
    const Screw s = screw(frame * *second * *first * frame.inverse());
    EXPECT_NEAR(s.angle, 2 * phi, 1e-14);
    EXPECT_NEAR(s.translation, 2 * h, 1e-12);
    EXPECT_LE(norm(s.direction - frame.apply_to_direction({0, 0, 1})), 1e-14 / phi);
  }
}

TEST(Screw, TurnsThatProductsLeaveBehindAreNone) {
  std::mt19937_64 random(8);
  for (int i = 0; i < 1000; ++i) {
    const Rotation turn(testing::random_rotation(random));
    const Displacement from{turn, random_direction(random)}, to{turn, random_direction(random)};
    const Screw s = screw(to * from.inverse());
    EXPECT_EQ(s.kind, ScrewKind::pure_translation);
    EXPECT_LE(norm(s.translation * s.direction - (to.translation - from.translation)), 2e-15);
  }
}

TEST(Screw, SmallTurnsThatAreExactAreKeptOnDemand) {
  for (const double angle : {1e-14, 1e-20, 1e-100, 1e-290}) {
    const Displacement t{Rotation::about_z(angle), {angle, 0, 0.5}};
    const Screw s = screw(t, 0);
    EXPECT_EQ(s.kind, ScrewKind::general);
    EXPECT_DOUBLE_EQ(s.angle, angle);
    EXPECT_LE(norm(s.point - Vector3{0.5 * angle, 1, 0}), 4e-16);
    EXPECT_EQ(*s.pitch(), 0.5 / angle);
  }
  EXPECT_EQ(screw({Rotation::about_z(1e-20), {1, 0, 0}}).kind, ScrewKind::pure_translation);
}

TEST(Screw, PointIsAsUncertainAsTheMatrixLeavesIt) {
  // An ulp more in one element of a matrix of size 1, as in a product: u |d| / θ² in the point, and no more.
  for (const double angle : {1e-1, 1e-2, 1e-4, 1e-6}) {
    const Displacement exact{*Rotation::about_axis({1, 2, 2}, angle), {0.3, -0.5, 0.8}};
    Matrix3x3 noisy = exact.rotation.matrix();
    noisy(0, 1) += 0x1p-52;
    const Result<Rotation> rotation = Rotation::from_matrix(noisy);
    ASSERT_TRUE(rotation.ok());
    const double error = norm(screw({*rotation, exact.translation}).point - screw(exact).point);
    EXPECT_LE(error, 4 * 0x1p-52 / (angle * angle)) << angle;
  }
}

TEST(Screw, TakesAnyLengthAndAnyNumberOfTurns) {
  const Result<Displacement> once = screw_displacement({0, 0, 1}, {1, 0, 0}, 0.5, 2);
  const Result<Displacement> long_direction = screw_displacement({0, 0, 1e300}, {1, 0, 7}, 0.5, 2);
  const Result<Displacement> again = screw_displacement({0, 0, 1}, {1, 0, 0}, 0.5 + 4 * pi, 2);
  const Result<Displacement> backwards = screw_displacement({0, 0, -1}, {1, 0, 0}, -0.5, -2);
  EXPECT_EQ(*once, *long_direction);
  EXPECT_LE(ulps(*once, *again), 16);
  EXPECT_EQ(*once, *backwards);
}

TEST(Screw, RefusesWhatIsNoScrew) {
  const auto code = [](const auto& result) { return result ? std::string("none") : result.errors().front().code; };
  EXPECT_EQ(code(screw_displacement({0, 0, 0}, {1, 2, 3}, 1, 1)), "zero_axis");
  EXPECT_EQ(code(screw_displacement({0, nan, 0}, {1, 2, 3}, 1, 1)), "not_finite");
  EXPECT_EQ(code(screw_displacement({0, 0, 1}, {1, infinity, 3}, 1, 1)), "not_finite");
  EXPECT_EQ(code(screw_displacement({0, 0, 1}, {1, 2, 3}, nan, 1)), "not_finite");
  EXPECT_EQ(code(screw_displacement({0, 0, 1}, {1, 2, 3}, 1, infinity)), "not_finite");
  EXPECT_EQ(code(screw_displacement({0, 0, 1}, {1.7e308, 1.7e308, 0}, pi, 0)), "not_finite") << "overflow";
  EXPECT_EQ(code(screw_of(Displacement::translated({nan, 0, 0}))), "not_finite");
  EXPECT_EQ(code(screw_of({Rotation::about_z(1e-300), {1e200, 0, 0}}, 0)), "axis_too_far") << "an axis beyond 1e308";
}

}  // namespace
}  // namespace linkwright::screw_test
