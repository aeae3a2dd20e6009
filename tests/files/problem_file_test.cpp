#include "linkwright/files/problem_file.hpp"

#include <fmt/format.h>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "files/problem_writer.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/number_text.hpp"
#include "support/draws.hpp"
#include "support/file_support.hpp"

namespace linkwright::problem_file_test {
namespace {

using testing::motion;

using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string with(std::string_view members) {
  return R"({"linkwright": 1, "task": {"kind": "motion", "mechanism": "four_bar", "poses": [
    {"x": 0, "y": 0, "theta_deg": 0}, {"x": -125, "y": 75, "theta_deg": -25},
    {"x": -220, "y": 220, "theta_deg": -52}, {"x": -220, "y": 450, "theta_deg": -82}]})" +
         std::string(members) + "}";
}

Problem read(const std::string& text) {
  auto problem = read_problem(text);
  EXPECT_TRUE(problem.ok()) << (problem.ok() ? "" : problem.errors()[0].place + ": " + problem.errors()[0].message);
  return problem.ok() ? problem.value() : Problem{};
}

nlohmann::json problem_schema() {
  return nlohmann::json::parse(std::ifstream(LINKWRIGHT_SCHEMA_DIR "/problem.schema.json"));
}

TEST(ProblemFile, ReadsTheExample) {
  const auto problem = read_problem_file(std::filesystem::path(LINKWRIGHT_EXAMPLES_DIR) / "tailgate.json");
  ASSERT_TRUE(problem.ok());
  EXPECT_EQ(problem->title, "Tailgate hinge");
  EXPECT_EQ(problem->length_unit, "mm");
  ASSERT_EQ(motion(*problem).poses.size(), 4u);
  EXPECT_EQ(motion(*problem).poses[3].pose.origin, Point(-220, 450));
  EXPECT_EQ(motion(*problem).poses[3].pose.angle, radians(-82));
  EXPECT_EQ(problem->requirements.min_transmission_angle, radians(30));
  EXPECT_EQ(problem->requirements.max_length, 450);
  ASSERT_TRUE(problem->requirements.moving_pivots_within);
  EXPECT_EQ(problem->requirements.moving_pivots_within->y_high, 380);
}

TEST(ProblemFile, WithoutOptionalMembersHasTheDefaults) {
  const Problem problem = read(with(""));
  const Requirements defaults;
  EXPECT_EQ(problem.title, "");
  EXPECT_TRUE(problem.requirements.no_defects);
  EXPECT_EQ(problem.requirements.max_link_ratio, defaults.max_link_ratio);
  EXPECT_FALSE(problem.requirements.max_length);
  EXPECT_EQ(problem.options.region_samples, SynthesisOptions{}.region_samples);
  EXPECT_EQ(problem.view, "");
}

TEST(ProblemFile, TheSchemaTellsTheDefaultsThatATaskMakes) {
  const nlohmann::json members = problem_schema()["$defs"]["requirements"]["properties"];
  const auto words_of = [&](const char* key) { return members[key]["description"].get<std::string>(); };
  EXPECT_THAT(words_of("max_length"), HasSubstr(fmt::format("default {} times the task's", default_max_length)));
  EXPECT_THAT(words_of("min_length"), HasSubstr("default a thousandth of the task's"));
  EXPECT_EQ(default_min_length, 1e-3);
  EXPECT_EQ(SixBarSearchOptions{}.effort, SynthesisOptions{}.effort);
}

TEST(ProblemFile, NullSwitchesALimitOff) {
  const Problem problem = read(with(R"(, "requirements": {"types": null, "min_transmission_angle_deg": null,
    "max_link_ratio": null, "max_length": null, "ground_pivots_within": null, "moving_pivots_within": null})"));
  EXPECT_TRUE(problem.requirements.types.empty());
  EXPECT_EQ(problem.requirements.min_transmission_angle, 0);
  EXPECT_EQ(problem.requirements.max_link_ratio, Requirements::unlimited);
  EXPECT_EQ(problem.requirements.max_length, Requirements::unlimited);
  EXPECT_FALSE(problem.requirements.ground_pivots_within);
}

