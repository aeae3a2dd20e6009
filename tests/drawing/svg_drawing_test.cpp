#include "linkwright/drawing/svg_drawing.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <regex>
#include <vector>

#include "drawing/svg_canvas.hpp"
#include "linkwright/core/angle.hpp"
#include "support/draws.hpp"
#include "support/file_support.hpp"
#include "support/spherical_case.hpp"
#include "support/spherical_function.hpp"
#include "support/straight_line_tasks.hpp"

namespace linkwright::svg_drawing_test {
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

// Any letters may stand in the text of a picture's bytes.
std::string without_pictures(std::string svg) {
  constexpr std::string_view beginning = "base64,";
  for (std::size_t at = svg.find(beginning); at != std::string::npos; at = svg.find(beginning, at + 1))
    svg.erase(at + beginning.size(), svg.find('"', at) - at - beginning.size());
  return svg;
}

TEST(SvgDrawing, OfASolutionShowsTaskRegionAndNumbers) {
  const std::string svg = draw_answer(testing::tailgate(), testing::solved_tailgate());
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(svg, HasSubstr("Tailgate hinge"));
  EXPECT_THAT(svg, HasSubstr("data:image/png;base64,"));
  EXPECT_THAT(svg, HasSubstr("closed branch"));
  EXPECT_THAT(svg, HasSubstr("∞"));
  EXPECT_THAT(svg, HasSubstr("100 mm"));
  EXPECT_THAT(without_pictures(svg), Not(HasSubstr("nan")));
  EXPECT_LT(svg.size(), 300'000u);
}

TEST(SvgDrawing, EscapesTheTitle) {
  Problem problem = testing::tailgate();
  problem.title = "<b>\"A\" & 'B'</b>\n\x01\xFF\xEF\xBF\xBF ]]> 门";
  problem.length_unit = "<mm>";
  const std::string svg = draw_answer(problem, testing::solved_tailgate());
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(svg, HasSubstr("&lt;b&gt;&quot;A&quot; &amp; 'B'&lt;/b&gt;"));
  EXPECT_THAT(svg, HasSubstr("门"));
  EXPECT_THAT(svg, Not(HasSubstr("\x01")));
  EXPECT_THAT(svg, Not(HasSubstr("\xFF")));
}

TEST(SvgDrawing, StaysSmallForLargeRegions) {
  Problem problem = testing::tailgate();
  problem.options.region_samples = 1500;
  EXPECT_LT(draw_answer(problem, testing::answer_of(problem)).size(), 300'000u);
}

TEST(SvgDrawing, OfATaskWithoutLinkagesSaysWhy) {
  Problem nothing_left = testing::tailgate();
  nothing_left.requirements.max_length = 1;
  for (const Problem& problem : {nothing_left, testing::problem_of({{0, 0, 0}, {1, 1, 0}, {2, 5, 0}, {3, 2, 0}}),
                                 testing::problem_of({{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0.6, 0.8, 0}}),
                                 testing::problem_of({{0, 0, 0}, {1, 1, 0}, {2, 1, 0}, {3, 2, 100}})}) {
    const Answer answer = testing::answer_of(problem);
    const std::string svg = draw_answer(problem, answer);
    EXPECT_TRUE(is_well_formed(svg));
    EXPECT_THAT(without_pictures(svg), Not(HasSubstr("nan")));
    EXPECT_THAT(svg, HasSubstr(testing::four_bars(answer).linkages.empty() ? "No linkage to show" : "Best linkage"));
  }
}

TEST(SvgDrawing, DoesNotDependOnWhereAndHowLargeTheTaskIs) {
  Problem moved = testing::tailgate();
  moved.requirements = {};
  for (PrescribedPose& pose : motion(moved).poses) pose.pose.origin = 1e-3 * pose.pose.origin + Point{0.5, -0.25};
  const std::string svg = draw_answer(moved, testing::answer_of(moved));
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(svg, Not(HasSubstr("1e+")));
}

std::size_t count_of(const std::string& text, const std::string& piece) {
  std::size_t count = 0;
  for (std::size_t at = text.find(piece); at != std::string::npos; at = text.find(piece, at + 1)) ++count;
  return count;
}

TEST(SvgDrawing, ShowsTheDirectionOfTravelAsAnArrow) {
  const std::string svg = draw_answer(testing::hood_hinge(), testing::solved_hood_hinge());
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(without_pictures(svg), Not(HasSubstr("nan")));
  StoredLinkage linkage;
  linkage.four_bar = testing::four_bars(testing::solved_hood_hinge()).linkages.front().four_bar;
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

/// No text begins or ends beyond the picture's borders, as far as the font's width is known.
void expect_texts_inside(const std::string& svg, double width, double height) {
  const std::regex text("<text x=\"([-.\\d]+)\" y=\"([-.\\d]+)\" font-size=\"([.\\d]+)\"([^>]*)>([^<]*)</text>");
  int count = 0;
  for (std::sregex_iterator found(svg.begin(), svg.end(), text), end; found != end; ++found, ++count) {
    const std::string rest = (*found)[4];
    const std::string words = std::regex_replace((*found)[5].str(), std::regex(" +"), " ");  // as they are drawn
    if (rest.find("rotate") != std::string::npos) continue;
    const double room = text_width(words, std::stod((*found)[3])), x = std::stod((*found)[1]);
    const bool ends = rest.find("\"end\"") != std::string::npos, centred = rest.find("middle") != std::string::npos;
    const double left = ends ? x - room : centred ? x - room / 2 : x;
    EXPECT_GE(left, 0) << words;
    EXPECT_LE(left + room, width) << words;
    EXPECT_LE(std::stod((*found)[2]), height) << words;
  }
  EXPECT_GT(count, 8);
}

void expect_whole(const std::string& svg) {
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(without_pictures(svg), Not(HasSubstr("nan")));
  EXPECT_THAT(svg, Not(HasSubstr("inf\"")));
  EXPECT_LT(svg.size(), 300'000u);
  expect_texts_inside(svg, 1440, 900);
}

TEST(SvgDrawing, OfThreePositionsHasDirectionsInDegrees) {
  const auto& [problem, answer] = testing::three_positions();
  const std::string svg = draw_answer(problem, answer);
  expect_whole(svg);
  EXPECT_THAT(svg, HasSubstr("Three positions (P-P-P), grounded links 18 and 24"));
  EXPECT_THAT(svg, HasSubstr("direction β₁ in position 1, degrees"));
  EXPECT_THAT(svg, HasSubstr("sheet 2"));
  EXPECT_THAT(svg, HasSubstr(">150</text>"));
  EXPECT_THAT(svg, Not(HasSubstr("our positions")));
  EXPECT_THAT(svg, HasSubstr("directions β₁ and β₂"));
}

TEST(SvgDrawing, OfFivePositionsIsABoardWithBeads) {
  const auto& [problem, answer] = testing::five_positions();
  const std::string svg = draw_answer(problem, answer);
  expect_whole(svg);
  EXPECT_THAT(svg, HasSubstr("4 Burmester points"));
  EXPECT_EQ(count_of(svg, "r=\"4.5\""), 7u + 2u) << "the fourth fixed pivot is metres away; two in the key";
  EXPECT_THAT(svg, HasSubstr("every cell is a pair of dyads"));
  EXPECT_THAT(svg, HasSubstr("branch defect"));
  EXPECT_THAT(svg, HasSubstr("γ 46.6°"));
  EXPECT_THAT(svg, HasSubstr("dyads, by their numbers"));
}

TEST(SvgDrawing, OfFivePositionsWithoutAnswerShowsAWayOut) {
  const auto& [problem, answer] = testing::five_without_answer();
  const std::string svg = draw_answer(problem, answer);
  expect_whole(svg);
  EXPECT_THAT(svg, HasSubstr("Alternative: without position "));
  EXPECT_THAT(svg, HasSubstr("No linkage to show"));
  EXPECT_THAT(svg, HasSubstr("error "));
}

TEST(SvgDrawing, OfAFunctionHasItsRibbonDialsAndError) {
  const auto& [problem, answer] = testing::function();
  const std::string svg = draw_answer(problem, answer);
  expect_whole(svg);
  EXPECT_THAT(svg, HasSubstr("Solution region: every value is one four-bar"));
  EXPECT_THAT(svg, HasSubstr("Structural error of linkage 1"));
  EXPECT_THAT(svg, HasSubstr("Input, degrees"));
  EXPECT_THAT(svg, HasSubstr("largest structural error"));
  EXPECT_THAT(svg, Not(HasSubstr("path of the frame's origin")));
}

TEST(SvgDrawing, OfOtherKindsIsWhole) {
  const char* const pairs = R"("pairs": [{"input_deg": 0, "output_deg": 0}, {"input_deg": 30, "output_deg": 10},
    {"input_deg": 50, "output_deg": 30}, {"input_deg": 70, "output_deg": 70}])";
  const char* const poses = R"("poses": [{"x": 0, "y": 0, "theta_deg": 0}, {"x": 50, "y": 30, "theta_deg": 30},
    {"x": 60, "y": 90, "theta_deg": 80}])";
  const char* const shifts = R"("poses": [{"x": 0, "y": 0, "theta_deg": 0}, {"x": 50, "y": 30, "theta_deg": 0},
    {"x": 60, "y": 90, "theta_deg": 80}])";
  const std::string motion_start = R"({"kind": "motion", "mechanism": "four_bar", )",
                    function_start = R"({"kind": "function", "mechanism": "four_bar", )";
  const std::pair<std::string, std::string> tasks[] = {
      {motion_start + poses + R"(, "given": {"side_angle_deg": 60, "directed": false}})", "length R₂"},
      {motion_start + poses + R"(, "given": {"instant_center": [-20, 120]}})", "Burmester curve: "},
      {motion_start + shifts + R"(, "given": {"side_lengths": [80, 60]}})", "on its circle"},
      {motion_start + poses + R"(, "given": {"side_lengths": [1e-3, 60]}})", "No linkage to show"},
      {function_start + pairs + "}", "output over input"},
      {function_start + pairs + R"(, "free": {"number": "output_scale", "range": [0.5, 2]}})", "Output scale"},
      {function_start + R"("function": {"expression": "log", "x": [1, 10], "input_range_deg": [0, 60],
        "output_range_deg": [0, 60], "points": 5}})",
       "every cell is one four-bar"},
  };
  for (const auto& [task, words] : tasks) {
    SCOPED_TRACE(task);
    const Problem problem = testing::problem_from(
        R"({"linkwright": 1, "options": {"region_samples": 40, "best": 3}, "task": )" + task + "}");
    const std::string svg = draw_answer(problem, testing::answer_of(problem));
    expect_whole(svg);
    EXPECT_THAT(svg, HasSubstr(words));
  }
}

