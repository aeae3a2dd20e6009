#include "four_bar_loads.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "lane_loads.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/loads/load_report.hpp"
#include "linkwright/region/region_map.hpp"
#include "loads/cell_loads.hpp"
#include "loads/free_strength.hpp"
#include "loads/load_kernel.hpp"
#include "loads_analysis.hpp"

namespace linkwright {
namespace {

LoadRow::What what_of(ReadOut read_out) {
  switch (read_out) {
    case ReadOut::max_open_force:
      return LoadRow::open;
    case ReadOut::max_close_force:
      return LoadRow::close;
    case ReadOut::hand_force:
      return LoadRow::hand;
    case ReadOut::hold_open:
      return LoadRow::hold;
    case ReadOut::max_pin_force:
      return LoadRow::pin;
    case ReadOut::self_rise:
      return LoadRow::rise;
    case ReadOut::self_close:
      return LoadRow::shut;
    case ReadOut::hand_force_error:
      return LoadRow::error;
    default:
      return LoadRow::effort;
  }
}

void count_cases(LoadRow& row, const Loads& loads, std::span<const ReadOut> read_outs) {
  const std::vector<LoadCase> cases = cases_of(loads);
  const auto count = [&](LoadRow::What what, ReadOut by) {
    for (std::size_t c = 0; c < cases.size(); ++c)
      if (cases[c].counts(by)) row.counted[what] |= 1U << c;
  };
  for (const ReadOut read_out : read_outs) {
    if (read_out == ReadOut::best_f1) continue;  // of no case
    const bool is_error = read_out == ReadOut::hand_force_error;
    count(what_of(read_out), is_error ? ReadOut::hand_force : read_out);
    if (is_error) count(LoadRow::hand, ReadOut::hand_force);
  }
}

LoadRow blank_row(const Loads& loads, std::span<const ReadOut> read_outs, Point turned) {
  LoadRow row{};
  count_cases(row, loads, read_outs);
  constexpr std::array drives = {LoadRow::by_hand, LoadRow::by_input, LoadRow::by_output, LoadRow::by_cylinder};
  row.drive = drives[static_cast<std::size_t>(loads.drive)];
  if (loads.handle) {
    row.handle = lane_point({LoadedBody::body, loads.handle->point}, turned);
    row.hand_way = loads.handle->direction == Handle::Direction::tangential ? LoadRow::tangential : LoadRow::along;
  }
  row.cylinder_from = lane_point(loads.cylinder.from, turned);
  row.cylinder_to = lane_point(loads.cylinder.to, turned);
  if (loads.pins) {
    const double mu = loads.pins->friction;
    row.friction_circle = loads.pins->radius * mu / std::sqrt(1 + mu * mu);
  }
  return row;
}

void put(Point point, double (&to)[2]) {
  to[0] = point.real();
  to[1] = point.imag();
}

/// What the linkages of a map share.
class TablesOfLoads {
 public:
  TablesOfLoads(const FourBarCells& links, const RegionMap& map, const Loads& loads, Point turned, Simd simd)
      : loads_(lane_loads(loads, turned)) {
    tables_.loads = &loads_;
    tables_.positions = static_cast<int>(links.positions());
    for (std::size_t j = 0; j < links.positions(); ++j) {
      put(links.to_user(links.origin(j)), tables_.origin[j]);
      put(links.turn(j), tables_.turned[j]);
    }
    constexpr std::size_t lanes = LoadTables::most_lanes;
    tables_.stride = static_cast<int>((map.columns() / lanes + 2) * lanes);
    common_.resize(links.positions() * (lanes_cases() + static_cast<std::size_t>(loads_.common_springs)));
    tables_.common = common_.data();
    tables_.common_rubbing = tables_.common + links.positions() * lanes_cases();
    columns_.resize(static_cast<std::size_t>(tables_.rows()) * static_cast<std::size_t>(tables_.stride));
    tables_.numbers = columns_.data();
    for (std::size_t at = 0; at < static_cast<std::size_t>(tables_.stride); ++at)
      put_column(links, std::min(at, map.columns() - 1), at);
    load_tables_kernel.for_simd(simd)(tables_);
  }
  TablesOfLoads(const TablesOfLoads&) = delete;
  TablesOfLoads& operator=(const TablesOfLoads&) = delete;

  [[nodiscard]] const LoadTables& operator*() const { return tables_; }

