#include "linkwright/planar/burmester_curve.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/tolerance.hpp"
#include "planar/task_curve.hpp"
#include "support/case_coordinates.hpp"
#include "support/planar_case.hpp"
#include "support/random_task.hpp"
#include "support/tailgate.hpp"

namespace linkwright::burmester_curve_test {
namespace {

using testing::planar_case;
using testing::planar_cases;

bool beyond_the_arithmetic(const std::string& name) { return name == "tiny_1e-2" || name == "tiny_1e-6"; }

std::string expected_kind(std::string theirs) {
  if (theirs == "all-points") return "every_point";
  if (theirs == "line at infinity + double line" || theirs == "line at infinity + two lines")
    return "line_at_infinity_and_lines";
  if (theirs == "line at infinity + conic") return "line_at_infinity_and_conic";
  if (theirs == "line+circle") return "line_and_circle";
  for (char& c : theirs)
    if (c == ' ') c = '_';
  return theirs;
}

TEST(BurmesterCurve, CasesAgreeInKindAndKappa) {
  for (const auto& c : planar_cases()) {
    if (c.name == "tiny_1e-6") continue;
    const BurmesterCurve curve(pose_conditions(c.poses));
    EXPECT_EQ(name(curve.kind()), expected_kind(c.json["circle_point_curve"]["kind"])) << c.name;
    EXPECT_EQ(name(curve.center_kind()), expected_kind(c.json["centre_point_curve"]["kind"])) << c.name;
    const auto& focal = c.json["circle_point_curve"].value("focal", nlohmann::json::object());
    if (!focal.contains("k2") || focal["k2"].is_null()) continue;
    ASSERT_TRUE(curve.kappa()) << c.name;
    EXPECT_NEAR(*curve.kappa(), 1 - focal["k2"].get<double>(), 1e-9) << c.name;
  }
}

// There a whole line of centres may belong to the circle point.
bool is_double_point(const BurmesterCurve& curve, Homogeneous circle) {
  for (const Homogeneous p : curve.circle_curve().double_points())
    if (great_circle(p, circle) < 1e-9) return true;
  return false;
}

TEST(BurmesterCurve, CasesAgreeInEverySampleOfTheCirclePointCurve) {
  for (const auto& c : planar_cases()) {
    const auto& samples =
        c.json["circle_point_curve"].value("samples_homogeneous_working_frame", nlohmann::json::array());
    const BurmesterCurve curve(pose_conditions(c.poses));
    // Pure translations: every pair of points at infinity is a dyad, and no partner is the partner.
    if (beyond_the_arithmetic(c.name) || c.name == "pure_translations" || samples.empty()) continue;
    std::vector<double> theirs;
    for (const auto& sample : samples) theirs.push_back(sample["tau"]);
    const std::vector<double> ours = our_coordinates(c, curve, theirs);
    for (std::size_t i = 0; i < ours.size(); ++i) {
      const Dyad dyad = curve.dyad(ours[i]);
      const Homogeneous z{samples[i]["Z"][0], samples[i]["Z"][1], samples[i]["Z"][2]};
      const Homogeneous m{samples[i]["C"][0], samples[i]["C"][1], samples[i]["C"][2]};
      EXPECT_LT(great_circle(dyad.circle, z), 1e-9) << c.name << " tau " << theirs[i];
      EXPECT_LT(curve.residual(dyad), 1e-15) << c.name;
      if (is_double_point(curve, z)) continue;
      EXPECT_LT(great_circle(dyad.center, m), 1e-9) << c.name << " tau " << theirs[i];
    }
  }
}

// Whether some dyad of the curve is this one: on the circle-point curve, or on a centre line.
bool contains(const BurmesterCurve& curve, Homogeneous circle, Homogeneous center) {
  const Dyad on_curve = curve.dyad(*curve.circle_curve().coordinate_of(circle));
  if (great_circle(on_curve.circle, circle) < 1e-8 && great_circle(on_curve.center, center) < 1e-8) return true;
  for (const CurveBranch& branch : curve.branches()) {
    if (branch.name != "center_line") continue;
    const Dyad a = curve.dyad(branch.from), b = curve.dyad(branch.from + 0.5);
    if (great_circle(a.circle, circle) < 1e-8 && std::abs(determinant(a.center, b.center, center)) < 1e-8) return true;
  }
  return false;
}

TEST(BurmesterCurve, CasesHaveEveryDyadOfTheCentrePointCurve) {
  for (const auto& c : planar_cases()) {
    const auto& samples =
        c.json["centre_point_curve"].value("samples_homogeneous_working_frame", nlohmann::json::array());
    const BurmesterCurve curve(pose_conditions(c.poses));
    if (beyond_the_arithmetic(c.name) || c.name == "pure_translations" || samples.empty()) continue;
    for (const auto& sample : samples)
      EXPECT_TRUE(contains(curve, {sample["Z"][0], sample["Z"][1], sample["Z"][2]},
                           {sample["C"][0], sample["C"][1], sample["C"][2]}))
          << c.name << " tau " << sample["tau"];
  }
}

TEST(BurmesterCurve, EverySampleKeepsItsLengthInUserCoordinates) {
  std::mt19937_64 random(11);
  for (int trial = 0; trial < 300; ++trial) {
    const auto poses = testing::random_poses(random);
    const PoseConditions conditions = pose_conditions(poses);
    const BurmesterCurve curve(conditions);
    for (const double tau : curve.samples(31, Spacing::coordinate)) {
      const Dyad dyad = conditions.frame.to_user(curve.dyad(tau));
      const auto z = conditions.frame.finite_user_point(dyad.circle),
                 c = conditions.frame.finite_user_point(dyad.center);
      if (!z || !c || std::abs(*z) > 1e4 || std::abs(*c) > 1e4) continue;
      for (const PrescribedPose& pose : poses) {
        const double length = std::abs(displaced(*z, poses[0].pose, pose.pose) - *c);
        EXPECT_NEAR(length / std::abs(*z - *c), 1, 1e-8) << trial;
      }
    }
  }
}

TEST(BurmesterCurve, NearACommonPoleShortSideLinksKeepTheirLengths) {
  std::mt19937_64 random(12);
  for (const double deviation : {1e-4, 1e-6, 1e-8}) {
    const auto poses = testing::nearly_common_pole(random, deviation);
    const PoseConditions conditions = pose_conditions(poses);
    const BurmesterCurve curve(conditions);
    for (const double tau : curve.samples(101, Spacing::coordinate)) {
      const Dyad working = curve.dyad(tau);
      EXPECT_LT(curve.residual(working), 1e-15 / deviation);
      const Dyad dyad = conditions.frame.to_user(working);
      const auto z = conditions.frame.finite_user_point(dyad.circle),
                 c = conditions.frame.finite_user_point(dyad.center);
      if (!z || !c) continue;
      // Rounding of the pivots is all that is left.
      for (const PrescribedPose& pose : poses)
        EXPECT_NEAR(std::abs(displaced(*z, poses[0].pose, pose.pose) - *c), std::abs(*z - *c),
                    5e-15 * (1 + std::abs(*z) + std::abs(*c)))
            << deviation << " at " << tau;
    }
  }
}

// Both points leave the pole once, within a stretch of τ as short as the deviation.
TEST(BurmesterCurve, NearACommonPoleItsRunGoesToInfinityAndBack) {
  std::mt19937_64 random(13);
  for (const double deviation : {1e-3, 1e-5, 1e-7, 1e-9}) {
    const BurmesterCurve curve(pose_conditions(testing::nearly_common_pole(random, deviation)));
    EXPECT_NEAR(curve.arc_length_table().length.back(), two_pi, 100 * deviation) << deviation;
    int far = 0;
    for (const double tau : curve.samples(100, Spacing::arc_length)) {
      const Dyad dyad = curve.dyad(tau);
      far += great_circle(dyad.circle, dyad.center) > 0.1 ? 1 : 0;
    }
    EXPECT_GT(far, 80) << deviation;
  }
}

TEST(BurmesterCurve, NearMirrorSymmetryItRunsAlongTheCurveOfTheMirroredPoses) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    std::mt19937_64 same(seed);
    const double mirrored =
        BurmesterCurve(pose_conditions(testing::nearly_mirrored(same, 0))).arc_length_table().length.back();
    for (const double deviation : {1e-10, 1e-8, 1e-6, 1e-5}) {
      std::mt19937_64 random(seed);
      const BurmesterCurve curve(pose_conditions(testing::nearly_mirrored(random, deviation)));
      EXPECT_NEAR(curve.arc_length_table().length.back() / mirrored, 1, 0.02) << deviation;
      for (const double tau : curve.samples(400, Spacing::arc_length))
        EXPECT_LT(curve.residual(curve.dyad(tau)), 1e-15) << deviation << " at " << tau;
    }
  }
}

