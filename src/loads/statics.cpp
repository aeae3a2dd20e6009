#include "statics.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/angle.hpp"
#include "loads/carried.hpp"

namespace linkwright {
namespace {

using Link = LinkPoint::Link;
constexpr std::size_t at(Link link) { return static_cast<std::size_t>(link); }
constexpr Point quarter_turn{0, 1};

/// |v|, without the care of hypot() where squares neither overflow nor vanish.
double length_of(Point v) {
  constexpr double least = 1e-280, most = 1e280;
  const double square = std::norm(v);
  return square > least && square < most ? std::sqrt(square) : std::abs(v);
}

Point unit(Point v) {
  const double length = length_of(v);
  return length > 0 ? v / length : Point{1, 0};
}

/// None where both are at one place: a spring without length does nothing.
Point direction_between(Point from, Point to) { return from == to ? Point{} : unit(to - from); }

Point arm(const FourBar& bars, Link link) {
  switch (link) {
    case Link::input:
      return bars.input_moving - bars.input_fixed;
    case Link::coupler:
      return bars.output_moving - bars.input_moving;
    case Link::output:
      return bars.output_moving - bars.output_fixed;
    default:
      return {1, 0};
  }
}

/// Turn of a joint's moving link by the other one.
template <class OfLinks>
double relative(FourBarJoint joint, const OfLinks& of) {
  switch (joint) {
    case FourBarJoint::input_ground:
      return of(Link::input);
    case FourBarJoint::input_coupler:
      return of(Link::coupler) - of(Link::input);
    case FourBarJoint::output_coupler:
      return of(Link::coupler) - of(Link::output);
    default:
      return of(Link::output);
  }
}

/// Of a joint the moving link, and the other one.
struct JointLinks {
  Link moving, other;
};
constexpr std::array<JointLinks, four_bar_joints> joint_links = {
    JointLinks{Link::input, Link::ground}, JointLinks{Link::coupler, Link::input},
    JointLinks{Link::coupler, Link::output}, JointLinks{Link::output, Link::ground}};

void add_joint_moment(Resultants& all, FourBarJoint joint, double moment) {
  const JointLinks links = joint_links[static_cast<std::size_t>(joint)];
  all.add_moment(links.moving, moment);
  all.add_moment(links.other, -moment);
}

Resultants plus(Resultants all, const Resultants& other, double times) {
  for (std::size_t k = 0; k < all.force.size(); ++k) {
    all.force[k] += times * other.force[k];
    all.moment[k] += times * other.moment[k];
  }
  return all;
}

}  // namespace

std::optional<FourBarTwist> twist_of(const FourBar& bars, double sense) {
  const Point alpha = arm(bars, Link::input), h = arm(bars, Link::coupler), beta = arm(bars, Link::output);
  const double input = cross(beta, h), coupler = cross(alpha, beta), output = cross(alpha, h);
  const double largest = std::max({std::abs(input), std::abs(coupler), std::abs(output)});
  const double square = bars.lengths().perimeter() * bars.lengths().perimeter();
  if (!(largest > 1e-14 * square)) return std::nullopt;
  const double scale = sense / largest;
  return FourBarTwist{input * scale, coupler * scale, output * scale};
}

Point LoadedPlace::origin(Link link) const {
  switch (link) {
    case Link::input:
      return bars.input_fixed;
    case Link::coupler:
      return bars.input_moving;
    case Link::output:
      return bars.output_fixed;
    default:
      return {};
  }
}

Point LoadedPlace::axis(Link link) const { return link == Link::ground ? Point{1, 0} : unit(arm(bars, link)); }

double LoadedPlace::rate(Link link) const {
  const std::array<double, 4> rates = {twist.input, twist.coupler, twist.output, 0};
  return rates[at(link)];
}

Point LoadedPlace::velocity(const LinkPoint& point) const {
  const Point turning = quarter_turn * (rate(point.link) * (axis(point.link) * point.at));
  if (point.link == Link::ground) return {};
  return point.link == Link::coupler ? turning + quarter_turn * (twist.input * arm(bars, Link::input)) : turning;
}

void Resultants::add(const LoadedPlace& place, const LinkPoint& point, Point acting) {
  if (point.link == Link::ground) return;
  force[at(point.link)] += acting;
  moment[at(point.link)] += cross(place.axis(point.link) * point.at, acting);
}

void Resultants::add_moment(Link link, double acting) {
  if (link != Link::ground) moment[at(link)] += acting;
}

double Resultants::power(const LoadedPlace& place) const {
  const Point of_coupler = quarter_turn * (place.twist.input * arm(place.bars, Link::input));
  return place.twist.input * moment[0] + place.twist.coupler * moment[1] + place.twist.output * moment[2] +
         dot(force[1], of_coupler);
}

BoundLoads::BoundLoads(const Loads& loads, const LoadCase& of, const FourBar& bars, const Pose& body)
    : first_(bars), body_(body), size_(bars.lengths().perimeter()), metres_(metres_of(loads)) {
  gravity_ = gravity_in(loads, of);
  for (const CarriedMass& mass : masses_in(loads, of, bars))
    masses_.push_back({bound(mass.at), mass.mass, mass.inertia});
  bind_forces(loads, of);
  bind_springs(loads, of);
  if (loads.handle) {
    handle_ = bound({LoadedBody::body, loads.handle->point});
    hand_direction_ = loads.handle->direction;
    const bool is_vertical = hand_direction_ == Handle::Direction::vertical;
    hand_along_ = is_vertical ? -unit(gravity_) : direction(loads.handle->angle);
  }
  drive_ = loads.drive;
  if (drive_ == LoadDrive::cylinder) {
    cylinder_from_ = bound(loads.cylinder.from);
    cylinder_to_ = bound(loads.cylinder.to);
  }
  if (loads.pins) {
    const double mu = loads.pins->friction;
    friction_circle_ = loads.pins->radius * mu / std::sqrt(1 + mu * mu);
  }
  if (loads.rpm) angular_velocity_ = *loads.rpm * two_pi / 60;
  if (loads.motion) law_.emplace(*loads.motion);
}

LinkPoint BoundLoads::bound(const CarriedPoint& point) const {
  switch (point.on) {
    case LoadedBody::ground:
      return {Link::ground, point.at};
    case LoadedBody::input:
      return {Link::input, point.at};
    case LoadedBody::coupler:
      return {Link::coupler, point.at};
    case LoadedBody::output:
      return {Link::output, point.at};
    default:
      return {Link::coupler, (body_.origin + direction(body_.angle) * point.at - first_.input_moving) /
                                 unit(arm(first_, Link::coupler))};
  }
}

void BoundLoads::bind_forces(const Loads& loads, const LoadCase& of) {
  for (const ExtraLoad& extra : loads.extra) {
    if (extra.mass || !acts_in(extra, of)) continue;
    const LinkPoint point = bound(extra.at);
    Point force = extra.force;
    const bool turns = extra.turns_with_body && point.link != Link::ground;
    if (turns && extra.at.on == LoadedBody::body) force *= direction(body_.angle) / unit(arm(first_, Link::coupler));
    forces_.push_back({point, force, turns});
    has_energy_ = has_energy_ && !turns;
  }
}

void BoundLoads::bind_springs(const Loads& loads, const LoadCase& of) {
  const double percent = of.spring_percent / 100;
  for (const Spring& spring : loads.springs) {
    spring_of_.emplace_back();
    if (const auto* torsion = std::get_if<TorsionSpring>(&spring.law)) {
      const double scale = percent * spring.count / metres_;
      torsion_.push_back(
          {torsion->joint, degrees(torsion->rate_per_degree) * scale, torsion->torque_at_position_1 * scale});
      continue;
    }
    Linear linear{bound(spring.from), bound(spring.to), static_cast<double>(spring.count), percent, {}, {}, 0};
    if (const auto* gas = std::get_if<GasSpring>(&spring.law)) {
      const double five_mm = 0.005 / metres_;
      linear.law = GasLaw(*gas, five_mm);
      linear.extended = gas->extended_length;
      linear.state = {GasLaw::heat(*gas, of.temperature), of.gas_exponent, 0};
      // It took the temperature of its surroundings where the linkage rested: in position 1.
      const LoadedPlace rest{first_, {}, {}};
      linear.state.rested_at = linear.extended - std::abs(rest.position(linear.to) - rest.position(linear.from));
    } else {
      linear.law = std::get<CoilSpring>(spring.law);
    }
    spring_of_.back() = linear_.size();
    linear_.push_back(linear);
  }
}

namespace {

/// Pushing > 0, N.
double coil_force(const CoilSpring& coil, double length) {
  const double force = coil.rate * (coil.free_length - length);
  if (coil.acts == CoilSpring::Acts::tension) return std::min(0.0, force);
  return coil.acts == CoilSpring::Acts::compression ? std::max(0.0, force) : force;
}

double coil_energy(const CoilSpring& coil, double length) {
  const double by = coil_force(coil, length);
  return coil.rate > 0 ? by * by / (2 * coil.rate) : 0;
}

}  // namespace

BoundLoads::SpringState BoundLoads::state(const Linear& spring, const LoadedPlace& place) const {
  const Point from = place.position(spring.from), to = place.position(spring.to);
  SpringState state;
  state.length = length_of(to - from);
  state.rate = dot(direction_between(from, to), place.velocity(spring.to) - place.velocity(spring.from));
  if (const auto* gas = std::get_if<GasLaw>(&spring.law)) {
    const double x = spring.extended - state.length;
    state.force = spring.percent * gas->force(x, spring.state);
    state.friction = gas->friction(x);
  } else {
    state.force = spring.percent * coil_force(std::get<CoilSpring>(spring.law), state.length);
  }
  return state;
}

std::vector<std::optional<BoundLoads::SpringState>> BoundLoads::springs(const LoadedPlace& place) const {
  std::vector<std::optional<SpringState>> states;
  for (const auto& index : spring_of_)
    states.push_back(index ? std::optional(state(linear_[*index], place)) : std::nullopt);
  return states;
}

Acting BoundLoads::acting(const LoadedPlace& place) const {
  Acting all;
  for (const Mass& mass : masses_) all.still.add(place, mass.at, mass.mass * gravity_);
  for (const Force& force : forces_)
    all.still.add(place, force.at, force.turns ? force.force * place.axis(force.at.link) : force.force);
  for (const Torsion& spring : torsion_) {
    const double turned =
        relative(spring.joint, [&](Link link) { return link == Link::ground ? 0 : place.turn[at(link)]; });
    add_joint_moment(all.still, spring.joint, spring.moment - spring.rate * turned);
  }
  for (const Linear& spring : linear_) add_spring(spring, place, all);
  if (is_dynamic()) add_inertia(place, all.still);
  return all;
}

void BoundLoads::add_spring(const Linear& spring, const LoadedPlace& place, Acting& all) const {
  const SpringState is = state(spring, place);
  const Point along = direction_between(place.position(spring.from), place.position(spring.to));
  const auto add = [&](Resultants& to, double force) {
    to.add(place, spring.to, spring.count * force * along);
    to.add(place, spring.from, -spring.count * force * along);
  };
  add(all.still, is.force);
  if (is.friction != 0 && is.rate != 0) add(all.rubbing, -std::copysign(is.friction, is.rate));
}

double BoundLoads::spring_friction(const LoadedPlace& place) const {
  double sum = 0;
  for (const Linear& spring : linear_) {
    const SpringState is = state(spring, place);
    sum += spring.count * is.friction * std::abs(is.rate);
  }
  return sum;
}

double BoundLoads::energy(const LoadedPlace& place) const {
  double sum = 0;
  for (const Mass& mass : masses_) sum -= mass.mass * dot(gravity_, place.position(mass.at));
  for (const Force& force : forces_) sum -= dot(force.force, place.position(force.at));
  for (const Torsion& spring : torsion_) {
    const double turned =
        relative(spring.joint, [&](Link link) { return link == Link::ground ? 0 : place.turn[at(link)]; });
    sum += turned * (spring.rate * turned / 2 - spring.moment);
  }
  for (const Linear& spring : linear_) {
    const double length = std::abs(place.position(spring.to) - place.position(spring.from));
    const auto* gas = std::get_if<GasLaw>(&spring.law);
    sum += spring.count * spring.percent *
           (gas ? gas->energy(spring.extended - length, spring.state)
                : coil_energy(std::get<CoilSpring>(spring.law), length));
  }
  return sum;
}

namespace {

/// Angular velocities and accelerations of the links while the input turns by one radian per unit of time.
struct LinkRates {
  std::array<double, 3> first{}, second{};
};

std::optional<LinkRates> rates_of(const LoadedPlace& place) {
  if (place.twist.input == 0) return std::nullopt;
  const Point alpha = arm(place.bars, Link::input), h = arm(place.bars, Link::coupler);
  const Point beta = arm(place.bars, Link::output);
  const double theta = place.twist.coupler / place.twist.input, psi = place.twist.output / place.twist.input;
  const Point r = alpha + h * (theta * theta) - beta * (psi * psi);
  return LinkRates{{1, theta, psi},
                   {0, dot(r, beta) / dot(quarter_turn * h, beta), -dot(r, h) / dot(quarter_turn * beta, h)}};
}

/// What a point moves by: d²p/dt² = φ̇² d²p/dφ² + φ̈ dp/dφ.
Point acceleration(const LoadedPlace& place, const LinkRates& rates, const BoundLoads::DriverRates& driver,
                   const LinkPoint& point) {
  const Point arm_of_point = place.axis(point.link) * point.at;
  const double first = rates.first[at(point.link)], second = rates.second[at(point.link)];
  Point by_square = arm_of_point * Point{-first * first, second};
  if (point.link == Link::coupler) by_square -= arm(place.bars, Link::input);
  const Point by_turn = place.velocity(point) / place.twist.input;
  return driver.speed * driver.speed * by_square + driver.acceleration * by_turn;
}

}  // namespace

void BoundLoads::add_inertia(const LoadedPlace& place, Resultants& all) const {
  const auto rates = rates_of(place);
  if (!rates) return;
  const DriverRates driver = driver_rates(place);
  for (const Mass& mass : masses_) {
    if (mass.at.link == Link::ground) continue;
    const std::size_t link = at(mass.at.link);
    all.add(place, mass.at, -mass.mass * metres_ * acceleration(place, *rates, driver, mass.at));
    const double turning = driver.speed * driver.speed * rates->second[link] + driver.acceleration * rates->first[link];
    all.add_moment(mass.at.link, -mass.inertia * turning / metres_);
  }
}

BoundLoads::DriverRates BoundLoads::driver_rates(const LoadedPlace& place) const {
  const double sense = place.twist.input < 0 ? -1 : 1;
  if (!law_) {
    const double time = angular_velocity_ > 0 ? place.share * place.whole / angular_velocity_ : 0;
    return {sense * angular_velocity_, 0, time};
  }
  const DriverState state = law_->at_share(place.share);
  return {sense * place.whole * state.speed, sense * place.whole * state.acceleration, state.time};
}

Point BoundLoads::shaking_force(const LoadedPlace& place) const {
  const auto rates = rates_of(place);
  const DriverRates driver = driver_rates(place);
  Point sum{};
  for (const Mass& mass : masses_) {
    if (mass.at.link == Link::ground) continue;
    sum += mass.mass * gravity_;
    if (rates) sum -= mass.mass * metres_ * acceleration(place, *rates, driver, mass.at);
  }
  return sum;
}

std::optional<UnitEffort> BoundLoads::hand(const LoadedPlace& place) const {
  constexpr double rests = 1e-9;
  if (!handle_) return std::nullopt;
  const Point velocity = place.velocity(*handle_);
  const bool follows = hand_direction_ == Handle::Direction::tangential;
  const Point along = follows ? unit(velocity) : hand_along_;
  UnitEffort effort;
  effort.rate = dot(along, velocity);
  if (!(std::abs(effort.rate) > rests * size_)) return std::nullopt;
  effort.wrench.add(place, *handle_, along);
  return effort;
}

std::optional<UnitEffort> BoundLoads::torque(const LoadedPlace& place, Link crank) const {
  constexpr double rests = 1e-12;
  UnitEffort effort;
  effort.rate = place.rate(crank);
  if (!(std::abs(effort.rate) > rests)) return std::nullopt;
  effort.wrench.add_moment(crank, 1);
  return effort;
}

std::optional<UnitEffort> BoundLoads::cylinder(const LoadedPlace& place) const {
  constexpr double rests = 1e-9;
  const Point along = direction_between(place.position(cylinder_from_), place.position(cylinder_to_));
  UnitEffort effort;
  effort.rate = dot(along, place.velocity(cylinder_to_) - place.velocity(cylinder_from_));
  if (!(std::abs(effort.rate) > rests * size_)) return std::nullopt;
  effort.wrench.add(place, cylinder_to_, along);
  effort.wrench.add(place, cylinder_from_, -along);
  return effort;
}

std::optional<double> BoundLoads::pressure_angle(const LoadedPlace& place) const {
  const Point along = unit(place.position(cylinder_to_) - place.position(cylinder_from_));
  const Point velocity = place.velocity(cylinder_to_) - place.velocity(cylinder_from_);
  if (std::abs(velocity) == 0) return std::nullopt;
  return std::atan2(std::abs(cross(along, velocity)), std::abs(dot(along, velocity)));
}

std::optional<UnitEffort> BoundLoads::drive(const LoadedPlace& place) const {
  switch (drive_) {
    case LoadDrive::hand:
      return hand(place);
    case LoadDrive::input:
      return torque(place, Link::input);
    case LoadDrive::output:
      return torque(place, Link::output);
    default:
      return cylinder(place);
  }
}

std::optional<JointForces> BoundLoads::joint_forces(const LoadedPlace& place, const Resultants& all) {
  struct Row {
    Point arm;
    double moment;
  };
  const Point alpha = arm(place.bars, Link::input);
  const std::array<Row, 3> rows = {Row{arm(place.bars, Link::output), all.moment[2]},
                                   Row{arm(place.bars, Link::coupler), -all.moment[1]},
                                   Row{alpha, -cross(alpha, all.force[1]) - all.moment[0]}};
  double best = 0;  // square of the sine
  std::optional<Point> at_output;
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = i + 1; j < rows.size(); ++j) {
      const double area = cross(rows[i].arm, rows[j].arm);
      const double square = area / std::norm(rows[i].arm) * (area / std::norm(rows[j].arm));
      if (!(square > best)) continue;
      best = square;
      at_output = (rows[i].moment * rows[j].arm - rows[j].moment * rows[i].arm) / area;
    }
  if (!at_output) return std::nullopt;
  const Point at_input = -all.force[1] - *at_output;
  return JointForces{at_input - all.force[0], at_input, *at_output, *at_output - all.force[2]};
}

