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
  constexpr std::array<std::string_view, 4> known = {"xa", "ya", "theta_deg", "at_infinity"};
  EXPECT_EQ(nearest_name("thetadeg", known), "theta_deg");
  EXPECT_EQ(nearest_name("za", known), "xa");
}

TEST(NearestName, IsNotOfferedWhereItIsFarFetched) {
  constexpr std::array<std::string_view, 5> known = {"side_lengths", "side_length", "side_angle_deg", "instant_center",
                                                     "at_infinity"};
  for (const char* far : {"moving_pivots", "z", "directed", "", "pivots_on_line"})
    EXPECT_EQ(nearest_name(far, known), "") << far;
  EXPECT_EQ(nearest_name(std::string(1 << 20, 'q'), known), "");
}

TEST(NearestName, StrangeNamesArePresentable) {
  EXPECT_EQ(in_quotes("a\nb"), "\"a?b\"");
  const std::string cut = presentable(std::string(39, 'a') + "üüüü");
  EXPECT_EQ(cut, std::string(39, 'a') + "…");  // never half a character
  EXPECT_EQ(presentable("a\xFFz"), "a\uFFFDz");
}

TEST(NearestName, TextsBecomeWellFormed) {
  EXPECT_EQ(well_formed("\"机构\"\n"), "\"机构\"\n");
  EXPECT_EQ(well_formed("\xC3"), "\uFFFD");
  EXPECT_EQ(well_formed(std::string_view("\0\xFFü", 4)), std::string_view("\0\uFFFDü", 6));
}

}  // namespace
}  // namespace linkwright::nearest_name_test