TEST(BurmesterCurve, PassesThroughPolesAndImagePoles) {
  std::mt19937_64 random(5);
  for (int trial = 0; trial < 100; ++trial) {
    const auto poses = testing::random_poses(random);
    const PoseConditions conditions = pose_conditions(poses);
    const BurmesterCurve curve(conditions);
    const auto working = conditions.frame.to_working(poses);
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j) {
        // The point that the turn from i to j leaves in place.
        const Point r = direction(working[j].pose.angle - working[i].pose.angle);
        const Point pole = (working[j].pose.origin - r * working[i].pose.origin) / (1.0 - r);
        const auto on_centers = curve.center_curve().coordinate_of(Homogeneous::of(pole));
        EXPECT_LT(great_circle(curve.center_curve().point(*on_centers), Homogeneous::of(pole)), 1e-9);
        const Homogeneous image = Homogeneous::of(displaced(pole, working[i].pose, working[0].pose));
        const auto on_circles = curve.circle_curve().coordinate_of(image);
        EXPECT_LT(great_circle(curve.circle_curve().point(*on_circles), image), 1e-9);
      }
  }
}

TEST(BurmesterCurve, KappaIsTheSameForCirclePointsAndCentrePoints) {
  std::mt19937_64 random(6);
  for (int trial = 0; trial < 500; ++trial) {
    const BurmesterCurve curve(pose_conditions(testing::random_poses(random)));
    ASSERT_TRUE(curve.kappa() && curve.center_curve().kappa());
    EXPECT_NEAR(*curve.kappa(), *curve.center_curve().kappa(), 1e-9);
  }
}

