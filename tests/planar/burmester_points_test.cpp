#include "linkwright/planar/burmester_points.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <nlohmann/json.hpp>
#include <random>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/defects.hpp"
#include "linkwright/mechanism/position.hpp"
#include "support/dyad_measures.hpp"
#include "support/random_four_bar.hpp"
#include "support/random_task.hpp"

namespace linkwright::burmester_points_test {
namespace {

using testing::apart;
using testing::nearest;

using testing::uniform;

std::vector<PrescribedPose> prescribed(const std::vector<Pose>& poses) {
  std::vector<PrescribedPose> result;
  for (const Pose& pose : poses) result.push_back({pose, {}});
  return result;
}

int counted(const BurmesterPoints& found) {
  int sum = found.complex_roots;
  for (const BurmesterPoint& point : found.points) sum += point.multiplicity;
  return sum;
}

nlohmann::json file(const std::string& name) {
  return nlohmann::json::parse(std::ifstream(LINKWRIGHT_DATA_DIR "/five_positions/" + name + ".json"));
}

std::vector<PrescribedPose> positions_of(const nlohmann::json& json) {
  std::vector<PrescribedPose> poses;
  for (const auto& position : json.at("positions")) {
    poses.push_back({{{position[0][0], position[0][1]}, position[0][2]}, {}});
    for (std::size_t m = 1; m < position.size(); ++m)
      poses.back().derivatives.push_back({{position[m][0], position[m][1]}, position[m][2]});
  }
  return poses;
}

const std::map<std::string, LinkageType> types = {
    {"GRRC", LinkageType::rocker_crank},          {"GCRR", LinkageType::crank_rocker},
    {"GRCR", LinkageType::double_rocker},         {"RRR2", LinkageType::triple_rocker_input},
    {"RRR3", LinkageType::triple_rocker_coupler}, {"RRR4", LinkageType::triple_rocker_output}};

class FivePositionCase : public ::testing::TestWithParam<std::string> {};

TEST_P(FivePositionCase, HasTheConditionAndTheDyadsThatWereComputedElsewhere) {
  const nlohmann::json json = file(GetParam());
  const PoseConditions conditions = pose_conditions(positions_of(json));
  EXPECT_EQ(conditions.rank, 4);
  EXPECT_NEAR(conditions.frame.scale / json["working_frame"]["scale"].get<double>(), 1, 1e-12);
  EXPECT_NEAR(conditions.condition() / json["condition"].get<double>(), 1, 1e-10);
  const BurmesterPoints found = burmester_points(conditions);
  ASSERT_EQ(found.points.size(), json["count_real"]);
  EXPECT_EQ(counted(found), 4);
  EXPECT_FALSE(found.degeneracy);
  for (const auto& dyad : json["burmester_dyads_real"]) {
    const auto& z = dyad["Z"];
    const auto& c = dyad["C"];
    EXPECT_LT(nearest(found, {{c[0], c[1], c[2]}, {z[0], z[1], z[2]}}), 1e-12);
  }
}

TEST_P(FivePositionCase, HasFourBarsOfTheTypesAndDefectsStated) {
  const nlohmann::json json = file(GetParam());
  const auto poses = positions_of(json);
  const auto pivots = [&](const nlohmann::json& index) {
    const auto& dyad = json["burmester_dyads_real"][index.get<std::size_t>()];
    const auto &c = dyad["centre_point"], &z = dyad["circle_point"];
    return std::array<Point, 2>{Point{c[0], c[1]}, Point{z[0], z[1]}};
  };
  for (const auto& stated : json["four_bars"]) {
    const auto a = pivots(stated["driver"]), b = pivots(stated["driven"]);
    const DefectReport report = find_defects({a[0], a[1], b[0], b[1]}, poses);
    EXPECT_EQ(report.type, types.at(stated["type"]));
    EXPECT_EQ(report.defects.circuit(), stated["circuit"]);
    EXPECT_EQ(report.defects.branch(), stated["branch"]);
    if (!report.defects.branch()) {
      EXPECT_EQ(report.defects.order(), stated["order"]);
    }
    if (report.defects.none()) {
      EXPECT_NEAR(degrees(report.min_transmission_angle), stated["gamma_task"], 1e-6);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(OfData, FivePositionCase,
                         ::testing::Values("five_PP-P-P-P", "five_PPP-PP", "five_PPPPP", "five_finite_a", "five_hatch"),
                         [](const auto& of) {
                           std::string name = of.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(BurmesterPoints, OfPublishedTasksLieWhereTheyWereFoundElsewhere) {
  for (const std::string name : {"pm5-kinzel-2006", "pm5-sandor-erdman"}) {
    const nlohmann::json json = file(name);
    std::vector<Pose> poses;
    for (const auto& pose : json["input"]["poses"])
      poses.push_back({{pose["x"], pose["y"]}, radians(pose["theta_deg"].get<double>())});
    const PoseConditions conditions = pose_conditions(prescribed(poses));
    const BurmesterPoints found = burmester_points(conditions);
    const auto& own = json["own_result"];
    ASSERT_EQ(found.points.size(), own["n_real"]) << name;
    EXPECT_EQ(found.complex_roots, own["n_complex"]) << name;
    for (const auto& dyad : own["real_dyads"]) {
      const auto &c = dyad["fixed_pivot"], &z = dyad["moving_pivot_in_position_1"];
      double best = 1;
      for (const BurmesterPoint& point : found.points) {
        const Dyad user = conditions.frame.to_user(point.dyad);
        const Point center = finite_point(user.center).value_or(1e9), circle = finite_point(user.circle).value_or(1e9);
        best = std::min(best, std::abs(center - Point{c[0], c[1]}) + std::abs(circle - Point{z[0], z[1]}));
      }
      EXPECT_LT(best, 3e-8) << name;  // eight decimals are printed
    }
  }
}

// Where the fifth condition changes its sign along the curve of the first four positions.
int sign_changes(const PoseConditions& five, const std::vector<PrescribedPose>& poses) {
  const PoseConditions four = pose_conditions({poses.begin(), poses.begin() + 4});
  const BurmesterCurve curve(four);
  const double scale = four.frame.scale / five.frame.scale;  // same origin
  const auto rescaled = [&](Homogeneous p) { return normalized(Homogeneous{p.w, scale * p.x, scale * p.y}); };
  const Pose &from = poses.front().pose, &to = poses.back().pose;
  const PoseConditions last = pose_conditions({{from, {}}, {to, {}}});
  const double to_last = five.frame.scale / last.frame.scale;
  int changes = 0;
  for (const CurveBranch& branch : curve.branches()) {
    constexpr int steps = 3000;
    Homogeneous circle{}, center{};
    double before = 0;
    for (int i = 0; i <= steps; ++i) {
      const Dyad dyad = curve.dyad(branch.from + (branch.to - branch.from) * (i % steps + 1e-3) / steps);
      Homogeneous z = rescaled(dyad.circle), c = rescaled(dyad.center);
      if (i > 0 && dot(z, circle) < 0) z = -1.0 * z;
      if (i > 0 && dot(c, center) < 0) c = -1.0 * c;
      const Homogeneous zl{z.w, to_last * z.x, to_last * z.y}, cl{c.w, to_last * c.x, to_last * c.y};
      const double value = dot(zl, last.rows[0] * cl);
      changes += i > 0 && (value < 0) != (before < 0);
      before = value, circle = z, center = c;
    }
  }
  return changes;
}

TEST(BurmesterPoints, AreAsManyAsTheFifthConditionHasZerosOnTheCurveOfTheOthers) {
  std::mt19937_64 random(51);
  int differ = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const auto poses = testing::random_poses(random, 5);
    const PoseConditions conditions = pose_conditions(poses);
    // Two zeros within a step are not seen.
    differ += sign_changes(conditions, poses) != static_cast<int>(burmester_points(conditions).points.size());
  }
  EXPECT_LE(differ, 1);
}

TEST(BurmesterPoints, HoldTheTwoSideLinksOfALinkageThatWasDrivenThroughThePoses) {
  std::mt19937_64 random(52);
  int tried = 0;
  double worst = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Point a{uniform(random, -1, 1), uniform(random, -1, 1)}, b{uniform(random, 1, 2), uniform(random, -1, 1)};
    const FourBar bars{{0, 0}, a, {uniform(random, 1, 3), 0}, b};
    const Configuration start = configuration_of(bars);
    std::vector<Pose> poses;
    for (int j = 0; j < 5; ++j) {
      const auto there = assemble(bars.lengths(), start.input_angle + 0.25 * j, assembly_of(bars));
      if (!there) break;
      const FourBar moved = placed(bars, *there);
      const double turn = std::arg((moved.output_moving - moved.input_moving) / (b - a));
      poses.push_back({moved.input_moving + direction(turn) * (Point{0.2, 0.3} - a), turn});
    }
    if (poses.size() < 5) continue;
    const PoseConditions conditions = pose_conditions(prescribed(poses));
    if (conditions.condition() > 1e5) continue;
    ++tried;
    const BurmesterPoints found = burmester_points(conditions);
    for (const auto& [center, circle] : {std::pair{bars.input_fixed, a}, std::pair{bars.output_fixed, b}}) {
      const Dyad wanted{normalized(conditions.frame.to_working(Homogeneous::of(center))),
                        normalized(conditions.frame.to_working(Homogeneous::of(circle)))};
      double condition = 1, best = 2;
      for (const BurmesterPoint& point : found.points)
        if (const double distance = apart(point.dyad, wanted); distance < best)
          best = distance, condition = point.condition;
      worst = std::max(worst, best / condition);
    }
  }
  EXPECT_GT(tried, 100);
  EXPECT_LT(worst, 1e-14);
}

TEST(BurmesterPoints, MoveNoFurtherThanTheirConditionSays) {
  std::mt19937_64 random(53);
  constexpr double nudge = 1e-9;
  double most = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const auto poses = testing::random_poses(random, 5);
    const PoseConditions conditions = pose_conditions(poses);
    const BurmesterPoints before = burmester_points(conditions);
    auto moved = poses;
    for (std::size_t j = 1; j < 5; ++j)
      moved[j].pose.origin += nudge * conditions.frame.scale * direction(uniform(random, -pi, pi));
    const PoseConditions other = pose_conditions(moved);
    const BurmesterPoints after = burmester_points(other);
    for (const BurmesterPoint& point : before.points) {
      if (point.condition > 1e5) continue;
      const Dyad user = conditions.frame.to_user(point.dyad);
      const double distance =
          nearest(after, {other.frame.to_working(user.center), other.frame.to_working(user.circle)});
      most = std::max(most, distance / (nudge * point.condition));
    }
  }
  EXPECT_LT(most, 4);     // four rows, each by about the nudge
  EXPECT_GT(most, 0.01);  // and no idle bound
}

TEST(BurmesterPoints, KeepSliders) {
  // A body whose point (1, 0) slides along the line y = 0, and whose point (0, 1) turns about (0, −1).
  std::vector<Pose> poses;
  for (const double angle : {0.0, 0.2, 0.45, 0.7, 1.0}) {
    // Origin such that the second condition holds: (x, 0) with |x + i e^{iθ}(...)| kept, solved for x.
    const Point arm = direction(angle) * Point{-1, 1};
    const double reach = std::norm(Point{0, 1} - Point{0, -1});
    const double height = arm.imag() + 1, x = -arm.real() + std::sqrt(reach - height * height);
    poses.push_back({Point{x, 0} - direction(angle) * Point{1, 0}, angle});
  }
  const PoseConditions conditions = pose_conditions(prescribed(poses));
  const BurmesterPoints found = burmester_points(conditions);
  int sliders = 0;
  for (const BurmesterPoint& point : found.points) {
    EXPECT_LT(point.residual, 1e-14);
    if (!is_at_infinity(point.dyad.center)) continue;
    ++sliders;
    const Dyad user = conditions.frame.to_user(point.dyad);
    EXPECT_NEAR(std::abs(user.center.x) / norm(user.center), 0, 1e-9);
    EXPECT_NEAR(user.circle.y / user.circle.w, 0, 1e-9);
  }
  EXPECT_EQ(sliders, 1);
}

TEST(BurmesterPoints, ThatMeetAreOneOfMultiplicityTwo) {
  std::mt19937_64 random(54);
  int tried = 0;
  for (int trial = 0; tried < 20 && trial < 400; ++trial) {
    const auto from = testing::random_poses(random, 5);
    auto to = from;
    to[4].pose.origin += Point{uniform(random, -1, 1), uniform(random, -1, 1)};
    const auto at = [&](double s) {
      auto poses = from;
      poses[4].pose.origin += s * (to[4].pose.origin - from[4].pose.origin);
      return burmester_points(pose_conditions(poses));
    };
    const int first = at(0).complex_roots;
    if (first == at(1).complex_roots) continue;
    double low = 0, high = 1;
    BurmesterPoints found;
    for (int step = 0; step < 60; ++step) {
      found = at((low + high) / 2);
      if (std::any_of(found.points.begin(), found.points.end(), [](const auto& p) { return p.multiplicity > 1; }))
        break;
      (found.complex_roots == first ? low : high) = (low + high) / 2;
    }
    ++tried;
    EXPECT_EQ(counted(found), 4);
    ASSERT_EQ(found.warnings.size(), 1u);
    EXPECT_EQ(found.warnings[0].code, "double_point");
    const auto which = static_cast<std::size_t>(std::get<double>(found.warnings[0].values[0].value)) - 1;
    EXPECT_EQ(found.points[which].multiplicity, 2);
    EXPECT_LT(found.points[which].residual, 1e-11);
    EXPECT_GT(found.points[which].condition, 1e5);
  }
  EXPECT_EQ(tried, 20);
}

TEST(BurmesterPoints, OfTurnsAboutOnePoleAreAllPoints) {
  std::vector<Pose> poses;
  for (const double angle : {0.0, 0.3, 0.8, 1.1, 2.0})
    poses.push_back({Point{5, -7} + direction(angle) * Point{3, 4}, angle});
  const BurmesterPoints found = burmester_points(pose_conditions(prescribed(poses)));
  ASSERT_TRUE(found.degeneracy);
  EXPECT_EQ(found.degeneracy->code, "common_pole");
  EXPECT_TRUE(found.points.empty());
}

TEST(BurmesterPoints, OfParallelPosesAreToldByTheCircleOfTheirOrigins) {
  const auto code_of = [](Point last) {
    const BurmesterPoints found = burmester_points(
        pose_conditions(prescribed({{{2, 0}, 0}, {{0, 2}, 0}, {{-2, 0}, 0}, {{0, -2}, 0}, {last, 0}})));
    return found.degeneracy ? found.degeneracy->code : "";
  };
  EXPECT_EQ(code_of(2.0 * direction(0.7)), "translations_on_circle");
  EXPECT_EQ(code_of({1, 0.5}), "only_translations");
}

TEST(BurmesterPoints, OfARepeatedConditionAreTheCurveOfTheOthers) {
  std::mt19937_64 random(55);
  auto poses = testing::random_poses(random, 4);
  poses.push_back(poses[2]);
  const BurmesterPoints found = burmester_points(pose_conditions(poses));
  ASSERT_TRUE(found.degeneracy);
  EXPECT_EQ(found.degeneracy->code, "dependent_rows");
  ASSERT_TRUE(found.curve);
  const PoseConditions four = pose_conditions({poses.begin(), poses.begin() + 4});
  EXPECT_EQ(found.curve->kind(), BurmesterCurve(four).kind());
}

TEST(BurmesterPoints, OfFivePositionsOfCardansCirclesAreAWholeCircle) {
  std::vector<Pose> poses;
  for (const double angle : {0.1, 0.5, 0.8, 1.4, 2.3}) poses.push_back({direction(angle), -angle});
  const BurmesterPoints found = burmester_points(pose_conditions(prescribed(poses)));
  ASSERT_TRUE(found.degeneracy);
  EXPECT_EQ(found.degeneracy->code, "common_component");
}

std::vector<FivePoses> random_tasks(std::mt19937_64& random, int count) {
  std::vector<FivePoses> tasks(static_cast<std::size_t>(count));
  for (FivePoses& poses : tasks)
    for (Pose& pose : poses) pose = {{uniform(random, -2, 2), uniform(random, -2, 2)}, uniform(random, -3, 3)};
  return tasks;
}

BurmesterPoints carefully(const FivePoses& poses) {
  return burmester_points(pose_conditions(prescribed({poses.begin(), poses.end()})));
}

// Those of one task by the quick way are those by the careful one; gives how far they are from it.
double compare(const BurmesterDyads& quick, const FivePoses& poses) {
  const BurmesterPoints found = carefully(poses);
  const int count = static_cast<int>(found.points.size());
  EXPECT_EQ(quick.count, count);
  if (quick.count != count) return std::numeric_limits<double>::infinity();
  EXPECT_EQ(quick.complex_roots, found.complex_roots);
  EXPECT_EQ(quick.degenerate, found.degeneracy.has_value());
  double worst = 0;
  for (std::size_t k = 0; k < found.points.size(); ++k) {
    EXPECT_EQ(quick.dyads[k].coordinate, found.points[k].dyad.coordinate);
    EXPECT_EQ(quick.multiplicity[k], found.points[k].multiplicity);
    const double distance = apart(quick.dyads[k], found.points[k].dyad);
    EXPECT_LT(distance, 1e-15 * found.points[k].condition + 1e-15);
    worst = std::max(worst, distance);
  }
  return worst;
}

TEST(BurmesterPoints, OfManyTasksAtOnceAreTheSame) {
  std::mt19937_64 random(56);
  std::vector<FivePoses> tasks = random_tasks(random, 2001);  // no multiple of a pack or a block
  for (std::size_t i = 0; i < 5; ++i)
    tasks[1][i] = {direction(0.3 * static_cast<double>(i)), 0.3 * static_cast<double>(i)};
  for (std::size_t i = 0; i < 5; ++i) tasks[2][i].angle = 0;
  tasks[3][4] = tasks[3][0];
  for (Pose& pose : tasks[4]) pose.origin = 0;
  for (Pose& pose : tasks[5]) pose = {1e9 * pose.origin, pose.angle};
  for (Pose& pose : tasks[6]) pose = {1e-9 * pose.origin, pose.angle};
  for (Pose& pose : tasks[7]) pose.angle += 2000 * pi;
  std::vector<BurmesterDyads> quick(tasks.size());
  burmester_points_of_all(tasks, quick);
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    EXPECT_LT(compare(quick[i], tasks[i]), 1e-12) << i;
    const WorkingFrame frame = pose_conditions(prescribed({tasks[i].begin(), tasks[i].end()})).frame;
    EXPECT_NEAR(quick[i].frame.scale / frame.scale, 1, 1e-14) << i;
    EXPECT_EQ(quick[i].frame.origin, frame.origin) << i;
  }
}

TEST(BurmesterPoints, OfManyTasksAtOnceHaveTheSameBitsOnEveryMachine) {
  std::mt19937_64 random(57);
  const std::vector<FivePoses> tasks = random_tasks(random, 500);
  std::vector<BurmesterDyads> scalar(tasks.size()), other(tasks.size());
  burmester_points_of_all(tasks, scalar, Simd::scalar);
  for (const Simd simd : {Simd::baseline, Simd::avx2, Simd::avx512}) {
    if (!is_supported(simd)) continue;
    burmester_points_of_all(tasks, other, simd);
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      EXPECT_EQ(other[i].frame.scale, scalar[i].frame.scale) << name(simd) << i;
      ASSERT_EQ(other[i].count, scalar[i].count) << name(simd) << i;
      for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(apart(other[i].dyads[k], scalar[i].dyads[k]), 0) << name(simd) << i;
    }
  }
}

FivePoses between(const FivePoses& a, const FivePoses& b, double share) {
  FivePoses poses;
  for (std::size_t i = 0; i < poses.size(); ++i)
    poses[i] = {a[i].origin + share * (b[i].origin - a[i].origin), a[i].angle + share * (b[i].angle - a[i].angle)};
  return poses;
}

// The quick way has no branches: it must step back where points run together.
TEST(BurmesterPoints, OfManyTasksAtOnceGoTheCarefulWayInTime) {
  std::mt19937_64 random(58);
  std::vector<FivePoses> tasks;
  for (int pair = 0; pair < 20; ++pair) {
    const std::vector<FivePoses> ends = random_tasks(random, 2);
    const std::size_t before = carefully(ends[0]).points.size();
    double low = 0, high = 1;
    while (high - low > 1e-15) {
      const double middle = (low + high) / 2;
      (carefully(between(ends[0], ends[1], middle)).points.size() == before ? low : high) = middle;
    }
    for (double away = 1e-15; away < 0.1; away *= 4)
      for (const double share : {low - away, low + away}) tasks.push_back(between(ends[0], ends[1], share));
  }
  std::vector<BurmesterDyads> quick(tasks.size());
  burmester_points_of_all(tasks, quick);
  int multiple = 0;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    compare(quick[i], tasks[i]);
    for (const int times : quick[i].multiplicity) multiple += times > 1;
  }
  EXPECT_GT(multiple, 20);
}

TEST(BurmesterPoints, OfNoTasksAreNone) { burmester_points_of_all({}, {}); }

}  // namespace
}  // namespace linkwright::burmester_points_test
