#include "linkwright/files/spherical_file.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/files/result_file.hpp"
#include "linkwright/files/six_bar_file.hpp"
#include "support/file_support.hpp"
#include "support/spherical_case.hpp"

namespace linkwright::spherical_file_test {
namespace {

/// The folding wing on a small map.
struct Solved {
  Problem problem;
  Answer answer;
  Solved() {
    problem.title = "Folding wing";
    SphericalMotionTask task;
    task.orientations = testing::spherical_case("folding-wing-4").orientations;
    problem.task = task;
    problem.options.region_samples = 60;
    problem.options.best = 2;
    auto found = solve(problem);
    EXPECT_TRUE(found.ok());
    answer = std::move(found).value();
    EXPECT_EQ(linkages().size(), 2u);
  }
  [[nodiscard]] const std::vector<SphericalSolution>& linkages() const {
    return std::get<SphericalMotionAnswer>(answer).linkages;
  }
};
const Solved& solved() {
  static const Solved once;
  return once;
}

StoredSphericalFourBar stored(std::size_t index = 0) {
  const auto linkages = read_any_result_linkages(write_result(solved().problem, solved().answer, false));
  EXPECT_TRUE(linkages.ok());
  return std::get<StoredSphericalFourBar>(linkages.value().at(index));
}

StoredSphericalFourBar read_one(const std::string& text) {
  const auto read = read_any_linkage(text);
  EXPECT_TRUE(read.ok()) << text;
  return std::get<StoredSphericalFourBar>(read.value());
}

std::string of_angles(double ground, double input, double coupler, double output) {
  return nlohmann::json{
      {"mechanism", "spherical_four_bar"},
      {"angles_deg", {{"ground", ground}, {"input", input}, {"coupler", coupler}, {"output", output}}}}
      .dump();
}

TEST(SphericalFile, ResultReadsBackBitIdentical) {
  for (std::size_t i = 0; i < 2; ++i) {
    const StoredSphericalFourBar read = stored(i);
    EXPECT_EQ(read.four_bar, solved().linkages()[i].four_bar);
    EXPECT_EQ(read.title, "Folding wing");
    EXPECT_EQ(read.orientations, std::get<SphericalMotionTask>(solved().problem.task).orientations);
  }
}

TEST(SphericalFile, ResultSaysWhatWasFound) {
  const auto result = nlohmann::json::parse(write_result(solved().problem, solved().answer, true));
  EXPECT_EQ(result["curve"]["kind"], "two_components");
  EXPECT_EQ(result["curve"]["samples"]["coordinate"].size(), 60u);
  EXPECT_EQ(result["curve"]["samples"]["moving_axis"].size(), 60u);
  EXPECT_EQ(result["curve"]["samples"]["fixed_axis"][59].size(), 3u);
  EXPECT_TRUE(result["dyads"].empty());
  const auto& linkage = result["linkages"][0];
  const SphericalSolution& found = solved().linkages()[0];
  EXPECT_EQ(linkage["mechanism"], "spherical_four_bar");
  EXPECT_EQ(linkage["type"], name(found.report.type));
  EXPECT_EQ(linkage["angles_deg"]["coupler"].get<double>(), degrees(found.angles.coupler));
  EXPECT_EQ(linkage["input"]["coordinate"].get<double>(), found.input.coordinate);
  EXPECT_EQ(linkage["verified_by_driving"], true);
  EXPECT_LT(linkage["residual"].get<double>(), 1e-12);
}

TEST(SphericalFile, LinkageReadsBackBitIdentical) {
  StoredSphericalFourBar without_record = stored();
  without_record.record.clear();
  for (const StoredSphericalFourBar& linkage : {stored(), without_record}) {
    const std::string text = write_linkage(linkage);
    const StoredSphericalFourBar again = read_one(text);
    EXPECT_EQ(again.four_bar, linkage.four_bar);
    EXPECT_EQ(again.title, linkage.title);
    EXPECT_EQ(again.orientations, linkage.orientations);
    EXPECT_EQ(write_linkage(again), text);
  }
}

/// Unit to rounding is unit enough: written and read again nothing changes, however the axes came about.
TEST(SphericalFile, AnyAxesReadBackBitIdentical) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> coordinate;
  const auto axis = [&] { return normalized(Vector3{coordinate(random), coordinate(random), coordinate(random)}); };
  for (int i = 0; i < 500; ++i) {
    StoredSphericalFourBar linkage;
    linkage.four_bar = {axis(), axis(), axis(), axis()};
    linkage.orientations = testing::random_orientations(random, 4);
    const StoredSphericalFourBar again = read_one(write_linkage(linkage));
    EXPECT_EQ(again.four_bar, linkage.four_bar);
    EXPECT_EQ(again.orientations, linkage.orientations);
  }
}

TEST(SphericalFile, AxesOfAnyLengthAreLines) {
  const StoredSphericalFourBar read = read_one(R"({"mechanism": "spherical_four_bar", "axes": {"input_fixed": [0, 0, 5],
    "input_moving": [0, 1, 1], "output_moving": [2, 1, 0], "output_fixed": [1, 0, 0]}})");
  EXPECT_EQ(read.four_bar.input_fixed, (Vector3{0, 0, 1}));
  EXPECT_NEAR(norm(read.four_bar.output_moving), 1, 1e-15);
  EXPECT_NEAR(degrees(read.four_bar.angles().input), 45, 1e-12);
  EXPECT_TRUE(read.orientations.empty());
}

