#include "linkwright/files/linkage_file.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>

#include "linkwright/files/result_file.hpp"
#include "linkwright/mechanism/position.hpp"
#include "support/file_support.hpp"

namespace linkwright::linkage_file_test {
namespace {

using testing::motion;

using ::testing::HasSubstr;

TEST(LinkageFile, ReadsPivots) {
  const auto linkage = read_linkage(R"({"length_unit": "mm", "pivots": {"input_center": [0, 0], "input_circle": [0, 2],
    "output_center": [4, 0], "output_circle": [3, 3.5]}})");
  ASSERT_TRUE(linkage.ok());
  EXPECT_EQ(linkage->four_bar.input_moving, Point(0, 2));
  EXPECT_EQ(linkage->four_bar.output_moving, Point(3, 3.5));
  EXPECT_EQ(linkage->length_unit, "mm");
  EXPECT_TRUE(linkage->poses.empty());
}

TEST(LinkageFile, LengthsAreLaidOutAsAFourBarOfThoseLengths) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> length(0.1, 10);
  int read = 0;
  for (int i = 0; i < 500; ++i) {
    const LinkLengths wanted{length(random), length(random), length(random), length(random)};
    const auto linkage =
        read_linkage(fmt::format(R"({{"lengths": {{"ground": {}, "input": {}, "coupler": {}, "output": {}}}}})",
                                 wanted.ground, wanted.input, wanted.coupler, wanted.output));
    if (!linkage.ok()) {
      EXPECT_GT(2 * wanted.longest(), wanted.perimeter() - 1e-9);
      continue;
    }
    ++read;
    const LinkLengths found = linkage->four_bar.lengths();
    EXPECT_NEAR(found.ground, wanted.ground, 1e-9);
    EXPECT_NEAR(found.input, wanted.input, 1e-9);
    EXPECT_NEAR(found.coupler, wanted.coupler, 1e-9);
    EXPECT_NEAR(found.output, wanted.output, 1e-9);
    EXPECT_EQ(assembly_of(linkage->four_bar), Assembly::positive);
  }
  EXPECT_GT(read, 300);
}

TEST(LinkageFile, LinksThatCannotCloseAreRefused) {
  const auto linkage = read_linkage(R"({"lengths": {"ground": 10, "input": 1, "coupler": 2, "output": 3}})");
  ASSERT_FALSE(linkage.ok());
  EXPECT_EQ(linkage.errors()[0].place, "lengths");
  EXPECT_THAT(linkage.errors()[0].message, HasSubstr("longer than the other three together (6)"));
}

TEST(LinkageFile, MistakesAreToldInTheirPlaces) {
  const std::tuple<std::string, std::string, std::string> refused[] = {
      {"{}", "", "no linkage is given"},
      {R"({"lengths": {"ground": 4, "input": 2, "coupler": 3}})", "lengths.output", "missing"},
      {R"({"lengths": {"ground": 4, "input": -2, "coupler": 3, "output": 3}})", "lengths.input", "greater than 0"},
      {R"({"lengths": {"ground": 4, "input": 2, "couppler": 3, "output": 3}})", "lengths.couppler", "\"coupler\""},
      {R"({"pivots": {"input_center": [0, 0], "input_circle": [0, 0], "output_center": [4, 0], "output_circle": [3, 3]}})",
       "pivots", "coincide"},
      {R"({"pivots": {"input_center": [0], "input_circle": [0, 1], "output_center": [4, 0], "output_circle": [3, 3]}})",
       "pivots.input_center", "two numbers"},
      {R"({"pivots": {"input_center": [1e300, 0], "input_circle": [0, 1], "output_center": [4, 0], "output_circle": [3, 3]}})",
       "pivots", "between"},
      {R"({"mechanism": "spherical_four_bar"})", "", "add \"axes\", \"angles_deg\""},
      {R"({"mechanism": "slider_crank"})", "mechanism", "only a"},
      {R"({"linkages": []})", "linkages", "linkwright export"},
      {R"({"linkwright": 2})", "linkwright", "newer"},
  };
  for (const auto& [text, place, reason] : refused) {
    const auto linkage = read_linkage(text);
    ASSERT_FALSE(linkage.ok()) << text;
    EXPECT_EQ(linkage.errors()[0].place, place) << text;
    EXPECT_THAT(linkage.errors()[0].message, HasSubstr(reason));
  }
}