TEST(ProblemFile, ReadsRequirementsAndOptions) {
  const Problem problem =
      read(with(R"(, "requirements": {"types": ["double_crank", "change_point"], "no_defects": false,
      "respect_direction": false},
    "options": {"region_samples": 33.0, "spacing": "arc_length", "objective": "size", "best": 3,
      "window": [[0, 0.5], [0.25, 1]]})"));
  EXPECT_EQ(problem.requirements.types, (std::vector{LinkageType::double_crank, LinkageType::change_point}));
  EXPECT_FALSE(problem.requirements.no_defects);
  EXPECT_FALSE(problem.requirements.respect_direction);
  EXPECT_EQ(problem.options.region_samples, 33);
  EXPECT_EQ(problem.options.spacing, Spacing::arc_length);
  EXPECT_EQ(problem.options.objective, Objective::size);
  EXPECT_EQ(problem.options.best, 3);
  ASSERT_TRUE(problem.options.window);
  EXPECT_EQ(problem.options.window->output[0], 0.25);
}

TEST(ProblemFile, ReadsAPlaceOfTheMapAndWritesIt) {
  const Problem problem = read(with(R"(, "options": {"at": [0.1, 1.25]})"));
  ASSERT_TRUE(problem.options.at);
  EXPECT_EQ(problem.options.at->input, 0.1);
  EXPECT_EQ(problem.options.at->output, 1.25);
  EXPECT_EQ(read(write_problem(problem)).options.at->output, 1.25);
  EXPECT_FALSE(read(with(R"(, "options": {"at": null})")).options.at);
  EXPECT_FALSE(read_problem(with(R"(, "options": {"at": [0.1]})")).ok());
}

TEST(ProblemFile, MayHoldCommentsAndAByteOrderMark) {
  EXPECT_TRUE(read_problem("\xEF\xBB\xBF// a comment with \"quotes\" and {{{ brackets\n" + with("// more\n")).ok());
}

TEST(ProblemFile, ViewIsKeptAndNeverRead) {
  const Problem problem = read(with(R"(, "view": {"pins": [1.5, null], "outline": {"poses": "Tür"}})"));
  EXPECT_EQ(nlohmann::json::parse(problem.view),
            nlohmann::json::parse(R"({"pins":[1.5,null],"outline":{"poses":"Tür"}})"));
}

TEST(ProblemFile, TheOutlineIsReadOutOfTheViewAndWrittenBackIntoIt) {
  const Problem problem = read(with(R"(, "view": {"pins": [], "outline": [[0, 0], [1.5, 0], [0, 1e-3]]})"));
  EXPECT_EQ(problem.outline, (std::vector<Point>{{0, 0}, {1.5, 0}, {0, 1e-3}}));
  EXPECT_EQ(problem.view, R"({"pins":[]})");
  const Problem again = read(write_problem(problem));
  EXPECT_EQ(again.outline, problem.outline);
  EXPECT_EQ(again.view, problem.view);
  EXPECT_EQ(read(with(R"(, "view": {"outline": [[0, 0], [1, 0], [0, 1]]})")).view, "");
}

