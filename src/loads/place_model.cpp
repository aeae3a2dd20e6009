#include "place_model.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "loads/place_lanes.hpp"

namespace linkwright {
void PlaceModel::Linear::resize(std::size_t count) {
  middle.resize(count);
  rest.resize(count);
  for (auto& by : slope) by.resize(count);
}

PlaceModel::Room::Room(const PlaceModel& model)
    : program(std::array<double, program_unknowns>{}, std::array<double, program_unknowns>{}) {
  for (Linear* linear : {&length, &rate, &work}) linear->resize(model.padded_);
  for (auto* array : {&low, &high, &slowest, &fastest, &force, &force_by, &work_low, &work_high, &fast_low, &fast_high})
    array->resize(model.padded_);
}

FoundOrNot<PlaceModel> PlaceModel::of(const HandStudy& study, const Pose& body, const Loads& loads,
                                      const SpringWanted& wanted, int between) {
  PlaceModel model;
  const double metres = metres_of(loads);
  model.name_ = wanted.name;
  model.number_ = wanted.count;
  model.ratio_ = wanted.f2_over_f1;
  model.friction_ = wanted.friction;
  model.told_measured_at_ = wanted.measured_at;
  model.measured_at_ = wanted.measured_at.value_or(0.005 / metres);
  model.margin_ = wanted.end_margin.value_or(0.010 / metres);
  model.least_charge_ = std::max(least_f1, wanted.demands.min_f1.value_or(0)) + wanted.friction;
  model.most_charge_ = wanted.demands.max_f1.value_or(0) + wanted.friction;
  model.min_stroke_ = wanted.min_stroke;
  model.min_lever_ = wanted.min_lever;
  model.end_length_ = wanted.end_length;
  model.extended_ = wanted.extended_length;
  model.stroke_ = wanted.stroke;
  GasSpring gas;
  for (const LoadCase& each : study.cases()) {
    OfCase of;
    of.is_objective = each.counts(ReadOut::hand_force);
    of.strength = wanted.count * each.spring_percent / 100 * GasLaw::heat(gas, each.temperature);
    of.exponent = each.gas_exponent;
    model.of_case_.push_back(of);
  }
  const LoadTravel& travel = study.travel();
  model.first_pivot_ = travel.first().input_moving;
  const BoundLoads bound(loads, study.cases().front(), travel.first(), body);
  for (const double turn : travel.stations(between)) {
    const auto place = travel.at(turn);
    if (!place) return {{}, no_travel()};
    const auto hand = study.at(*place);
    if (!hand.found) return {{}, hand.why_not};
    model.turns_.push_back(turn);
    model.add_station(*place, body, *hand.found, turn == travel.end(), study.cases(), wanted.demands, *bound.handle());
  }
  model.pad();
  return {std::move(model), {}};
}

void PlaceModel::add_station(const LoadedPlace& place, const Pose& body, const std::vector<HandAt>& hand, bool is_last,
                             const std::vector<LoadCase>& cases, const SpringDemands& demands,
                             const LinkPoint& handle) {
  const Point turned = direction(body.angle + place.turn[1]);
  const Point from_first = direction(place.turn[1]);
  // The pivot at the input in the moving frame is where it was in position 1.
  const Point pivot = place.bars.input_moving;
  const Point origin = pivot + from_first * (body.origin - first_pivot_);
  const Point velocity =
      place.velocity({LinkPoint::Link::coupler, (origin - pivot) / place.axis(LinkPoint::Link::coupler)});
  dx_.push_back(origin.real());
  dy_.push_back(origin.imag());
  cosine_.push_back(turned.real());
  sine_.push_back(turned.imag());
  vx_.push_back(velocity.real());
  vy_.push_back(velocity.imag());
  omega_.push_back(place.twist.coupler);
  handle_speed_.push_back(std::abs(place.velocity(handle)));
  for (std::size_t c = 0; c < of_case_.size(); ++c) {
    OfCase& of = of_case_[c];
    of.open.push_back(hand[c].without + hand[c].friction);
    of.close.push_back(-hand[c].without + hand[c].friction);
    of.per_power.push_back(hand[c].per_power);
    for (const int sense : {+1, -1})
      if (const auto limit = demanded(demands, cases[c], sense, place.turn[1], is_last).limit)
        of.limits.push_back({count_, sense, *limit});
  }
  ++count_;
}

void PlaceModel::pad() {
  constexpr std::size_t lanes = place_lanes::lanes;
  padded_ = (count_ + lanes - 1) / lanes * lanes;
  const auto pad_one = [&](std::vector<double>& values) { values.resize(padded_, values.back()); };
  for (auto* values : {&dx_, &dy_, &cosine_, &sine_, &vx_, &vy_, &omega_, &handle_speed_}) pad_one(*values);
  for (OfCase& of : of_case_)
    for (auto* values : {&of.open, &of.close, &of.per_power}) pad_one(*values);
}

PlaceModel::Bound PlaceModel::bound(const StudCoordinates& middle, const StudCoordinates& half, Room& room,
                                    double enough) const {
  reach(middle, half, room);
  const Lengths of = lengths(room);
  if (!may_be_built(of, room)) return {};
  forces(of, room);
  Charges charges;
  const LeastTop found = least(room, charges);
  if (found.value == nowhere) return {};
  Bound bound{found.value, widest(half, room, found)};
  if (bound.force < enough && !extended_) bound.force = by_slopes(room, charges, bound.force, enough);
  return bound;
}

PlaceModel::Value PlaceModel::value(const StudCoordinates& studs, Room& room) const {
  reach(studs, {}, room);
  const Lengths of = lengths(room);
  Value value;
  value.extended_length = extended_.value_or(of.longest_low + margin_);
  value.stroke = stroke_.value_or(of.longest_low - of.shortest_low + 2 * margin_);
  if (!may_be_built(of, room)) return value;
  forces(of, room);
  Charges charges;
  LeastTop found = least(room, charges);
  if (!pins_.empty() && found.value < nowhere) found = least_with_pins(studs, room, found);
  value.force = found.value;
  value.charge = found.s;
  return value;
}

Spring PlaceModel::spring(const StudCoordinates& studs, const Value& of) const {
  GasSpring gas;
  gas.extended_length = of.extended_length;
  gas.stroke = of.stroke;
  gas.measured_at = told_measured_at_;
  gas.f1 = of.charge - friction_;
  gas.f2 = ratio_ * of.charge - friction_;
  gas.friction = friction_;
  return {name_, number_, {LoadedBody::ground, {studs[0], studs[1]}}, {LoadedBody::body, {studs[2], studs[3]}}, gas};
}

}  // namespace linkwright
