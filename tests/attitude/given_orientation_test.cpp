#include "linkwright/attitude/given_orientation.hpp"

#include <gtest/gtest.h>

namespace linkwright::given_orientation_test {
namespace {

const UnitQuaternion quarter = UnitQuaternion::about({0, 0, 1}, 1.5);

TEST(GivenOrientation, IsTheRotationInWhateverForm) {
  const GivenOrientation given(quarter, R"("axis": [0,0,1], "angle_deg": 90)");
  EXPECT_EQ(given, GivenOrientation(quarter));
  EXPECT_EQ(given.apply({1, 0, 0}), quarter.apply({1, 0, 0}));
  EXPECT_FALSE(given == GivenOrientation());
}

TEST(GivenOrientation, AnotherRotationForgetsTheForm) {
  GivenOrientation given(quarter, R"("quaternion": [1,0,0,1])");
  given = quarter.inverse();
  EXPECT_EQ(given, quarter.inverse());
  EXPECT_TRUE(given.form().empty());
}

}  // namespace
}  // namespace linkwright::given_orientation_test