TEST(ProblemFile, WrittenProblemReadsBackAsItself) {
  const Problem problem = read(with(R"(, "title": "Tür \"A\" \\ \u0007 ∞", "length_unit": "in",
    "requirements": {"types": ["crank_rocker"], "min_transmission_angle_deg": 33.3, "max_link_ratio": null,
      "max_length": 0.1, "ground_pivots_within": {"x": [-1e-3, 1e9], "y": [0.1, 0.3]}},
    "options": {"region_samples": 17, "spacing": "arc_length", "objective": "link_ratio", "best": 0,
      "window": [[0.1, 0.7], [0.2, 0.3]]}, "view": {"a": [1e-7]})"));
  const std::string once = write_problem(problem);
  EXPECT_EQ(write_problem(read(once)), once);
  EXPECT_EQ(motion(read(once)).poses[1].pose.angle, motion(problem).poses[1].pose.angle);
  EXPECT_EQ(read(once).title, problem.title);
  EXPECT_EQ(read(once).view, problem.view);
}

TEST(ProblemFile, RequirementsOfAnotherClassAreRefusedInTheirPlace) {
  const auto mistake_of = [](std::string_view requirement) {
    const auto problem = read_problem(with(fmt::format(R"(, "requirements": {{{}}})", requirement)));
    if (problem || problem.errors().size() != 1) return std::string("none or several");
    return problem.errors()[0].code + " " + problem.errors()[0].place;
  };
  EXPECT_EQ(mistake_of(R"("min_link_angle_deg": 10)"), "requirement_of_class requirements.min_link_angle_deg");
  EXPECT_EQ(mistake_of(R"("min_link_angle_deg": 0)"), "requirement_of_class requirements.min_link_angle_deg");
  EXPECT_EQ(mistake_of(R"("max_link_angle_deg": 80)"), "requirement_of_class requirements.max_link_angle_deg");
  EXPECT_EQ(mistake_of(R"("fixed_axes_within": {"axis": [0, 0, 1], "half_angle_deg": 20})"),
            "requirement_of_class requirements.fixed_axes_within");
  EXPECT_EQ(mistake_of(R"("moving_axes_within": {"axis": [0, 0, 1], "half_angle_deg": 0})"),
            "half_angle_range requirements.moving_axes_within.half_angle_deg");
  EXPECT_EQ(mistake_of(R"("moving_axes_within": {"axis": [0, 0, 0], "half_angle_deg": 9})"),
            "axis_null requirements.moving_axes_within.axis");
  EXPECT_EQ(mistake_of(R"("types": ["triple_rocker"])"), "type_of_class requirements.types");
  EXPECT_TRUE(read_problem(with(R"(, "requirements": {"min_link_angle_deg": null, "fixed_axes_within": null})")).ok());
}

TEST(ProblemFile, HoldsTheRequirementsOfTheClassAndNoOthers) {
  const auto written = [](const Requirements& wanted) {
    std::string text;
    {
      JsonWriter json([&text](std::string_view piece) { text += piece; });
      write_requirements(json, wanted, spherical_linkages);
    }
    return nlohmann::json::parse(text);
  };
  Requirements wanted;
  wanted.types = {LinkageType::triple_rocker};
  wanted.min_link_angle = radians(12.5);
  wanted.fixed_axes_within = Cone{{0, 3, 4}, radians(33.3)};
  EXPECT_EQ(written(wanted), nlohmann::json::parse(R"({"types": ["triple_rocker"], "no_defects": true,
    "min_transmission_angle_deg": 0, "min_link_angle_deg": 12.5, "max_link_angle_deg": null,
    "fixed_axes_within": {"axis": [0, 3, 4], "half_angle_deg": 33.3}, "moving_axes_within": null,
    "respect_direction": true})"));
  wanted.min_link_angle = 0;
  EXPECT_TRUE(written(wanted)["min_link_angle_deg"].is_null()) << "switched off";
  EXPECT_FALSE(written(Requirements{}).contains("min_link_angle_deg")) << "the default, not known yet";
}

TEST(ProblemFile, AnObjectiveOfAnotherClassIsRefused) {
  const auto problem = read_problem(with(R"(, "options": {"objective": "link_angle"})"));
  ASSERT_FALSE(problem.ok());
  EXPECT_EQ(problem.errors()[0].code, "objective_of_class");
  EXPECT_EQ(problem.errors()[0].place, "options.objective");
  EXPECT_THAT(problem.errors()[0].message, HasSubstr(R"("min_transmission_angle", "link_ratio", "size")"));
}

std::string mixed(std::string_view poses) {
  return R"({"linkwright": 1, "task": {"kind": "motion", "mechanism": "four_bar", "poses": [)" + std::string(poses) +
         "]}}";
}

constexpr std::string_view hood = R"(
  {"x": 0, "y": 0, "theta_deg": 0, "derivatives": [{"x": 0, "y": 1, "theta": -0.004}]},
  {"x": -30, "y": 75, "theta_deg": -25, "derivatives": []}, {"x": -75, "y": 75, "theta_deg": -55})";