Push BoundLoads::push(const LoadedPlace& place, const Acting& all, const UnitEffort& by, int sense,
                      PinFrictionModel model) const {
  constexpr int most_steps = 50;
  const double settled = model == PinFrictionModel::close ? 1e-7 : 1e-13;
  const Resultants acting = plus(all.still, all.rubbing, sense);
  const auto effort_of = [&](const Resultants& them) { return -them.power(place) / by.rate; };
  const auto rate = [&](Link link) { return place.rate(link); };
  Push push;
  push.effort = effort_of(acting);
  const double frictionless = push.effort;  // not small where friction takes the effort through 0
  auto joints = joint_forces(place, plus(acting, by.wrench, push.effort));
  if (joints) push.joints = *joints;
  for (int step = 0; friction_circle_ > 0 && joints && step < most_steps; ++step) {
    Resultants rubbing = acting;
    for (std::size_t k = 0; k < four_bar_joints; ++k) {
      const auto joint = static_cast<FourBarJoint>(k);
      const double turning = sense * relative(joint, rate);
      if (turning != 0)
        add_joint_moment(rubbing, joint, -std::copysign(friction_circle_ * length_of(push.joints[k]), turning));
    }
    const double before = push.effort;
    push.effort = effort_of(rubbing);
    if (model == PinFrictionModel::first_order) break;
    joints = joint_forces(place, plus(rubbing, by.wrench, push.effort));
    push.joints = *joints;
    if (std::abs(push.effort - before) <= settled * (std::abs(push.effort) + std::abs(frictionless))) break;
    push.locks = step + 1 == most_steps;
  }
  push.effort *= sense;  // as a force along the motion where the effort goes along in opening
  return push;
}

}  // namespace linkwright
