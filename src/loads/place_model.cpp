#include "place_model.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace linkwright {
namespace {

constexpr std::size_t lanes = 8;
/// Measured stroke without which there is no law of a force, in the unit of length.
constexpr double no_travel_at_all = 1e-9;

double largest_of(const std::vector<double>& values) {
  std::array<double, lanes> most;
  std::copy_n(values.begin(), lanes, most.begin());
  for (std::size_t i = lanes; i < values.size(); i += lanes)
    for (std::size_t k = 0; k < lanes; ++k) most[k] = values[i + k] > most[k] ? values[i + k] : most[k];
  return *std::max_element(most.begin(), most.end());
}
double least_of(const std::vector<double>& values) {
  std::array<double, lanes> least;
  std::copy_n(values.begin(), lanes, least.begin());
  for (std::size_t i = lanes; i < values.size(); i += lanes)
    for (std::size_t k = 0; k < lanes; ++k) least[k] = values[i + k] < least[k] ? values[i + k] : least[k];
  return *std::min_element(least.begin(), least.end());
}

double larger(double a, double b) { return a > b ? a : b; }
double smaller(double a, double b) { return a < b ? a : b; }

}  // namespace

void PlaceModel::Linear::resize(std::size_t count) {
  middle.resize(count);
  rest.resize(count);
  for (auto& by : slope) by.resize(count);
}

namespace {

/// σ, the four offsets of the studs times σ, and the force.
constexpr std::size_t program_unknowns = 6;
constexpr std::array<double, program_unknowns> no_limits{};

}  // namespace

PlaceModel::Room::Room(const PlaceModel& model) : program(no_limits, no_limits) {
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
  padded_ = (count_ + lanes - 1) / lanes * lanes;
  const auto pad_one = [&](std::vector<double>& values) { values.resize(padded_, values.back()); };
  for (auto* values : {&dx_, &dy_, &cosine_, &sine_, &vx_, &vy_, &omega_, &handle_speed_}) pad_one(*values);
  for (OfCase& of : of_case_)
    for (auto* values : {&of.open, &of.close, &of.per_power}) pad_one(*values);
}

void PlaceModel::add_friction(std::size_t of_case, std::size_t station, int sense, double force) {
  auto& values = sense > 0 ? of_case_[of_case].open : of_case_[of_case].close;
  values[station] += force;
  if (station + 1 == count_)
    std::fill(values.begin() + static_cast<std::ptrdiff_t>(station), values.end(), values[station]);
}

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

void PlaceModel::add_lines(const OfCase& of, Room& room) const {
  const std::size_t first = room.a.size();
  room.a.resize(first + 2 * padded_);
  room.b.resize(first + 2 * padded_);
  double *open_a = room.a.data() + first, *open_b = room.b.data() + first;
  double *close_a = open_a + padded_, *close_b = open_b + padded_;
  const double rubbing = number_ * friction_;
  for (std::size_t i = 0; i < padded_; ++i) {
    const double rubs = rubbing * of.per_power[i] * room.slowest[i], scale = of.strength * of.per_power[i];
    open_a[i] = of.open[i] + rubs;
    open_b[i] = -scale * room.fast_high[i];
    close_a[i] = of.close[i] + rubs;
    close_b[i] = scale * room.fast_low[i];
  }
}

/// The charges that meet the demands somewhere in the box. The lines of the case are the last ones.
void PlaceModel::limit_charge(const OfCase& of, Room& room, Charges& charges) const {
  const std::size_t first = room.a.size() - 2 * padded_;
  for (const Limited& limited : of.limits) {
    const std::size_t line = first + limited.station + (limited.sense > 0 ? 0 : padded_);
    const double constant = room.a[line] - limited.limit, slope = room.b[line];
    if (slope < 0)
      charges.low = larger(charges.low, -constant / slope);
    else if (slope > 0)
      charges.high = smaller(charges.high, -constant / slope);
    else if (slope == 0 && constant > 0)  // of no number nothing is known
      charges.high = -nowhere;
  }
}

