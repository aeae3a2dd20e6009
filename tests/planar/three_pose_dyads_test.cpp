#include "planar/three_pose_dyads.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <random>

#include "linkwright/core/angle.hpp"
#include "support/random_task.hpp"

namespace linkwright::three_pose_dyads_test {
namespace {

using testing::random_poses;
using testing::uniform;
using Json = nlohmann::json;

Json read(const std::string& name) {
  return Json::parse(std::ifstream(LINKWRIGHT_DATA_DIR "/three_poses/" + name + ".json"));
}

Point point_of(const Json& json) { return {json[0].get<double>(), json[1].get<double>()}; }

std::vector<PrescribedPose> poses_of(const Json& positions) {
  std::vector<PrescribedPose> poses;
  for (const Json& position : positions) poses.push_back({{point_of(position[0]), position[0][2].get<double>()}, {}});
  return poses;
}

struct Links {
  Point center, circle;
};

// In the user's frame.
struct Task {
  explicit Task(std::vector<PrescribedPose> given)
      : poses(std::move(given)), conditions(pose_conditions(poses)), dyads(conditions) {}

  [[nodiscard]] Links user(const Dyad& dyad) const {
    return {conditions.frame.to_user(finite_point(dyad.center).value()),
            conditions.frame.to_user(finite_point(dyad.circle).value())};
  }
  [[nodiscard]] std::vector<Links> of_arm(Point arm) const {
    std::vector<Links> found;
    for (const int sheet : {0, 1})
      if (const auto dyad = dyads.dyad(arm / conditions.frame.scale, sheet)) found.push_back(user(*dyad));
    return found;
  }
  // Worst relative change of the grounded link's length over the finite poses.
  [[nodiscard]] double residual(const Links& links) const {
    const double length = std::abs(links.circle - links.center);
    double worst = 0;
    for (const PrescribedPose& pose : poses)
      worst = std::max(
          worst,
          std::abs(std::abs(displaced(links.circle, poses.front().pose, pose.pose) - links.center) / length - 1));
    return worst;
  }