TEST(SvgDrawing, OfASinglePoseHasRoom) {
  Problem problem = testing::problem_of({{1e5, -2e5, 30}});
  motion(problem).poses[0].derivatives = {{{100, 0}, 0.8}, {{60, 100}, 0.2}, {{0, 120}, -0.3}};
  for (const double max_length : {1e-6, 1e9}) {
    problem.requirements.max_length = max_length;
    const Answer answer = testing::answer_of(problem);
    EXPECT_EQ(testing::four_bars(answer).linkages.empty(), max_length < 1);
    const std::string svg = draw_answer(problem, answer);
    EXPECT_TRUE(is_well_formed(svg));
    EXPECT_THAT(without_pictures(svg), Not(HasSubstr("nan")));
    EXPECT_GT(count_of(svg, "<polyline"), 1u) << "the curves";
    EXPECT_LT(svg.size(), 300'000u);
  }
}

/// The wing of data/spherical with so many samples, and what is found for it.
std::pair<Problem, Answer> folded_wing(int samples) {
  Problem problem;
  problem.title = "Wing & tip";
  problem.task = SphericalMotionTask{testing::spherical_case("folding-wing-4").orientations, {}};
  problem.options.region_samples = samples;
  problem.options.best = 1;
  return {problem, testing::answer_of(problem)};
}

TEST(SvgDrawing, OfASphericalTaskShowsBothConesTheMapAndTheLinkage) {
  const auto [problem, answer] = folded_wing(60);
  const std::string svg = draw_answer(problem, answer);
  EXPECT_TRUE(is_well_formed(svg));
  for (const char* words : {"Wing &amp; tip", "cone of fixed axes", "cone of moving axes", "odd branch", "oval",
                            "data:image/png;base64,", "Best spherical four-bar", ">Triple rocker</text>"})
    EXPECT_THAT(svg, HasSubstr(words));
  EXPECT_THAT(svg, Not(HasSubstr("ground longest")));
  for (const char* name : {">G₁</text>", ">G₂</text>", ">W₁</text>", ">W₂</text>"}) {
    const auto first = svg.find(name);
    ASSERT_NE(first, std::string::npos) << name;
    EXPECT_NE(svg.find(name, first + 1), std::string::npos) << "in both views";
  }
  EXPECT_THAT(without_pictures(svg), Not(HasSubstr("nan")));
  EXPECT_EQ(draw_answer(problem, answer), svg);
}

TEST(SvgDrawing, OfASphericalTaskStaysSmall) {
  const auto [problem, answer] = folded_wing(400);
  EXPECT_LT(draw_answer(problem, answer).size(), 300'000u);
}

TEST(SvgDrawing, OfASphericalTaskWithoutLinkagesSaysWhy) {
  auto [problem, answer] = folded_wing(40);
  problem.requirements.min_transmission_angle = radians(89.9);
  problem.requirements.min_link_angle = radians(70);
  const std::string svg = draw_answer(problem, testing::answer_of(problem));
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(svg, HasSubstr("No linkage to show"));
  EXPECT_THAT(svg, HasSubstr("The orientations"));
  EXPECT_THAT(svg, Not(HasSubstr(">G₁</text>")));
}

TEST(SvgDrawing, OfASphericalLinkageShowsWhatIsHiddenThin) {
  StoredSphericalFourBar linkage;
  linkage.four_bar = {{0, 0, 1}, {0, -0.6, 0.8}, {0.8, -0.6, 0}, {1, 0, 0}};
  const std::string svg = draw_linkage(linkage);
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(svg, HasSubstr("stroke-width=\"7\""));
  EXPECT_THAT(svg, HasSubstr("90°"));
  const std::string dashed = "stroke-width=\"1.6\" stroke-dasharray=\"5 4\"";
  EXPECT_THAT(svg, Not(HasSubstr(dashed))) << "all of it lies in front";
  linkage.four_bar = {{0, 0, 1}, {0, 0.6, 0.8}, {0.8, 0.6, 0}, normalized(Vector3{0.6, -0.9, -0.2})};
  EXPECT_THAT(draw_linkage(linkage), HasSubstr(dashed));
}

/// Left ends of a text.
std::vector<double> places_of(const std::string& words, const std::string& svg) {
  const std::regex text("<text x=\"([0-9.]+)\"[^>]*>" + words);
  std::vector<double> found;
  for (std::sregex_iterator at(svg.begin(), svg.end(), text), end; at != end; ++at)
    found.push_back(std::stod((*at)[1]));
  return found;
}

TEST(SvgDrawing, OfASphericalLinkageHasRoomForItsKeys) {
  StoredSphericalFourBar linkage;
  linkage.four_bar = {{0, 0, 1}, {0, -0.6, 0.8}, {0.8, -0.6, 0}, {1, 0, 0}};
  const auto places = places_of("dead point of the input", draw_linkage(linkage));
  ASSERT_EQ(places.size(), 1u);
  constexpr double wide_letter = 10, right_edge = 980;
  EXPECT_LT(places[0] + 23 * wide_letter, right_edge);
}

TEST(SvgDrawing, OfASphericalFunctionShowsTheLinkageInBothViewsAboveItsError) {
  Problem problem;
  problem.task = testing::named_spherical_task("x^2", {0, 1}, 60, 80, 70);
  problem.options.region_samples = 100;
  const std::string svg = draw_answer(problem, testing::answer_of(problem));
  EXPECT_TRUE(is_well_formed(svg));
  for (const char* words : {"Best spherical four-bar", "along the mean of the axes", "the same from 60° above",
                            "path of the coupler's middle", "Structural error of linkage 1"})
    EXPECT_THAT(svg, HasSubstr(words));
  for (const char* name : {"G₁</text>", "G₂</text>", "W₁</text>", "W₂</text>"})
    EXPECT_EQ(places_of(name, svg).size(), 2u);
  EXPECT_THAT(without_pictures(svg), Not(HasSubstr("nan")));
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

/// What is found for a straight line on a small map.
testing::Solved solved_line(const StraightLineTask& task) {
  Problem problem;
  problem.title = "Line & strip";
  problem.length_unit = "mm";
  problem.task = task;
  problem.options.region_samples = 16;
  problem.options.best = 2;
  problem.options.effort = 500;
  problem.options.objective = Objective::stroke;
  return {problem, testing::answer_of(problem)};
}

TEST(SvgDrawing, OfEveryStraightLineIsWhole) {
  const auto tasks = testing::straight_line_tasks();
  const int every = static_cast<int>(tasks.size()) / testing::draws(static_cast<int>(tasks.size()));
  for (std::size_t i = 0; i < tasks.size(); i += static_cast<std::size_t>(every)) {
    const StraightLineTask& task = tasks[i];
    SCOPED_TRACE(name(task.given));
    const auto [problem, answer] = solved_line(task);
    ASSERT_FALSE(std::get<StraightLineAnswer>(answer).linkages.empty());
    const std::string svg = draw_answer(problem, answer);
    expect_whole(svg);
    for (const char* words : {"Line &amp; strip", "Best linkage", "usable length", "inflection circle", ">C</text>",
                              ">A₀</text>", ">B₀</text>", "Deviation of C from the line", "fold</text>", ">+δ</text>",
                              "Way s of the point along the line, mm", "C to input pin", "points of contact"})
      EXPECT_THAT(svg, HasSubstr(words));
    const auto& lines = std::get<StraightLineAnswer>(answer).lines;
    const bool has_map = lines != nullptr && !lines->axis(Side::input).is_discrete();
    EXPECT_EQ(svg.find("data:image/png;base64,") != std::string::npos, has_map);
    EXPECT_EQ(svg.find("The linkages of this task") != std::string::npos, lines != nullptr && !has_map);
    EXPECT_EQ(svg.find("The best of all cases") != std::string::npos, lines == nullptr);
  }
}

TEST(SvgDrawing, OfAStraightLineStacksTheLayers) {
  const auto [problem, answer] = solved_line({LineAtAngle{{0, 40}, 0.1}, straight_cases::FivePoint{100, 0.7}});
  const std::string svg = draw_answer(problem, answer);
  for (const char* layer : {">AB</text>", ">AD</text>", ">BD</text>"}) EXPECT_THAT(svg, HasSubstr(layer));
  EXPECT_THAT(svg, Not(HasSubstr("link_ray")));
}

TEST(SvgDrawing, OfAStraightLineMarksContactsAndStroke) {
  const auto [problem, answer] =
      solved_line({LineAtAngle{{0, 4}, 0}, straight_cases::MixedContacts{{0, 0}, {{1, 3, 1}, {3, 1, 1}}, 0}});
  const std::string svg = draw_answer(problem, answer);
  EXPECT_THAT(svg, HasSubstr(">3</text>"));
  EXPECT_THAT(svg, HasSubstr("stroke, off the line by "));
}

TEST(SvgDrawing, OfAStraightLineWithoutLinkagesSaysWhy) {
  auto [problem, answer] = solved_line(testing::straight_line_tasks().front());
  problem.requirements.min_stroke = 1e6;
  const std::string svg = draw_answer(problem, testing::answer_of(problem));
  expect_whole(svg);
  EXPECT_THAT(svg, HasSubstr("No linkage to show"));
  EXPECT_THAT(svg, HasSubstr(">The line</text>"));
  EXPECT_THAT(svg, Not(HasSubstr("Deviation of C")));
}

TEST(SvgDrawing, OfALinkageWithAPointShowsItsLine) {
  StoredLinkage linkage;
  linkage.four_bar = {{-2, 0}, {-1, 2}, {2, 0}, {1, 2}};
  const std::string without = draw_linkage(linkage);
  linkage.point = Point{0, 3};
  const std::string svg = draw_linkage(linkage);
  EXPECT_TRUE(is_well_formed(svg));
  for (const char* words : {">C</text>", ">C to input pin</text>", ">usable length</text>", ">0.0000, 3.0000</text>"}) {
    EXPECT_THAT(svg, HasSubstr(words));
    EXPECT_THAT(without, Not(HasSubstr(words)));
  }
  linkage.point = Point{0, 4};  // the pole, where it rests
  EXPECT_TRUE(is_well_formed(draw_linkage(linkage)));
  EXPECT_THAT(draw_linkage(linkage), Not(HasSubstr("nan")));
}

}  // namespace
}  // namespace linkwright::svg_drawing_test