TEST(ProblemFile, ReadsDerivatives) {
  const Problem problem = read(mixed(hood));
  ASSERT_EQ(motion(problem).poses.size(), 3u);
  ASSERT_EQ(motion(problem).poses[0].derivatives.size(), 1u);
  EXPECT_EQ(motion(problem).poses[0].derivatives[0].origin, Point(0, 1));
  EXPECT_EQ(motion(problem).poses[0].derivatives[0].angle, -0.004) << "radians";
  EXPECT_TRUE(motion(problem).poses[1].derivatives.empty());
  const Problem one = read(mixed(R"({"x": 1, "y": 2, "theta_deg": 30, "derivatives": [
    {"x": 1, "y": 0, "theta": 0.8}, {"x": 0.6, "y": 1, "theta": 0.2}, {"x": 0, "y": 1.2, "theta": -0.3}]})"));
  ASSERT_EQ(motion(one).poses.size(), 1u);
  EXPECT_EQ(motion(one).poses[0].multiplicity(), 4);
  EXPECT_EQ(motion(one).poses[0].derivatives[2].angle, -0.3);
}

TEST(ProblemFile, WrittenDerivativesReadBackAsThemselves) {
  Problem problem = read(mixed(hood));
  motion(problem).poses[0].derivatives[0] = {{0.1, -1.0 / 3}, 1e-7};
  const std::string once = write_problem(problem);
  EXPECT_EQ(write_problem(read(once)), once);
  const PoseDerivative again = motion(read(once)).poses[0].derivatives[0];
  EXPECT_EQ(again.origin, motion(problem).poses[0].derivatives[0].origin);
  EXPECT_EQ(again.angle, 1e-7);
  const auto poses = nlohmann::json::parse(once)["task"]["poses"];
  EXPECT_FALSE(poses[1].contains("derivatives"));
  EXPECT_EQ(poses[0]["derivatives"].size(), 1u);
}

std::string with_task(std::string_view task, std::string_view options = "{}") {
  return R"({"linkwright": 1, "title": "T", "task": )" + std::string(task) + R"(, "options": )" + std::string(options) +
         "}";
}

std::string three(std::string_view given) {
  return with_task(R"({"kind": "motion", "mechanism": "four_bar", "poses": [{"x": 0.1, "y": 0, "theta_deg": 0.3},
    {"x": 50, "y": 30, "theta_deg": 33.3}, {"x": 60, "y": 90, "theta_deg": 80}], "given": )" +
                   std::string(given) + "}");
}

std::string five(std::string_view more) {
  return with_task(R"({"kind": "motion", "mechanism": "four_bar", "poses": [{"x": 0, "y": 0, "theta_deg": 0},
    {"x": 30, "y": 10, "theta_deg": 25}, {"x": 55, "y": 40, "theta_deg": 40}, {"x": 60, "y": 75, "theta_deg": 75},
    {"x": 40, "y": 100, "theta_deg": 110.1}])" +
                   std::string(more) + "}");
}

std::string function(std::string_view members, std::string_view options = "{}") {
  return with_task(
      R"({"kind": "function", "mechanism": "four_bar", "ground_pivots": {"input": [0.1, -3], "output": [1, 1e-3]}, )" +
          std::string(members) + "}",
      options);
}