  std::vector<PrescribedPose> poses;
  PoseConditions conditions;
  ThreePoseDyads dyads;
};

void expect_same(const std::vector<Links>& found, const Json& expected, const std::string& where) {
  ASSERT_EQ(found.size(), expected.size()) << where;
  for (const Json& dyad : expected) {
    double nearest = 1;
    for (const Links& links : found)
      nearest = std::min(nearest, std::abs(links.center - point_of(dyad["centre_point"])) +
                                      std::abs(links.circle - point_of(dyad["circle_point"])));
    EXPECT_LT(nearest, 1e-11) << where;
  }
}

class ThreePoseCase : public ::testing::TestWithParam<const char*> {};

TEST_P(ThreePoseCase, HasTheDyadsOfEachGivenLengthAndInstantCentre) {
  const Json json = read(GetParam());
  const Task task(poses_of(json["positions"]));
  for (const Json& row : json["given_lengths"]) {
    const double beta = row["beta"];
    expect_same(task.of_arm(row["R"].get<double>() * direction(beta)), row["dyads"],
                "direction " + std::to_string(beta));
  }
  const WorkingFrame& frame = task.conditions.frame;
  for (const Json& row : json["given_instant_centre"]) {
    std::vector<Links> found;
    const DirectedLine line{frame.to_working(point_of(row["I"])), direction(row["beta"].get<double>())};
    const auto on_line = task.dyads.dyads_on_lines(line, line);
    ASSERT_TRUE(on_line);
    for (const Dyad& dyad : *on_line) found.push_back(task.user(dyad));
    expect_same(found, row["dyads"], "through the centre " + row["beta"].dump());
  }
}

INSTANTIATE_TEST_SUITE_P(Data, ThreePoseCase, ::testing::Values("three_general", "three_one_translation"));

TEST(ThreePoseDyads, MeetAtThePolesOfThePublishedTask) {
  const Json json = read("pm3-sandor-erdman-a");
  std::vector<PrescribedPose> poses;
  for (const Json& pose : json["input"]["poses"])
    poses.push_back({{{pose["x"], pose["y"]}, radians(pose["theta_deg"].get<double>())}, {}});
  const Task task(poses);
  // A pole as circle point has the other poles' perpendicular bisector: P12 stays where it is from pose 1 to pose 2, so
  // that its centre is equally far from it and from where pose 3 takes it, and any such centre will do.
  for (const auto& [name, other] : {std::pair{"P12", 2u}, std::pair{"P13", 1u}}) {
    const Point pole = point_of(json["own_result"][name]);
    const Homogeneous unit = normalized(task.conditions.frame.to_working(Homogeneous::of(pole)));
    const Homogeneous a = unit * task.conditions.rows[0], b = unit * task.conditions.rows[1];
    EXPECT_LT(norm(cross(normalized(a), normalized(b))), 1e-7) << name;
    const Point moved = displaced(pole, poses[0].pose, poses[other].pose);
    const Point center = (pole + moved) / 2.0 + Point{0, 0.7} * (moved - pole);
    EXPECT_LT(task.residual({center, pole}), 1e-7) << name;
  }
  // P23 as centre: its circle points in poses 2 and 3 coincide with nothing to be told from one another.
  const Point p23 = point_of(json["own_result"]["P23"]);
  const Homogeneous unit = normalized(task.conditions.frame.to_working(Homogeneous::of(p23)));
  EXPECT_LT(norm(cross(normalized(task.conditions.rows[0] * unit), normalized(task.conditions.rows[1] * unit))), 1e-7);
}

TEST(ThreePoseDyads, PartnersAreEachOthersPartners) {
  std::mt19937_64 random(3);
  for (int trial = 0; trial < 500; ++trial) {
    const Task task(random_poses(random, 3));
    const Homogeneous circle = trial % 5 == 0 ? Homogeneous::at_infinity(direction(uniform(random, 0, two_pi)))
                                              : Homogeneous::of({uniform(random, -2, 2), uniform(random, -2, 2)});
    const auto center = task.dyads.center_of(circle);
    ASSERT_TRUE(center);
    EXPECT_LT(task.dyads.residual({*center, circle, 0}), 1e-15);
    const auto back = task.dyads.circle_of(*center);
    ASSERT_TRUE(back);
    EXPECT_LT(norm(cross(*back, normalized(circle))), 1e-9);
  }
}

TEST(ThreePoseDyads, SayWhereAnyCentreWillDo) {
  // Turns about one pole: as circle point it stays where it is; as centre any circle point runs about it.
  std::vector<PrescribedPose> poses;
  for (const double angle : {0.2, 0.9, 2.0})
    poses.push_back({{Point{5, -7} + direction(angle) * Point{3, 4}, angle}, {}});
  const Task task(poses);
  const Homogeneous pole = task.conditions.frame.to_working(Homogeneous::of({5, -7}));
  EXPECT_FALSE(task.dyads.center_of(pole));
  EXPECT_FALSE(task.dyads.circle_of(pole));
  const auto center = task.dyads.center_of(Homogeneous::of({0.3, 0.2}));
  ASSERT_TRUE(center);
  EXPECT_LT(norm(cross(*center, normalized(pole))), 1e-12);
  for (const Links& links : task.of_arm(Point{1, 2}))
    EXPECT_LT(std::min(std::abs(links.center - Point{5, -7}), std::abs(links.circle - Point{5, -7})), 1e-12);
  EXPECT_EQ(task.of_arm({1, 2}).size(), 2u);
}

const std::vector<std::vector<int>> three_position_patterns = {{1, 1, 1}, {2, 1}, {1, 2}, {3}};

// Length and direction are as asked, and the conditions are met: all patterns, whatever the numbers.
TEST(ThreePoseDyads, KeepLengthAndDirectionInRandomTasks) {
  std::mt19937_64 random(1);
  double worst_bilinear = 0, worst = 0;
  int found = 0;
  for (int trial = 0; trial < 8000; ++trial) {
    const Task task(random_poses(random, three_position_patterns[static_cast<std::size_t>(trial % 4)]));
    const Point arm = std::exp(uniform(random, -2, 2)) * direction(uniform(random, 0, two_pi));
    for (const int sheet : {0, 1}) {
      const auto dyad = task.dyads.dyad(arm / task.conditions.frame.scale, sheet);
      if (!dyad) continue;
      ++found;
      worst_bilinear = std::max(worst_bilinear, task.dyads.residual(*dyad));
      const Links links = task.user(*dyad);
      EXPECT_LT(std::abs(links.circle - links.center - arm), 1e-13 * (std::abs(arm) + std::abs(links.center)));
      worst = std::max(worst, task.residual(links) * std::abs(arm) / (std::abs(arm) + std::abs(links.center)));
    }
  }
  EXPECT_GT(found, 8000);
  EXPECT_LT(worst_bilinear, 1e-12);
  EXPECT_LT(worst, 1e-11);
  RecordProperty("worst_bilinear", std::to_string(worst_bilinear * 1e16) + "e-16");
  RecordProperty("worst_change_of_length", std::to_string(worst * 1e16) + "e-16");
}

// A second way: along lines of circle points, where the distance from the centre passes the length; no formula of the
// direction is used.
TEST(ThreePoseDyads, NoneOfALengthIsMissed) {
  std::mt19937_64 random(5);
  int compared = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const Task task(random_poses(random, 3));
    const double length = uniform(random, 0.3, 2);
    const auto excess = [&](Point z) -> std::optional<double> {
      const auto center = task.dyads.center_of(Homogeneous::of(z));
      if (!center || is_at_infinity(*center)) return std::nullopt;
      return std::abs(z - *finite_point(*center)) - length;
    };
    for (int line = 0; line < 40; ++line) {
      const double y = uniform(random, -3, 3);
      std::optional<double> before;
      for (double x = -3; x < 3; x += 0.01) {
        const auto here = excess({x, y});
        if (before && here && *before * *here < 0 && std::abs(*here - *before) < 0.5) {
          double low = x - 0.01, high = x;
          for (int step = 0; step < 55; ++step) {
            const double middle = (low + high) / 2;
            (excess({middle, y}).value_or(0) * *before > 0 ? low : high) = middle;
          }
          const Point z{low, y}, center = *finite_point(*task.dyads.center_of(Homogeneous::of(z)));
          double nearest = 1;
          for (const int sheet : {0, 1})
            if (const auto dyad = task.dyads.dyad(length * (z - center) / std::abs(z - center), sheet))
              nearest = std::min(nearest, std::abs(*finite_point(dyad->circle) - z));
          // At the edge of the real directions the root doubles the digits lost.
          EXPECT_LT(nearest, 1e-5) << trial;
          ++compared;
        }
        before = here;
      }
    }
  }
  EXPECT_GT(compared, 500);
}

TEST(ThreePoseDyads, SheetsAreContinuousAndMeetWhereTheRootVanishes) {
  std::mt19937_64 random(8);
  int ends = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const Task task(random_poses(random, 3));
    const double length = uniform(random, 0.2, 3);
    for (const DirectionArc arc : task.dyads.directions(length)) {
      const auto at = [&](double beta, int sheet) { return task.dyads.dyad(length * direction(beta), sheet); };
      const double width = arc.to - arc.from;
      for (const bool first : {true, false}) {
        if (width == two_pi) continue;
        const double inwards = first ? width : -width, end = first ? arc.from : arc.to;
        const auto apart = [&](double share) {
          const auto a = at(end + share * inwards, 0), b = at(end + share * inwards, 1);
          EXPECT_TRUE(a && b);
          return a && b ? norm(cross(normalized(a->circle), normalized(b->circle))) : 1;
        };
        EXPECT_NEAR(apart(1e-6) / apart(1e-8), 10, 0.5) << "as the square root of the distance";
        EXPECT_FALSE(at(end - 1e-8 * inwards, 0));
        ++ends;
      }
      for (const int sheet : {0, 1})
        for (int i = 1; i < 20; ++i) {
          const double beta = arc.from + width * i / 20;
          const auto here = at(beta, sheet), next = at(beta + 1e-9 * width, sheet);
          ASSERT_TRUE(here && next) << "inside an arc every direction is real";
          EXPECT_LT(norm(cross(normalized(here->circle), normalized(next->circle))), 1e-4);
        }
    }
  }
  EXPECT_GT(ends, 200);
}

