#include "linkwright/attitude/euler_sequence.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <set>

namespace linkwright::euler_sequence_test {
namespace {

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

}  // namespace
}  // namespace linkwright::euler_sequence_test
