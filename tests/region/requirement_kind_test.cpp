#include "linkwright/region/requirement_kind.hpp"

#include <gtest/gtest.h>
#include <set>

namespace linkwright::requirement_kind_test {
namespace {

TEST(RequirementKind, HasTheKeyOfTheProblemFile) {
  EXPECT_EQ(key(RequirementKind::min_transmission_angle), "min_transmission_angle_deg");
  EXPECT_EQ(key(RequirementKind::moving_pivots_within), "moving_pivots_within");
  EXPECT_EQ(key(RequirementKind::max_link_angle), "max_link_angle_deg");
  EXPECT_EQ(key(RequirementKind::moving_axes_within), "moving_axes_within");
  std::set<std::string_view> keys;
  for (std::size_t k = 0; k < requirement_kind_count; ++k) keys.insert(key(static_cast<RequirementKind>(k)));
  EXPECT_EQ(keys.size(), requirement_kind_count);
}

TEST(RequirementKind, OfAnAngleIsTold) {
  EXPECT_TRUE(is_angle(RequirementKind::min_link_angle));
  EXPECT_TRUE(is_angle(RequirementKind::fixed_axes_within));
  EXPECT_FALSE(is_angle(RequirementKind::max_link_ratio));
  EXPECT_FALSE(is_angle(RequirementKind::ground_pivots_within));
}

TEST(RequirementKind, HasAPlaceAmongOthers) {
  constexpr std::array kinds = {RequirementKind::no_defects, RequirementKind::min_link_angle};
  EXPECT_EQ(place_among(kinds, RequirementKind::min_link_angle), 1u);
  EXPECT_EQ(place_among(kinds, RequirementKind::types), kinds.size());
}

}  // namespace
}  // namespace linkwright::requirement_kind_test
