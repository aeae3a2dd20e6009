#include "linkwright/loads/loads.hpp"

#include <gtest/gtest.h>

namespace linkwright::loads_test {
namespace {

std::vector<std::string> codes(const Loads& loads) {
  std::vector<std::string> found;
  for (const Error& mistake : mistakes_in(loads)) found.push_back(mistake.code);
  return found;
}

Loads held_by_hand() {
  Loads loads;
  loads.handle = Handle{{10, 20}};
  loads.metres = 0.001;
  return loads;
}

TEST(Loads, HaveOneCaseWhereNoneIsGiven) {
  const Loads loads;
  ASSERT_EQ(cases_of(loads).size(), 1U);
  EXPECT_EQ(cases_of(loads).front().temperature, 20);
  EXPECT_TRUE(cases_of(loads).front().counts(ReadOut::hold_open));
}

TEST(Loads, CountACaseForWhatItNames) {
  LoadCase of;
  of.counts_for = {ReadOut::hold_open};
  EXPECT_TRUE(of.counts(ReadOut::hold_open));
  EXPECT_FALSE(of.counts(ReadOut::max_pin_force));
}

TEST(Loads, NameSpringsThatHaveNoName) {
  Loads loads;
  loads.springs.resize(2);
  loads.springs[1].name = "strut";
  EXPECT_EQ(spring_name(loads, 0), "spring_1");
  EXPECT_EQ(spring_name(loads, 1), "strut");
}

TEST(Loads, AreWithoutMistakesWhereAHandHolds) { EXPECT_TRUE(mistakes_in(held_by_hand()).empty()); }

TEST(Loads, NeedMetresForWhatIsPerMetre) {
  Loads loads = held_by_hand();
  loads.input = LinkMass{.kg_per_m = 1.2};
  EXPECT_TRUE(codes(loads).empty());
  loads.metres.reset();
  EXPECT_EQ(codes(loads), std::vector<std::string>{"load_unit"});
}

TEST(Loads, HaveNoVerticalWithoutGravity) {
  Loads loads = held_by_hand();
  loads.handle->direction = Handle::Direction::vertical;
  EXPECT_TRUE(codes(loads).empty());
  loads.gravity->acceleration = 0;
  EXPECT_EQ(codes(loads), std::vector<std::string>{"vertical_without_gravity"});
  loads.gravity.reset();
  EXPECT_EQ(codes(loads), std::vector<std::string>{"vertical_without_gravity"});
}

TEST(Loads, TellEveryMistakeAtOnce) {
  Loads loads = held_by_hand();
  loads.body = BodyMass{-1, {}, -2};
  loads.cases = {{.name = "a"}, {.name = "a", .extra = {"snow"}}};
  loads.springs.push_back({"", 1, {LoadedBody::body, {}}, {LoadedBody::coupler, {}}, CoilSpring{-1, 2}});
  EXPECT_EQ(codes(loads), (std::vector<std::string>{"load_range", "load_range", "spring_to_itself", "load_range",
                                                    "load_name_twice", "unknown_extra"}));
}

}  // namespace
}  // namespace linkwright::loads_test
