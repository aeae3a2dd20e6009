// What a spring does over a box of studs.

#include <algorithm>
#include <cmath>

#include "loads/place_lanes.hpp"
#include "loads/place_model.hpp"

namespace linkwright {

using place_lanes::larger;
using place_lanes::no_travel_at_all;
using place_lanes::smaller;

/// Static force over σ, and `work`, that times the rate. With A = longest − l + c and B = l − shortest + c, c the
/// margin less where it is measured, the gas is compressed by the share A/(A + B) of its measured stroke, and the force
/// is
///   f = k (A + B)/D,  D = A + k B,      f − f₀ = k (k − 1) Y/(D D₀),  Y = B₀ (A − A₀) − A₀ (B − B₀), exactly.
/// Longest and shortest are those of the middle's stations but for e, by which others can get past them.
void PlaceModel::forces(const Lengths& of, Room& room) const {
  if (extended_) return forces_of_part(room);
  const double c = margin_ - measured_at_, k = ratio_;
  const Linear& length = room.length;
  const auto& l = length.middle;
  const auto j = static_cast<std::size_t>(std::max_element(l.begin(), l.end()) - l.begin());
  const auto m = static_cast<std::size_t>(std::min_element(l.begin(), l.end()) - l.begin());
  const double *l0 = length.slope[0].data(), *l1 = length.slope[1].data(), *l2 = length.slope[2].data(),
               *l3 = length.slope[3].data(), *bend = length.rest.data();
  double past_longest = 0, past_shortest = 0;
  for (std::size_t i = 0; i < padded_; ++i) {
    const double by_longest =
        std::abs(l0[i] - l0[j]) + std::abs(l1[i] - l1[j]) + std::abs(l2[i] - l2[j]) + std::abs(l3[i] - l3[j]);
    const double by_shortest =
        std::abs(l0[i] - l0[m]) + std::abs(l1[i] - l1[m]) + std::abs(l2[i] - l2[m]) + std::abs(l3[i] - l3[m]);
    const double over = l[i] - l[j] + by_longest + bend[i], under = l[m] - l[i] + by_shortest + bend[m];
    past_longest = i == j ? past_longest : larger(past_longest, over);
    past_shortest = i == m ? past_shortest : larger(past_shortest, under);
  }
  // No farther than the lengths themselves tell.
  past_longest = smaller(past_longest, of.longest_high - room.low[j]);
  past_shortest = smaller(past_shortest, room.high[m] - of.shortest_low);
  const double b_all = l[j] - l[m];
  double* force = room.force.data();
  double* by = room.force_by.data();
  Linear& work = room.work;
  for (std::size_t i = 0; i < padded_; ++i) {
    const double a = l[j] - l[i] + c, b = b_all - (l[j] - l[i]) + c;
    const double d = larger(a + k * b, no_travel_at_all);
    const double a_rest = larger(bend[i], bend[j] + past_longest), b_rest = larger(bend[m], bend[i] + past_shortest);
    const double a0 = l0[j] - l0[i], a1 = l1[j] - l1[i], a2 = l2[j] - l2[i], a3 = l3[j] - l3[i];
    const double b0 = l0[i] - l0[m], b1 = l1[i] - l1[m], b2 = l2[i] - l2[m], b3 = l3[i] - l3[m];
    const double y0 = b * a0 - a * b0, y1 = b * a1 - a * b1, y2 = b * a2 - a * b2, y3 = b * a3 - a * b3;
    const double y = std::abs(y0) + std::abs(y1) + std::abs(y2) + std::abs(y3), y_rest = b * a_rest + a * b_rest;
    const double d_by = std::abs(a0 + k * b0) + std::abs(a1 + k * b1) + std::abs(a2 + k * b2) + std::abs(a3 + k * b3) +
                        a_rest + k * b_rest;
    const double a_low = larger(0, of.longest_low - room.high[i]) + c;
    const double b_low = larger(0, room.low[i] - of.shortest_high) + c;
    const double d_low = larger(larger(d - d_by, a_low + k * b_low), no_travel_at_all);
    const double scale = k * (k - 1) / d;
    force[i] = k * (a + b) / d;
    // Never outside [1, k].
    const double reach_of_force = smaller(scale * (y + y_rest) / d_low, larger(k - force[i], force[i] - 1));
    const double force_rest = scale * (y_rest / d_low + y * d_by / (d_low * d));
    const double rate = room.rate.middle[i], per_d = scale / d;
    const double r0 = room.rate.slope[0][i], r1 = room.rate.slope[1][i], r2 = room.rate.slope[2][i],
                 r3 = room.rate.slope[3][i];
    const double rate_by = std::abs(r0) + std::abs(r1) + std::abs(r2) + std::abs(r3) + room.rate.rest[i];
    by[i] = reach_of_force;
    work.middle[i] = force[i] * rate;
    work.slope[0][i] = force[i] * r0 + rate * per_d * y0;
    work.slope[1][i] = force[i] * r1 + rate * per_d * y1;
    work.slope[2][i] = force[i] * r2 + rate * per_d * y2;
    work.slope[3][i] = force[i] * r3 + rate * per_d * y3;
    work.rest[i] = std::abs(rate) * force_rest + force[i] * room.rate.rest[i] + reach_of_force * rate_by;
  }
  works(room);
}

/// Of a part its length and its stroke are known.
void PlaceModel::forces_of_part(Room& room) const {
  const double per = 1 / (*stroke_ - 2 * measured_at_), least = -measured_at_ * per;
  for (std::size_t i = 0; i < padded_; ++i) {
    const double low = force_at(larger((*extended_ - room.high[i] - measured_at_) * per, least));
    const double high = force_at(smaller((*extended_ - room.low[i] - measured_at_) * per, 1 - least));
    room.force[i] = (low + high) / 2;
    room.force_by[i] = (high - low) / 2;
    room.work.middle[i] = room.force[i] * room.rate.middle[i];
    room.work.rest[i] = nowhere;
    for (auto& slope : room.work.slope) slope[i] = 0;
  }
  works(room);
}

/// The least and the largest work: by its slopes, or by the intervals of force and rate.
void PlaceModel::works(Room& room) const {
  for (std::size_t i = 0; i < padded_; ++i) {
    const Linear &work = room.work, &of_rate = room.rate;
    const double by = std::abs(work.slope[0][i]) + std::abs(work.slope[1][i]) + std::abs(work.slope[2][i]) +
                      std::abs(work.slope[3][i]) + work.rest[i];
    const double rate_by = std::abs(of_rate.slope[0][i]) + std::abs(of_rate.slope[1][i]) +
                           std::abs(of_rate.slope[2][i]) + std::abs(of_rate.slope[3][i]) + of_rate.rest[i];
    const double rate_low = larger(of_rate.middle[i] - rate_by, -room.fastest[i]);
    const double rate_high = smaller(of_rate.middle[i] + rate_by, room.fastest[i]);
    const double f_low = room.force[i] - room.force_by[i], f_high = room.force[i] + room.force_by[i];
    const double low = rate_low > 0 ? f_low * rate_low : f_high * rate_low;
    const double high = rate_high > 0 ? f_high * rate_high : f_low * rate_high;
    // What is no number comes first: the other one stands then.
    room.work_low[i] = larger(work.middle[i] - by, low);
    room.work_high[i] = smaller(work.middle[i] + by, high);
  }
}

/// Gas that is compressed faster than heat gets out, from where it rested: its force is f (f/f_rest)^(n−1).
void PlaceModel::fast_works(const OfCase& of, Room& room) const {
  const double n = of.exponent;
  if (n == 1) {
    room.fast_low = room.work_low;
    room.fast_high = room.work_high;
    return;
  }
  const double floor = extended_ ? 1e-3 : 1, ceiling = extended_ ? nowhere : ratio_;  // of forces over F1's
  const auto lowest = [&](std::size_t i) { return larger(room.force[i] - room.force_by[i], floor); };
  const auto highest = [&](std::size_t i) { return smaller(room.force[i] + room.force_by[i], ceiling); };
  const double rest_low = lowest(0), rest_high = highest(0);
  for (std::size_t i = 0; i < padded_; ++i) {
    const double least = std::pow(lowest(i) / rest_high, n - 1);
    const double most = std::pow(highest(i) / rest_low, n - 1);
    const double low = room.work_low[i], high = room.work_high[i];
    room.fast_low[i] = low > 0 ? low * least : low * most;
    room.fast_high[i] = high > 0 ? high * most : high * least;
  }
}

}  // namespace linkwright
