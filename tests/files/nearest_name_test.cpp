#include "linkwright/files/nearest_name.hpp"

#include <array>
#include <gtest/gtest.h>

namespace linkwright::nearest_name_test {
namespace {

TEST(NearestName, EditDistanceCountsEditsAndExchanges) {
  EXPECT_EQ(edit_distance("", ""), 0u);
  EXPECT_EQ(edit_distance("abc", ""), 3u);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
  EXPECT_EQ(edit_distance("poses", "psoes"), 1u);
  EXPECT_EQ(edit_distance("theta", "theta_deg"), 4u);
}

TEST(NearestName, IsTheFirstOfEquals) {
  constexpr std::array<std::string_view, 3> known = {"x", "y", "theta_deg"};
  EXPECT_EQ(nearest_name("thetadeg", known), "theta_deg");
  EXPECT_EQ(nearest_name("z", known), "x");
  EXPECT_EQ(nearest_name(std::string(1 << 20, 'q'), known), "x");
}

TEST(NearestName, StrangeNamesArePresentable) {
  EXPECT_EQ(in_quotes("a\nb"), "\"a?b\"");
  const std::string cut = presentable(std::string(39, 'a') + "üüüü");
  EXPECT_EQ(cut, std::string(39, 'a') + "…");  // never half a character
}

}  // namespace
}  // namespace linkwright::nearest_name_test