constexpr std::string_view scale_of_sine = R"("function": {"expression": "sin_deg", "x": [0, 90.1],
  "y": [-0.1, 1.5], "input_range_deg": [0, -77.7], "output_range_deg": [10, 61.3], "points": 4, "spacing": "even"})";

// Poses by two points of the body are written in numbers.
TEST(ProblemFile, PosesByTwoPointsAreFitted) {
  const auto read = read_problem(R"({"linkwright": 1, "task": {"kind": "motion", "mechanism": "four_bar", "poses": [
    {"points": [[0, 0], [100, 0]]}, {"points": [[10, 20], [70, 100]]},
    {"points": [[40, 60], [40, 162]], "derivatives": []}], "given": {"side_lengths": [80, 60]}}})");
  ASSERT_TRUE(read.ok());
  const MotionTask& task = testing::motion(*read);
  ASSERT_EQ(task.points.size(), 3u);
  EXPECT_NEAR(task.poses[1].pose.angle, std::atan2(4, 3), 1e-15);
  EXPECT_LT(std::abs(task.poses[2].pose.origin - Point{40, 60 + (102 - 302.0 / 3) / 2}), 1e-12);
  const auto again = read_problem(write_problem(*read));
  ASSERT_TRUE(again.ok());
  EXPECT_TRUE(testing::motion(*again).points.empty());
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_LT(std::abs(testing::motion(*again).poses[i].pose.origin - task.poses[i].pose.origin), 1e-12);
}

const std::vector<std::string>& one_of_each_kind() {
  static const std::vector<std::string> problems = {
      three(R"({"side_lengths": [80.1, 60]})"),
      three(R"({"side_length": 0.1})"),
      three(R"({"side_angle_deg": 33.3, "directed": false})"),
      three(R"({"side_angle_deg": -60, "directed": true, "input_length": 7.7})"),
      three(R"({"instant_center": [-20.2, 0.1]})"),
      three(R"({"instant_center": [1, 0.3], "at_infinity": true})"),
      three(R"({"ground_pivots": {"input": [1, 0.3], "output": [0.1, 7.7]}})"),
      three(R"({"moving_pivots": {"input": [1, 0.3], "output": [0.1, 7.7]}})"),
      three(R"({"output_moving_pivot": [0.1, 7.7]})"),
      three(R"({"input_ground_pivot": [0.1, 7.7], "output_moving_pivot": [3, 3]})"),
      three(R"({"ground_pivot_on": {"point": [0.1, 7.7], "direction_deg": 33.3}})"),
      three(R"({"ground_pivot_on": {"point": [0.1, 7.7], "direction_deg": 33.3},
        "moving_pivot_on": {"point": [0, 0], "direction_deg": -90}})"),
      five(""),
      five(R"(, "freed_pose": 4)"),
      mixed(R"({"x": 1, "y": 2, "theta_deg": 30, "derivatives": [{"x": 1, "y": 0, "theta": 0.8}]},
        {"x": 4, "y": 3, "theta_deg": 70, "derivatives": [{"x": 0.1, "y": 1, "theta": 0.2}]},
        {"x": 5, "y": 6, "theta_deg": 100})"),
      function(std::string(scale_of_sine), R"({"objective": "structural_error"})"),
      function(std::string(scale_of_sine) + R"(, "free": {"number": "output_scale", "range": [0.3, 1.7]})"),
      function(R"("function": {"expression": "log", "x": [1, 10], "input_range_deg": [0, 60],
        "output_range_deg": [0, 60], "points": 5, "spacing": [1, 2.2, 3.3, 5, 9.9]})"),
      function(R"("function": {"table": [[0, 0], [1, 0.1], [2, 0.7], [3.3, 1]], "interpolation": "linear",
        "input_range_deg": [0, 60], "output_range_deg": [0, 60], "points": 4})"),
      function(R"("pairs": [{"input_deg": 0, "output_deg": 0}, {"input_deg": 30.3, "output_deg": 10},
        {"input_deg": 50, "output_deg": 30}, {"input_deg": 70, "output_deg": 70}],
        "free": {"number": "pair_output", "pair": 3, "range": [21.1, 41]})"),
      function(R"("pairs": [{"input_deg": 0, "output_deg": 0, "derivatives": [{"input": 1, "output": -0.3}]},
        {"input_deg": 50, "output_deg": 30}, {"input_deg": 70, "output_deg": 70.7}])"),
  };
  return problems;
}

