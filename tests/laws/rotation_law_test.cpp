// What must hold for a rotation in any representation: one set of laws, instantiated for each.

#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <type_traits>

#include "linkwright/attitude/axis_angle.hpp"
#include "linkwright/attitude/euler_angles.hpp"
#include "linkwright/attitude/finite_rotation.hpp"
#include "linkwright/attitude/rodrigues.hpp"
#include "linkwright/attitude/rotation_properties.hpp"
#include "linkwright/attitude/rotation_vector.hpp"
#include "linkwright/core/angle.hpp"
#include "support/attitude_case.hpp"

namespace linkwright {
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

/// Number 0 … 11 intrinsic, 12 … 23 extrinsic.
template <std::size_t number>
struct AsEulerAngles {
  static EulerSequence sequence() {
    return EulerSequence::all(number < 12 ? Turning::intrinsic : Turning::extrinsic)[number % 12];
  }
  static EulerAngles of(const UnitQuaternion& q) { return euler_angles(Rotation(q), sequence()).angles; }
  static Rotation rotation(const EulerAngles& t) { return t.rotation(); }
  static EulerAngles inverse(const EulerAngles& t) {
    // The turns back, in reverse order: of the other kind under the reversed name, so of the same kind by that name.
    return {EulerSequence::named(t.sequence.reversed().name(), t.sequence.turning()).value(), -t.third, -t.second,
            -t.first};
  }
};

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr int many = 100'000;
#else
constexpr int many = 1'000'000;
#endif

template <class Representation>
class RotationLaw : public ::testing::Test {
 protected:
  static Rotation there_and_back(const UnitQuaternion& q) { return Representation::rotation(Representation::of(q)); }
  static Rotation undone(const UnitQuaternion& q) {
    return Representation::rotation(Representation::inverse(Representation::of(q)));
  }
  /// All rotations have all representations but one: half-turns have no Rodrigues vector.
  static bool has(const UnitQuaternion& q) {
    return !std::is_same_v<Representation, AsRodrigues> || RodriguesVector::of(Rotation(q)).has_value();
  }
  std::mt19937_64 random{20};
};

using Representations =
    ::testing::Types<AsMatrix, AsQuaternionOfMatrix, AsFiniteRotation, As<AxisAngle>, As<RotationVector>, AsRodrigues,
                     As<ModifiedRodriguesVector>, AsShadow, AsEulerAngles<0>, AsEulerAngles<1>, AsEulerAngles<2>,
                     AsEulerAngles<3>, AsEulerAngles<4>, AsEulerAngles<5>, AsEulerAngles<6>, AsEulerAngles<7>,
                     AsEulerAngles<8>, AsEulerAngles<9>, AsEulerAngles<10>, AsEulerAngles<11>, AsEulerAngles<12>,
                     AsEulerAngles<13>, AsEulerAngles<14>, AsEulerAngles<15>, AsEulerAngles<16>, AsEulerAngles<17>,
                     AsEulerAngles<18>, AsEulerAngles<19>, AsEulerAngles<20>, AsEulerAngles<21>, AsEulerAngles<22>,
                     AsEulerAngles<23>>;
TYPED_TEST_SUITE(RotationLaw, Representations);

TYPED_TEST(RotationLaw, RandomRotationsComeBack) {
  double worst = 0;
  UnitQuaternion of;
  for (int n = 0; n < many; ++n) {
    const UnitQuaternion q = random_rotation(this->random);
    const double error = ulps_between(this->there_and_back(q), Rotation(q));
    if (error > worst) worst = error, of = q;
  }
  EXPECT_LE(worst, 10) << "ulps, of q = " << of.w() << ", " << of.v().x << ", " << of.v().y << ", " << of.v().z;
  this->RecordProperty("worst_ulps", std::to_string(worst));
}

TYPED_TEST(RotationLaw, TheIdentityIsNeutral) {
  EXPECT_EQ(this->there_and_back({}), Rotation());
  EXPECT_EQ(this->undone({}), Rotation());
}

TYPED_TEST(RotationLaw, TheInverseUndoes) {
  for (int n = 0; n < 10'000; ++n) {
    const UnitQuaternion q = random_rotation(this->random);
    EXPECT_LE(ulps_between(this->there_and_back(q) * this->undone(q), Rotation()), 16);
    EXPECT_LE(ulps_between(this->undone(q), this->there_and_back(q).inverse()), 16);
  }
}

TYPED_TEST(RotationLaw, ProductsAreThoseOfTheQuaternions) {
  for (int n = 0; n < 10'000; ++n) {
    const UnitQuaternion a = random_rotation(this->random), b = random_rotation(this->random),
                         c = random_rotation(this->random);
    EXPECT_LE(ulps_between(this->there_and_back(a * b), this->there_and_back(a) * this->there_and_back(b)), 20);
    EXPECT_LE(ulps_between(this->there_and_back((a * b) * c), this->there_and_back(a * (b * c))), 24) << "associative";
  }
}

TYPED_TEST(RotationLaw, LengthsAnglesAndHandednessStay) {
  for (int n = 0; n < 10'000; ++n) {
    const Rotation rotation = this->there_and_back(random_rotation(this->random));
    const Vector3 a = random_direction(this->random), b = random_direction(this->random);
    EXPECT_LE(ulps_between(norm(rotation.apply(a)), 1), 10);
    EXPECT_LE(ulps_between(dot(rotation.apply(a), rotation.apply(b)), dot(a, b)), 16);
    EXPECT_LE(ulps_between(cross(rotation.apply(a), rotation.apply(b)), rotation.apply(cross(a, b))), 16);
  }
}

TYPED_TEST(RotationLaw, AlwaysARotationToRounding) {
  for (int n = 0; n < 10'000; ++n)
    EXPECT_TRUE(is_rotation(this->there_and_back(random_rotation(this->random)).matrix(), 20 * ulp));
}

TYPED_TEST(RotationLaw, OppositeQuaternionsAreOneRotation) {
  for (int n = 0; n < 1000; ++n) {
    const UnitQuaternion q = random_rotation(this->random);
    EXPECT_EQ(this->there_and_back(q), this->there_and_back(-q));
  }
}

TYPED_TEST(RotationLaw, SmallTurnsAreTheirFirstTwoOrders) {
  for (double angle = 0.1; angle > 1e-30; angle /= 2) {
    const Vector3 p = random_direction(this->random);
    const UnitQuaternion q = UnitQuaternion::of(std::cos(angle / 2), std::sin(angle / 2) * p).value();
    const Matrix3x3 k = angle * skew_matrix(p);
    const Matrix3x3 orders = Matrix3x3::identity() + k + 0.5 * (k * k);
    EXPECT_LE(frobenius_norm(this->there_and_back(q).matrix() - orders), angle * angle * angle + 20 * ulp) << angle;
  }
}

TYPED_TEST(RotationLaw, HalfTurnsAndTheirNeighboursComeBack) {
  for (double exponent = 0; exponent < 20; exponent += 0.1)
    for (const double side : {1.0, -1.0, 0.0}) {
      const double half = pi / 2 + side * std::pow(10, -exponent) / 2;
      const Vector3 p = random_direction(this->random);
      const UnitQuaternion q = UnitQuaternion::of(side == 0 ? 1e-300 : std::cos(half), std::sin(half) * p).value();
      if (!this->has(q)) continue;
      EXPECT_LE(ulps_between(this->there_and_back(q), Rotation(q)), 12) << exponent << " " << side;
    }
}

TYPED_TEST(RotationLaw, TurnsAboutTheAxesComeBack) {
  // Where many sequences are locked, and where half-turns have zeros.
  for (const Axis axis : {Axis::x, Axis::y, Axis::z})
    for (int eighths = -8; eighths <= 8; ++eighths) {
      const double half = eighths * pi / 8;
      const UnitQuaternion q = UnitQuaternion::of(std::cos(half), std::sin(half) * unit_vector(axis)).value();
      EXPECT_LE(ulps_between(this->there_and_back(q), Rotation(q)), 6) << eighths;
    }
}

TYPED_TEST(RotationLaw, NeighboursStayNeighbours) {
  for (int n = 0; n < 10'000; ++n) {
    const UnitQuaternion q = random_rotation(this->random);
    const double step = std::pow(10, -1 - n % 15);
    const UnitQuaternion small = UnitQuaternion::of(1, step / 2 * random_direction(this->random)).value();
    EXPECT_LE(frobenius_norm(this->there_and_back(q * small).matrix() - this->there_and_back(q).matrix()),
              1.5 * step + 30 * ulp);
  }
}

}  // namespace
}  // namespace linkwright
