#include "linkwright/attitude/euler_angles.hpp"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>
#include <set>
#include <vector>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/tolerance.hpp"
#include "support/attitude_case.hpp"
#include "support/random_task.hpp"

namespace linkwright::euler_angles_test {
namespace {

using testing::attitude_cases;
using testing::random_rotation;
using testing::ulp;
using testing::ulps_between;
using testing::ulps_between_angles;
using testing::uniform;

std::vector<EulerSequence> all_sequences() {
  std::vector<EulerSequence> both(EulerSequence::all().begin(), EulerSequence::all().end());
  const auto& extrinsic = EulerSequence::all(Turning::extrinsic);
  both.insert(both.end(), extrinsic.begin(), extrinsic.end());
  return both;
}

std::string label(const EulerSequence& sequence) {
  return sequence.name() + (sequence.turning() == Turning::intrinsic ? " intrinsic" : " extrinsic");
}

void expect_answer(const EulerDecomposition& found, const testing::AttitudeCase::Euler& answer) {
  EXPECT_NEAR(found.angles.second, answer.angles.y, 4 * ulp);
  const double blur = 2 / std::min(found.lock_distance, 0.5);  // ulps: where a lock is near, the two err, in step
  EXPECT_LE(ulps_between_angles(found.angles.first, answer.angles.x), blur);
  EXPECT_LE(ulps_between_angles(found.angles.third, answer.angles.z), blur);
}

TEST(EulerAngles, AreThoseOfTheTable) {
  for (const auto& c : attitude_cases())
    for (const EulerSequence& sequence : EulerSequence::all()) {
      SCOPED_TRACE(c.name + " " + sequence.name());
      const auto& answer = c.euler.at(sequence.name());
      for (const EulerDecomposition& found :
           {euler_angles(c.input, sequence), euler_angles(Rotation::from_matrix(c.matrix).value(), sequence)}) {
        EXPECT_LE(ulps_between(found.angles.rotation().matrix(), c.matrix), 8);
        const bool locked = found.singularity == Singularity::gimbal_lock;
        EXPECT_TRUE(locked || !answer.locked);
        // A turn by 1e-20 or so off a lock is exactly not locked, but nearer than rounding lets anyone tell.
        EXPECT_TRUE(locked == answer.locked || c.kind == "near-0" || c.kind == "near-pi");
        if (locked == answer.locked) expect_answer(found, answer);
        EXPECT_LE(ulps_between_angles(found.determined, answer.angles.x + found.determined_sign * answer.angles.z), 8);
      }
    }
}

TEST(EulerAngles, ExtrinsicAreTheReversedIntrinsicOnes) {
  std::mt19937_64 random(1);
  for (int n = 0; n < 1000; ++n) {
    const UnitQuaternion q = random_rotation(random);
    for (const EulerSequence& sequence : EulerSequence::all()) {
      const EulerAngles intrinsic = euler_angles(q, sequence).angles;
      const EulerAngles extrinsic = euler_angles(q, sequence.reversed()).angles;
      EXPECT_EQ(extrinsic.sequence, sequence.reversed());
      EXPECT_EQ(intrinsic.first, extrinsic.third);
      EXPECT_EQ(intrinsic.second, extrinsic.second);
      EXPECT_EQ(intrinsic.third, extrinsic.first);
      EXPECT_EQ(intrinsic.rotation(), extrinsic.rotation());
    }
  }
}

TEST(EulerAngles, StayInTheirRanges) {
  std::mt19937_64 random(2);
  for (int n = 0; n < 10'000; ++n) {
    const UnitQuaternion q = random_rotation(random);
    for (const EulerSequence& sequence : all_sequences()) {
      const EulerAngles t = euler_angles(q, sequence).angles;
      EXPECT_GT(t.first, -pi);
      EXPECT_LE(t.first, pi);
      EXPECT_GT(t.third, -pi);
      EXPECT_LE(t.third, pi);
      EXPECT_GE(t.second, sequence.is_proper_euler() ? 0 : -pi / 2);
      EXPECT_LE(t.second, sequence.is_proper_euler() ? pi : pi / 2);
    }
  }
}

TEST(EulerAngles, KnowNoMinusPiAndNoMinusZero) {
  for (const Vector3 axis : {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}, Vector3{0, -1, 0}})
    for (const double angle : {0.6435011087932843, -0.6435011087932843, pi / 2, pi})
      for (const EulerSequence& sequence : all_sequences()) {
        const EulerAngles found = euler_angles(*Rotation::about_axis(axis, angle), sequence).angles;
        for (const double t : {found.first, found.second, found.third}) {
          EXPECT_GT(t, -pi) << label(sequence);
          EXPECT_FALSE(t == 0 && std::signbit(t)) << label(sequence);
        }
      }
}

TEST(EulerAngles, ComeBackFarFromLocks) {
  std::mt19937_64 random(3);
  for (const EulerSequence& sequence : all_sequences())
    for (int n = 0; n < 10'000; ++n) {
      const double middle = sequence.is_proper_euler() ? pi / 2 : 0;
      const EulerAngles given{sequence, uniform(random, -3.1, 3.1), middle + uniform(random, -1, 1),
                              uniform(random, -3.1, 3.1)};
      const EulerAngles found = euler_angles(given.rotation(), sequence).angles;
      ASSERT_NEAR(found.first, given.first, 12 * ulp) << label(sequence);
      ASSERT_NEAR(found.second, given.second, 12 * ulp) << label(sequence);
      ASSERT_NEAR(found.third, given.third, 12 * ulp) << label(sequence);
    }
}

TEST(EulerAngles, TwoWaysToTheRotationAgree) {
  std::mt19937_64 random(4);
  for (const EulerSequence& sequence : all_sequences())
    for (int n = 0; n < 1000; ++n) {
      const EulerAngles t{sequence, uniform(random, -7, 7), uniform(random, -7, 7), uniform(random, -7, 7)};
      EXPECT_LE(ulps_between(t.rotation(), Rotation(t.quaternion())), 8) << label(sequence);
    }
}

/// One attitude at `distance` from the lock at the low or high end of the second angle.
void expect_safe_near_lock(const EulerSequence& sequence, double lock, double distance, double first, double third) {
  SCOPED_TRACE(label(sequence) + ", second " + std::to_string(lock) + ", off by " +
               std::to_string(std::log10(std::abs(distance))));
  const EulerAngles given{sequence, first, lock + distance, third};
  for (const bool by_matrix : {false, true}) {
    const EulerDecomposition found =
        by_matrix ? euler_angles(given.rotation(), sequence) : euler_angles(given.quaternion(), sequence);
    EXPECT_LE(ulps_between(found.angles.rotation(), given.rotation()), 12) << "the rotation is made again";
    EXPECT_NEAR(found.lock_distance, std::abs(std::sin(distance / 2)), 4 * ulp);
    EXPECT_EQ(found.singularity == Singularity::gimbal_lock, found.lock_distance <= tolerance::gimbal_lock);
    EXPECT_EQ(found.is_near_gimbal_lock(), found.lock_distance < tolerance::near_gimbal_lock);
    const EulerAngles& t = found.angles;
    EXPECT_LE(ulps_between_angles(found.determined, t.first + found.determined_sign * t.third), 8);
    if (found.singularity == Singularity::none) continue;
    EXPECT_EQ(sequence.turning() == Turning::intrinsic ? t.third : t.first, 0) << "the angle that was chosen";
  }
}

TEST(EulerAngles, AreSafeAtAndAroundEveryLockFromBothSides) {
  std::mt19937_64 random(5);
  for (const EulerSequence& sequence : all_sequences())
    for (const double lock : {sequence.is_proper_euler() ? 0.0 : -pi / 2, sequence.is_proper_euler() ? pi : pi / 2}) {
      for (double exponent = 1; exponent <= 20; exponent += 0.5)
        for (const double side : {1.0, -1.0})
          expect_safe_near_lock(sequence, lock, side * std::pow(10, -exponent), uniform(random, -3, 3),
                                uniform(random, -3, 3));
      expect_safe_near_lock(sequence, lock, 0, uniform(random, -3, 3), uniform(random, -3, 3));
    }
}

TEST(EulerAngles, DeterminedCombinationIsTheGivenOneAtALock) {
  std::mt19937_64 random(6);
  for (const EulerSequence& sequence : all_sequences())
    for (const double lock : {sequence.is_proper_euler() ? 0.0 : -pi / 2, sequence.is_proper_euler() ? pi : pi / 2})
      for (const double distance : {0.0, 1e-15, 1e-9, 1e-3}) {
        const EulerAngles given{sequence, uniform(random, -3, 3), lock + (lock > 1 ? -distance : distance),
                                uniform(random, -3, 3)};
        const EulerDecomposition found = euler_angles(given.rotation(), sequence);
        EXPECT_LE(ulps_between_angles(found.determined, given.first + found.determined_sign * given.third), 12)
            << label(sequence) << " " << lock << " " << distance;
      }
}

TEST(EulerAngles, CardanAnglesOfSmallTurnsAreRelativelyExact) {
  std::mt19937_64 random(7);
  for (const EulerSequence& sequence : all_sequences()) {
    if (sequence.is_proper_euler()) continue;
    for (double size = 0.1; size > 1e-300; size *= 1e-3) {
      const EulerAngles given{sequence, size, 2 * size, -3 * size};
      const EulerAngles found = euler_angles(given.rotation(), sequence).angles;
      EXPECT_NEAR(found.first, given.first, 16 * ulp * size) << label(sequence);
      EXPECT_NEAR(found.second, given.second, 16 * ulp * size) << label(sequence);
      EXPECT_NEAR(found.third, given.third, 16 * ulp * size) << label(sequence);
    }
  }
}

TEST(EulerAngles, ThreeOneThreeIsTheMatrixOfTheArticleAndTheBook) {
  const double psi = 0.3, theta = 0.8, phi = -1.1;
  const double cp = std::cos(psi), sp = std::sin(psi), ct = std::cos(theta), st = std::sin(theta), cf = std::cos(phi),
               sf = std::sin(phi);
  const Matrix3x3 printed{{{{cp * cf - sp * ct * sf, -cp * sf - sp * ct * cf, sp * st},
                            {sp * cf + cp * ct * sf, -sp * sf + cp * ct * cf, -cp * st},
                            {st * sf, st * cf, ct}}}};
  EXPECT_LE(ulps_between(EulerAngles{EulerSequence::euler_313(), psi, theta, phi}.rotation().matrix(), printed), 1);
}

TEST(EulerAngles, BookZyxIsTheCorrectedMatrix) {
  const double theta = 0.3, beta = 0.8, alpha = -1.1;
  const double ct = std::cos(theta), st = std::sin(theta), cb = std::cos(beta), sb = std::sin(beta),
               ca = std::cos(alpha), sa = std::sin(alpha);
  const Matrix3x3 corrected{{{{ct * cb, ct * sb * sa - st * ca, ct * sb * ca + st * sa},
                              {st * cb, st * sb * sa + ct * ca, st * sb * ca - ct * sa},
                              {-sb, cb * sa, cb * ca}}}};
  EXPECT_LE(ulps_between(EulerAngles{EulerSequence::book_zyx(), theta, beta, alpha}.rotation().matrix(), corrected), 1);
  EXPECT_GT(std::abs(ct * sa - cb * sa), 0.1) << "the print has cos θ for cos β in the third row";
}

TEST(EulerAngles, RefuseWhatIsNotANumber) {
  const auto result = EulerAngles::of(EulerSequence::cardan_123(), std::nan(""), 0, -INFINITY);
  ASSERT_EQ(result.errors().size(), 2U);
  EXPECT_EQ(result.errors()[0].code, "not_finite");
  EXPECT_EQ(result.errors()[0].place, "angles[0]");
  EXPECT_EQ(result.errors()[1].place, "angles[2]");
  EXPECT_EQ(EulerAngles::of(EulerSequence::cardan_123(), 1, 2, 3)->second, 2);
}

TEST(EulerAngles, CardanAreTheTurnsOfTheThreeRings) {
  const EulerAngles t{EulerSequence::cardan_123(), 0.1, 0.2, 0.3};
  EXPECT_EQ(t.rotation(), Rotation::about_x(0.1) * Rotation::about_y(0.2) * Rotation::about_z(0.3));
}

using ::testing::HasSubstr;

TEST(EulerSequence, AreTwelveOfEitherKind) {
  std::set<std::string> names;
  int proper = 0;
  for (const EulerSequence& sequence : EulerSequence::all()) {
    names.insert(sequence.name());
    proper += sequence.is_proper_euler() ? 1 : 0;
    EXPECT_EQ(sequence.turning(), Turning::intrinsic);
    EXPECT_NE(sequence.first(), sequence.second());
    EXPECT_NE(sequence.second(), sequence.third());
    EXPECT_EQ(EulerSequence::named(sequence.name()).value(), sequence);
  }
  EXPECT_EQ(names.size(), 12U);
  EXPECT_EQ(proper, 6);
  for (const EulerSequence& sequence : EulerSequence::all(Turning::extrinsic))
    EXPECT_EQ(EulerSequence::named(sequence.name(), Turning::extrinsic).value(), sequence);
}

TEST(EulerSequence, TakesDigitsHyphensAndCapitals) {
  for (const char* name : {"zxz", "313", "3-1-3", "z-x-z", "ZXZ", "Z-X-Z"})
    EXPECT_EQ(EulerSequence::named(name).value(), EulerSequence::euler_313()) << name;
  EXPECT_EQ(EulerSequence::named("1-2-3").value(), EulerSequence::cardan_123());
  EXPECT_EQ(EulerSequence::named("zyx").value(), EulerSequence::book_zyx());
  EXPECT_EQ(EulerSequence::book_zxz().name(), "zxz");
}

TEST(EulerSequence, RefusesOthersAndListsTheTwelve) {
  for (const char* name :
       {"", "x", "xx", "xxy", "xyy", "xyw", "XYW", "xyzx", "3--13", "012", "x-yz", "xyz-", "--x--"}) {
    const auto result = EulerSequence::named(name);
    ASSERT_FALSE(result.ok()) << name;
    EXPECT_EQ(result.errors().front().code, "unknown_sequence");
    EXPECT_THAT(result.errors().front().message, HasSubstr("take xyz, xzy"));
  }
}

TEST(EulerSequence, ReversedIsOfTheOtherKind) {
  const EulerSequence reversed = EulerSequence::book_zyx().reversed();
  EXPECT_EQ(reversed.name(), "xyz");
  EXPECT_EQ(reversed.turning(), Turning::extrinsic);
  EXPECT_EQ(reversed.reversed(), EulerSequence::book_zyx());
}

using testing::random_rotation;
using testing::ulps_between;

TEST(ResalFrame, IsTheBooksMatrixOfTwoTurns) {
  const double theta = 0.4, alpha = 1.2;
  const double ct = std::cos(theta), st = std::sin(theta), ca = std::cos(alpha), sa = std::sin(alpha);
  const Matrix3x3 printed{{{{ct, -st * ca, st * sa}, {st, ct * ca, -ct * sa}, {0, sa, ca}}}};
  EXPECT_LE(ulps_between(resal_frame(theta, alpha).matrix(), printed), 1);
}

TEST(ResalFrame, SharesTheBodysAxisAndDoesNotSpin) {
  std::mt19937_64 random(1);
  for (int n = 0; n < 1000; ++n) {
    const Rotation body(random_rotation(random));
    const ResalFrame resal = resal_frame(body);
    EXPECT_LE(ulps_between(resal.frame.matrix().column(2), body.matrix().column(2)), 8);
    EXPECT_NEAR(resal.frame.matrix()(2, 0), 0, 1e-15) << "its x axis is the line of nodes";
    EXPECT_LE(ulps_between(resal.frame * Rotation::about_z(resal.spin), body), 8);
  }
}

TEST(ResalFrame, StaysWhileTheBodySpins) {
  const Rotation at_rest = resal_frame(0.5, 1.0);
  for (double spin = -3; spin < 3; spin += 0.25) {
    const ResalFrame resal = resal_frame(at_rest * Rotation::about_z(spin));
    EXPECT_NEAR(resal.spin, spin, 1e-15);
    EXPECT_LE(ulps_between(resal.frame, at_rest), 8);
  }
}

TEST(ResalFrame, CountsAllAsPrecessionAtALock) {
  const ResalFrame resal = resal_frame(Rotation::about_z(0.7));
  EXPECT_EQ(resal.spin, 0);
  EXPECT_LE(ulps_between(resal.frame, Rotation::about_z(0.7)), 2);
}

}  // namespace
}  // namespace linkwright::euler_angles_test
