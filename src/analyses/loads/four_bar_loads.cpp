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
#include "loads/load_kernel.hpp"

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
    default:
      return LoadRow::effort;
  }
}

void count_cases(LoadRow& row, const Loads& loads, std::span<const ReadOut> read_outs) {
  const std::vector<LoadCase> cases = cases_of(loads);
  for (const ReadOut read_out : read_outs)
    for (std::size_t c = 0; c < cases.size(); ++c)
      if (cases[c].counts(read_out)) row.counted[what_of(read_out)] |= 1U << c;
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
  TablesOfLoads(const FourBarCells& links, const RegionMap& map, const Loads& loads, Point turned)
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
    load_tables_kernel.for_simd(Simd::automatic)(tables_);
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
  LoadRow::What what;
  double unit;  ///< by which values are multiplied
  float none;   ///< where there is no value
};

std::vector<LoadColumn> columns_of(const Loads& loads, std::span<const ReadOut> read_outs) {
  constexpr float infinite = std::numeric_limits<float>::infinity();
  std::vector<LoadColumn> columns;
  for (const ReadOut read_out : read_outs)
    columns.push_back({what_of(read_out), read_out == ReadOut::max_torque ? metres_of(loads) : 1,
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
  for (std::size_t j = 1; j + 1 < static_cast<std::size_t>(row.stations); ++j) {
    const double before = turns[j] - turns[j - 1], after = turns[j + 1] - turns[j];
    row.steps[j] = {before, after, 1 / before, 1 / after, 1 / (before + after)};
  }
}

/// The cells of a map row by row.
class RowsOfLoads {
 public:
  using Values = std::span<const std::span<float>>;

  RowsOfLoads(std::shared_ptr<const FourBarCells> links, const RegionMap& map, const Loads& loads,
              std::span<const ReadOut> read_outs, Point turned)
      : links_(std::move(links)),
        map_(map),
        tables_(*links_, map, loads, turned),
        told_(columns_of(loads, read_outs)),
        blank_(blank_row(loads, read_outs, turned)),
        between_(steps_between(loads.stations, links_->positions())) {
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
    const auto count = (*tables_).loads->cases * LoadRow::curves * row.stations;
    // Not cleared; std::make_unique_for_overwrite is not in every library.
    const std::unique_ptr<double[]> values_of_curves(
        new double[static_cast<std::size_t>(count) * LoadTables::most_lanes]);
    row.values = values_of_curves.get();
    for (std::size_t k = 0; k < told_.size(); ++k) {
      fill_blank(at, told_[k].none, values[k]);
      row.value[told_[k].what] = values[k].data();
      row.unit[told_[k].what] = told_[k].unit;
    }
    for (const int sense : {1, -1}) {
      if (std::find(senses.begin(), senses.end(), sense) == senses.end()) continue;
      put_driver(*links_, links_->input_link(at), sense, between_, row);
      load_kernel.for_simd(Simd::automatic)(row);
    }
  }

 private:
  /// Of columns; so many more that a kernel may read beyond them.
  [[nodiscard]] std::vector<signed char> senses_of(std::size_t row) const {
    std::vector<signed char> senses(map_.columns() + LoadTables::most_lanes, 0);
    for (std::size_t column = 0; column < map_.columns(); ++column) {
      const std::size_t cell = map_.index(row, column);
      if (map_.type(cell) == LinkageType::degenerate || !map_.defects(cell).none()) continue;
      senses[column] = map_.drive_sense(row, column) == DriveSense::cw ? -1 : 1;
    }
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
  TablesOfLoads tables_;
  std::vector<LoadColumn> told_;
  LoadRow blank_;
  int between_;
};

}  // namespace

bool fits_lanes(const Loads& loads, std::size_t positions) {
  const bool is_linear = std::none_of(loads.springs.begin(), loads.springs.end(), [](const Spring& spring) {
    return std::holds_alternative<TorsionSpring>(spring.law);
  });
  const bool is_slow =
      std::all_of(loads.cases.begin(), loads.cases.end(), [](const LoadCase& of) { return of.gas_exponent == 1; });
  const std::size_t stations = (positions - 1) * static_cast<std::size_t>(steps_between(loads.stations, positions)) + 1;
  return is_linear && is_slow && loads.rpm.value_or(0) == 0 && stations <= LoadRow::most_stations &&
         loads.extra.size() + 4 <= LaneLoads::most_forces && loads.springs.size() <= LaneLoads::most_springs;
}

CellMeasures::Rows four_bar_loads(std::shared_ptr<const FourBarCells> links, const RegionMap& map, const Loads& loads,
                                  std::span<const ReadOut> read_outs, const Pose& body) {
  const auto rows = std::make_shared<const RowsOfLoads>(std::move(links), map, loads, read_outs, direction(body.angle));
  return [rows](std::size_t row, RowsOfLoads::Values values) { rows->write(row, values); };
}

}  // namespace linkwright