TEST(ProblemFile, OfEveryKindReadsBackAsItself) {
  for (const std::string& text : one_of_each_kind()) {
    SCOPED_TRACE(text);
    const std::string once = write_problem(read(text));
    EXPECT_EQ(write_problem(read(once)), once);
    // What the file gave is echoed: nothing of the task is lost or changed.
    const auto given = nlohmann::json::parse(text)["task"], echo = nlohmann::json::parse(once)["task"];
    for (const auto& [key, value] : given.items()) {
      if (value.is_object())
        for (const auto& [inner, member] : value.items()) EXPECT_EQ(echo[key][inner], member) << key << "." << inner;
      else
        EXPECT_EQ(echo[key], value) << key;
    }
  }
}

// Tasks as they are written: members in order, defaults filled in.
std::vector<std::string> tasks_of_every_kind() {
  const std::string motion = R"({"kind":"motion","mechanism":"four_bar","poses":[{"x":0,"y":0,"theta_deg":0},)"
                             R"({"x":4,"y":10,"theta_deg":-10},{"x":34,"y":14,"theta_deg":-75}],"given":)";
  const std::string function = R"({"kind":"function","mechanism":"four_bar",)";
  const std::string pivots = R"("ground_pivots":{"input":[0,0],"output":[60.5,1]})";
  const std::string dials = R"("input_range_deg":[0,60],"output_range_deg":[0,-45.3],"points":)";
  const std::string pairs = R"("pairs":[{"input_deg":0,"output_deg":0,"derivatives":[{"input":1,"output":0.8}]},)"
                            R"({"input_deg":33.3,"output_deg":21.7},{"input_deg":60,"output_deg":30}],)";
  const std::string six_bar = R"({"kind":"motion","mechanism":"six_bar","poses":[{"x":0,"y":0,"theta_deg":0},)"
                              R"({"x":80,"y":30,"theta_deg":14},{"x":150,"y":90,"theta_deg":34},)"
                              R"({"x":200,"y":170,"theta_deg":57}],)";
  return {
      motion + R"({"side_length":18}})",
      motion + R"({"side_lengths":[18,24.1]}})",
      motion + R"({"side_angle_deg":33.3,"directed":false,"input_length":18}})",
      motion + R"({"instant_center":[20.1,-3]}})",
      motion + R"({"instant_center":[0,1],"at_infinity":true}})",
      motion + R"({"ground_pivots":{"input":[0,1],"output":[2.5,-1]}}})",
      motion + R"({"moving_pivots":{"input":[0,1],"output":[2.5,-1]}}})",
      motion + R"({"input_moving_pivot":[0.1,1]}})",
      motion + R"({"input_ground_pivot":[0.1,1],"output_moving_pivot":[3,1]}})",
      motion + R"({"ground_pivot_on":{"point":[0.1,1],"direction_deg":33.3}}})",
      motion + R"({"moving_pivot_on":{"point":[0.1,1],"direction_deg":-90}}})",
      function + pairs + pivots + "}",
      function + pairs + pivots + R"(,"free":{"number":"output_scale","range":[0.7,1.1]}})",
      function + pairs + pivots + R"(,"free":{"number":"pair_output","pair":2,"range":[20.1,30]}})",
      function + R"("function":{"expression":"x^-1.5","x":[1,2],)" + dials + R"(4,"spacing":[1,1.2,1.5,1.9]},)" +
          pivots + "}",
      function + R"("function":{"table":[[0,0],[1,2.5],[2,3],[4,3.5]],"interpolation":"linear","x":[0.5,3],)" +
          R"("y":[0,4],)" + dials + R"(5,"spacing":"even"},)" + pivots + "}",
      six_bar + R"("chain":{"a":[-250,-150],"b":[-200,220],"d":[100,90],"elbow":[1,-1,0,1]},"added":["0-2","3-4"]})",
      six_bar + R"("added":["1-3","0-4"]})"};
}