TEST(SphericalFile, AnglesAreLaidOutAsALinkageOfThoseAngles) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> angle(2, 178);
  int laid = 0;
  for (int i = 0; i < 500; ++i) {
    const std::array<double, 4> wanted = {angle(random), angle(random), angle(random), angle(random)};
    const auto read = read_any_linkage(of_angles(wanted[0], wanted[1], wanted[2], wanted[3]));
    if (!read.ok()) {
      EXPECT_TRUE(read.errors()[0].code == "cannot_be_assembled_on_the_sphere" ||
                  read.errors()[0].code == "too_long_for_the_sphere");
      continue;
    }
    ++laid;
    const SphericalFourBar& bars = std::get<StoredSphericalFourBar>(*read).four_bar;
    const auto found = bars.angles().all();
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(degrees(found[k]), wanted[k], 1e-9);
    EXPECT_EQ(bars.input_fixed, (Vector3{0, 0, 1}));
    EXPECT_NEAR(bars.output_fixed.x, std::sin(radians(wanted[0])), 1e-12);
    EXPECT_EQ(assembly_of(bars), Assembly::positive);
  }
  EXPECT_GT(laid, 200);
}

TEST(SphericalFile, MistakesSayWhereAndWhat) {
  struct Bad {
    std::string members, place, words;
  };
  const std::string rest = R"("input_moving": [0, 1, 1], "output_moving": [2, 1, 0], "output_fixed": [1, 0, 0]}})";
  const std::vector<Bad> table = {
      {"}", "", "add \"axes\", \"angles_deg\""},
      {R"(, "axes": 3})", "axes", "object"},
      {R"(, "axes": {)" + rest, "axes.input_fixed", "missing"},
      {R"(, "axes": {"input_fixed": null, )" + rest, "axes.input_fixed", "3 numbers"},
      {R"(, "axes": {"input_fixed": [0, 0], )" + rest, "axes.input_fixed", "3 numbers [x, y, z] belong here, not 2"},
      {R"(, "axes": {"input_fixed": [0, 0, 0], )" + rest, "axes.input_fixed", "no direction"},
      {R"(, "axes": {"input_fixed": [0, 0, 1e300], )" + rest, "axes.input_fixed", "too large"},
      {R"(, "axes": {"input_fixed": [0, -1, -1], )" + rest, "axes", "in one line"},
      {R"(, "axes": {"input_fixt": [0, 0, 1], )" + rest, "axes.input_fixt", "\"input_fixed\""},
      {R"(, "angles_deg": {"ground": 0, "input": 30, "coupler": 60, "output": 60}})", "angles_deg.ground",
       "between 0° and 180°, not 0°"},
      {R"(, "angles_deg": {"ground": 60, "input": 180, "coupler": 60, "output": 60}})", "angles_deg.input",
       "between 0° and 180°, not 180°"},
      {R"(, "angles_deg": {"ground": 100, "input": 20, "coupler": 30, "output": 40}})", "angles_deg",
       "the longest link (100°) is longer than the other three together (90°)"},
      {R"(, "angles_deg": {"ground": 170, "input": 160, "coupler": 150, "output": 40}})", "angles_deg",
       "the three longest links together (480°) are longer than the shortest and a full turn (400°)"},
      {R"(, "input": {"fixed_axis": [0, 0, 1]}})", "input.moving_axis", "missing"},
      {R"(, "angles_deg": {"ground": 60, "input": 30, "coupler": 60, "output": 60}, "orientations": [3]})",
       "orientations[0]", "object"},
      {R"(, "angles_deg": {"ground": 60, "input": 30, "coupler": 60, "output": 60}, "orientations": [1,2,3,4,5,6]})",
       "orientations", "at most 5 orientations"},
  };
  for (const Bad& bad : table) {
    const auto read = read_any_linkage(R"({"mechanism": "spherical_four_bar")" + bad.members);
    ASSERT_FALSE(read.ok()) << bad.words;
    EXPECT_EQ(read.errors()[0].place, bad.place) << read.errors()[0].message;
    EXPECT_NE(read.errors()[0].message.find(bad.words), std::string::npos) << read.errors()[0].message;
  }
}

