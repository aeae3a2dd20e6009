#include "linkwright/region/linkage_class.hpp"

#include <algorithm>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"

namespace linkwright::linkage_class_test {
namespace {

std::vector<std::string> places_of_mistakes(const Requirements& wanted, const LinkageClass& of) {
  std::vector<std::string> places;
  for (const Error& mistake : mistakes_in(wanted, of)) places.push_back(mistake.place);
  return places;
}
using Places = std::vector<std::string>;

TEST(LinkageClass, HasNoMoreRequirementsThanAByteHasBits) {
  for (const LinkageClass& of :
       {planar_linkages, unloaded_linkages, spherical_linkages, straight_line_linkages, path_linkages}) {
    EXPECT_LE(of.requirements.size(), max_requirements);
    EXPECT_EQ(std::count(of.types.begin(), of.types.end(), LinkageType::degenerate), 1);
    EXPECT_FALSE(of.objectives.empty());
  }
}

// What a cell fails is told by bits in the order of planar linkages, whatever they are for.
TEST(LinkageClass, BeginsWithWhatIsAskedWithoutLoads) {
  const auto begins_with = [](const auto& whole, const auto& part) {
    return part.size() < whole.size() && std::equal(part.begin(), part.end(), whole.begin());
  };
  EXPECT_TRUE(begins_with(planar_linkages.requirements, unloaded_linkages.requirements));
  EXPECT_TRUE(begins_with(planar_linkages.objectives, unloaded_linkages.objectives));
  Requirements wanted;
  wanted.max_pin_force = 100;
  EXPECT_TRUE(mistakes_in(wanted, planar_linkages).empty());
  EXPECT_EQ(places_of_mistakes(wanted, unloaded_linkages), Places{"requirements.max_pin_force"});
}

TEST(LinkageClass, TakesItsOwnRequirements) {
  EXPECT_TRUE(mistakes_in(Requirements{}, planar_linkages).empty());
  EXPECT_TRUE(mistakes_in(Requirements{}, spherical_linkages).empty());
  Requirements planar;
  planar.types = {LinkageType::triple_rocker_input};
  planar.max_link_ratio = 3;
  planar.max_length = 3;
  planar.ground_pivots_within = Box{0, 1, 0, 1};
  EXPECT_TRUE(mistakes_in(planar, planar_linkages).empty());
  EXPECT_EQ(places_of_mistakes(planar, spherical_linkages),
            (Places{"requirements.types", "requirements.max_link_ratio", "requirements.max_length",
                    "requirements.ground_pivots_within"}));
}

TEST(LinkageClass, RefusesThoseOfAnother) {
  Requirements spherical;
  spherical.types = {LinkageType::triple_rocker};
  spherical.min_link_angle = radians(10);
  spherical.max_link_angle = radians(80);
  spherical.fixed_axes_within = Cone{{0, 0, 1}, radians(30)};
  spherical.moving_axes_within = spherical.fixed_axes_within;
  EXPECT_TRUE(mistakes_in(spherical, spherical_linkages).empty());
  EXPECT_EQ(places_of_mistakes(spherical, planar_linkages),
            (Places{"requirements.types", "requirements.min_link_angle_deg", "requirements.max_link_angle_deg",
                    "requirements.fixed_axes_within", "requirements.moving_axes_within"}));
}

TEST(LinkageClass, AFullTurnIsAskedOfPathsAlone) {
  Requirements wanted;
  wanted.full_turn = true;
  EXPECT_TRUE(mistakes_in(wanted, path_linkages).empty());
  EXPECT_EQ(places_of_mistakes(wanted, planar_linkages), Places{"requirements.full_turn"});
}

TEST(LinkageClass, TakesWhatIsSwitchedOff) {
  Requirements off;
  off.max_link_ratio = off.max_length.emplace(Requirements::unlimited);
  off.min_length = 0;
  EXPECT_TRUE(mistakes_in(off, spherical_linkages).empty());
  off.min_link_angle = 0;
  EXPECT_TRUE(mistakes_in(off, planar_linkages).empty());
}

TEST(LinkageClass, SaysWhatMayBeAskedInstead) {
  const Error mistake = foreign_requirement(RequirementKind::max_link_ratio, spherical_linkages);
  EXPECT_EQ(mistake.place, "requirements.max_link_ratio");
  EXPECT_NE(mistake.message.find("min_link_angle_deg"), std::string::npos) << mistake.message;
}

}  // namespace
}  // namespace linkwright::linkage_class_test