TEST(ThreePoseDyads, ArcsLeaveNoDirectionOut) {
  std::mt19937_64 random(9);
  for (int trial = 0; trial < 100; ++trial) {
    const Task task(random_poses(random, three_position_patterns[static_cast<std::size_t>(trial % 4)]));
    const double length = uniform(random, 0.1, 3);
    const auto arcs = task.dyads.directions(length);
    for (int i = 0; i < 100; ++i) {
      const double beta = two_pi * i / 100;
      const bool inside = std::any_of(arcs.begin(), arcs.end(), [&](DirectionArc arc) {
        return (beta >= arc.from && beta <= arc.to) || beta + two_pi <= arc.to;
      });
      EXPECT_EQ(inside, task.dyads.dyad(length * direction(beta), 0).has_value()) << trial << ' ' << i;
    }
  }
}

// Free length, given direction: the centres lie on the circular cubic of the theory (angle between the grounded links).
TEST(ThreePoseDyads, CentresOfADirectionLieOnTheCubic) {
  std::mt19937_64 random(12);
  for (int trial = 0; trial < 300; ++trial) {
    const Task task(random_poses(random, 3));
    const Point e = direction(uniform(random, 0, two_pi));
    for (const double length : {0.1, 0.7, 4.0})
      for (const Links& links : task.of_arm(length * e)) {
        const auto s_and_turn = [&](std::size_t j) {
          const Point d1 = task.poses[0].pose.origin,
                      r = direction(task.poses[j].pose.angle - task.poses[0].pose.angle);
          const Point c = links.center - d1, s = task.poses[j].pose.origin - d1 - c + r * c;
          return std::pair{std::norm(s), dot(s, r * e)};
        };
        const auto [s2, t2] = s_and_turn(1);
        const auto [s3, t3] = s_and_turn(2);
        EXPECT_NEAR((s2 * t3 - s3 * t2) / std::pow(s2 + s3, 1.5), 0, 1e-11);
      }
  }
}

