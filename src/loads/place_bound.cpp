// The least largest force over a box of studs.

#include <algorithm>
#include <cmath>

#include "loads/place_lanes.hpp"
#include "loads/place_model.hpp"

namespace linkwright {

using place_lanes::larger;
using place_lanes::smaller;

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

}  // namespace linkwright
