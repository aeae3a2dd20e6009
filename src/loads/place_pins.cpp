#include "place_pins.hpp"

#include <cmath>

namespace linkwright {
namespace {

using Link = LinkPoint::Link;

Loads frictionless(Loads loads) {
  loads.pins.reset();
  return loads;
}

/// Of frictionless pins, with the effort that keeps what acts in balance; none where links lie in one line.
JointForces joints_under(const LoadedPlace& place, Resultants acting, const UnitEffort& by) {
  const double effort = -acting.power(place) / by.rate;
  for (std::size_t k = 0; k < acting.force.size(); ++k) {
    acting.force[k] += effort * by.wrench.force[k];
    acting.moment[k] += effort * by.wrench.moment[k];
  }
  return BoundLoads::joint_forces(place, acting).value_or(JointForces{});
}

Resultants sum(const Acting& of, int sense) {
  Resultants all = of.still;
  for (std::size_t k = 0; k < all.force.size(); ++k) {
    all.force[k] += static_cast<double>(sense) * of.rubbing.force[k];
    all.moment[k] += sense * of.rubbing.moment[k];
  }
  return all;
}

}  // namespace

PlacePins::PlacePins(const Loads& loads, const LoadCase& of, const FourBar& first, const Pose& body)
    : bound_(frictionless(loads), of, first, body) {
  const double mu = loads.pins->friction;
  friction_circle_ = loads.pins->radius * mu / std::sqrt(1 + mu * mu);
}

void PlacePins::add(const LoadedPlace& place, Point body_origin) {
  const UnitEffort hand = *bound_.hand(place);
  const Acting acting = bound_.acting(place);
  Station at;
  at.without = {joints_under(place, sum(acting, +1), hand), joints_under(place, sum(acting, -1), hand)};
  const LinkPoint origin{Link::coupler, (body_origin - place.bars.input_moving) / place.axis(Link::coupler)};
  const auto under_force = [&](Point force) {
    Resultants only;
    only.add(place, origin, force);
    return joints_under(place, only, hand);
  };
  at.by_x = under_force({1, 0});
  at.by_y = under_force({0, 1});
  Resultants turning;
  turning.add_moment(Link::coupler, 1);
  at.by_moment = joints_under(place, turning, hand);
  const auto& [input, coupler, output] = place.twist;
  const std::array<double, four_bar_joints> rates = {input, coupler - input, coupler - output, output};
  for (std::size_t k = 0; k < four_bar_joints; ++k)
    at.weight[k] = friction_circle_ * std::abs(rates[k]) / std::abs(hand.rate);
  stations_.push_back(at);
}

PlacePins::Loss PlacePins::loss(std::size_t station, int sense, const Pushing& spring) const {
  const Station& at = stations_[station];
  Loss loss;
  for (std::size_t k = 0; k < four_bar_joints; ++k) {
    const Point by =
        spring.along.real() * at.by_x[k] + spring.along.imag() * at.by_y[k] + spring.lever * at.by_moment[k];
    const Point joint = at.without[sense > 0 ? 0 : 1][k] + spring.force * by;
    const double force = std::abs(joint);
    loss.force += at.weight[k] * force;
    if (force > 0) loss.by_charge += at.weight[k] * spring.by_charge * dot(joint, by) / force;
  }
  return loss;
}

}  // namespace linkwright