TEST(ProblemFile, TasksOfEveryKindAreWrittenAsTheyWereRead) {
  for (const std::string& task : tasks_of_every_kind()) {
    SCOPED_TRACE(task);
    const std::string text =
        R"({"linkwright":1,"options":{"box":{"x":[-300,300],"y":[-200,250.5]},"seed":7,"effort":100},)"
        R"("task":)" +
        task + "}";
    const std::string once = write_problem(read(text));
    const auto again = nlohmann::json::parse(once);
    EXPECT_EQ(again["task"], nlohmann::json::parse(task));
    const auto given = nlohmann::json::parse(text);
    for (const auto& [key, value] : given["options"].items()) EXPECT_EQ(again["options"][key], value);
    EXPECT_EQ(write_problem(read(once)), once);
  }
}

TEST(ProblemFile, ANamedFunctionBringsItsPairs) {
  const Problem problem = read(R"({"linkwright": 1, "task": {"kind": "function", "mechanism": "four_bar",
    "function": {"expression": "x^2", "x": [0, 1], "input_range_deg": [10, 70], "output_range_deg": [0, 90],
      "points": 5, "spacing": "even"}}})");
  const auto& task = std::get<FunctionTask>(problem.task);
  ASSERT_EQ(task.pairs.size(), 5u);
  EXPECT_NEAR(degrees(task.pairs[1].input), 25, 1e-12);
  EXPECT_NEAR(degrees(task.pairs[1].output), 90.0 / 16, 1e-12);
}

TEST(ProblemFile, FunctionsOfSphericalFourBarsComeBack) {
  for (const std::string wanted :
       {R"("pairs": [{"input_deg": 0, "output_deg": 0}, {"input_deg": 12, "output_deg": 20},
           {"input_deg": 26, "output_deg": 38, "derivatives": [{"input": 1, "output": 0.5}]}])",
        R"("function": {"expression": "x^2", "x": [0, 1], "input_range_deg": [10, 70], "output_range_deg": [0, 90]},
           "free": {"number": "output_scale", "range": [0.7, 1.4]})"}) {
    const Problem problem = read(R"({"linkwright": 1, "task": {"kind": "function", "mechanism": "spherical_four_bar",
      "ground_angle_deg": 70, )" +
                                 wanted + "}}");
    const auto& task = std::get<SphericalFunctionTask>(problem.task);
    EXPECT_NEAR(degrees(task.ground_angle), 70, 1e-12);
    EXPECT_EQ(position_count(task.pairs), 4);
    const Problem again = read(write_problem(problem));
    EXPECT_EQ(std::get<SphericalFunctionTask>(again.task), task);
    EXPECT_EQ(write_problem(again), write_problem(problem));
  }
}

TEST(ProblemFile, ASearchTakesItsBoxFromTheOptions) {
  const Problem problem =
      read(R"({"linkwright": 1, "options": {"box": {"x": [-300, 300], "y": [-200, 250]}}, "task":)" +
           tasks_of_every_kind().back() + "}");
  const auto& task = std::get<SixBarTask>(problem.task);
  ASSERT_TRUE(task.box);
  EXPECT_EQ(task.box->y_high, 250);
  EXPECT_FALSE(task.chain);
}

TEST(ProblemFile, AWrongBoxIsToldOnce) {
  const auto problem =
      read_problem(R"({"linkwright": 1, "options": {"box": {"x": [300, -300], "y": [-200, 250]}}, "task":)" +
                   tasks_of_every_kind().back() + "}");
  ASSERT_EQ(problem.errors().size(), 1u);
  EXPECT_EQ(problem.errors()[0].place, "options.box");
}

