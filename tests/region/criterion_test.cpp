#include "linkwright/region/criterion.hpp"

#include <array>
#include <gtest/gtest.h>
#include <set>

namespace linkwright::criterion_test {
namespace {

TEST(Criterion, HasTheKeyOfTheProblemFile) {
  EXPECT_EQ(key(RequirementKind::min_transmission_angle), "min_transmission_angle_deg");
  EXPECT_EQ(key(RequirementKind::moving_pivots_within), "moving_pivots_within");
  EXPECT_EQ(key(RequirementKind::max_link_angle), "max_link_angle_deg");
  EXPECT_EQ(key(RequirementKind::moving_axes_within), "moving_axes_within");
  std::set<std::string_view> keys;
  for (std::size_t k = 0; k < requirement_kind_count; ++k) keys.insert(key(static_cast<RequirementKind>(k)));
  EXPECT_EQ(keys.size(), requirement_kind_count);
}

TEST(Criterion, OfAnAngleIsTold) {
  EXPECT_TRUE(criterion(RequirementKind::min_link_angle).is_angle());
  EXPECT_TRUE(criterion(RequirementKind::fixed_axes_within).is_angle());
  EXPECT_FALSE(criterion(RequirementKind::max_link_ratio).is_angle());
  EXPECT_FALSE(criterion(RequirementKind::ground_pivots_within).is_angle());
}

TEST(Criterion, IsANumberOfAMeasureOrAPlaceOrAVerdict) {
  for (const Criterion& each : criteria()) {
    EXPECT_EQ(each.is_number(), each.of != nullptr) << each.key;
    EXPECT_FALSE(each.name.empty()) << each.key;
    const bool is_place = each.rule == Criterion::Rule::ground_inside || each.rule == Criterion::Rule::moving_inside;
    EXPECT_EQ(is_place, std::holds_alternative<std::optional<Box> Requirements::*>(each.asked) ||
                            std::holds_alternative<std::optional<Cone> Requirements::*>(each.asked))
        << each.key;
  }
}

TEST(Criterion, HasTheLimitThatIsAsked) {
  Requirements wanted;
  const Criterion &length = criterion(RequirementKind::max_length), &ratio = criterion(RequirementKind::max_link_ratio);
  EXPECT_EQ(length.limit(wanted), Requirements::unlimited);
  EXPECT_FALSE(length.has_limit(wanted));
  wanted.max_length = 3;
  EXPECT_EQ(length.limit(wanted), 3);
  EXPECT_TRUE(length.is_asked(wanted));
  EXPECT_TRUE(ratio.has_limit(wanted)) << "by default";
  EXPECT_FALSE(ratio.is_asked(wanted));
  wanted.max_link_ratio = 4;
  EXPECT_TRUE(ratio.is_asked(wanted));
}

TEST(Criterion, HasTheWindowThatIsAsked) {
  Requirements wanted;
  for (const Criterion& each : criteria()) EXPECT_FALSE(each.window(wanted)) << each.key;
  wanted.moving_axes_within = Cone{{0, 0, 1}, 0.5};
  const auto window = criterion(RequirementKind::moving_axes_within).window(wanted);
  ASSERT_TRUE(window);
  EXPECT_EQ(std::get<Cone>(*window), *wanted.moving_axes_within);
  EXPECT_TRUE(criterion(RequirementKind::moving_axes_within).is_asked(wanted));
}

TEST(Criterion, HasAPlaceAmongOthers) {
  constexpr std::array kinds = {RequirementKind::no_defects, RequirementKind::min_link_angle};
  EXPECT_EQ(place_among(kinds, RequirementKind::min_link_angle), 1u);
  EXPECT_EQ(place_among(kinds, RequirementKind::types), kinds.size());
}

}  // namespace
}  // namespace linkwright::criterion_test
