// The least largest force at a place under the friction of pins, which goes by the charge: convex, as a force of a pin
// is the length of a vector that is linear in it.

#include <algorithm>
#include <cmath>

#include "linkwright/core/angle.hpp"
#include "loads/place_model.hpp"

namespace linkwright {

PlaceModel PlaceModel::with_pins(const HandStudy& study, const Pose& body, const Loads& loads) const {
  PlaceModel model = *this;
  const LoadTravel& travel = study.travel();
  for (const LoadCase& each : study.cases()) model.pins_.emplace_back(loads, each, travel.first(), body);
  for (std::size_t i = 0; i < count_; ++i)
    for (PlacePins& pins : model.pins_) pins.add(*travel.at(turns_[i]), {dx_[i], dy_[i]});
  return model;
}

std::vector<PlaceModel::PlaceRow> PlaceModel::rows_at(const StudCoordinates& studs, Room& room) const {
  std::vector<PlaceRow> rows;
  const Point ground{studs[0], studs[1]};
  for (std::size_t c = 0; c < of_case_.size(); ++c) {
    const OfCase& of = of_case_[c];
    fast_works(of, room);
    for (std::size_t i = 0; i < count_; ++i) {
      const Point arm = Point{cosine_[i], sine_[i]} * Point{studs[2], studs[3]};
      const Point way = Point{dx_[i], dy_[i]} + arm - ground, along = way / room.length.middle[i];
      const double rate = room.rate.middle[i], rubs = number_ * friction_;
      const double fast = room.work.middle[i] != 0 ? room.fast_high[i] / room.work.middle[i] : 1;
      for (const int sense : {+1, -1}) {
        PlaceRow row{(sense > 0 ? of.open[i] : of.close[i]) + rubs * of.per_power[i] * std::abs(rate),
                     -sense * of.strength * of.per_power[i] * room.fast_high[i]};
        row.pins = &pins_[c];
        row.station = i;
        row.sense = sense;
        row.spring = {along, cross(arm, along), rate == 0 ? 0 : -sense * std::copysign(rubs, rate),
                      of.strength * fast * room.force[i]};
        row.is_objective = of.is_objective;
        for (const Limited& limited : of.limits)
          if (limited.station == i && limited.sense == sense) row.limit = limited.limit;
        if (row.is_objective || row.limit) rows.push_back(row);
      }
    }
  }
  return rows;
}

/// By tangents: what they make of the rows lies below them, and is exact where the last one was taken. Bounds on the
/// charge are those of tangents, too.
LeastTop PlaceModel::least_with_pins(const StudCoordinates& studs, Room& room, const LeastTop& start) const {
  constexpr int most_turns = 12;
  constexpr double settled = 1e-9;
  const std::vector<PlaceRow> rows = rows_at(studs, room);
  Charges charges{least_charge_, most_charge_};
  room.a.clear();
  room.b.clear();
  LeastTop found = start;
  for (int turn = 0; turn < most_turns; ++turn) {
    double largest = -nowhere;
    for (const PlaceRow& row : rows) {
      PlacePins::Pushing spring = row.spring;
      spring.force += found.s * spring.by_charge;
      const PlacePins::Loss loss = row.pins->loss(row.station, row.sense, spring);
      const double b = row.b + loss.by_charge, a = row.a + loss.force - loss.by_charge * found.s;
      if (row.is_objective) {
        largest = std::max(largest, a + b * found.s);
        room.a.push_back(a);
        room.b.push_back(b);
      }
      if (!row.limit) continue;
      const double over = a - *row.limit;
      if (b < 0) charges.low = std::max(charges.low, -over / b);
      if (b > 0) charges.high = std::min(charges.high, -over / b);
      if (b == 0 && over > 0) charges.high = -nowhere;
    }
    LeastTop next;
    next.value = nowhere;
    if (!(charges.low <= charges.high)) return next;
    next = least_top({room.a.data(), room.b.data(), room.a.size()}, charges.low, charges.high);
    const bool is_settled = std::abs(next.s - found.s) <= settled * (1 + std::abs(found.s));
    if (turn > 0 && is_settled) next.value = largest;
    found = next;
    if (turn > 0 && is_settled) break;
  }
  return found;
}

}  // namespace linkwright
