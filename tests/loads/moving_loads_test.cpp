#include <array>
#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/loads/load_report.hpp"
#include "loads/load_travel.hpp"
#include "support/load_cases.hpp"

// Loads in motion, against differences of where the links are in time: nothing of velocities and accelerations of the
// library is used on the other side.
namespace linkwright::moving_loads_test {
namespace {

using testing::load_file;
using testing::loaded_case;
using testing::LoadedCase;
using Link = LinkPoint::Link;

/// The tailgate with masses everywhere, its struts, a crank that drives it, pins without friction; millimetres.
LoadedCase moving(const DriverMotion& motion) {
  LoadedCase of = loaded_case(load_file("tailgate_friction"));
  of.loads.cases = {{.name = "room", .slope = 0.1}};
  of.loads.pins.reset();
  of.loads.drive = LoadDrive::input;
  of.loads.metres = 0.001;
  of.loads.body = BodyMass{24, {40, 120}, 1.7};
  of.loads.input = LinkMass{.mass = {}, .kg_per_m = 1.2, .center = {}};
  of.loads.coupler = LinkMass{.mass = 0.8, .kg_per_m = {}, .center = Point{30, 10}, .inertia = 0.02};
  of.loads.output = LinkMass{.mass = 2.5, .kg_per_m = {}, .center = Point{50, -20}, .inertia = 0.3};
  of.loads.extra = {{.name = "motor", .at = {LoadedBody::output, {30, 40}}, .mass = 1.5, .always = true}};
  of.loads.motion = motion;
  return of;
}

DriverMotion of_law(DriverMotion::Law law, double duration) {
  DriverMotion motion;
  motion.law = law;
  motion.duration = duration;
  return motion;
}
const std::array motions = {of_law(DriverMotion::Law::cycloid, 0.8), of_law(DriverMotion::Law::polynomial_345, 1.5),
                            of_law(DriverMotion::Law::trapezoid, 0.9), of_law(DriverMotion::Law::uniform, 0.6)};

/// A link with all of its mass, seen from outside.
struct Body {
  Link link;
  double mass, inertia;  ///< kg, kg m²
  Point center;          ///< along and across, mm
};

/// One linkage over its travel in time.
struct Film {
  LoadedCase of;
  LoadTravel travel;
  TimeLaw law;
  std::vector<Body> bodies;

