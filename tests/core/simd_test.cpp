#include "linkwright/core/simd.hpp"

#include <gtest/gtest.h>

namespace linkwright::simd_test {
namespace {

TEST(Simd, AutomaticIsTheBestThereIs) {
  EXPECT_TRUE(is_supported(best_simd()));
  EXPECT_TRUE(is_supported(Simd::scalar));
  EXPECT_EQ(name(Simd::avx512), "avx512");
}

}  // namespace
}  // namespace linkwright::simd_test
