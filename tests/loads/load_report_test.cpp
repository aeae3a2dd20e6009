#include "linkwright/loads/load_report.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "loads/load_travel.hpp"
#include "support/load_cases.hpp"

namespace linkwright::load_report_test {
namespace {

using nlohmann::json;
using testing::load_case_from;
using testing::load_file;
using testing::loaded_case;
using testing::LoadedCase;
using testing::point_from;

/// Poses of the files meet the pivots to 1e-15 of their sizes only.
void expect_near(double found, const json& told, const char* what, double relative = 2e-10) {
  const double wanted = told.get<double>();
  EXPECT_NEAR(found, wanted, relative * std::max(1.0, std::abs(wanted))) << what;
}
void expect_point(Point found, const json& told, const char* what, double scale = 1) {
  EXPECT_NEAR(std::abs(found - point_from(told)), 0, 5e-10 * std::max(scale, std::abs(point_from(told)))) << what;
}
template <class Value>
void expect_value(const std::optional<Value>& found, const json& told, const char* what) {
  ASSERT_EQ(found.has_value(), !told.is_null()) << what;
  if (!found) return;
  expect_near(*found, told, what);
}
void expect_place(const std::optional<LoadPlace>& found, const json& told, const char* what) {
  ASSERT_EQ(found.has_value(), !told.is_null()) << what;
  if (!found) return;
  expect_near(degrees(found->driver_turn), told["driver_turn_deg"], what, 1e-9);
  expect_near(degrees(found->body_turn), told["body_turn_deg"], what, 1e-9);
}

LoadReport report_of(LoadedCase& of, const json& block) {
  of.loads.cases = {load_case_from(block)};
  return load_report(of.loads, of.bars, of.poses).value();
}

double largest_pin(const JointForces& joints) {
  double most = 0;
  for (const Point joint : joints) most = std::max(most, std::abs(joint));
  return most;
}

class Curves : public ::testing::TestWithParam<const char*> {};

TEST_P(Curves, AreThoseOfFreeBodies) {
  const json file = load_file(GetParam());
  LoadedCase of = loaded_case(file);
  for (const json& result : file["results"]) {
    SCOPED_TRACE(result["case"]["name"].get<std::string>());
    const LoadCase each = load_case_from(result["case"]);
    const auto travel = LoadTravel::of(of.bars, of.poses).value();
    const BoundLoads bound(of.loads, each, of.bars, of.poses.front().pose);
    const double start = bound.energy(travel.at(0).value());
    for (const json& station : result["stations"]) {
      const LoadedPlace place = travel.at(radians(station["driver_turn_deg"].get<double>())).value();
      const UnitEffort hand = bound.hand(place).value();
      expect_near(degrees(place.turn[1]), station["body_turn_deg"], "body turn");
      expect_near(-bound.resultants(place).power(place) / hand.rate, station["hand_frictionless"], "frictionless");
      expect_near((bound.energy(place) - start) / 1000, station["energy_J"], "energy");
      const auto spring = bound.springs(place).front().value();
      expect_near(spring.length, station["gas_springs"][0]["length"], "length");
      expect_near(spring.force, station["gas_springs"][0]["static_force_each"], "gas");
      expect_near(spring.friction, station["gas_springs"][0]["friction_each"], "friction");
      const Push open = bound.push(place, hand, +1, PinFrictionModel::exact);
      const Push close = bound.push(place, hand, -1, PinFrictionModel::exact);
      expect_near(open.effort, station["open_force"], "open");
      expect_near(close.effort, station["close_force"], "close");
      expect_near(largest_pin(open.joints), station["max_pin_open"], "pin, opening");
      expect_near(largest_pin(close.joints), station["max_pin_close"], "pin, closing");
    }
  }
}

TEST_P(Curves, AreReadOff) {
  const json file = load_file(GetParam());
  LoadedCase of = loaded_case(file);
  for (const json& result : file["results"]) {
    SCOPED_TRACE(result["case"]["name"].get<std::string>());
    const LoadReport report = report_of(of, result["case"]);
    const CaseReport& found = report.cases.front();
    const json& told = result["read_outs"];
    expect_value(found.max_open_force, told["max_open_force"], "max_open_force");
    expect_value(found.max_close_force, told["max_close_force"], "max_close_force");
    expect_value(found.hold_open, told["hold_open"], "hold_open");
    expect_value(found.close_start, told["close_start"], "close_start");
    expect_value(found.pop_up, told["pop_up"], "pop_up");
    ASSERT_TRUE(found.hump);
    EXPECT_NEAR(*found.hump, told["hump"].get<double>(), 1e-8);
    expect_place(found.self_rise, told["self_rise"], "self_rise");
    expect_place(found.self_close, told["self_close"], "self_close");
    ASSERT_EQ(found.equilibria.size(), told["equilibria"].size());
    for (std::size_t k = 0; k < found.equilibria.size(); ++k) {
      expect_place(found.equilibria[k].at, told["equilibria"][k], "equilibrium");
      EXPECT_EQ(found.equilibria[k].stable, told["equilibria"][k]["stable"].get<bool>());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, Curves, ::testing::Values("tailgate_gas", "tailgate_self_close", "tailgate_friction"));

void expect_joints(const JointForces& found, const json& told, double scale) {
  for (std::size_t k = 0; k < four_bar_joints; ++k)
    expect_point(found[k], told.at(std::string(four_bar_joint_names[k])), four_bar_joint_names[k].data(), scale);
}

/// The joints' forces while an effort holds the linkage.
JointForces held(const BoundLoads& bound, const LoadedPlace& place, const UnitEffort& by) {
  return bound.push(place, by, +1, PinFrictionModel::exact).joints;
}

TEST(Weight, IsHeldByHandInThreeDirectionsByBothCranksAndByThePins) {
  const json file = load_file("tailgate_weight");
  LoadedCase of = loaded_case(file);
  const auto travel = LoadTravel::of(of.bars, of.poses).value();
  for (const json& result : file["results"]) {
    const LoadCase each = load_case_from(result["case"]);
    for (const json& told : result["positions"]) {
      const LoadedPlace place = travel.at(radians(told["driver_turn_deg"].get<double>())).value();
      const auto hand_by = [&](Handle::Direction direction) {
        of.loads.handle->direction = direction;
        of.loads.handle->angle = radians(135);
        const BoundLoads bound(of.loads, each, of.bars, of.poses.front().pose);
        return -bound.resultants(place).power(place) / bound.hand(place)->rate;
      };
      expect_near(hand_by(Handle::Direction::vertical), told["hand_vertical"], "vertical");
      expect_near(hand_by(Handle::Direction::fixed), told["hand_fixed_135"], "fixed");
      expect_near(hand_by(Handle::Direction::tangential), told["hand_tangential"], "tangential");
      const BoundLoads bound(of.loads, each, of.bars, of.poses.front().pose);
      const double power = bound.resultants(place).power(place);
      const UnitEffort input = bound.torque(place, LinkPoint::Link::input).value();
      expect_near(-power / input.rate / 1000, told["torque_input_Nm"], "input");
      expect_near(-power / bound.torque(place, LinkPoint::Link::output)->rate / 1000, told["torque_output_Nm"],
                  "output");
      expect_joints(held(bound, place, input), told["reactions_input_held"], 300);
      expect_joints(held(bound, place, bound.hand(place).value()), told["reactions_hand_held"], 300);
    }
  }
}

TEST(DeadPoint, HasNoTorqueButAHandAndPins) {
  const json file = load_file("dead_point");
  const LoadedCase of = loaded_case(file);
  LoadedPlace place{of.bars, twist_of(of.bars, 1).value(), {}};
  const BoundLoads bound(of.loads, LoadCase{}, of.bars, of.poses.front().pose);
  EXPECT_NEAR(place.twist.input, 0, 1e-15);
  EXPECT_FALSE(bound.torque(place, LinkPoint::Link::input));
  const UnitEffort hand = bound.hand(place).value();
  const double power = bound.resultants(place).power(place);
  expect_near(-power / hand.rate, file["hand_tangential"], "hand");
  expect_near(-power / bound.torque(place, LinkPoint::Link::output)->rate / 1000, file["torque_output_Nm"], "output");
  expect_joints(held(bound, place, hand), file["reactions_hand_held"], 150);
}

TEST(Cylinder, HasItsOwnDeadPoint) {
  const json file = load_file("cylinder");
  LoadedCase of = loaded_case(file);
  json block = file["loads"];
  block["drive"]["cylinder"] = file["cylinder"];
  of.loads = testing::loads_from(block);
  const BoundLoads bound(of.loads, LoadCase{}, of.bars, of.poses.front().pose);
  const Configuration first = configuration_of(of.bars);
  for (const json& told : file["results"]) {
    const double turn = radians(told["input_turn_deg"].get<double>());
    const FourBar bars =
        placed(of.bars, assemble(of.bars.lengths(), first.input_angle + turn, assembly_of(of.bars)).value());
    const double sense = assembly_of(of.bars) == Assembly::positive ? -1 : 1;
    const LoadedPlace place{bars, twist_of(bars, sense).value(), {}};
    const double power = bound.resultants(place).power(place);
    const UnitEffort cylinder = bound.cylinder(place).value();
    expect_near(-power / cylinder.rate, told["cylinder_force"], "cylinder", 1e-8);
    expect_near(degrees(bound.pressure_angle(place).value()), told["pressure_angle_deg"], "pressure angle");
    expect_near(-power / bound.hand(place)->rate, told["hand_tangential"], "hand");
    expect_joints(held(bound, place, cylinder), told["reactions"], std::abs(told["cylinder_force"].get<double>()) * 20);
  }
}

TEST(Springs, OfGasAreThoseOfTheFile) {
  const json file = load_file("gas_spring");
  for (const json& told : file["results"]) {
    json block = file["spring"];
    if (told["spring"] == "without rod diameter") block.erase("rod_diameter");
    if (told["spring"].get<std::string>().find("percent") != std::string::npos) block["percent_per_10K"] = 3.5;
    if (told["spring"].get<std::string>().find("friction") != std::string::npos) {
      block.erase("F3"), block.erase("F4");
      block["friction"] = 25;
    }
    block["from"] = {{"on", "ground"}, {"at", {150, 115}}};
    block["to"] = {{"on", "body"}, {"at", {60, 298}}};
    const Loads loads = testing::loads_from({{"springs", {block}}});
    const auto& gas = std::get<GasSpring>(loads.springs.front().law);
    const GasLaw law(gas, 5);
    const GasLaw::State state{GasLaw::heat(gas, told["temperature_C"]), 1, 0};
    const double x = told["compression"];
    SCOPED_TRACE(told.dump());
    expect_near(law.force(x, state), told["static"], "static");
    expect_near(law.friction(x), told["friction"], "friction");
    expect_near(law.energy(x, state) / 1000, told["energy_J"], "energy");
  }
}

// Of gas that has no time to take or give heat, too.
TEST(Springs, OfGasTakeUpTheWorkOfTheirForce) {
  GasSpring gas{325, 128};
  gas.f1 = 400, gas.f2 = 530, gas.rod_diameter = 8;
  const GasLaw law(gas, 5);
  for (const double exponent : {1.0, 1.0 + 1e-9, 1.2, 1.4}) {
    const GasLaw::State state{1.1, exponent, 30};
    constexpr int steps = 2000;
    constexpr double from = -4, to = 120, step = (to - from) / steps;
    double work = 0;
    for (int i = 0; i < steps; ++i) work += law.force(from + (i + 0.5) * step, state) * step;
    EXPECT_NEAR(law.energy(to, state) - law.energy(from, state), work, 1e-6 * work) << exponent;
  }
}

TEST(Springs, OfTorsionAndCoilHoldItWhereItRests) {
  const json file = load_file("torsion_and_coil");
  LoadedCase of = loaded_case(file);
  // The travel of the file is one of the input; a pose in its middle says which way.
  const double range = file["input_range_rad"];
  const Pose first = of.poses.front().pose;
  for (const double share : {0.5, 1.0}) {
    const Configuration there =
        assemble(of.bars.lengths(), configuration_of(of.bars).input_angle - share * range, assembly_of(of.bars))
            .value();
    const FourBar bars = placed(of.bars, there);
    const Point turned = (bars.output_moving - bars.input_moving) / (of.bars.output_moving - of.bars.input_moving);
    of.poses.push_back({{bars.input_moving + turned * (first.origin - of.bars.input_moving), std::arg(turned)}, {}});
  }
  for (const json& result : file["results"]) {
    const LoadCase each = load_case_from(result["case"]);
    const auto stations = load_curve(of.loads, each, of.bars, of.poses, 4);
    ASSERT_EQ(stations.size(), result["stations"].size());
    for (std::size_t k = 0; k < stations.size(); ++k) {
      const json& told = result["stations"][k];
      expect_near(degrees(stations[k].at.driver_turn), told["input_turn_deg"], "turn");
      expect_near(stations[k].torque.value(), told["torque_input_Nm"], "torque");
      expect_near(stations[k].frictionless.value(), told["hand_tangential"], "hand");
      expect_near(stations[k].energy.value(), told["energy_J"], "energy");
    }
    const LoadReport report = report_of(of, result["case"]);
    ASSERT_EQ(report.cases.front().equilibria.size(), result["equilibria"].size());
    const Equilibrium& rest = report.cases.front().equilibria.front();
    expect_near(degrees(rest.at.driver_turn), result["equilibria"][0]["input_turn_deg"], "rest", 1e-9);
    expect_near(rest.stiffness, result["equilibria"][0]["stiffness_Nm_per_rad"], "stiffness", 1e-8);
    EXPECT_TRUE(rest.stable);
  }
}

TEST(Inertia, TakesTheTorqueOfTheFile) {
  const json file = load_file("torque_in_motion");
  LoadedCase of = loaded_case(file);
  of.loads.rpm = file["rpm"].get<double>();
  const BoundLoads bound(of.loads, LoadCase{}, of.bars, of.poses.front().pose);
  const double sense = assembly_of(of.bars) == Assembly::positive ? -1 : 1;
  for (const json& told : file["results"]) {
    const double turn = radians(told["input_turn_deg"].get<double>());
    const FourBar bars =
        placed(of.bars,
               assemble(of.bars.lengths(), configuration_of(of.bars).input_angle + turn, assembly_of(of.bars)).value());
    const LoadedPlace place{bars, twist_of(bars, sense).value(), {}};
    const UnitEffort torque = bound.torque(place, LinkPoint::Link::input).value();
    expect_near(-bound.resultants(place).power(place) / torque.rate / 1000, told["torque_Nm"], "torque");
    expect_point(bound.shaking_force(place), told["shaking_force_N"], "shaking", 100);
    expect_joints(held(bound, place, torque), told["pins"], 100);
  }
}

// Laws. The tailgate with two struts in its coldest case, seen otherwise.

LoadedCase struts() {
  LoadedCase of = loaded_case(load_file("tailgate_friction"));
  of.loads.cases = {{.name = "cold", .temperature = -30, .slope = 0.1}};
  return of;
}
CaseReport report_of(const LoadedCase& of) { return load_report(of.loads, of.bars, of.poses).value().cases.front(); }

void expect_same(const CaseReport& a, const CaseReport& b) {
  const auto near = [](std::optional<double> x, std::optional<double> y, const char* what) {
    ASSERT_TRUE(x && y) << what;
    EXPECT_NEAR(*x, *y, 1e-7 * std::max(1.0, std::abs(*x))) << what;
  };
  near(a.max_open_force, b.max_open_force, "open");
  near(a.max_close_force, b.max_close_force, "close");
  near(a.hold_open, b.hold_open, "hold");
  near(a.hump, b.hump, "hump");
  for (std::size_t k = 0; k < four_bar_joints; ++k) near(a.pins[k]->force, b.pins[k]->force, "pin");
}

// The drawing turned and moved, and gravity with it.
TEST(LoadLaws, AreTheSameWhereverTheDrawingLies) {
  const LoadedCase of = struts();
  LoadedCase moved = of;
  const double turned = 0.7;
  const auto carried = [&](Point p) { return Point{3e4, -2e4} + direction(turned) * p; };
  moved.bars = {carried(of.bars.input_fixed), carried(of.bars.input_moving), carried(of.bars.output_fixed),
                carried(of.bars.output_moving)};
  for (PrescribedPose& pose : moved.poses) pose.pose = {carried(pose.pose.origin), pose.pose.angle + turned};
  moved.loads.gravity->direction += turned;
  moved.loads.springs.front().from.at = carried(of.loads.springs.front().from.at);
  expect_same(report_of(of), report_of(moved));
}

// Another frame in the body.
TEST(LoadLaws, AreTheSameInWhateverFrameTheBodyIsTold) {
  const LoadedCase of = struts();
  LoadedCase told = of;
  const Point shift{31, -57};
  const double turn = -1.1;
  for (PrescribedPose& pose : told.poses)
    pose.pose = {pose.pose.origin + direction(pose.pose.angle) * shift, pose.pose.angle + turn};
  const auto seen = [&](Point p) { return (p - shift) / direction(turn); };
  told.loads.body->center = seen(told.loads.body->center);
  told.loads.handle->point = seen(told.loads.handle->point);
  told.loads.springs.front().to.at = seen(told.loads.springs.front().to.at);
  expect_same(report_of(of), report_of(told));
}

// Driven from the other side nothing changes but the names of the joints.
TEST(LoadLaws, DoNotCareWhichLinkIsCalledTheInput) {
  const LoadedCase of = struts();
  LoadedCase swapped = of;
  swapped.bars = of.bars.swapped();
  std::swap(swapped.loads.input, swapped.loads.output);
  CaseReport one = report_of(of), other = report_of(swapped);
  std::swap(other.pins[0], other.pins[3]);
  std::swap(other.pins[1], other.pins[2]);
  expect_same(one, other);
}

TEST(LoadLaws, TakeASlopeForGravityTurned) {
  LoadedCase of = struts();
  const CaseReport on_a_slope = report_of(of);
  of.loads.gravity->direction -= of.loads.cases.front().slope;
  of.loads.cases.front().slope = 0;
  expect_same(on_a_slope, report_of(of));
}

TEST(LoadLaws, SplitASpringInHalves) {
  LoadedCase of = struts();
  const CaseReport whole = report_of(of);
  Spring& spring = of.loads.springs.front();
  spring.count = 1;
  of.loads.springs.push_back(spring);
  of.loads.springs.back().name = "other";
  expect_same(whole, report_of(of));
}

// Under pure weight a parallelogram is held by the weight itself, wherever it is.
TEST(LoadLaws, HoldAParallelogramByItsWeight) {
  const FourBar bars{{0, 0}, {60, 80}, {200, 0}, {260, 80}};
  Loads loads;
  loads.body = BodyMass{24, {40, 120}};
  loads.handle = Handle{{-5, -70}, Handle::Direction::vertical};
  const std::vector<PrescribedPose> poses = {{{{0, 0}, 0}, {}}};
  const LoadTravel travel = LoadTravel::of(bars, poses).value();
  const BoundLoads bound(loads, LoadCase{}, bars, poses[0].pose);
  const LoadedPlace place = travel.at(0).value();
  EXPECT_NEAR(-bound.resultants(place).power(place) / bound.hand(place)->rate, 24 * 9.81, 1e-9);
}

// The work of the hand is the energy, whatever the path: H ds over the handle's way.
TEST(LoadLaws, DoTheWorkOfTheEnergy) {
  LoadedCase of = struts();
  of.loads.pins.reset();
  const auto travel = LoadTravel::of(of.bars, of.poses).value();
  const BoundLoads bound(of.loads, of.loads.cases.front(), of.bars, of.poses.front().pose);
  constexpr int steps = 4000;
  double work = 0;
  for (int i = 0; i < steps; ++i) {
    const LoadedPlace place = travel.at(travel.end() * (i + 0.5) / steps).value();
    const double per_radian = std::abs(place.velocity(*bound.handle()) / place.twist.input);
    const double force = -bound.resultants(place).power(place) / bound.hand(place)->rate;
    work += force * per_radian * travel.end() / steps;
  }
  const double energy = bound.energy(travel.at(travel.end()).value()) - bound.energy(travel.at(0).value());
  EXPECT_NEAR(work, energy, 1e-5 * std::abs(energy));
}

// Where the effort passes 0 its last digits are those of larger numbers: that is no lock.
TEST(LoadLaws, DoNotTakeAnEffortOfNothingForALock) {
  LoadedCase of = loaded_case(load_file("tailgate_friction"));
  of.loads.cases = {{.name = "room"}};
  auto& gas = std::get<GasSpring>(of.loads.springs.front().law);
  for (int i = 0; i < 60; ++i) {
    for (double* force : {&gas.f1, &gas.f2, &*gas.f3, &*gas.f4}) *force += 1;
    EXPECT_FALSE(report_of(of).locks) << gas.f1;
  }
}

// A hand that pulls across the way of its point somewhere has no largest force; at the ends it has one.
TEST(LoadLaws, KnowNoLargestForceOfAHandThatPullsAcrossTheWay) {
  LoadedCase of = loaded_case(load_file("tailgate_weight"));
  const auto travel = LoadTravel::of(of.bars, of.poses).value();
  const BoundLoads bound(of.loads, LoadCase{}, of.bars, of.poses.front().pose);
  const Point along = travel.at(0.4 * travel.end()).value().velocity(*bound.handle());
  of.loads.handle->direction = Handle::Direction::fixed;
  of.loads.handle->angle = std::arg(along) + pi / 2;
  const CaseReport across = report_of(of);
  EXPECT_TRUE(across.locks);
  EXPECT_FALSE(across.max_open_force || across.max_close_force || across.pins[0]);
  EXPECT_TRUE(across.hold_open && across.close_start);
  of.loads.handle->angle = std::arg(along);
  const CaseReport with_it = report_of(of);
  EXPECT_FALSE(with_it.locks);
  EXPECT_TRUE(with_it.max_open_force && with_it.pins[0]);
}

// A hand is needed the way that its point goes, whichever way along its line the direction was given.
TEST(LoadLaws, AskTheSameOfAHandGivenTheOtherWayRound) {
  LoadedCase of = loaded_case(load_file("tailgate_weight"));
  const auto travel = LoadTravel::of(of.bars, of.poses).value();
  const BoundLoads bound(of.loads, LoadCase{}, of.bars, of.poses.front().pose);
  of.loads.handle->direction = Handle::Direction::fixed;
  of.loads.handle->angle = std::arg(travel.at(0.4 * travel.end()).value().velocity(*bound.handle()));
  const CaseReport with_it = report_of(of);
  of.loads.handle->angle += pi;
  const CaseReport against = report_of(of);
  for (const ReadOut each : {ReadOut::max_open_force, ReadOut::max_close_force, ReadOut::hold_open,
                             ReadOut::close_start, ReadOut::pop_up, ReadOut::hump})
    EXPECT_NEAR(with_it.value(each).value(), against.value(each).value(), 1e-9) << name(each);
  EXPECT_EQ(with_it.self_close.has_value(), against.self_close.has_value());
}

// Peaks are found by their condition: no station of a close sweep stands above what is reported.
TEST(LoadLaws, ReportNoLessThanACloseSweepFinds) {
  const LoadedCase of = struts();
  const CaseReport report = report_of(of);
  double open = -1e9, close = -1e9;
  for (const LoadStation& station : load_curve(of.loads, of.loads.cases.front(), of.bars, of.poses, 240)) {
    open = std::max(open, station.open.value());
    close = std::max(close, station.close.value());
  }
  EXPECT_NEAR(report.max_open_force.value(), open, 1e-3);
  EXPECT_GE(report.max_open_force.value(), open - 1e-9);
  EXPECT_NEAR(report.max_close_force.value(), close, 1e-3);
  EXPECT_GE(report.max_close_force.value(), close - 1e-9);
}

}  // namespace
}  // namespace linkwright::load_report_test