/// The orientations of a task, each in another form.
nlohmann::json in_all_forms() {
  return nlohmann::json::parse(R"([
    {"matrix": [[1, 0, 0], [0, 0.6, -0.8], [0, 0.8, 0.6]]},
    {"matrix": [[0.8, -0.61, 0], [0.6, 0.8, 0], [0, 0.001, 1.01]], "nearest": true},
    {"axis": [0, 0.1, 3], "angle_deg": 390.1, "angular_velocity": [0.1, 0, 0.2]},
    {"rotation_vector": [0.1, 0.7000000000000001, -2e-3]},
    {"quaternion": [-2, 0.1, 0.3333333333333333, 5]},
    {"euler_deg": [10.1, -400, 3.3], "sequence": "zyx"},
    {"euler_deg": [10.1, -40, 3.3], "sequence": "zxz", "turning": "extrinsic"}
  ])");
}

nlohmann::json problem_of(const nlohmann::json& orientations) {
  return {{"linkwright", 1},
          {"task", {{"kind", "motion"}, {"mechanism", "spherical_four_bar"}, {"orientations", orientations}}}};
}

Problem read_task(const nlohmann::json& orientations) {
  const auto read = read_problem(problem_of(orientations).dump());
  EXPECT_TRUE(read.ok()) << read.errors()[0].message;
  return *read;
}

TEST(SphericalFile, TaskIsEchoedInTheFormsInWhichItWasGiven) {
  const auto all = in_all_forms();
  for (std::size_t first = 0; first + 4 <= all.size(); ++first) {
    const nlohmann::json given(std::vector<nlohmann::json>(all.begin() + first, all.begin() + first + 4));
    const Problem problem = read_task(given);
    const std::string text = write_problem(problem);
    EXPECT_EQ(nlohmann::json::parse(text)["task"]["orientations"], given) << text;
    const auto again = read_problem(text);
    ASSERT_TRUE(again.ok());
    EXPECT_EQ(again->task, problem.task);
    EXPECT_EQ(write_problem(*again), text);
  }
}

TEST(SphericalFile, LinkagesCarryTheOrientationsAsGiven) {
  const auto all = in_all_forms();
  StoredSphericalFourBar linkage = stored();
  linkage.orientations.clear();
  for (const std::size_t i : {1, 2, 6})
    linkage.orientations.push_back(
        std::get<SphericalMotionTask>(read_task({all[i], all[0], all[3], all[4]}).task).orientations[0]);
  const std::string text = write_linkage(linkage);
  EXPECT_EQ(nlohmann::json::parse(text)["orientations"], (nlohmann::json{all[1], all[2], all[6]}));
  EXPECT_EQ(write_linkage(read_one(text)), text);
  EXPECT_EQ(read_one(text).orientations, linkage.orientations);
}