TEST(LinkageFile, WrittenLinkageReadsBackBitIdentical) {
  StoredLinkage linkage;
  linkage.four_bar = {{0.1, -0.2}, {1.0 / 3, 2e-7}, {4e3, 1e-3}, {3, 3.5}};
  linkage.title = "A \"title\"";
  linkage.poses = motion(testing::tailgate()).poses;
  const auto read = read_linkage(write_linkage(linkage));
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->four_bar.input_fixed, linkage.four_bar.input_fixed);
  EXPECT_EQ(read->four_bar.input_moving, linkage.four_bar.input_moving);
  EXPECT_EQ(read->four_bar.output_fixed, linkage.four_bar.output_fixed);
  EXPECT_EQ(read->four_bar.output_moving, linkage.four_bar.output_moving);
  EXPECT_EQ(read->title, linkage.title);
  ASSERT_EQ(read->poses.size(), 4u);
  EXPECT_EQ(read->poses[1].pose.angle, linkage.poses[1].pose.angle);
}

TEST(LinkageFile, DerivativesReadBackBitIdentical) {
  StoredLinkage linkage;
  linkage.four_bar = {{0, 0}, {0, 2}, {4, 0}, {3, 3.5}};
  linkage.poses = motion(testing::hood_hinge()).poses;
  linkage.poses[2].derivatives = {{{1.0 / 3, 0.1}, 2e-7}, {{0, 0}, -1}};
  const std::string text = write_linkage(linkage);
  const auto read = read_linkage(text);
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(write_linkage(*read), text);
  ASSERT_EQ(read->poses[2].derivatives.size(), 2u);
  EXPECT_EQ(read->poses[2].derivatives[0].origin, linkage.poses[2].derivatives[0].origin);
  EXPECT_EQ(read->poses[2].derivatives[0].angle, 2e-7);
  EXPECT_EQ(read->poses[0].derivatives[0].angle, -0.004);
}

TEST(LinkageFile, OfEveryKindReadsBackWithItsPoses) {
  for (const auto* solved : {&testing::three_positions(), &testing::five_positions(), &testing::function()}) {
    const auto linkages = read_result_linkages(write_result(solved->problem, solved->answer, false));
    ASSERT_TRUE(linkages.ok());
    ASSERT_GT(linkages->size(), 0u);
    const std::string text = write_linkage(linkages.value().front());
    const auto read = read_linkage(text);
    ASSERT_TRUE(read.ok());
    EXPECT_EQ(write_linkage(*read), text);
    EXPECT_EQ(read->poses.size(), linkages.value().front().poses.size());
    EXPECT_EQ(read->four_bar.output_moving, linkages.value().front().four_bar.output_moving);
  }
}

TEST(LinkageFile, ALinkagesOwnPosesCountNotThoseBesideIt) {
  const auto read = read_linkage(R"({"poses": [{"x": 1, "y": 2, "theta_deg": 3}], "linkage": {"input":
    {"center_point": [0, 0], "circle_point": [0, 2]}, "output": {"center_point": [4, 0], "circle_point": [3, 3.5]},
    "poses": [{"x": 0, "y": 2, "theta_deg": 0}, {"x": 1, "y": 2, "theta_deg": 10}]}})");
  ASSERT_TRUE(read.ok());
  ASSERT_EQ(read->poses.size(), 2u);
  EXPECT_EQ(read->poses[0].pose.origin, Point(0, 2));
}

TEST(LinkageFile, OfAResultKeepsItsRecord) {
  const auto linkages = read_result_linkages(write_result(testing::tailgate(), testing::solved_tailgate(), false));
  ASSERT_TRUE(linkages.ok());
  const std::string text = write_linkage(linkages.value().front());
  const auto read = read_linkage(text);
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->record, linkages.value().front().record);
  EXPECT_THAT(text, HasSubstr("verified_by_driving"));
  EXPECT_EQ(write_linkage(*read), text);
}

}  // namespace
}  // namespace linkwright::linkage_file_test