LeastTop PlaceModel::least(Room& room, Charges& charges) const {
  charges = {least_charge_, most_charge_};
  room.a.clear();
  room.b.clear();
  std::size_t kept = 0;
  for (const OfCase& of : of_case_) {
    fast_works(of, room);
    add_lines(of, room);
    limit_charge(of, room, charges);
    if (of.is_objective) kept = room.a.size();
    room.a.resize(kept);
    room.b.resize(kept);
  }
  LeastTop none;
  none.value = nowhere;
  return charges.low <= charges.high ? least_top({room.a.data(), room.b.data(), kept}, charges.low, charges.high)
                                     : none;
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

/// All rows at once, with the studs' offsets the same for all: a linear program of σ, of the offsets as shares of half
/// the box's sides times σ, and of the force t:
///   t ≥ constant ∓ σ work₀ ∓ Σ slope u ∓ σ rest,   |u| ≤ σ.
/// Its multipliers are what is used of it: any ≥ 0 make of the rows an inequality that holds in all of the box, so that
/// the bound does not depend on how well the program was solved.
double PlaceModel::by_slopes(Room& room, const Charges& charges, double at_least, double enough) const {
  constexpr int most_steps = 40;
  constexpr std::size_t charge = 0, force = 5;
  const double top = at_least + 1e3 * (1 + std::abs(at_least));
  const double c = charges.high;
  room.program = SmallProgram(std::array{charges.low, -c, -c, -c, -c, at_least}, std::array{c, c, c, c, c, top});
  SmallProgram& program = room.program;
  const std::size_t limits_of_unknowns = 2 * program_unknowns;
  for (std::size_t k = 1; k <= 4; ++k)
    for (const double sign : {1.0, -1.0}) {
      SmallProgram::Row row{-1};
      row[k] = sign;
      program.add(row, 0);
    }
  const std::size_t first = limits_of_unknowns + 8;
  std::vector<SmallProgram::Row> rows;  // σ, u, t, and last the constant
  const auto add = [&](const OfCase& of, std::size_t i, int sense, std::optional<double> limit) {
    const double rubs = number_ * friction_ * of.per_power[i] * room.slowest[i], scale = of.strength * of.per_power[i];
    const double constant = (sense > 0 ? of.open[i] : of.close[i]) + rubs - limit.value_or(0);
    SmallProgram::Row row{};
    row[charge] = scale * (-sense * room.work.middle[i] - room.work.rest[i]);
    for (std::size_t k = 0; k < 4; ++k) row[k + 1] = -sense * scale * room.work.slope[k][i];
    row[force] = limit ? 0 : -1;
    program.add(row, -constant);
    row[7] = constant;
    rows.push_back(row);
  };
  for (const OfCase& of : of_case_) {
    if (of.exponent != 1) continue;
    for (std::size_t i = 0; i < count_ && of.is_objective; ++i)
      for (const int sense : {+1, -1}) add(of, i, sense, {});
    for (const Limited& limited : of.limits) add(of, limited.station, limited.sense, limited.limit);
  }
  const auto vertex = program.least_within(most_steps, enough);
  if (!vertex) return at_least;
  SmallProgram::Row sum{};
  double constant = 0, share = 0;
  for (std::size_t k = 0; k < program_unknowns; ++k) {
    if (vertex->row[k] < first || !(vertex->multiplier[k] > 0)) continue;
    const SmallProgram::Row& row = rows[vertex->row[k] - first];
    for (std::size_t n = 0; n < 5; ++n) sum[n] += vertex->multiplier[k] * row[n];
    constant += vertex->multiplier[k] * row[7];
    share -= vertex->multiplier[k] * row[force];
  }
  // share · t ≥ constant + sum · (σ, u), least over |u| ≤ σ and then at an end of the charges.
  const double slope = sum[0] - std::abs(sum[1]) - std::abs(sum[2]) - std::abs(sum[3]) - std::abs(sum[4]);
  const double least = constant + slope * (slope > 0 ? charges.low : charges.high);
  if (!(share > 0.5) || !std::isfinite(least)) return at_least;
  return larger(at_least, least / share);
}

/// Of the two lines that meet in the least.
std::size_t PlaceModel::widest(const StudCoordinates& half, const Room& room, const LeastTop& found) const {
  StudCoordinates weight{};
  for (const std::size_t line : {found.falling, found.rising}) {
    const std::size_t i = line % padded_;
    for (std::size_t k = 0; k < 4; ++k)
      weight[k] += std::abs(room.rate.slope[k][i]) + 0.2 * half[k] * std::abs(omega_[i]);
  }
  return static_cast<std::size_t>(std::max_element(weight.begin(), weight.end()) - weight.begin());
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
  const LeastTop found = least(room, charges);
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