TEST(ThreePoseDyads, OneShiftLeavesTwoDirectionsToALength) {
  const Task task(poses_of(read("three_one_translation")["positions"]));
  const WorkingFrame& frame = task.conditions.frame;
  EXPECT_EQ(task.dyads.freedom(), DirectionFreedom::of_length);
  const Point shift{1.5, 0.6};
  EXPECT_TRUE(task.dyads.directions(0.49 * std::abs(shift) / frame.scale).empty());
  const auto arcs = task.dyads.directions(2 / frame.scale);
  ASSERT_EQ(arcs.size(), 2u);
  for (const DirectionArc arc : arcs) {
    EXPECT_NEAR(std::cos(arc.from - std::arg(shift)), -std::abs(shift) / 4, 1e-14);
    EXPECT_NEAR(task.dyads.length_of(arc.from).value() * frame.scale, 2, 1e-12);
    for (const double turn : {0.0, 0.3, 0.9}) {
      const auto dyad = task.dyads.dyad_round(2 / frame.scale * direction(arc.from), turn);
      ASSERT_TRUE(dyad);
      EXPECT_LT(task.residual(task.user(*dyad)), 1e-14);
    }
    EXPECT_FALSE(task.dyads.dyad_round(2 / frame.scale * direction(arc.from + 0.1), 0));
  }
  EXPECT_FALSE(task.dyads.length_of(std::arg(shift)));  // the grounded link would have to point the other way
}

TEST(ThreePoseDyads, AStartWithAShiftLeavesOneLineOfDirections) {
  const Task task({{{{0, 0}, 0}, {{{2, 1}, 0}}}, {{{3, 1}, 0.8}, {}}});
  EXPECT_EQ(task.dyads.freedom(), DirectionFreedom::of_length);
  for (const double length : {0.01, 1.0, 50.0}) {
    const auto arcs = task.dyads.directions(length);
    ASSERT_EQ(arcs.size(), 2u);
    for (const DirectionArc arc : arcs) EXPECT_NEAR(std::cos(arc.from - std::atan2(1, 2)), 0, 1e-14);
  }
  EXPECT_FALSE(task.dyads.length_of(0.3));
}