 private:
  [[nodiscard]] std::size_t lanes_cases() const { return static_cast<std::size_t>(loads_.cases); }
  void put_column(const FourBarCells& links, std::size_t column, std::size_t at) {
    const LinkPositions& link = links.output_link(column);
    const auto put_at = [&](double* x, double* y, Point working) {
      const Point drawn = links.to_user(working);
      x[at] = drawn.real();
      y[at] = drawn.imag();
    };
    put_at(tables_.fixed(0), tables_.fixed(1), link.center);
    for (int j = 0; j < tables_.positions; ++j)
      put_at(tables_.moving(j, 0), tables_.moving(j, 1), link.circle[static_cast<std::size_t>(j)]);
  }

  LaneLoads loads_;
  std::vector<LaneWrench> common_;
  std::vector<double> columns_;
  LoadTables tables_;
};

/// A column of loads.
struct LoadColumn {
  ReadOut read_out;
  double unit;  ///< by which values are multiplied
  float none;   ///< where there is no value
};

std::vector<LoadColumn> columns_of(const Loads& loads, std::span<const ReadOut> read_outs) {
  constexpr float infinite = std::numeric_limits<float>::infinity();
  std::vector<LoadColumn> columns;
  for (const ReadOut read_out : read_outs)
    columns.push_back({read_out, read_out == ReadOut::max_torque ? metres_of(loads) : 1,
                       larger_is_worse(read_out) ? infinite : -infinite});
  return columns;
}

/// How far a driver has turned at the stations, and where it is.
void put_stations(const FourBarCells& links, const LinkPositions& driver, int between, LoadRow& row,
                  std::span<double> turns) {
  const Point first = driver.circle[0] - driver.center;
  put(links.to_user(driver.circle[0]), row.input_moving[0]);
  double last = turns[0] = 0;
  for (std::size_t j = 1, station = 1; j < links.positions(); ++j) {
    const double next = wrap_positive(row.sense * std::arg((driver.circle[j] - driver.center) / first));
    for (int i = 1; i < between; ++i, ++station) {
      turns[station] = last + (next - last) * i / between;
      const Point at = driver.center + first * direction(row.sense * turns[station]);
      put(links.to_user(at), row.input_moving[station]);
    }
    put(links.to_user(driver.circle[j]), row.input_moving[station]);
    last = turns[station++] = next;
  }
}

void put_driver(const FourBarCells& links, const LinkPositions& driver, double sense, int between, LoadRow& row) {
  row.sense = sense;
  put(links.to_user(driver.center), row.input_fixed);
  std::array<double, LoadRow::most_stations> turns{};
  put_stations(links, driver, between, row, turns);
  const auto steps_about = [&](int j, int apart) {
    const auto turn = [&](int at) { return turns[static_cast<std::size_t>(at)]; };
    const double before = turn(j) - turn(j - apart), after = turn(j + apart) - turn(j);
    return LoadSteps{before, after, 1 / before, 1 / after, 1 / (before + after)};
  };
  for (int j = 1; j + 1 < row.stations; ++j) row.steps[j] = steps_about(j, 1);
  for (int j = between; j + between < row.stations; j += between)
    row.position_steps[j / between] = steps_about(j, between);
}

/// What is left free, and the cases by which it is told, a bit to each.
struct Strength {
  FreeStrength free;
  unsigned hand = 0, last = 0;
};

std::optional<Strength> strength_of(const Loads& loads) {
  const auto k = free_spring(loads);
  if (!k) return std::nullopt;
  Strength found{*std::get<GasSpring>(loads.springs[*k].law).free};
  const std::vector<LoadCase> cases = cases_of(loads);
  for (std::size_t c = 0; c < cases.size(); ++c) {
    if (cases[c].counts(ReadOut::hand_force)) found.hand |= 1U << c;
    if (cases[c].counts(ReadOut::hold_open)) found.last |= 1U << c;
  }
  return found;
}

/// The cells of a map row by row.
class RowsOfLoads {
 public:
  using Values = std::span<const std::span<float>>;

  RowsOfLoads(std::shared_ptr<const FourBarCells> links, const RegionMap& map, const Loads& loads,
              std::span<const ReadOut> read_outs, Point turned, Simd simd)
      : links_(std::move(links)),
        map_(map),
        simd_(simd),
        tables_(*links_, map, loads, turned, simd),
        told_(columns_of(loads, read_outs)),
        blank_(blank_row(loads, read_outs, turned)),
        between_(steps_between(loads.stations, links_->positions())),
        strength_(strength_of(loads)) {
    blank_.tables = &*tables_;
    blank_.columns = static_cast<int>(map.columns());
    blank_.stations = static_cast<int>(links_->positions() - 1) * between_ + 1;
    for (int j = 0; j < blank_.stations; ++j) blank_.position[j] = j % between_ == 0 ? j / between_ : -1;
  }

