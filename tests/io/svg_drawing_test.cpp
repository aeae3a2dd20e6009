#include "linkwright/io/svg_drawing.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <regex>
#include <vector>

#include "io_support.hpp"

namespace linkwright {
namespace {

using testing::motion;

using ::testing::HasSubstr;
using ::testing::Not;

/// Whether every tag is closed in order and attributes are quoted: enough of XML for what we write.
::testing::AssertionResult is_well_formed(const std::string& text) {
  std::vector<std::string> open;
  std::size_t place = 0;
  while ((place = text.find('<', place)) != std::string::npos) {
    const std::size_t end = text.find('>', place);
    if (end == std::string::npos) return ::testing::AssertionFailure() << "open tag at " << place;
    const std::string tag = text.substr(place + 1, end - place - 1);
    if (std::count(tag.begin(), tag.end(), '"') % 2 != 0) return ::testing::AssertionFailure() << "quotes in " << tag;
    if (tag.find('<') != std::string::npos) return ::testing::AssertionFailure() << "bracket in " << tag;
    place = end;
    if (tag.front() == '?' || tag.back() == '/') continue;
    if (tag.front() != '/') {
      open.push_back(tag.substr(0, tag.find_first_of(" \n")));
    } else if (open.empty() || open.back() != tag.substr(1)) {
      return ::testing::AssertionFailure() << "closing " << tag;
    } else {
      open.pop_back();
    }
  }
  if (!open.empty()) return ::testing::AssertionFailure() << open.back() << " is not closed";
  return ::testing::AssertionSuccess();
}

TEST(SvgDrawing, OfASolutionShowsTaskRegionAndNumbers) {
  const std::string svg = draw_solution(testing::tailgate(), testing::solved_tailgate());
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(svg, HasSubstr("Tailgate hinge"));
  EXPECT_THAT(svg, HasSubstr("data:image/png;base64,"));
  EXPECT_THAT(svg, HasSubstr("closed branch"));
  EXPECT_THAT(svg, HasSubstr("∞"));
  EXPECT_THAT(svg, HasSubstr("100 mm"));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_LT(svg.size(), 300'000u);
}

TEST(SvgDrawing, EscapesTheTitle) {
  Problem problem = testing::tailgate();
  problem.title = "<b>\"A\" & 'B'</b>\n\x01\xFF\xEF\xBF\xBF ]]> 门";
  problem.length_unit = "<mm>";
  const std::string svg = draw_solution(problem, testing::solved_tailgate());
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(svg, HasSubstr("&lt;b&gt;&quot;A&quot; &amp; 'B'&lt;/b&gt;"));
  EXPECT_THAT(svg, HasSubstr("门"));
  EXPECT_THAT(svg, Not(HasSubstr("\x01")));
  EXPECT_THAT(svg, Not(HasSubstr("\xFF")));
}

TEST(SvgDrawing, StaysSmallForLargeRegions) {
  Problem problem = testing::tailgate();
  problem.options.region_samples = 1500;
  EXPECT_LT(draw_solution(problem, testing::solution_of(problem)).size(), 300'000u);
}

TEST(SvgDrawing, OfATaskWithoutLinkagesSaysWhy) {
  Problem nothing_left = testing::tailgate();
  nothing_left.requirements.max_length = 1;
  for (const Problem& problem : {nothing_left, testing::problem_of({{0, 0, 0}, {1, 1, 0}, {2, 5, 0}, {3, 2, 0}}),
                                 testing::problem_of({{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0.6, 0.8, 0}}),
                                 testing::problem_of({{0, 0, 0}, {1, 1, 0}, {2, 1, 0}, {3, 2, 100}})}) {
    const Solution solution = testing::solution_of(problem);
    const std::string svg = draw_solution(problem, solution);
    EXPECT_TRUE(is_well_formed(svg));
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
    EXPECT_THAT(svg, HasSubstr(solution.linkages.empty() ? "No linkage to show" : "Best linkage"));
  }
}

TEST(SvgDrawing, DoesNotDependOnWhereAndHowLargeTheTaskIs) {
  Problem moved = testing::tailgate();
  moved.requirements = {};
  for (PrescribedPose& pose : motion(moved).poses) pose.pose.origin = 1e-3 * pose.pose.origin + Point{0.5, -0.25};
  const std::string svg = draw_solution(moved, testing::solution_of(moved));
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(svg, Not(HasSubstr("1e+")));
}

std::size_t count_of(const std::string& text, const std::string& piece) {
  std::size_t count = 0;
  for (std::size_t at = text.find(piece); at != std::string::npos; at = text.find(piece, at + 1)) ++count;
  return count;
}

TEST(SvgDrawing, ShowsTheDirectionOfTravelAsAnArrow) {
  const std::string svg = draw_solution(testing::hood_hinge(), testing::solved_hood_hinge());
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  StoredLinkage linkage;
  linkage.four_bar = testing::solved_hood_hinge().linkages.front().four_bar;
  linkage.poses = motion(testing::hood_hinge()).poses;
  const std::string arrow = draw_linkage(linkage);
  EXPECT_TRUE(is_well_formed(arrow));
  linkage.poses[0].derivatives = {{{0, 0}, 1}};  // turning about its origin
  const std::string bent = draw_linkage(linkage);
  EXPECT_TRUE(is_well_formed(bent));
  linkage.poses[0].derivatives.clear();
  const std::string none = draw_linkage(linkage);
  EXPECT_EQ(count_of(arrow, "<line"), count_of(none, "<line") + 1);
  EXPECT_EQ(count_of(bent, "<polyline"), count_of(none, "<polyline") + 1);
  EXPECT_EQ(count_of(arrow, "<polygon"), count_of(none, "<polygon") + 1);
  EXPECT_EQ(count_of(bent, "<polygon"), count_of(none, "<polygon") + 1);
}

TEST(SvgDrawing, OfASinglePoseHasRoom) {
  Problem problem = testing::problem_of({{1e5, -2e5, 30}});
  motion(problem).poses[0].derivatives = {{{100, 0}, 0.8}, {{60, 100}, 0.2}, {{0, 120}, -0.3}};
  for (const double max_length : {1e-6, 1e9}) {
    problem.requirements.max_length = max_length;
    const Solution solution = testing::solution_of(problem);
    EXPECT_EQ(solution.linkages.empty(), max_length < 1);
    const std::string svg = draw_solution(problem, solution);
    EXPECT_TRUE(is_well_formed(svg));
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
    EXPECT_GT(count_of(svg, "<polyline"), 1u) << "the curves";
    EXPECT_LT(svg.size(), 300'000u);
  }
}

TEST(SvgDrawing, OfALinkageShowsItsDimensions) {
  StoredLinkage linkage;
  linkage.four_bar = {{0, 0}, {0, 2}, {4, 0}, {3, 3.5}};
  linkage.title = "A & B";
  linkage.length_unit = std::string("in");
  const std::string svg = draw_linkage(linkage);
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(svg, HasSubstr("A &amp; B"));
  EXPECT_THAT(svg, HasSubstr("4.0000 in"));
  linkage.poses = motion(testing::tailgate()).poses;
  EXPECT_TRUE(is_well_formed(draw_linkage(linkage)));
}

}  // namespace
}  // namespace linkwright