TEST(ThreePoseDyads, ShiftsWithoutACurvedCircleOfCentres) {
  // The second pose parallel to the first and passed with a turn: neither condition has |C|², the centres of a
  // direction lie on a line.
  const Task task({{{{0, 0}, 0}, {}}, {{{2, 1}, 0}, {{{1, 0.5}, 1}}}});
  EXPECT_EQ(task.dyads.freedom(), DirectionFreedom::of_length);
  const auto arcs = task.dyads.directions(3);
  ASSERT_EQ(arcs.size(), 2u);
  for (const double turn : {0.1, 0.5, 0.8}) {
    const auto dyad = task.dyads.dyad_round(3.0 * direction(arcs[0].from), turn);
    ASSERT_TRUE(dyad);
    EXPECT_LT(task.dyads.residual(*dyad), 1e-15);
    EXPECT_LT(task.residual(task.user(*dyad)), 1e-13);
  }
}

TEST(ThreePoseDyads, OnlyShiftsLeaveNoDirection) {
  const Task task({{{{0, 0}, 0.4}, {}}, {{{2, 0}, 0.4}, {}}, {{{1, 3}, 0.4}, {}}});
  EXPECT_EQ(task.dyads.freedom(), DirectionFreedom::only_shifts);
  EXPECT_TRUE(task.dyads.directions(1).empty());
}

// Parallel poses that are not the first, poses on a line, half-turns: nothing special.
TEST(ThreePoseDyads, LaterParallelPosesAndHalfTurnsAreOrdinary) {
  const std::vector<std::vector<PrescribedPose>> tasks = {
      {{{{0, 0}, 0}, {}}, {{{2, 1}, 0.7}, {}}, {{{3, -1}, 0.7}, {}}},
      {{{{0, 0}, 0}, {}}, {{{1, 1}, 0.7}, {}}, {{{2, 2}, 1.1}, {}}},
      {{{{0, 0}, 0}, {}}, {{{1, 1}, pi}, {}}, {{{2, 0}, -pi / 2}, {}}},
  };
  for (const auto& poses : tasks) {
    const Task task(poses);
    EXPECT_EQ(task.dyads.freedom(), DirectionFreedom::free);
    int found = 0;
    for (int i = 0; i < 360; ++i)
      for (const Links& links : task.of_arm(2.0 * direction(radians(i)))) {
        EXPECT_LT(task.residual(links), 1e-12);
        ++found;
      }
    EXPECT_GT(found, 100);
  }
}

TEST(ThreePoseDyads, SmallTurnsKeepTheirDigits) {
  std::mt19937_64 random(21);
  for (const double angle : {1e-2, 1e-4, 1e-6})
    for (int trial = 0; trial < 50; ++trial) {
      auto poses = random_poses(random, 3);
      for (PrescribedPose& pose : poses) pose.pose.angle = uniform(random, -angle, angle);
      const Task task(poses);
      const double length = uniform(random, 0.5, 3) / task.conditions.frame.scale;
      for (const DirectionArc arc : task.dyads.directions(length))
        for (const int sheet : {0, 1}) {
          const auto dyad = task.dyads.dyad(length * direction((arc.from + arc.to) / 2), sheet);
          ASSERT_TRUE(dyad);
          EXPECT_LT(task.residual(task.user(*dyad)), 1e-14 / angle) << angle;
        }
    }
}

TEST(ThreePoseDyads, MoveWithTheDrawing) {
  std::mt19937_64 random(31);
  for (int trial = 0; trial < 100; ++trial) {
    const auto poses = random_poses(random, three_position_patterns[static_cast<std::size_t>(trial % 4)]);
    const Task task(poses);
    const Point arm = uniform(random, 0.3, 2) * direction(uniform(random, 0, two_pi));
    for (const double scale : {1e-6, 1e6}) {
      const double angle = uniform(random, -pi, pi);
      const Point shift = scale * Point{uniform(random, -50, 50), uniform(random, -50, 50)};
      const auto before = task.of_arm(arm);
      const auto after = Task(testing::moved(poses, scale, angle, shift)).of_arm(scale * direction(angle) * arm);
      ASSERT_EQ(before.size(), after.size());
      for (std::size_t i = 0; i < before.size(); ++i) {
        double nearest = 1;
        for (const Links& links : after)
          nearest = std::min(nearest, std::abs((links.circle - shift) / (scale * direction(angle)) - before[i].circle) /
                                          (1 + std::abs(before[i].circle)));
        EXPECT_LT(nearest, 1e-9);
      }
    }
  }
}

}  // namespace
}  // namespace linkwright::three_pose_dyads_test