  void write(std::size_t at, Values values) const {
    LoadRow row = blank_;
    const std::vector<signed char> senses = senses_of(at);
    row.senses = senses.data();
    const std::vector<LaneWrench> shared = room_of(row);
    const auto count = static_cast<std::size_t>(row.of_curves()) * LoadTables::most_lanes;
    // Not cleared; std::make_unique_for_overwrite is not in every library.
    const std::unique_ptr<double[]> values_of_curves(new double[count]);
    row.values = values_of_curves.get();
    const std::vector<double> shares = strength_ ? best_shares(at, row, senses) : std::vector<double>{};
    row.shares = strength_ ? shares.data() : nullptr;
    for (std::size_t k = 0; k < told_.size(); ++k) {
      fill_blank(at, told_[k].none, values[k]);
      if (told_[k].read_out == ReadOut::best_f1) {
        tell_strength(senses, shares, values[k]);
        continue;
      }
      const LoadRow::What what = what_of(told_[k].read_out);
      row.value[what] = values[k].data();
      row.unit[what] = told_[k].unit;
    }
    run(at, row, senses);
  }

 private:
  void run(std::size_t at, LoadRow& row, const std::vector<signed char>& senses) const {
    for (const int sense : {1, -1}) {
      if (std::find(senses.begin(), senses.end(), sense) == senses.end()) continue;
      put_driver(*links_, links_->input_link(at), sense, between_, row);
      load_kernel.for_simd(simd_)(row);
    }
  }

  /// The hand's forces in the cells of a row, each under a strength of the free spring.
  struct UnderStrength {
    std::vector<double> forces;  ///< LoadRow::hand_forces
    std::vector<float> largest;  ///< infinite where there are none
  };
  [[nodiscard]] UnderStrength under(const std::vector<double>& shares, std::size_t at, LoadRow row,
                                    const std::vector<signed char>& senses) const {
    UnderStrength found{std::vector<double>(map_.columns() * of_cell(row)), std::vector<float>(map_.columns())};
    std::fill(std::begin(row.counted), std::end(row.counted), 0U);
    row.counted[LoadRow::hand] = strength_->hand | strength_->last;
    row.unit[LoadRow::hand] = 1;
    row.value[LoadRow::hand] = found.largest.data();
    row.hand_forces = found.forces.data();
    row.shares = shares.data();
    row.senses = senses.data();
    run(at, row, senses);
    return found;
  }
  [[nodiscard]] std::size_t of_cell(const LoadRow& row) const {
    return static_cast<std::size_t>((*tables_).loads->cases) * 2 * static_cast<std::size_t>(row.stations);
  }

  /// As CellLoads has them, of columns; not a number where there is none.
  [[nodiscard]] std::vector<double> best_shares(std::size_t at, const LoadRow& row,
                                                std::vector<signed char> senses) const {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    LoadRow smooth = row;
    smooth.friction_circle = 0;
    std::vector<double> shares(senses.size(), 0.0);
    const UnderStrength weakest = under(shares, at, smooth, senses);
    const UnderStrength strongest = under(std::vector<double>(senses.size(), 1.0), at, smooth, senses);
    UnderStrength now = weakest;
    for (int turn = 0; turn < most_strengths; ++turn) {
      for (std::size_t column = 0; column < map_.columns(); ++column) {
        if (senses[column] == 0) continue;
        const double before = shares[column];
        shares[column] = next_share(column, before, {&weakest, &strongest, &now}, row).value_or(none);
        const bool agrees = turn > 0 && std::abs(shares[column] - before) <= agreed_strength;
        if (std::isnan(shares[column]) || !(row.friction_circle > 0) || agrees) senses[column] = 0;
      }
      if (std::all_of(senses.begin(), senses.end(), [](signed char sense) { return sense == 0; })) return shares;
      now = under(shares, at, row, senses);
    }
    for (std::size_t column = 0; column < map_.columns(); ++column)
      if (senses[column] != 0) shares[column] = none;
    return shares;
  }
  struct Strengths {
    const UnderStrength *weakest, *strongest, *now;
  };
  [[nodiscard]] std::optional<double> next_share(std::size_t column, double share, const Strengths& known,
                                                 const LoadRow& row) const {
    for (const UnderStrength* under : {known.weakest, known.strongest, known.now})
      if (!std::isfinite(under->largest[column])) return std::nullopt;
    const auto stations = static_cast<std::size_t>(row.stations);
    StrengthLines hand, last;
    for (std::size_t c = 0; c < of_cell(row) / (2 * stations); ++c) {
      const std::size_t first = column * of_cell(row) + c * 2 * stations;
      const auto add = [&](StrengthLines& to, std::size_t k) {
        to.add(known.now->forces[k], share, {known.weakest->forces[k], known.strongest->forces[k]});
      };
      if (strength_->hand >> c & 1U)
        for (std::size_t k = first; k < first + 2 * stations; ++k) add(hand, k);
      if (strength_->last >> c & 1U) add(last, first + stations - 1);
    }
    return best_share(hand, last, held_open(strength_->free));
  }
  void tell_strength(const std::vector<signed char>& senses, const std::vector<double>& shares,
                     std::span<float> values) const {
    const StrengthRange range = strengths_of(strength_->free);
    for (std::size_t column = 0; column < values.size(); ++column)
      if (senses[column] != 0 && !std::isnan(shares[column]))
        values[column] = static_cast<float>(range.f1(shares[column]));
  }

