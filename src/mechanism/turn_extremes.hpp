#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/drive_table.hpp"

namespace linkwright {

/// A quantity of a crank's turn is looked at a degree apart, and ever more closely where the links come nearest to
/// lying in one line, with the input along the ground link: there it may rise and fall within a degree.
[[nodiscard]] inline std::vector<double> places_of_a_turn() {
  constexpr double nearest = 1e-8, wider = 1.5;
  std::vector<double> places;
  for (int k = -180; k <= 180; ++k) places.push_back(radians(k));
  for (const double line : {-pi, 0.0, pi})
    for (double off = nearest; off < radians(1); off *= wider) {
      if (line < pi) places.push_back(line + off);
      if (line > -pi) places.push_back(line - off);
    }
  std::sort(places.begin(), places.end());
  return places;
}

/// The largest value of a quantity near a place that its neighbours do not exceed, by golden sections.
template <class Quantity>
[[nodiscard]] double top_between(const Quantity& quantity, double low, double high) {
  constexpr double golden = 0.6180339887498949;
  constexpr int sections = 60;
  double one = high - golden * (high - low), other = low + golden * (high - low);
  double at_one = quantity(one), at_other = quantity(other), most = std::max(at_one, at_other);
  for (int section = 0; section < sections; ++section) {
    if (at_one > at_other) {
      high = other, other = one, at_other = at_one;
      one = high - golden * (high - low);
      at_one = quantity(one);
    } else {
      low = one, one = other, at_one = at_other;
      other = low + golden * (high - low);
      at_other = quantity(other);
    }
    most = std::max({most, at_one, at_other});
  }
  return most;
}

/// Least and most of `ratio(input angle)`, an optional number, over a crank's turn; nothing where it is not defined.
template <class Ratio>
[[nodiscard]] std::optional<RatioRange> extremes_over_turn(const Ratio& ratio) {
  const std::vector<double> places = places_of_a_turn();
  std::vector<double> values;
  for (const double place : places) {
    const auto value = ratio(place);
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  const auto most_of = [&](double sign) {
    const auto quantity = [&](double place) { return sign * ratio(place).value_or(values.front()); };
    double most = sign * values.front();
    for (std::size_t i = 0; i < places.size(); ++i) {
      const std::size_t before = i > 0 ? i - 1 : i, after = i + 1 < places.size() ? i + 1 : i;
      const double here = sign * values[i];
      if (here >= sign * values[before] && here >= sign * values[after])
        most = std::max({most, here, top_between(quantity, places[before], places[after])});
    }
    return sign * most;
  };
  return RatioRange{most_of(-1), most_of(1)};
}

}  // namespace linkwright