TEST(BurmesterCurve, CentreOfAndCircleOfAreInverse) {
  const BurmesterCurve curve(pose_conditions(planar_case("landing_gear").poses));
  for (const double tau : curve.samples(97, Spacing::coordinate)) {
    const Dyad dyad = curve.dyad(tau);
    EXPECT_LT(great_circle(curve.center_of(dyad.circle), dyad.center), 1e-9);
    EXPECT_LT(great_circle(curve.circle_of(dyad.center), dyad.circle), 1e-9);
  }
}

TEST(BurmesterCurve, SliderDyadIsAnOrdinaryPoint) {
  // J. M. McCarthy & G. S. Soh, Geometric Design of Linkages, 2nd ed., 2011, ch. 5: four poses with a PR dyad of slope
  // 0.6.
  const std::vector<PrescribedPose> poses = {{{{-1.512691961, -1.976868401}, radians(28.64788975654116)}, {}},
                                             {{{0.307550937, -0.2158636}, radians(-57.29577951308232)}, {}},
                                             {{{1.867671484, -0.773925269}, radians(80.21409131831524)}, {}},
                                             {{{-0.733911613, -0.929764415}, radians(-17.188733853924695)}, {}}};
  const PoseConditions conditions = pose_conditions(poses);
  const BurmesterCurve curve(conditions);
  const Homogeneous normal_to_slope{0, -0.6, 1};
  const double tau = *curve.circle_curve().coordinate_of(curve.circle_of(normal_to_slope));
  const Dyad slider = curve.dyad(tau);
  EXPECT_LT(great_circle(slider.center, normal_to_slope), 1e-7);
  const Point pivot = *conditions.frame.finite_user_point(conditions.frame.to_user(slider.circle));
  EXPECT_NEAR(pivot.real(), -0.714740803, 1e-7);
  EXPECT_NEAR(pivot.imag(), -1.768844482, 1e-7);
  const Dyad near = curve.dyad(tau + 1e-6);
  EXPECT_LT(great_circle(near.center, slider.center), 1e-3);
}

