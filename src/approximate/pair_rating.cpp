#include "approximate/pair_rating.hpp"

#include <algorithm>
#include <cmath>

namespace linkwright {

PairRating::PairRating(std::span<const Point> chosen, std::span<const double> weights, Point pivot, bool closed)
    : count_(chosen.size()), weights_(weights), closed_(closed) {
  for (std::size_t j = 0; j < count_; ++j) {
    const Point to = chosen[j] - pivot;
    distances_[j] = std::sqrt(std::norm(to));
    directions_[j] = to / distances_[j];
  }
}

void PairRating::drive(double input, double arm, std::uint32_t right) {
  const double excess = (input - arm) * (input + arm);
  for (std::size_t j = 0; j < count_; ++j) {  // the law of cosines
    const double d = distances_[j];
    const double at_pivot = std::clamp((d * d + excess) / (2 * d * input), -1.0, 1.0);
    const double at_point = std::clamp((d * d - excess) / (2 * d * arm), -1.0, 1.0);
    const double up = ((right >> j & 1) != 0 ? -1 : 1) * std::sqrt(1 - at_pivot * at_pivot);
    driven_[j] = {product(directions_[j], {at_pivot, up}), product(directions_[j], {at_point, -input / arm * up})};
  }
}

void PairRating::score(ScannedPair& pair) {
  CouplerLinkage& linkage = pair.linkage;
  const Point turn = std::conj(linkage.p) / std::sqrt(std::norm(linkage.p)), frame = linkage.a0 - linkage.b0;
  double square = 0, weights = 0;
  for (std::size_t j = 0; j < count_; ++j) {
    states_[j] = {driven_[j].e, product(driven_[j].u, turn)};
    output_[j] = frame + linkage.a * states_[j].e + linkage.h * states_[j].u;
    square += weights_[j] * std::norm(output_[j]);
    weights += weights_[j];
  }
  linkage.b = std::sqrt(square / weights);
  pair.score = std::sqrt(square_across(linkage) / weights);
}

// The gap of the loop by the sine between the velocities that input and coupler give the point: no root is needed.
double PairRating::square_across(const CouplerLinkage& linkage) const {
  const double square_b = linkage.b * linkage.b;
  double sum = 0;
  for (std::size_t j = 0; j < count_; ++j) {
    const double f = (std::norm(output_[j]) - square_b) / 2, f_e = linkage.a * cross(states_[j].e, output_[j]),
                 f_u = linkage.h * cross(states_[j].u, output_[j]);
    const Point by_e = linkage.a * quarter_turn(states_[j].e), by_u = quarter_turn(product(linkage.p, states_[j].u));
    const double across = f * cross(by_e, by_u);
    sum += weights_[j] * across * across / (std::norm(f_e * by_u - f_u * by_e) + 1e-12 * (f_e * f_e + f_u * f_u));
  }
  return sum;
}

char PairRating::driver(const CouplerLinkage& linkage, std::string_view among) const {
  const auto e = [&](std::size_t j) { return states_[j].e; };
  const auto u = [&](std::size_t j) { return states_[j].u; };
  const auto g = [&](std::size_t j) { return output_[j] / linkage.b; };
  for (const char letter : among)
    if (letter == 'e' ? drives(e, u, g) : letter == 'u' ? drives(u, e, g) : drives(g, e, u)) return letter;
  return 0;
}

// Turns one way, but for what an error of the points may turn it back, and the two others never are in line.
template <class Driving, class One, class Other>
bool PairRating::drives(const Driving& driver, const One& one, const Other& other) const {
  constexpr double slack = 0.05;  // radians
  double turned[2] = {0, 0};
  const bool side = cross(one(0), other(0)) > 0;
  for (std::size_t j = 0; j < count_; ++j) {
    if ((cross(one(j), other(j)) > 0) != side) return false;
    if (j + 1 == count_ && !closed_) break;
    const double sine = cross(driver(j), driver(j + 1 < count_ ? j + 1 : 0));
    turned[sine > 0] += std::abs(sine);
  }
  return std::min(turned[0], turned[1]) <= slack;
}

}  // namespace linkwright