  explicit Film(const DriverMotion& motion)
      : of(moving(motion)), travel(*LoadTravel::of(of.bars, of.poses)), law(motion) {
    const LinkLengths lengths = of.bars.lengths();
    const double rod = lengths.input / 1000;
    bodies.push_back({Link::input, 1.2 * rod, 1.2 * rod * rod * rod / 12, {lengths.input / 2, 0}});
    bodies.push_back({Link::coupler, 0.8, 0.02, {30, 10}});
    bodies.push_back({Link::output, 2.5, 0.3, {50, -20}});
    bodies.push_back({Link::output, 1.5, 0, {30, 40}});
    const Pose first = of.poses.front().pose;
    const Point along = of.bars.output_moving - of.bars.input_moving;
    const Point center = first.origin + direction(first.angle) * Point{40, 120};
    bodies.push_back({Link::coupler, 24, 1.7, (center - of.bars.input_moving) / (along / std::abs(along))});
  }
  [[nodiscard]] double turn_at(double time) const { return travel.end() * law.at_time(time).share; }
  [[nodiscard]] LoadedPlace at(double time) const { return travel.at(turn_at(time)).value(); }
  [[nodiscard]] Point center(const Body& body, double time) const {
    return at(time).position({body.link, body.center}) / 1000.0;
  }
  [[nodiscard]] double angle(const Body& body, double time) const {
    return at(time).turn[static_cast<std::size_t>(body.link)];
  }
  /// Away from jumps of the acceleration.
  [[nodiscard]] std::vector<double> times() const {
    std::vector<double> all;
    for (const double share : {0.06, 0.17, 0.29, 0.5, 0.71, 0.8, 0.93}) all.push_back(share * law.duration());
    return all;
  }
  [[nodiscard]] double step() const { return 2e-3 * law.duration(); }
};

template <class Of>
auto first_difference(const Of& of, double at, double step) {
  return (of(at - 2 * step) - 8.0 * of(at - step) + 8.0 * of(at + step) - of(at + 2 * step)) / (12 * step);
}
template <class Of>
auto second_difference(const Of& of, double at, double step) {
  return (-of(at - 2 * step) + 16.0 * of(at - step) - 30.0 * of(at) + 16.0 * of(at + step) - of(at + 2 * step)) /
         (12 * step * step);
}

/// Kinetic and potential, joules.
double energy(const Film& film, const BoundLoads& bound, double time) {
  double sum = bound.energy(film.at(time)) / 1000;
  for (const Body& body : film.bodies) {
    const Point velocity = first_difference([&](double t) { return film.center(body, t); }, time, film.step() / 4);
    const double turning = first_difference([&](double t) { return film.angle(body, t); }, time, film.step() / 4);
    sum += (body.mass * std::norm(velocity) + body.inertia * turning * turning) / 2;
  }
  return sum;
}

TEST(MovingLoads, TakeTheTorqueThatChangesTheEnergy) {
  for (const DriverMotion& motion : motions) {
    const Film film(motion);
    const BoundLoads bound(film.of.loads, film.of.loads.cases.front(), film.of.bars, film.of.poses.front().pose);
    const auto stations = load_curve(film.of.loads, film.of.loads.cases.front(), film.of.bars, film.of.poses, 4);
    double largest = 0;
    for (const LoadStation& station : stations) largest = std::max(largest, std::abs(station.torque.value()));
    for (const double time : film.times()) {
      const LoadedPlace place = film.at(time);
      const double torque = -bound.resultants(place).power(place) / bound.torque(place, Link::input)->rate / 1000;
      const double turning =
          film.travel.sense() * first_difference([&](double t) { return film.turn_at(t); }, time, film.step());
      const double power = first_difference([&](double t) { return energy(film, bound, t); }, time, film.step());
      EXPECT_NEAR(torque, power / turning, 1e-6 * largest) << name(motion.law) << " at " << time;
      EXPECT_NEAR(bound.driver_rates(place).speed, turning, 1e-7 * std::abs(turning));
    }
  }
}

/// Newton and Euler for each link by itself, about its fixed pivot or its pivot at the input.
TEST(MovingLoads, HoldEachLinkByTheForcesOfItsPins) {
  for (const DriverMotion& motion : motions) {
    const Film film(motion);
    const LoadCase& each = film.of.loads.cases.front();
    const BoundLoads bound(film.of.loads, each, film.of.bars, film.of.poses.front().pose);
    const Point gravity = 9.81 * direction(-pi / 2 - each.slope);
    for (const double time : film.times()) {
      const LoadedPlace place = film.at(time);
      const UnitEffort drive = bound.torque(place, Link::input).value();
      const Push push = bound.push(place, drive, +1, PinFrictionModel::exact);
      const Acting acting = bound.acting(place);
      const double torque = -(acting.still.power(place) + acting.rubbing.power(place)) / drive.rate / 1000;
      std::array<Point, 3> force{};
      std::array<double, 3> moment{};
      const auto add = [&](Link link, Point at, Point by) {
        if (link == Link::ground) return;
        force[static_cast<std::size_t>(link)] += by;
        moment[static_cast<std::size_t>(link)] += cross((at - place.origin(link)) / 1000.0, by);
      };
      for (const Body& body : film.bodies) {
        const Point acceleration = second_difference([&](double t) { return film.center(body, t); }, time, film.step());
        const double turning = second_difference([&](double t) { return film.angle(body, t); }, time, film.step());
        add(body.link, place.position({body.link, body.center}), body.mass * (gravity - acceleration));
        moment[static_cast<std::size_t>(body.link)] -= body.inertia * turning;
      }
      const auto strut = bound.springs(place).front().value();
      const Spring& spring = film.of.loads.springs.front();
      const Pose first = film.of.poses.front().pose;
      const Point along = film.of.bars.output_moving - film.of.bars.input_moving;
      const Point on_body = (first.origin + direction(first.angle) * spring.to.at - film.of.bars.input_moving) /
                            (along / std::abs(along));
      const Point stud = place.position({Link::coupler, on_body}),
                  way = (stud - spring.from.at) / std::abs(stud - spring.from.at);
      // Of its friction the direction is that in which it gets longer or shorter.
      const double longer =
          std::abs(film.at(time + film.step()).position({Link::coupler, on_body}) - spring.from.at) - strut.length;
      add(Link::coupler, stud, spring.count * (strut.force - std::copysign(strut.friction, longer)) * way);
      moment[0] += torque;
      const auto& [input_ground, input_coupler, output_coupler, output_ground] = push.joints;
      add(Link::input, place.bars.input_fixed, input_ground);
      add(Link::input, place.bars.input_moving, -input_coupler);
      add(Link::coupler, place.bars.input_moving, input_coupler);
      add(Link::coupler, place.bars.output_moving, output_coupler);
      add(Link::output, place.bars.output_moving, -output_coupler);
      add(Link::output, place.bars.output_fixed, output_ground);
      double scale = 0;
      for (const Point joint : push.joints) scale = std::max(scale, std::abs(joint));
      for (std::size_t link = 0; link < 3; ++link) {
        EXPECT_NEAR(std::abs(force[link]), 0, 1e-6 * scale) << name(motion.law) << " " << time << " link " << link;
        EXPECT_NEAR(moment[link], 0, 1e-6 * scale) << name(motion.law) << " " << time << " link " << link;
      }
    }
  }
}

/// What the links take from the ground but for springs and torque is their weight and what their centres' way takes.
TEST(MovingLoads, ShakeTheGroundByTheWayOfTheirCentres) {
  for (const DriverMotion& motion : motions) {
    const Film film(motion);
    const LoadCase& each = film.of.loads.cases.front();
    const BoundLoads bound(film.of.loads, each, film.of.bars, film.of.poses.front().pose);
    for (const double time : film.times()) {
      Point shaking{};
      for (const Body& body : film.bodies)
        shaking += body.mass * (9.81 * direction(-pi / 2 - each.slope) -
                                second_difference([&](double t) { return film.center(body, t); }, time, film.step()));
      EXPECT_NEAR(std::abs(bound.shaking_force(film.at(time)) - shaking), 0, 1e-6 * std::abs(shaking));
    }
  }
}

double largest_torque(const LoadReport& report) { return report.cases.front().max_torque.value(); }

// A uniform motion is a steady speed.
TEST(MovingLoads, AreThoseOfASteadySpeedWhereTheMotionIsUniform) {
  Film film(of_law(DriverMotion::Law::uniform, 0.6));
  const LoadReport by_motion = load_report(film.of.loads, film.of.bars, film.of.poses).value();
  film.of.loads.motion.reset();
  film.of.loads.rpm = film.travel.end() / 0.6 * 60 / two_pi;
  const LoadReport by_speed = load_report(film.of.loads, film.of.bars, film.of.poses).value();
  EXPECT_NEAR(largest_torque(by_motion), largest_torque(by_speed), 1e-9 * largest_torque(by_speed));
  EXPECT_NEAR(by_motion.cases.front().shaking->force, by_speed.cases.front().shaking->force, 1e-9);
  const auto last = load_curve(film.of.loads, film.of.loads.cases.front(), film.of.bars, film.of.poses, 3).back();
  EXPECT_NEAR(last.motion->time, 0.6, 1e-12);
}

// Twice as slow takes a quarter of what is above the forces at rest; very slow, nothing.
TEST(MovingLoads, GoByTheSquareOfTheSpeed) {
  const auto torques = [](double duration) {
    Film film(of_law(DriverMotion::Law::cycloid, duration));
    std::vector<double> found;
    for (const LoadStation& station :
         load_curve(film.of.loads, film.of.loads.cases.front(), film.of.bars, film.of.poses, 6))
      found.push_back(station.torque.value());
    return found;
  };
  const auto fast = torques(0.5), slow = torques(1), at_rest = torques(1e5);
  double largest = 0;
  for (std::size_t k = 0; k < fast.size(); ++k) {
    EXPECT_NEAR(fast[k] - at_rest[k], 4 * (slow[k] - at_rest[k]), 1e-6 * std::abs(fast[k]));
    largest = std::max(largest, std::abs(fast[k] - at_rest[k]));
  }
  EXPECT_GT(largest, 1);
}

// Its mirror image turns the other way and takes the same.
TEST(MovingLoads, AreTheSameInAMirror) {
  Film film(of_law(DriverMotion::Law::polynomial_345, 0.7));
  film.of.loads.cases.front().slope = 0;
  const LoadReport report = load_report(film.of.loads, film.of.bars, film.of.poses).value();
  LoadedCase mirrored = film.of;
  const auto seen = [](Point p) { return Point{-p.real(), p.imag()}; };
  mirrored.bars = {seen(film.of.bars.input_fixed), seen(film.of.bars.input_moving), seen(film.of.bars.output_fixed),
                   seen(film.of.bars.output_moving)};
  for (PrescribedPose& pose : mirrored.poses) pose.pose = {seen(pose.pose.origin), -pose.pose.angle};
  // The body's frame is mirrored with it, links keep what is along them.
  mirrored.loads.body->center = seen(film.of.loads.body->center);
  mirrored.loads.handle->point = seen(film.of.loads.handle->point);
  mirrored.loads.springs.front().from.at = seen(film.of.loads.springs.front().from.at);
  mirrored.loads.springs.front().to.at = seen(film.of.loads.springs.front().to.at);
  for (auto* link : {&mirrored.loads.coupler, &mirrored.loads.output}) (*link)->center = std::conj(*(*link)->center);
  mirrored.loads.extra.front().at.at = std::conj(film.of.loads.extra.front().at.at);
  const LoadReport other = load_report(mirrored.loads, mirrored.bars, mirrored.poses).value();
  EXPECT_NEAR(largest_torque(report), largest_torque(other), 1e-8 * largest_torque(other));
  EXPECT_NEAR(report.cases.front().shaking->force, other.cases.front().shaking->force, 1e-6);
  EXPECT_NEAR(report.cases.front().shaking->at.driver_turn, other.cases.front().shaking->at.driver_turn, 1e-5);
}

// Nothing rests while it moves, and no station stands above the peak.
TEST(MovingLoads, TellTheLargestForceOnTheGround) {
  for (const DriverMotion& motion : motions) {
    const Film film(motion);
    const CaseReport report = load_report(film.of.loads, film.of.bars, film.of.poses).value().cases.front();
    EXPECT_TRUE(report.equilibria.empty() && report.rests.empty());
    double most = 0;
    for (const LoadStation& station :
         load_curve(film.of.loads, film.of.loads.cases.front(), film.of.bars, film.of.poses, 400))
      most = std::max(most, std::abs(station.motion.value().shaking));
    EXPECT_GE(report.shaking.value().force, most * (1 - 1e-9)) << name(motion.law);
    if (motion.law != DriverMotion::Law::trapezoid) {
      EXPECT_NEAR(report.shaking->force, most, 1e-4 * most);
    }
  }
}

}  // namespace
}  // namespace linkwright::moving_loads_test