TEST(BurmesterCurve, SuhAndRadcliffesTaskHasItsPublishedDyads) {
  // C. H. Suh & C. W. Radcliffe 1978, in McCarthy & Soh 2011, Table 5.3; the pole of positions 1 and 2 is at infinity.
  const std::vector<PrescribedPose> poses = {
      {{{1, 1}, 0}, {}}, {{{2, 0.5}, 0}, {}}, {{{3, 1.5}, radians(45)}, {}}, {{{2, 2}, radians(90)}, {}}};
  const PoseConditions conditions = pose_conditions(poses);
  const BurmesterCurve curve(conditions);
  const std::vector<std::array<Point, 2>> published = {
      {{{0.774958049788, 2.03250646929}, {0.480897735766, 2.69438602568}}},
      {{{1.66135840633, 0.647921930994}, {-0.557180825767, -2.53915654704}}},
      {{{-0.464393805997, 1.48582314067}, {-0.477514160838, 2.70958242359}}},
      {{{1.06238677293, 1.93722576879}, {1.00330935657, 3.06907094238}}},
      {{{1.96697929272, 1.90674493457}, {1.24186135892, 1.70650934837}}}};
  for (const auto& [center, circle] : published) {
    const Homogeneous z = Homogeneous::of(conditions.frame.to_working(circle));
    const Dyad dyad = conditions.frame.to_user(curve.dyad(*curve.circle_curve().coordinate_of(z)));
    EXPECT_LT(std::abs(*conditions.frame.finite_user_point(dyad.center) - center), 1e-4);
    EXPECT_LT(std::abs(*conditions.frame.finite_user_point(dyad.circle) - circle), 1e-4);
  }
}

TEST(BurmesterCurve, SamplesAreExactlyAsManyAsAskedAndAscend) {
  for (const char* name : {"landing_gear", "drawer_hinge", "cardan"}) {
    const BurmesterCurve curve(pose_conditions(planar_case(name).poses));
    for (const Spacing spacing : {Spacing::coordinate, Spacing::arc_length})
      for (const int count : {1, 8, 101}) {
        const auto samples = curve.samples(count, spacing);
        ASSERT_EQ(samples.size(), static_cast<std::size_t>(count));
        for (std::size_t i = 1; i < samples.size(); ++i) EXPECT_GT(samples[i], samples[i - 1]);
        EXPECT_GE(samples.front(), 0);
        EXPECT_LT(samples.back(), curve.coordinate_length());
      }
  }
}

TEST(BurmesterCurve, ArcLengthSpacingTakesEqualSteps) {
  const auto run = [](const Dyad& a, const Dyad& b) {
    return great_circle(a.circle, b.circle) + great_circle(a.center, b.center);
  };
  for (const char* name : {"drawer_hinge", "near_node"}) {
    const BurmesterCurve curve(pose_conditions(planar_case(name).poses));
    const auto samples = curve.samples(400, Spacing::arc_length);
    std::vector<double> steps;
    for (std::size_t i = 1; i < samples.size(); ++i) {
      double length = 0;
      for (int part = 0; part < 20; ++part) {
        const double from = samples[i - 1] + (samples[i] - samples[i - 1]) * part / 20;
        const double to = samples[i - 1] + (samples[i] - samples[i - 1]) * (part + 1) / 20;
        length += run(curve.dyad(from), curve.dyad(to));
      }
      steps.push_back(length);
    }
    const auto [least, most] = std::minmax_element(steps.begin(), steps.end());
    EXPECT_LT(*most / *least, 1.01) << name;
  }
}

