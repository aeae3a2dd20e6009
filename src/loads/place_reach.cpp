// How long a spring is and how fast over a box of studs, and whether it can be built there.

#include <algorithm>
#include <cmath>

#include "loads/place_lanes.hpp"
#include "loads/place_model.hpp"

namespace linkwright {

using place_lanes::larger;
using place_lanes::largest_of;
using place_lanes::least_of;
using place_lanes::no_travel_at_all;
using place_lanes::smaller;

/// Lengths and their rates. With δ the offset of p − q from its middle, n along and t across that, the length is at
/// least l₀ + ⟨n, δ⟩ and at most √((l₀ + ⟨n, δ⟩)² + ⟨t, δ⟩²), which is r in [0, ⟨t, δ⟩²/(2 l)] more; and, without
/// approximation,
///   l′ − l₀′ = (−⟨t, v_p⟩⟨t, δq⟩ + ⟨t, v_q⟩⟨t, δp⟩ − ω⟨δq, J δp⟩ − l₀′ r)/l.
/// With l₀ for l in the first two terms that is the slope. And |l′| ≤ |v_p| everywhere.
void PlaceModel::reach(const StudCoordinates& middle, const StudCoordinates& half, Room& room) const {
  constexpr double tiny = 1e-300;
  const double qx = middle[0], qy = middle[1], sx = middle[2], sy = middle[3];
  const double hqx = half[0], hqy = half[1], hsx = half[2], hsy = half[3];
  Linear &of_length = room.length, &of_rate = room.rate;
  double *l = of_length.middle.data(), *bend = of_length.rest.data(), *low = room.low.data(), *high = room.high.data();
  double *l0 = of_length.slope[0].data(), *l1 = of_length.slope[1].data(), *l2 = of_length.slope[2].data(),
         *l3 = of_length.slope[3].data();
  double *rate = of_rate.middle.data(), *rest = of_rate.rest.data(), *r0 = of_rate.slope[0].data(),
         *r1 = of_rate.slope[1].data(), *r2 = of_rate.slope[2].data(), *r3 = of_rate.slope[3].data();
  double *slowest = room.slowest.data(), *fastest = room.fastest.data();
  for (std::size_t i = 0; i < padded_; ++i) {
    const double c = cosine_[i], s = sine_[i], omega = omega_[i];
    const double ax = c * sx - s * sy, ay = s * sx + c * sy;
    const double ux = dx_[i] + ax - qx, uy = dy_[i] + ay - qy;
    const double length = std::sqrt(ux * ux + uy * uy) + tiny;
    const double nx = ux / length, ny = uy / length;
    const double vpx = vx_[i] - omega * ay, vpy = vy_[i] + omega * ax;
    const double vqx = vx_[i] - omega * (qy - dy_[i]), vqy = vy_[i] + omega * (qx - dx_[i]);
    const double along = nx * vpx + ny * vpy, across_p = nx * vpy - ny * vpx, across_q = nx * vqy - ny * vqx;
    // n and t = J n in the moving frame: (xn, yn) and (−yn, xn).
    const double xn = c * nx + s * ny, yn = c * ny - s * nx;
    l0[i] = -hqx * nx;
    l1[i] = -hqy * ny;
    l2[i] = hsx * xn;
    l3[i] = hsy * yn;
    const double by_length = std::abs(l0[i]) + std::abs(l1[i]) + std::abs(l2[i]) + std::abs(l3[i]);
    const double ground_across = hqx * std::abs(ny) + hqy * std::abs(nx);
    const double body_across = hsx * std::abs(yn) + hsy * std::abs(xn);
    const double across = ground_across + body_across;
    const double shortest = larger(length - by_length, tiny);
    const double longest = std::sqrt((length + by_length) * (length + by_length) + across * across);
    bend[i] = across * across / (2 * shortest);
    l[i] = length;
    low[i] = shortest;
    high[i] = longest;
    const double p_rate = across_p / length, q_rate = across_q / length;
    r0[i] = hqx * p_rate * ny;
    r1[i] = -hqy * p_rate * nx;
    r2[i] = -hsx * q_rate * yn;
    r3[i] = hsy * q_rate * xn;
    const double both =
        std::abs(omega) * (std::abs(s) * (hqx * hsx + hqy * hsy) + std::abs(c) * (hqx * hsy + hqy * hsx));
    const double second = both + std::abs(along) * bend[i];
    const double by_slope = std::abs(r0[i]) + std::abs(r1[i]) + std::abs(r2[i]) + std::abs(r3[i]);
    // |1/l − 1/l₀| l₀, of what is left of the slope.
    const double shrinks = larger(length / shortest - 1, 1 - length / longest);
    rate[i] = along;
    rest[i] = by_slope * shrinks + second / shortest;
    const double most = std::sqrt(vpx * vpx + vpy * vpy) + std::abs(omega) * (hsx + hsy);
    const double by = by_slope + rest[i];
    slowest[i] = larger(std::abs(along) - by, 0);
    fastest[i] = smaller(std::abs(along) + by, most);
  }
}

PlaceModel::Lengths PlaceModel::lengths(const Room& room) const {
  return {least_of(room.low), least_of(room.high), largest_of(room.low), largest_of(room.high)};
}

/// Somewhere in the box a spring has room for its stroke and its ends.
bool PlaceModel::may_be_built(const Lengths& of, const Room& room) const {
  if (extended_) {
    const double spare = 0.01 * *stroke_;
    return of.longest_low <= *extended_ - spare && of.shortest_high >= *extended_ - *stroke_ + spare && has_lever(room);
  }
  // A spring has a measured stroke.
  const double stroke = of.longest_high - of.shortest_low + 2 * margin_;
  if (stroke < min_stroke_ || stroke < 2 * measured_at_ + no_travel_at_all) return false;
  // extended − stroke, without which studs would meet
  if (!(of.shortest_high > margin_)) return false;
  // extended − 2 stroke = 2 shortest − longest − 3 margins
  if (end_length_ && 2 * of.shortest_high - of.longest_low - 3 * margin_ < *end_length_) return false;
  return has_lever(room);
}

bool PlaceModel::has_lever(const Room& room) const {
  if (!(min_lever_ > 0)) return true;
  std::size_t long_enough = 0;
  for (std::size_t i = 0; i < count_; ++i)
    if (room.fastest[i] >= min_lever_ * handle_speed_[i]) ++long_enough;
  return 2 * long_enough >= count_;
}

}  // namespace linkwright