TEST(SphericalFile, AChangedOrientationIsWrittenAsItIs) {
  auto problem = read_task({in_all_forms()[0], in_all_forms()[3], in_all_forms()[4], in_all_forms()[5]});
  auto& task = std::get<SphericalMotionTask>(problem.task);
  task.orientations[0].orientation = UnitQuaternion::about({0, 0, 1}, 1);
  const auto again = read_problem(write_problem(problem));
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(again->task, problem.task);
}

TEST(SphericalFile, SequencesAreEchoedByLetters) {
  auto orientations = in_all_forms();
  orientations.erase(orientations.begin(), orientations.begin() + 3);
  orientations[2]["sequence"] = "3-2-1";
  const auto written = nlohmann::json::parse(write_problem(read_task(orientations)));
  EXPECT_EQ(written["task"]["orientations"][2]["sequence"], "zyx");
}

TEST(SphericalFile, TasksTakeFiveForms) {
  auto orientations = in_all_forms();
  orientations.erase(orientations.begin(), orientations.begin() + 3);
  orientations[1] = {{"rodrigues", {0, 0, 1}}};
  const auto read = read_problem(problem_of(orientations).dump());
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.errors()[0].code, "foreign_key") << "no known one is like it";
  EXPECT_EQ(read.errors()[0].place, "task.orientations[1].rodrigues");
}

TEST(SphericalFile, ReadersOfFourBarsRefuseIt) {
  const auto linkage = read_linkage(of_angles(80, 30, 70, 75));
  ASSERT_FALSE(linkage.ok());
  EXPECT_EQ(linkage.errors()[0].code, "not_a_four_bar");
  EXPECT_NE(linkage.errors()[0].message.find("spherical"), std::string::npos);
}

std::vector<std::vector<std::string>> cells(const std::string& table) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    rows.emplace_back();
    std::istringstream row(line + ",");
    for (std::string cell; std::getline(row, cell, ',');) rows.back().push_back(cell);
  }
  return rows;
}

TEST(SphericalFile, TableMeetsTheOrientations) {
  const StoredSphericalFourBar linkage = stored();
  const auto rows = cells(motion_table(analyze(linkage)));
  ASSERT_GT(rows.size(), 300u);
  const auto position =
      static_cast<std::size_t>(std::find(rows[0].begin(), rows[0].end(), "position") - rows[0].begin());
  ASSERT_LT(position, rows[0].size());
  std::string met;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    ASSERT_EQ(rows[i].size(), rows[0].size());
    const std::string& at = rows[i][position];
    if (at.empty()) continue;
    met += at;
    const auto& wanted = linkage.orientations.at(std::stoul(at) - 1).orientation;
    const auto q = UnitQuaternion::of(std::stod(rows[i][8]),
                                      {std::stod(rows[i][9]), std::stod(rows[i][10]), std::stod(rows[i][11])});
    ASSERT_TRUE(q.ok());
    EXPECT_LT(angle_between(*q, wanted), 1e-6);
  }
  std::sort(met.begin(), met.end());
  EXPECT_EQ(met, "1234");
}

TEST(SphericalFile, AnalysisIsWritten) {
  const auto crank = nlohmann::json::parse(write_analysis(analyze(read_one(of_angles(80, 30, 70, 75)))));
  EXPECT_EQ(crank["type"], "crank_rocker");
  EXPECT_EQ(crank["input_is_crank"], true);
  EXPECT_TRUE(crank["triple_rocker"].is_null());
  EXPECT_TRUE(crank["dead_points"].empty());
  EXPECT_EQ(crank["motion"]["input_deg"].size(), crank["motion"]["turn"].size());
  const auto rocker = nlohmann::json::parse(write_analysis(analyze(read_one(of_angles(80, 70, 30, 45)))));
  EXPECT_EQ(rocker["input_is_crank"], false);
  EXPECT_EQ(rocker["dead_points"].size(), 4u) << "two to each of its two ranges";
  EXPECT_TRUE(rocker["min_transmission_angle_full_turn_deg"].is_null());
}

}  // namespace
}  // namespace linkwright::spherical_file_test
