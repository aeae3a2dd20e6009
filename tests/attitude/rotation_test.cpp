#include "linkwright/attitude/rotation.hpp"

#include <gtest/gtest.h>

namespace linkwright {
namespace {

TEST(Rotation, IdentityMapsEveryVectorToItself) { EXPECT_EQ(Rotation().apply({1, 2, 3}), (Vector3{1, 2, 3})); }

}  // namespace
}  // namespace linkwright