TEST(BurmesterCurve, EveryPointHasNoCoordinates) {
  const BurmesterCurve curve(pose_conditions(planar_case("translations_on_circle").poses));
  EXPECT_EQ(curve.kind(), CubicKind::every_point);
  EXPECT_EQ(curve.coordinate_length(), 0);
  EXPECT_TRUE(curve.samples(10, Spacing::coordinate).empty());
}

TEST(BurmesterCurve, ItsPolygonIsDenseAndClosed) {
  const auto poses = testing::planar_case("landing_gear").poses;
  const BurmesterCurve curve(pose_conditions(poses));
  const std::vector<Dyad> polygon = curve.polygon(0.05);
  double longest = 0;
  for (std::size_t i = 1; i < polygon.size(); ++i) {
    EXPECT_GT(polygon[i].coordinate, polygon[i - 1].coordinate);
    if (std::floor(polygon[i].coordinate) != std::floor(polygon[i - 1].coordinate)) continue;
    longest = std::max(longest, norm(cross(polygon[i].circle, polygon[i - 1].circle)) +
                                    norm(cross(polygon[i].center, polygon[i - 1].center)));
  }
  EXPECT_LE(longest, 0.05);
  EXPECT_EQ(polygon.front().coordinate, 0);
  EXPECT_LT(norm(cross(polygon.front().circle, polygon.back().circle)), curve.branches().size() > 1 ? 2 : 1e-9);
}

TEST(BurmesterCurve, ItsRunGrowsWithTheCoordinate) {
  const BurmesterCurve curve(pose_conditions(testing::planar_case("landing_gear").poses));
  const auto run = curve.arc_length_table();
  ASSERT_EQ(run.tau.size(), run.length.size());
  EXPECT_TRUE(std::is_sorted(run.tau.begin(), run.tau.end()));
  EXPECT_TRUE(std::is_sorted(run.length.begin(), run.length.end()));
  EXPECT_GT(run.length.back(), pi) << "both points go once round, at least";
}