  /// Of columns; so many more that a kernel may read beyond them.
  [[nodiscard]] std::vector<signed char> senses_of(std::size_t row) const {
    std::vector<signed char> senses(map_.columns() + LoadTables::most_lanes, 0);
    const std::size_t columns = map_.columns(), first = map_.index(row, 0);
    const std::span<const std::uint8_t> types = map_.types().subspan(first, columns);
    const std::span<const std::uint8_t> defects = map_.defects().subspan(first, columns);
    constexpr auto degenerate = static_cast<std::uint8_t>(LinkageType::degenerate);
    signed char* const to = senses.data();
    for (std::size_t column = 0; column < columns; ++column)
      if (types[column] != degenerate && defects[column] == 0)
        to[column] = map_.drive_sense(row, column) == DriveSense::cw ? -1 : 1;
    return senses;
  }
  /// What the kernel works out first.
  [[nodiscard]] std::vector<LaneWrench> room_of(LoadRow& row) const {
    const LaneLoads& loads = *(*tables_).loads;
    const auto acting = static_cast<std::size_t>(row.stations) * static_cast<std::size_t>(loads.cases);
    std::vector<LaneWrench> room(acting + links_->positions() * static_cast<std::size_t>(loads.row_springs));
    row.acting = room.data();
    row.rubbing = room.data() + acting;
    return room;
  }
  /// No value, or 0 where there is no linkage.
  void fill_blank(std::size_t row, float none, std::span<float> values) const {
    const auto types = map_.types().subspan(map_.index(row, 0), map_.columns());
    const auto nothing = static_cast<std::uint8_t>(LinkageType::degenerate);
    for (std::size_t column = 0; column < types.size(); ++column)
      values[column] = types[column] == nothing ? 0.0F : none;
  }

  std::shared_ptr<const FourBarCells> links_;
  const RegionMap& map_;
  Simd simd_;
  TablesOfLoads tables_;
  std::vector<LoadColumn> told_;
  LoadRow blank_;
  int between_;
  std::optional<Strength> strength_;  ///< where a spring leaves it free
};

}  // namespace

bool fits_lanes(const Loads& loads, std::size_t positions) {
  const bool is_linear = std::none_of(loads.springs.begin(), loads.springs.end(), [](const Spring& spring) {
    return std::holds_alternative<TorsionSpring>(spring.law);
  });
  const bool is_slow =
      std::all_of(loads.cases.begin(), loads.cases.end(), [](const LoadCase& of) { return of.gas_exponent == 1; });
  const std::size_t stations = (positions - 1) * static_cast<std::size_t>(steps_between(loads.stations, positions)) + 1;
  return is_linear && is_slow && !has_inertia(loads) && stations <= LoadRow::most_stations &&
         loads.extra.size() + 4 <= LaneLoads::most_forces && loads.springs.size() <= LaneLoads::most_springs;
}

CellMeasures::Rows four_bar_loads(std::shared_ptr<const FourBarCells> links, const RegionMap& map, const Loads& loads,
                                  std::span<const ReadOut> read_outs, const Pose& body, Simd simd) {
  const auto rows =
      std::make_shared<const RowsOfLoads>(std::move(links), map, loads, read_outs, direction(body.angle), simd);
  return [rows](std::size_t row, RowsOfLoads::Values values) { rows->write(row, values); };
}

}  // namespace linkwright
