// What must hold for a rotation in any representation: one set of laws, instantiated for each.

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <random>
#include <string>
#include <vector>

#include "attitude/finite_rotation.hpp"
#include "linkwright/attitude/axis_angle.hpp"
#include "linkwright/attitude/euler_angles.hpp"
#include "linkwright/attitude/rodrigues.hpp"
#include "linkwright/attitude/rotation.hpp"
#include "linkwright/attitude/rotation_vector.hpp"
#include "linkwright/core/angle.hpp"
#include "support/attitude_case.hpp"
#include "support/draws.hpp"

namespace linkwright::rotation_law_test {
namespace {

using testing::random_direction;
using testing::random_rotation;
using testing::ulp;
using testing::ulps_between;

// A representation: how it is made of a quaternion, what rotation it is, and its inverse.

struct AsMatrix {
  static Rotation of(const UnitQuaternion& q) { return Rotation(q); }
  static Rotation rotation(const Rotation& c) { return c; }
  static Rotation inverse(const Rotation& c) { return c.inverse(); }
};

/// The matrix, then the quaternion of it: what every other representation of a matrix goes through.
struct AsQuaternionOfMatrix {
  static UnitQuaternion of(const UnitQuaternion& q) { return UnitQuaternion::of_matrix(q.matrix()); }
  static Rotation rotation(const UnitQuaternion& q) { return Rotation(q); }
  static UnitQuaternion inverse(const UnitQuaternion& q) { return q.inverse(); }
};

struct AsFiniteRotation {
  static FiniteRotation of(const UnitQuaternion& q) { return FiniteRotation(AxisAngle::of(Rotation(q))); }
  static Rotation rotation(const FiniteRotation& a) { return Rotation::from_matrix(a.matrix()).value(); }
  static FiniteRotation inverse(const FiniteRotation& a) { return a.inverse(); }
};

template <class Value>
struct As {
  static Value of(const UnitQuaternion& q) { return Value::of(Rotation(q)); }
  static Rotation rotation(const Value& v) { return v.rotation(); }
  static Value inverse(const Value& v) { return v.inverse(); }
};

struct AsRodrigues {
  static RodriguesVector of(const UnitQuaternion& q) { return RodriguesVector::of(Rotation(q)).value(); }
  static Rotation rotation(const RodriguesVector& g) { return g.rotation(); }
  static RodriguesVector inverse(const RodriguesVector& g) { return g.inverse(); }
};

struct AsShadow {
  static ModifiedRodriguesVector of(const UnitQuaternion& q) {
    const auto m = ModifiedRodriguesVector::of(Rotation(q));
    return m.shadow().value_or(m);
  }
  static Rotation rotation(const ModifiedRodriguesVector& m) { return m.rotation(); }
  static ModifiedRodriguesVector inverse(const ModifiedRodriguesVector& m) { return m.inverse(); }
};

/// What the laws see of a representation.
struct Representation {
  std::string name;
  std::function<Rotation(const UnitQuaternion&)> there_and_back, undone;
  bool has_half_turns = true;
};

template <class As>
Representation represented(std::string name, bool has_half_turns = true) {
  return {std::move(name), [](const UnitQuaternion& q) { return As::rotation(As::of(q)); },
          [](const UnitQuaternion& q) { return As::rotation(As::inverse(As::of(q))); }, has_half_turns};
}

Representation as_euler_angles(const EulerSequence& sequence) {
  const auto of = [=](const UnitQuaternion& q) { return euler_angles(Rotation(q), sequence).angles; };
  // The turns back, in reverse order: of the other kind under the reversed name, so of the same kind by that name.
  const auto back = EulerSequence::named(sequence.reversed().name(), sequence.turning()).value();
  return {sequence.name() + (sequence.turning() == Turning::intrinsic ? "_intrinsic" : "_extrinsic"),
          [=](const UnitQuaternion& q) { return of(q).rotation(); },
          [=](const UnitQuaternion& q) {
            const EulerAngles t = of(q);
            return EulerAngles{back, -t.third, -t.second, -t.first}.rotation();
          }};
}

std::vector<Representation> all_representations() {
  std::vector<Representation> all{
      represented<AsMatrix>("matrix"),
      represented<AsQuaternionOfMatrix>("quaternion"),
      represented<AsFiniteRotation>("finite_rotation"),
      represented<As<AxisAngle>>("axis_angle"),
      represented<As<RotationVector>>("rotation_vector"),
      represented<AsRodrigues>("rodrigues", false),
      represented<As<ModifiedRodriguesVector>>("modified_rodrigues"),
      represented<AsShadow>("shadow"),
  };
  for (const Turning turning : {Turning::intrinsic, Turning::extrinsic})
    for (const EulerSequence& sequence : EulerSequence::all(turning)) all.push_back(as_euler_angles(sequence));
  return all;
}

const int many = testing::draws(1'000'000);

class RotationLaw : public ::testing::TestWithParam<Representation> {
 protected:
  static Rotation there_and_back(const UnitQuaternion& q) { return GetParam().there_and_back(q); }
  static Rotation undone(const UnitQuaternion& q) { return GetParam().undone(q); }
  /// All rotations have all representations but one: half-turns have no Rodrigues vector.
  static bool has(const UnitQuaternion& q) {
    return GetParam().has_half_turns || RodriguesVector::of(Rotation(q)).has_value();
  }
  std::mt19937_64 random{20};
};

INSTANTIATE_TEST_SUITE_P(All, RotationLaw, ::testing::ValuesIn(all_representations()),
                         [](const auto& tested) { return tested.param.name; });

TEST_P(RotationLaw, RandomRotationsComeBack) {
  double worst = 0;
  UnitQuaternion of;
  for (int n = 0; n < many; ++n) {
    const UnitQuaternion q = random_rotation(random);
    const double error = ulps_between(there_and_back(q), Rotation(q));
    if (error > worst) worst = error, of = q;
  }
  EXPECT_LE(worst, 10) << "ulps, of q = " << of.w() << ", " << of.v().x << ", " << of.v().y << ", " << of.v().z;
  RecordProperty("worst_ulps", std::to_string(worst));
}

TEST_P(RotationLaw, TheIdentityIsNeutral) {
  EXPECT_EQ(there_and_back({}), Rotation());
  EXPECT_EQ(undone({}), Rotation());
}

TEST_P(RotationLaw, TheInverseUndoes) {
  for (int n = 0; n < 10'000; ++n) {
    const UnitQuaternion q = random_rotation(random);
    EXPECT_LE(ulps_between(there_and_back(q) * undone(q), Rotation()), 16);
    EXPECT_LE(ulps_between(undone(q), there_and_back(q).inverse()), 16);
  }
}

TEST_P(RotationLaw, ProductsAreThoseOfTheQuaternions) {
  for (int n = 0; n < 10'000; ++n) {
    const UnitQuaternion a = random_rotation(random), b = random_rotation(random), c = random_rotation(random);
    EXPECT_LE(ulps_between(there_and_back(a * b), there_and_back(a) * there_and_back(b)), 20);
    EXPECT_LE(ulps_between(there_and_back((a * b) * c), there_and_back(a * (b * c))), 24) << "associative";
  }
}

TEST_P(RotationLaw, LengthsAnglesAndHandednessStay) {
  for (int n = 0; n < 10'000; ++n) {
    const Rotation rotation = there_and_back(random_rotation(random));
    const Vector3 a = random_direction(random), b = random_direction(random);
    EXPECT_LE(ulps_between(norm(rotation.apply(a)), 1), 10);
    EXPECT_LE(ulps_between(dot(rotation.apply(a), rotation.apply(b)), dot(a, b)), 16);
    EXPECT_LE(ulps_between(cross(rotation.apply(a), rotation.apply(b)), rotation.apply(cross(a, b))), 16);
  }
}

TEST_P(RotationLaw, AlwaysARotationToRounding) {
  for (int n = 0; n < 10'000; ++n) EXPECT_TRUE(is_rotation(there_and_back(random_rotation(random)).matrix(), 20 * ulp));
}

TEST_P(RotationLaw, OppositeQuaternionsAreOneRotation) {
  for (int n = 0; n < 1000; ++n) {
    const UnitQuaternion q = random_rotation(random);
    EXPECT_EQ(there_and_back(q), there_and_back(-q));
  }
}

TEST_P(RotationLaw, SmallTurnsAreTheirFirstTwoOrders) {
  for (double angle = 0.1; angle > 1e-30; angle /= 2) {
    const Vector3 p = random_direction(random);
    const UnitQuaternion q = UnitQuaternion::of(std::cos(angle / 2), std::sin(angle / 2) * p).value();
    const Matrix3x3 k = angle * skew_matrix(p);
    const Matrix3x3 orders = Matrix3x3::identity() + k + 0.5 * (k * k);
    EXPECT_LE(frobenius_norm(there_and_back(q).matrix() - orders), angle * angle * angle + 20 * ulp) << angle;
  }
}

TEST_P(RotationLaw, HalfTurnsAndTheirNeighboursComeBack) {
  for (double exponent = 0; exponent < 20; exponent += 0.1)
    for (const double side : {1.0, -1.0, 0.0}) {
      const double half = pi / 2 + side * std::pow(10, -exponent) / 2;
      const Vector3 p = random_direction(random);
      const UnitQuaternion q = UnitQuaternion::of(side == 0 ? 1e-300 : std::cos(half), std::sin(half) * p).value();
      if (!has(q)) continue;
      EXPECT_LE(ulps_between(there_and_back(q), Rotation(q)), 12) << exponent << " " << side;
    }
}

TEST_P(RotationLaw, TurnsAboutTheAxesComeBack) {
  // Where many sequences are locked, and where half-turns have zeros.
  for (const Axis axis : {Axis::x, Axis::y, Axis::z})
    for (int eighths = -8; eighths <= 8; ++eighths) {
      const double half = eighths * pi / 8;
      const UnitQuaternion q = UnitQuaternion::of(std::cos(half), std::sin(half) * unit_vector(axis)).value();
      EXPECT_LE(ulps_between(there_and_back(q), Rotation(q)), 6) << eighths;
    }
}

TEST_P(RotationLaw, NeighboursStayNeighbours) {
  for (int n = 0; n < 10'000; ++n) {
    const UnitQuaternion q = random_rotation(random);
    const double step = std::pow(10, -1 - n % 15);
    const UnitQuaternion small = UnitQuaternion::of(1, step / 2 * random_direction(random)).value();
    EXPECT_LE(frobenius_norm(there_and_back(q * small).matrix() - there_and_back(q).matrix()), 1.5 * step + 30 * ulp);
  }
}

}  // namespace
}  // namespace linkwright::rotation_law_test