// Against 20 000 samples: between two of them on different sides of a line lies one of the places, and no others.
TEST(BurmesterCurve, MeetsALineWhereItsSamplesChangeSides) {
  std::mt19937_64 random(31);
  int met = 0;
  for (int trial = 0; trial < 12; ++trial) {
    const BurmesterCurve curve(pose_conditions(testing::random_poses(random)));
    for (const bool of_centers : {true, false}) {
      const Homogeneous line =
          cross(Homogeneous::of({testing::uniform(random, -2, 2), testing::uniform(random, -2, 2)}),
                Homogeneous::of({testing::uniform(random, -2, 2), testing::uniform(random, -2, 2)}));
      const auto places = of_centers ? curve.coordinates_of_centers_on(line) : curve.coordinates_of_circles_on(line);
      EXPECT_LE(places.size(), 3u);
      const auto point_at = [&](double tau) {
        const Dyad dyad = curve.dyad(tau);
        return normalized(of_centers ? dyad.center : dyad.circle);
      };
      for (const double tau : places) EXPECT_NEAR(dot(normalized(line), point_at(tau)), 0, 1e-9);
      const auto samples = curve.samples(20'000, Spacing::arc_length);
      for (std::size_t i = 1; i < samples.size(); ++i) {
        if (std::floor(samples[i - 1]) != std::floor(samples[i])) continue;
        const auto p = finite_point(point_at(samples[i - 1])), q = finite_point(point_at(samples[i]));
        if (!p || !q || std::abs(*p - *q) > 0.1) continue;
        const double at_p = dot(line, Homogeneous::of(*p)), at_q = dot(line, Homogeneous::of(*q));
        if ((at_p < 0) == (at_q < 0)) continue;
        ++met;
        EXPECT_TRUE(std::any_of(places.begin(), places.end(), [&](double tau) {
          return tau >= samples[i - 1] - 1e-9 && tau <= samples[i] + 1e-9;
        })) << trial;
      }
    }
  }
  EXPECT_GT(met, 20);
}

TEST(BurmesterCurve, AComponentOfCentersMeetsALineOnce) {
  const auto c = planar_case("two_translation_pairs");
  const BurmesterCurve curve(pose_conditions(c.poses));
  for (const CurveBranch& branch : curve.branches()) {
    if (branch.name != "center_line") continue;
    const Homogeneous line = cross(Homogeneous::of({0.3, -0.2}), Homogeneous::of({0.1, 1.4}));
    const auto places = curve.coordinates_of_centers_on(line);
    EXPECT_EQ(
        std::count_if(places.begin(), places.end(), [&](double tau) { return tau >= branch.from && tau <= branch.to; }),
        1);
  }
}

struct Marked {
  TaskCurve given;
  std::vector<CurveMark> marks;
};

Marked marked(const MotionTask& task) {
  TaskCurve given = task_curve(task);
  auto marks = curve_marks(task.poses, *given.curve, given.conditions.frame, given.curve->polygon(0.05));
  return {std::move(given), std::move(marks)};
}

std::ptrdiff_t count(const std::vector<CurveMark>& marks, CurveMark::Kind kind) {
  return std::count_if(marks.begin(), marks.end(), [&](const CurveMark& mark) { return mark.kind == kind; });
}

TEST(CurveMarks, PolesLieOnBothCurves) {
  const auto [given, marks] = marked(testing::tailgate_task());
  EXPECT_EQ(count(marks, CurveMark::Kind::pole), 6);
  const WorkingFrame& frame = given.conditions.frame;
  for (const CurveMark& mark : marks) {
    if (mark.kind != CurveMark::Kind::pole) continue;
    ASSERT_EQ(mark.tau.size(), 2u);
    const auto center = frame.finite_user_point(frame.to_user(given.curve->dyad(mark.tau[0]).center));
    const auto circle = frame.finite_user_point(frame.to_user(given.curve->dyad(mark.tau[1]).circle));
    EXPECT_LT(std::abs(*center - *mark.center), 1e-6);
    EXPECT_LT(std::abs(*circle - *mark.circle), 1e-6);
  }
}

TEST(CurveMarks, PointsAtInfinityAreThere) {
  for (const auto& c : testing::planar_cases()) {
    const TaskCurve given = task_curve({c.poses});
    // Where the arithmetic is at its end, a whole loop of one curve may belong to less than a side of the polygon.
    if (!given.curve->kappa() || !c.is_finite() || given.conditions.condition() > tolerance::ill_conditioned) continue;
    const auto marks = curve_marks(c.poses, *given.curve, given.conditions.frame, given.curve->polygon(0.025));
    // A circular cubic has one real point at infinity, or touches the line there.
    EXPECT_EQ(count(marks, CurveMark::Kind::center_at_infinity), 1) << c.name;
    EXPECT_EQ(count(marks, CurveMark::Kind::circle_at_infinity), 1) << c.name;
    for (const CurveMark& mark : marks) {
      const bool center = mark.kind == CurveMark::Kind::center_at_infinity;
      if (!center && mark.kind != CurveMark::Kind::circle_at_infinity) continue;
      const Dyad dyad = given.curve->dyad(mark.tau[0]);
      EXPECT_TRUE(is_at_infinity(center ? dyad.center : dyad.circle)) << c.name;
    }
  }
}

TEST(CurveMarks, PolesOfParallelPosesAreAtInfinity) {
  MotionTask task = testing::tailgate_task();
  task.poses[2].pose.angle = task.poses[0].pose.angle;
  const auto [given, marks] = marked(task);
  const auto pole = std::find_if(marks.begin(), marks.end(), [](const CurveMark& mark) {
    return mark.kind == CurveMark::Kind::pole && mark.poses == std::array{0, 2};
  });
  ASSERT_NE(pole, marks.end());
  EXPECT_FALSE(pole->center);
  EXPECT_TRUE(pole->tau.empty());
}

}  // namespace
}  // namespace linkwright::burmester_curve_test
