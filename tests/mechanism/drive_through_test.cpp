#include "linkwright/mechanism/drive_through.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/position.hpp"
#include "support/random_four_bar.hpp"

namespace linkwright::drive_through_test {
namespace {

using testing::coupler_pose;
using testing::four_bar_at;
using testing::RandomFourBars;

constexpr auto positive = Assembly::positive, negative = Assembly::negative;
constexpr Defects no_defect{}, order{Defects::order_bit}, branch{Defects::branch_bit},
    circuit{Defects::branch_bit | Defects::circuit_bit};

// A place in the motion of a four-bar.
struct Stop {
  double input_angle_deg;
  Assembly assembly = positive;
};

struct Task {
  FourBar four_bar;
  std::vector<PrescribedPose> poses;
};

// The four-bar in its first stop, and the poses of its coupler in all.
Task task_of(const LinkLengths& lengths, const std::vector<Stop>& stops) {
  Task task;
  for (const Stop& stop : stops) {
    const FourBar at = four_bar_at(lengths, radians(stop.input_angle_deg), stop.assembly);
    if (task.poses.empty()) task.four_bar = at;
    task.poses.push_back({coupler_pose(at), {}});
  }
  return task;
}

DriveThroughReport drive(const Task& task, const DriveThroughOptions& options = {}) {
  const DriveThroughReport report = drive_through(task.four_bar, task.poses, options);
  EXPECT_TRUE(report.completed);
  EXPECT_LT(report.worst_closure, 1e-12);
  return report;
}

Defects defects(const LinkLengths& lengths, const std::vector<Stop>& stops) {
  return drive(task_of(lengths, stops)).defects;
}

std::vector<int> visited(const LinkLengths& lengths, const std::vector<Stop>& stops) {
  return drive(task_of(lengths, stops)).visited;
}

using Order = std::vector<int>;

constexpr LinkLengths crank_rocker{4, 1, 3, 2.5};
constexpr LinkLengths double_crank{1, 2, 3.5, 4};
constexpr LinkLengths rocker_crank{4, 2.5, 3, 1};          // input in ±[24.2°, 71.8°]
constexpr LinkLengths double_rocker{4, 3, 1.5, 3.2};       // input in ±[22.9°, 83.0°]
constexpr LinkLengths triple_rocker{3, 2, 2.2, 2.1};       // not Grashof; input in [−117.2°, 117.2°]
constexpr LinkLengths triple_rocker_back{2, 2.2, 3, 2.1};  // not Grashof; input passes π, not 0

// ---- cranks
// ----------------------------------------------------------------------------------------------------------

TEST(DriveThroughACrank, MeetsPosesInOrderEitherWayRound) {
  EXPECT_EQ(defects(crank_rocker, {{0}, {60}, {130}, {300}}), no_defect);
  EXPECT_EQ(defects(crank_rocker, {{0}, {-60}, {-130}, {-300}}), no_defect);
  EXPECT_EQ(defects(crank_rocker, {{0, negative}, {60, negative}, {130, negative}, {300, negative}}), no_defect);
  EXPECT_EQ(defects(double_crank, {{0}, {60}, {130}, {300}}), no_defect);
}

TEST(DriveThroughACrank, AllowsTheTurnToRunOverThePointWhereAnglesWrap) {
  EXPECT_EQ(defects(crank_rocker, {{150}, {170}, {190}, {20}}), no_defect);
  EXPECT_EQ(defects(crank_rocker, {{20}, {350}, {200}, {30}}), no_defect);
}

TEST(DriveThroughACrank, CannotSkipAPoseAndComeBackToIt) {
  EXPECT_EQ(defects(crank_rocker, {{0}, {130}, {60}, {300}}), order);
  EXPECT_EQ(defects(crank_rocker, {{0}, {60}, {300}, {130}}), order);
}

TEST(DriveThroughACrank, TakesAnyThreePosesInOneOfTheTwoSenses) {
  EXPECT_EQ(defects(crank_rocker, {{0}, {100}, {200}}), no_defect);
  EXPECT_EQ(defects(crank_rocker, {{0}, {200}, {100}}), no_defect);
}

TEST(DriveThroughACrank, ListsPosesAsTheInputMeetsThem) {
  EXPECT_EQ(visited(crank_rocker, {{0}, {60}, {130}, {300}}), (Order{0, 1, 2, 3}));
  EXPECT_EQ(visited(crank_rocker, {{0}, {300}, {130}, {60}}), (Order{0, 1, 2, 3})) << "clockwise";
  EXPECT_EQ(visited(crank_rocker, {{0}, {60}, {300}, {130}}), (Order{0, 1, 3, 2}));
  EXPECT_EQ(visited(crank_rocker, {{0}, {200}, {250}, {60}}), (Order{0, 2, 1, 3})) << "160° on rather than 200° back";
}

TEST(DriveThroughACrank, CannotReachTheOtherAssembly) {
  EXPECT_EQ(defects(crank_rocker, {{0}, {60}, {130, negative}, {300}}), circuit);
  EXPECT_EQ(visited(crank_rocker, {{0}, {60}, {130, negative}, {300}}), (Order{0, 1, 3}));
}

// ---- rockers
// ---------------------------------------------------------------------------------------------------------

TEST(DriveThroughARocker, MeetsPosesInOrderOnTheWayUpOrDown) {
  EXPECT_EQ(defects(triple_rocker, {{-60}, {-20}, {10}, {50}}), no_defect);
  EXPECT_EQ(defects(triple_rocker, {{50, negative}, {10, negative}, {-20, negative}}), no_defect);
  EXPECT_EQ(defects(rocker_crank, {{40}, {50}, {60}, {70}}), no_defect);
}

TEST(DriveThroughARocker, CannotTurnOnThroughItsDeadPoints) {
  EXPECT_EQ(defects(triple_rocker, {{-20}, {10}, {-60}}), order) << "in order for a crank";
  EXPECT_EQ(defects(triple_rocker, {{-20}, {50}, {-60}, {10}}), order);
  EXPECT_EQ(defects(rocker_crank, {{50}, {40}, {70}}), order);
}

TEST(DriveThroughARocker, NeedsAPushToPassADeadPoint) {
  EXPECT_EQ(defects(triple_rocker, {{-60}, {-20}, {10, negative}, {50}}), branch);
  EXPECT_EQ(defects(rocker_crank, {{40}, {60, negative}}), branch);
  EXPECT_EQ(defects(double_rocker, {{30}, {31, negative}}), branch);
}

TEST(DriveThroughARocker, PassesPosesOnBothSidesOfADeadPointOnOneCircuit) {
  EXPECT_EQ(visited(triple_rocker, {{-60}, {-20}, {10, negative}, {50}}), (Order{0, 1, 3, 2}));
}

TEST(DriveThroughARocker, CannotReachTheMirrorImageOfItsRange) {
  EXPECT_EQ(defects(rocker_crank, {{40}, {-40, negative}}), circuit);
  EXPECT_EQ(defects(rocker_crank, {{40}, {50}, {-40}}), circuit);
  EXPECT_EQ(defects(double_rocker, {{30}, {-30}}), circuit);
}

TEST(DriveThroughARocker, RunsOverTheBackOfTheTurnWhereTheInputPassesPi) {
  EXPECT_EQ(defects(triple_rocker_back, {{120}, {170}, {190}, {240}}), no_defect);
  EXPECT_EQ(defects(triple_rocker_back, {{170}, {240}, {120}}), order);
  EXPECT_EQ(defects(triple_rocker_back, {{170}, {190}, {240, negative}}), branch);
}

TEST(DriveThrough, AsksNothingOfOnePoseButTheCircuit) {
  EXPECT_EQ(visited(crank_rocker, {{70}}), (Order{0}));
  EXPECT_EQ(defects(triple_rocker, {{70, negative}}), no_defect);
}

TEST(DriveThrough, IgnoresDerivativesUnlessToldToRespectThem) {
  Task task = task_of(crank_rocker, {{0}, {60}, {130}});
  task.poses[1].derivatives = {{{-1, 5}, -2}, {{7, 7}, 7}};
  EXPECT_EQ(drive(task).defects, no_defect);
  EXPECT_EQ(drive(task, {.respect_direction = true}).defects, order) << "the linkage does not move that way at all";
  EXPECT_GT(drive(task).worst_direction_error, 0.01);
}

// Derivatives of the coupler's pose in a stop by the turn of the input, from the angle rates.
void prescribe_direction(Task& task, const LinkLengths& lengths, std::size_t pose, const Stop& stop, double speed) {
  const Configuration c = *assemble(lengths, radians(stop.input_angle_deg), stop.assembly);
  const AngleRates rates = *angle_rates(lengths, c);
  const Point pivot = lengths.input * direction(c.input_angle);
  PrescribedPose& there = task.poses[pose];
  const Point offset = there.pose.origin - pivot;
  there.derivatives = {{speed * (Point{0, 1} * pivot + Point{0, rates.coupler} * offset), speed * rates.coupler}};
}

TEST(DriveThrough, TellsDirectionsByTheWayItGoes) {
  for (const auto& [lengths, stops] : {std::pair{crank_rocker, std::vector<Stop>{{0}, {60}, {130}}},
                                       {crank_rocker, {{0, negative}, {60, negative}, {130, negative}}},
                                       {triple_rocker, {{-60}, {-20}, {50}}},
                                       {triple_rocker_back, {{120}, {190}, {240}}}}) {
    for (std::size_t pose = 0; pose < 3; ++pose)
      for (const double speed : {1.0, -1.0, 1e-6, -1e6}) {
        Task task = task_of(lengths, stops);
        prescribe_direction(task, lengths, pose, stops[pose], speed);
        const DriveThroughReport report = drive(task, {.respect_direction = true});
        EXPECT_EQ(report.defects, speed > 0 ? no_defect : order);
        EXPECT_EQ(drive(task).defects, no_defect);
        EXPECT_LT(report.worst_direction_error, 1e-7);
      }
    Task task = task_of(lengths, {stops[2], stops[1], stops[0]});  // the same way back
    prescribe_direction(task, lengths, 0, stops[2], 1);
    EXPECT_EQ(drive(task, {.respect_direction = true}).defects, order);
    prescribe_direction(task, lengths, 0, stops[2], -1);
    EXPECT_EQ(drive(task, {.respect_direction = true}).defects, no_defect);
    prescribe_direction(task, lengths, 1, stops[1], 1);
    EXPECT_EQ(drive(task, {.respect_direction = true}).defects, order) << "two directions that contradict each other";
  }
}

TEST(DriveThrough, TakesOnePoseInEitherDirection) {
  for (const double speed : {2.0, -2.0}) {
    Task task = task_of(triple_rocker, {{70, negative}});
    prescribe_direction(task, triple_rocker, 0, {70, negative}, speed);
    EXPECT_EQ(drive(task, {.respect_direction = true}).defects, no_defect);
  }
}

// ---- any linkage
// -----------------------------------------------------------------------------------------------------

// What must come out, from how the stops were chosen: cranks keep their assembly and go round; rockers keep their
// range, and within it their assembly, and go to and fro.
Defects expected_defects(const LinkLengths& lengths, const std::vector<Stop>& stops) {
  const auto ranges = input_ranges(lengths);
  const auto differs = [&](auto property) {
    return std::any_of(stops.begin(), stops.end(), [&](const Stop& s) { return property(s) != property(stops[0]); });
  };
  const bool crank = ranges[0].is_full_turn();
  const bool other_assembly = differs([](const Stop& s) { return s.assembly; });
  const bool other_range = ranges.size() == 2 && differs([](const Stop& s) { return s.input_angle_deg > 0; });
  if (other_range || (crank && other_assembly)) return circuit;
  if (other_assembly) return branch;
  std::vector<double> way;
  for (const Stop& stop : stops) {
    const double from = radians(crank ? stops[0].input_angle_deg : degrees(ranges[0].from));
    way.push_back(ranges.size() == 2 ? stop.input_angle_deg : wrap_positive(radians(stop.input_angle_deg) - from));
  }
  if (std::is_sorted(way.begin(), way.end())) return no_defect;
  std::reverse(way.begin() + (crank ? 1 : 0), way.end());
  return std::is_sorted(way.begin(), way.end()) ? no_defect : order;
}

// Stops anywhere a third of the time, otherwise in one assembly, of these half in order: every verdict turns up.
std::vector<Stop> random_stops(RandomFourBars& random, const LinkLengths& lengths, int count) {
  const bool anywhere = random.below(3) == 0, sorted = random.below(2) == 0;
  const Assembly assembly = random.assembly();
  std::vector<Stop> stops;
  for (int i = 0; i < count; ++i)
    stops.push_back({degrees(random.input_angle(lengths)), anywhere ? random.assembly() : assembly});
  const auto ranges = input_ranges(lengths);
  const double sign = stops[0].input_angle_deg;
  if (ranges.size() == 2 && !anywhere)
    for (Stop& stop : stops) stop.input_angle_deg = std::copysign(stop.input_angle_deg, sign);
  const auto before = [](const Stop& a, const Stop& b) {
    return wrap_positive(radians(a.input_angle_deg)) < wrap_positive(radians(b.input_angle_deg));
  };
  if (sorted) std::sort(stops.begin(), stops.end(), before);
  return stops;
}

// A verdict for each, and how well it was come by.
struct Tally {
  std::array<int, 8> seen{};
  double worst_closure = 0, worst_pose_error = 0;
};

void judge(const LinkLengths& lengths, const std::vector<Stop>& stops, Tally& tally) {
  const DriveThroughReport report = drive(task_of(lengths, stops));
  ASSERT_EQ(int{report.defects.bits}, int{expected_defects(lengths, stops).bits});
  ++tally.seen[report.defects.bits];
  tally.worst_closure = std::max(tally.worst_closure, report.worst_closure);
  tally.worst_pose_error = std::max(tally.worst_pose_error, report.worst_pose_error);
}

TEST(DriveThrough, SaysOfRandomLinkagesHowTheirPosesWereMade) {
  RandomFourBars random(1);
  Tally tally;
  for (int i = 0; i < 20000; ++i) {
    const LinkLengths lengths = random.lengths();
    judge(lengths, random_stops(random, lengths, 3 + i % 3), tally);
    ASSERT_FALSE(HasFatalFailure()) << "linkage " << i;
  }
  EXPECT_LT(tally.worst_closure, 2e-13);
  EXPECT_LT(tally.worst_pose_error, 1e-10);
  for (const Defects verdict : {no_defect, order, branch, circuit}) EXPECT_GT(tally.seen[verdict.bits], 1000);
}

// One excess, by number, is `share` of the perimeter (nearly); the others are not small.
LinkLengths near_change_point(RandomFourBars& random, int which, double share) {
  for (;;) {
    LinkLengths l = random.lengths();
    const double wanted = share * l.perimeter();
    if (which == 1) l.ground = l.input + l.output - l.coupler + wanted;
    if (which == 2) l.ground = l.input + l.coupler - l.output + wanted;
    if (which == 3) l.ground = l.coupler + l.output - l.input - wanted;
    const std::array<double, 3> excesses{l.ground + l.coupler - l.input - l.output,
                                         l.ground + l.output - l.input - l.coupler,
                                         l.coupler + l.output - l.ground - l.input};
    const bool others_large =
        std::count_if(excesses.begin(), excesses.end(), [](double t) { return std::abs(t) > 0.1; }) == 2;
    if (l.shortest() > 0.1 && others_large) return l;
  }
}

// Half of the stops close to where the strands of the curve nearly touch: φ = 0 or π.
std::vector<Stop> stops_near_flat(RandomFourBars& random, const LinkLengths& lengths, double flat_deg) {
  std::vector<Stop> stops = random_stops(random, lengths, 4);
  for (Stop& stop : stops) {
    const double close = flat_deg + random.uniform(-1, 1) * std::pow(10, random.uniform(-4, 1));
    if (random.below(2) == 0 && assemble(lengths, radians(close), positive)) stop.input_angle_deg = close;
    stop.input_angle_deg = degrees(wrap_signed(radians(stop.input_angle_deg)));
  }
  return stops;
}

TEST(DriveThrough, NeverJumpsBetweenStrandsThatNearlyTouchAtAChangePoint) {
  RandomFourBars random(2);
  Tally tally;
  for (int i = 0; i < 6000; ++i) {
    const int which = 1 + i % 3;
    const double share = (random.below(2) == 0 ? 1 : -1) * std::pow(10, random.uniform(-9, -2));
    const LinkLengths lengths = near_change_point(random, which, share);
    judge(lengths, stops_near_flat(random, lengths, which == 3 ? 180 : 0), tally);
    ASSERT_FALSE(HasFatalFailure()) << "linkage " << i << ", excess " << which << ' ' << share;
  }
  for (const Defects verdict : {no_defect, order, branch, circuit}) EXPECT_GT(tally.seen[verdict.bits], 100);
}

// Where the circuit crosses itself, which way a change point goes on is open; between two crossings all is decided.
TEST(DriveThrough, JudgesChangePointsUpToWhereTheCircuitCrossesItself) {
  for (const LinkLengths lengths : {LinkLengths{3, 2, 3, 2}, {3, 3, 2, 2}, {4, 1, 3, 2}}) {
    EXPECT_EQ(defects(lengths, {{20}, {40}, {60}}), no_defect);
    EXPECT_EQ(defects(lengths, {{60}, {40}, {20}}), no_defect);
    EXPECT_EQ(defects(lengths, {{40}, {20}, {60}}), order);
  }
  for (const double beyond : {-60.0, -150.0}) {
    const Task task = task_of({3, 2, 3, 2}, {{20}, {40}, {beyond}});
    EXPECT_FALSE(drive_through(task.four_bar, task.poses).completed);
  }
  const Task back = task_of({3, 2, 3, 2}, {{60}, {40}, {20}});
  EXPECT_EQ(drive_through(back.four_bar, back.poses).visited, (std::vector<int>{0, 1, 2}));
}

TEST(DriveThrough, FollowsTinyCircuits) {
  const LinkLengths barely_assembled{3, 1, 1, 1 + 1e-6};
  EXPECT_EQ(defects(barely_assembled, {{-0.01}, {0}, {0.01}}), no_defect);
  EXPECT_EQ(defects(barely_assembled, {{-0.01}, {0}, {0.01, negative}}), branch);
  const LinkLengths tiny_crank{2, 1e-6, 1.5, 1.2}, tiny_output{2, 1.2, 1.5, 1e-6};
  EXPECT_EQ(defects(tiny_crank, {{0}, {100}, {200}, {300}}), no_defect);
  EXPECT_EQ(defects(tiny_crank, {{0}, {100}, {300}, {200}}), order);
  const double middle = degrees((input_ranges(tiny_output)[1].from + input_ranges(tiny_output)[1].to) / 2);
  EXPECT_EQ(defects(tiny_output, {{middle}, {middle + 1e-6}, {middle + 2e-6}}), no_defect);
  EXPECT_EQ(defects(tiny_output, {{middle}, {middle + 1e-6, negative}}), branch);
}

// ---- how it is asked
// -------------------------------------------------------------------------------------------------

Task moved(const Task& task, Point turn_and_scale, Point shift) {
  const auto move = [&](Point p) { return turn_and_scale * p + shift; };
  const FourBar& f = task.four_bar;
  Task result{{move(f.input_fixed), move(f.input_moving), move(f.output_fixed), move(f.output_moving)}, task.poses};
  for (PrescribedPose& p : result.poses) p.pose = {move(p.pose.origin), p.pose.angle + std::arg(turn_and_scale)};
  return result;
}

TEST(DriveThrough, DoesNotDependOnWhereTheDrawingLiesOrHowBigItIs) {
  RandomFourBars random(3);
  for (int i = 0; i < 300; ++i) {
    const LinkLengths lengths = random.lengths();
    const Task task = task_of(lengths, random_stops(random, lengths, 4));
    const DriveThroughReport report = drive(task);
    for (const double scale : {1e-6, 1.0, 1e6}) {
      const Point shift = scale * 100 * Point{random.uniform(-1, 1), random.uniform(-1, 1)};
      const DriveThroughReport again = drive(moved(task, scale * direction(random.uniform(-pi, pi)), shift));
      EXPECT_EQ(again.defects, report.defects);
      EXPECT_EQ(again.visited, report.visited);
      EXPECT_LT(again.worst_pose_error, 1e-9 * scale);
    }
  }
}

TEST(DriveThrough, DoesNotDependOnTheStep) {
  RandomFourBars random(4);
  for (int i = 0; i < 200; ++i) {
    const LinkLengths lengths = random.lengths();
    const Task task = task_of(lengths, random_stops(random, lengths, 4));
    const DriveThroughReport report = drive(task);
    for (const double step : {1.0, 1e-2, 1e-3}) {
      const DriveThroughReport again = drive(task, {.step = step});
      EXPECT_EQ(again.defects, report.defects);
      EXPECT_EQ(again.visited, report.visited);
    }
  }
}

TEST(DriveThrough, MeasuresByHowMuchAPoseIsMissed) {
  Task task = task_of(crank_rocker, {{0}, {60}, {130}});
  EXPECT_LT(drive(task).worst_pose_error, 1e-12);
  task.poses[1].pose.origin += Point{1e-5, -1e-5};
  const DriveThroughReport missed = drive(task);
  EXPECT_EQ(missed.defects, no_defect);
  EXPECT_GT(missed.worst_pose_error, 1e-6);
  EXPECT_LT(missed.worst_pose_error, 1e-4);
  task.poses[1].pose.origin += Point{0.1, -0.1};
  EXPECT_EQ(drive(task).defects, circuit) << "no place on the circuit comes near it";
}

TEST(DriveThrough, MeetsPosesThatAreNearlyTheSame) {
  EXPECT_EQ(defects(crank_rocker, {{0}, {1e-6}, {2e-6}, {3e-6}}), no_defect);
  EXPECT_EQ(defects(crank_rocker, {{0}, {1e-6}, {3e-6}, {2e-6}}), order);
  EXPECT_EQ(defects(triple_rocker, {{1e-6}, {0}, {2e-6}}), order);
}

TEST(DriveThrough, StopsAfterTheStepsItIsGranted) {
  const Task task = task_of(crank_rocker, {{0}, {60}});
  EXPECT_FALSE(drive_through(task.four_bar, task.poses, {.max_steps = 10}).completed);
  EXPECT_FALSE(drive_through(task.four_bar, task.poses, {.step = 0}).completed);
  EXPECT_FALSE(drive_through(task.four_bar, task.poses, {.step = std::nan("")}).completed);
}

TEST(DriveThrough, SaysNothingOfWhatIsNoLinkage) {
  const Task task = task_of(crank_rocker, {{0}, {60}});
  EXPECT_FALSE(drive_through(task.four_bar, {}).completed);
  EXPECT_FALSE(drive_through({}, task.poses).completed) << "all pivots in one point";
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), 1e308}) {
    FourBar four_bar = task.four_bar;
    four_bar.output_moving = {bad, -bad};
    EXPECT_FALSE(drive_through(four_bar, task.poses).completed);
  }
  Task without_coupler = task;
  without_coupler.four_bar.output_moving = without_coupler.four_bar.input_moving;
  EXPECT_FALSE(drive_through(without_coupler.four_bar, without_coupler.poses).completed);
  Task nowhere = task;
  nowhere.poses[1].pose.angle = std::nan("");
  EXPECT_FALSE(drive_through(nowhere.four_bar, nowhere.poses).completed);
}

TEST(DriveThrough, MeetsNoPoseBeyondTheLinkage) {
  Task task = task_of(crank_rocker, {{0}, {60}});
  for (const double far : {100.0, 1e300}) {
    task.poses[1].pose.origin = {far, far};
    const DriveThroughReport report = drive(task);
    EXPECT_EQ(report.defects, circuit);
    EXPECT_EQ(report.visited, Order{0});
  }
}

}  // namespace
}  // namespace linkwright::drive_through_test