TEST(ProblemFile, ThousandsOfDerivativesAreOneMistake) {
  std::string derivatives = R"({"x": 1, "y": 0, "theta": 0})";
  for (int i = 0; i < 16; ++i) derivatives += "," + derivatives;
  const auto problem =
      read_problem(mixed(R"({"x": 1, "y": 2, "theta_deg": 30, "derivatives": [)" + derivatives + "]}"));
  ASSERT_EQ(problem.errors().size(), 1u);
  EXPECT_THAT(problem.errors()[0].message, StartsWith("65536 derivatives are given"));
}

TEST(ProblemFile, EchoesTheAngleThatWasGiven) {
  const std::string text = with("");
  const auto echo = nlohmann::json::parse(write_problem(read(text)));
  EXPECT_EQ(echo["task"]["poses"], nlohmann::json::parse(text)["task"]["poses"]);
}

TEST(ProblemFile, BadProblemsAreRefusedWithEveryMistakeInItsPlace) {
  const auto folder = std::filesystem::path(LINKWRIGHT_DATA_DIR) / "bad_problems";
  const auto expected = nlohmann::json::parse(testing::text_of(folder / "expected.json"))["files"];
  ASSERT_GE(expected.size(), 40u);
  for (const auto& [name, mistakes] : expected.items()) {
    SCOPED_TRACE(name);
    const auto problem = read_problem_file(folder / name);
    ASSERT_FALSE(problem.ok());
    ASSERT_EQ(problem.errors().size(), mistakes.size());
    for (std::size_t i = 0; i < mistakes.size(); ++i) {
      EXPECT_EQ(problem.errors()[i].place, mistakes[i][0].get<std::string>());
      EXPECT_THAT(problem.errors()[i].message, HasSubstr(mistakes[i][1].get<std::string>()));
      EXPECT_FALSE(problem.errors()[i].code.empty());
    }
  }
}

TEST(ProblemFile, HostileTextsAreRefusedQuickly) {
  const std::string brackets(1'000'000, '['), objects = [] {
    std::string text;
    for (int i = 0; i < 100'000; ++i) text += "{\"a\":";
    return text;
  }();
  for (const std::string& text :
       {brackets, objects, std::string(17 << 20, ' '), std::string(17 << 20, '1'), std::string(1 << 20, '"'),
        std::string(1 << 20, '\\'), std::string(1 << 20, '\xFF')}) {
    EXPECT_FALSE(read_problem(text).ok());
  }
}

TEST(ProblemFile, AMillionUnknownKeysAreCountedNotListed) {
  const int count = testing::draws(1'000'000);
  std::string members;
  for (int i = 0; i < count; ++i) members += ",\"k" + std::to_string(i) + "\":0";
  const auto problem = read_problem(with(members));
  ASSERT_FALSE(problem.ok());
  EXPECT_LE(problem.errors().size(), 101u);
  EXPECT_THAT(problem.errors().back().message, StartsWith(std::to_string(count - 100) + " more mistakes"));
}

TEST(ProblemFile, AnEndlessKeyIsCutInTheMessage) {
  const auto problem = read_problem(with(", \"" + std::string(5 << 20, 'k') + "\": 1"));
  ASSERT_FALSE(problem.ok());
  EXPECT_LT(problem.errors()[0].place.size(), 100u);
}

TEST(ProblemFile, EveryCutOfAFileIsRefused) {
  const std::string text = testing::text_of(std::filesystem::path(LINKWRIGHT_EXAMPLES_DIR) / "tailgate.json");
  const std::size_t end = text.rfind('}');
  for (std::size_t length = 0; length <= end; ++length)
    EXPECT_FALSE(read_problem(text.substr(0, length)).ok()) << length;
}

}  // namespace
}  // namespace linkwright::problem_file_test
