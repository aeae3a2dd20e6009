#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <gtest/gtest.h>
#include <random>
#include <string>
#include <vector>

#include "analyses/loads/four_bar_loads.hpp"
#include "analyses/loads/loads_analysis.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/planar/task_family.hpp"
#include "linkwright/region/region_map.hpp"
#include "loads/cell_loads.hpp"
#include "support/draws.hpp"
#include "support/file_support.hpp"

namespace linkwright::random_loads_test {
namespace {

/// Loads at random on the scale of the tailgate: all that kernels know, anywhere.
class RandomLoads {
 public:
  explicit RandomLoads(unsigned seed) : numbers_(seed) {}

  Loads operator()() {
    Loads loads;
    loads.metres = 0.001;
    if (is_one_in(2)) loads.body = BodyMass{in(5, 30), point(200), 0};
    for (auto* link : {&loads.input, &loads.coupler, &loads.output})
      if (is_one_in(3)) *link = link_mass();
    for (int k = whole(0, 3); k > 0; --k) loads.extra.push_back(extra("load " + std::to_string(k)));
    for (int k = whole(0, 4); k > 0; --k) loads.springs.push_back(spring());
    if (is_one_in(3)) leave_free(loads);
    using Direction = Handle::Direction;
    loads.handle = Handle{
        point(150), std::array{Direction::tangential, Direction::vertical, Direction::fixed}[index(3)], in(-3, 3)};
    if (is_one_in(3)) loads.pins = PinFriction{in(2, 9), in(0.05, 0.3)};
    loads.drive = std::array{LoadDrive::hand, LoadDrive::input, LoadDrive::output, LoadDrive::cylinder}[index(4)];
    loads.cylinder = {{LoadedBody::ground, point(200)}, at(LoadedBody::output)};
    for (int k = whole(1, 3); k > 0; --k) loads.cases.push_back(load_case(loads, std::to_string(k)));
    loads.stations = std::array{4, 7, 13}[index(3)];
    return loads;
  }

 private:
  double in(double from, double to) { return std::uniform_real_distribution(from, to)(numbers_); }
  int whole(int from, int to) { return std::uniform_int_distribution(from, to)(numbers_); }
  std::size_t index(int count) { return static_cast<std::size_t>(whole(0, count - 1)); }
  bool is_one_in(int count) { return whole(1, count) == 1; }
  Point point(double size) { return {in(-size, size), in(-size, size)}; }
  LoadedBody body() { return static_cast<LoadedBody>(whole(0, 4)); }
  CarriedPoint at(LoadedBody on) { return {on, point(on == LoadedBody::ground ? 400 : 120)}; }

  LinkMass link_mass() {
    LinkMass link;
    if (is_one_in(2)) {
      link.kg_per_m = in(0.5, 3);
    } else {
      link.mass = in(0.2, 2);
      if (is_one_in(2)) link.center = point(80);
    }
    return link;
  }
  ExtraLoad extra(std::string name) {
    ExtraLoad load{.name = std::move(name), .at = at(body()), .force = point(60), .always = is_one_in(2)};
    if (is_one_in(3)) load.mass = in(1, 6);
    load.turns_with_body = is_one_in(2);
    return load;
  }
  Spring spring() {
    const LoadedBody from = body();
    LoadedBody to = body();
    while (to == from) to = body();
    Spring spring{.name = {}, .count = whole(1, 2), .from = at(from), .to = at(to), .law = {}};
    if (is_one_in(2)) {
      const double f1 = in(100, 300), friction = in(0, 30);
      spring.law = GasSpring{.extended_length = 3000, .stroke = 2900, .f1 = f1, .f2 = 1.3 * f1, .friction = friction};
    } else {
      using Acts = CoilSpring::Acts;
      spring.law = CoilSpring{in(0, 1), in(0, 400), std::array{Acts::both, Acts::tension, Acts::compression}[index(3)]};
    }
    return spring;
  }
  /// The first gas spring.
  void leave_free(Loads& loads) {
    for (Spring& spring : loads.springs)
      if (auto* gas = std::get_if<GasSpring>(&spring.law)) {
        gas->free = FreeStrength{.max_f1 = in(200, 2000)};
        if (is_one_in(2)) gas->free->min_f1 = in(1, 100);
        if (is_one_in(2)) gas->free->min_hold_open = in(-30, 30);
        return;
      }
  }
  LoadCase load_case(const Loads& loads, std::string name) {
    LoadCase of{.name = std::move(name), .temperature = in(-30, 60), .slope = in(-0.1, 0.1)};
    for (const ExtraLoad& load : loads.extra)
      if (is_one_in(2)) of.extra.push_back(load.name);
    of.spring_percent = in(80, 120);
    if (is_one_in(4)) of.counts_for = {ReadOut::hold_open, ReadOut::max_open_force, ReadOut::max_pin_force};
    return of;
  }

  std::mt19937 numbers_;
};

struct Compared {
  int values = 0, numbers = 0;
  int none = 0, infinite = 0;  ///< where one by one there is no value; of these in packs
};

/// Measures of a map, or those of them that ask for no pins.
std::vector<Measure> asked(const LinkageFamily& family, const Loads& loads, bool with_pins) {
  std::vector<Measure> measures;
  for (const AddedMeasure& each : load_measures(family, loads).all)
    if (with_pins || each.measure->measure() != measures::max_pin_force) measures.push_back(each.measure->measure());
  return measures;
}

std::uint32_t bits(float value) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

using Columns = std::vector<std::vector<float>>;

/// As they are filled together, which is the same by every instruction set that there is.
Columns filled(const LinkageFamily& family, const RegionMap& map, const Loads& loads,
               const std::vector<Measure>& measures) {
  const AddedMeasures added = load_measures(family, loads);
  const auto fill = [&](const CellMeasures::Rows& rows) {
    Columns columns(measures.size(), std::vector<float>(map.types().size()));
    for (std::size_t row = 0; row < map.rows(); ++row) {
      std::vector<std::span<float>> places;
      for (auto& column : columns) places.push_back(std::span(column).subspan(row * map.columns(), map.columns()));
      rows(row, places);
    }
    return columns;
  };
  Columns columns = fill(added.find(measures.front())->together->rows_of(map, measures));
  auto links = family.four_bar_cells(map);
  if (!fits_lanes(loads, links->positions())) return columns;
  std::vector<ReadOut> read_outs;
  for (const Measure& measure : measures) read_outs.push_back(read_out_of(measure).value());
  const auto body = family.output({map.input_coordinates()[0], map.output_coordinates()[1]});
  const auto& planar = std::get<PlanarOutput>(body.value());
  for (const Simd simd : {Simd::scalar, Simd::baseline, Simd::avx2, Simd::avx512}) {
    if (!is_supported(simd)) continue;
    const Columns by = fill(four_bar_loads(family.four_bar_cells(map), map, loads, read_outs,
                                           {planar.positions.front().point, planar.body_angle}, simd));
    for (std::size_t k = 0; k < by.size(); ++k)
      for (std::size_t cell = 0; cell < by[k].size(); ++cell)
        EXPECT_EQ(bits(by[k][cell]), bits(columns[k][cell]))
            << name(simd) << " " << measures[k].key << " of cell " << cell;
  }
  return columns;
}

/// Every cell of a map, against CellLoads.
Compared compare(const LinkageFamily& family, const RegionMap& map, const Loads& loads, bool with_pins) {
  Compared count;
  const std::vector<Measure> measures = asked(family, loads, with_pins);
  const Columns columns = filled(family, map, loads, measures);
  for (std::size_t cell = 0; cell < map.types().size(); ++cell) {
    const MapPoint place = {map.input_coordinates()[cell / map.columns()],
                            map.output_coordinates()[cell % map.columns()]};
    const bool is_whole = map.type(cell) != LinkageType::degenerate && map.defects(cell).none();
    const auto output = is_whole ? family.output(place) : std::nullopt;
    for (std::size_t k = 0; k < measures.size(); ++k) {
      const double found = columns[k][cell];
      if (!is_whole) {
        EXPECT_TRUE(map.type(cell) == LinkageType::degenerate ? found == 0 : std::isinf(found));
        continue;
      }
      const ReadOut read_out = read_out_of(measures[k]).value();
      const auto alone = CellLoads(loads, std::get<PlanarOutput>(*output), CellLook::map).read_out(read_out);
      ++count.values;
      if (!alone) {
        ++count.none;
        count.infinite += std::isinf(found) && (found > 0) == larger_is_worse(read_out);
        continue;
      }
      // Near dead points rounding decides how large a force is.
      const double expected = *alone;
      if (std::abs(expected) > 1e5) continue;
      EXPECT_NEAR(found, expected, 1e-4 + 2e-6 * std::abs(expected)) << measures[k].key << " of cell " << cell;
      ++count.numbers;
    }
  }
  return count;
}

class RandomLoadsOnMaps : public ::testing::TestWithParam<const char*> {};

TEST_P(RandomLoadsOnMaps, AreTheSameInPacksAsOneByOne) {
  const auto file = std::filesystem::path(LINKWRIGHT_EXAMPLES_DIR) / (std::string(GetParam()) + ".json");
  const TaskFamily given = task_family(testing::motion(read_problem_file(file).value()), {}, Objective::size);
  RegionMap map;
  const auto along = [&](Side side) { return given.family->samples(side, 15, Spacing::coordinate); };
  given.family->classify(map, along(Side::input), along(Side::output), true);
  RandomLoads random(20);
  Compared all;
  for (int i = 0; i < testing::draws(60, 600) + 1 && !::testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE(i);
    const Loads loads = random();
    for (const bool with_pins : {false, true}) {
      const Compared here = compare(*given.family, map, loads, with_pins);
      all.values += here.values;
      all.numbers += here.numbers;
      all.none += here.none;
      all.infinite += here.infinite;
    }
  }
  EXPECT_GT(all.values, 300);
  EXPECT_GT(all.numbers, 0.9 * (all.values - all.none));
  EXPECT_GE(all.infinite, 0.98 * all.none);  // rounding decides whether a handle rests
}

// From the fixed pivot of the input link of a row to the same place on the ground.
TEST(LoadsOnMaps, SpringsWithoutLengthDoNothing) {
  const auto file = std::filesystem::path(LINKWRIGHT_EXAMPLES_DIR) / "tailgate.json";
  const TaskFamily given = task_family(testing::motion(read_problem_file(file).value()), {}, Objective::size);
  RegionMap map;
  const auto along = [&](Side side) { return given.family->samples(side, 25, Spacing::coordinate); };
  given.family->classify(map, along(Side::input), along(Side::output), true);
  Loads loads;
  loads.metres = 0.001;
  loads.body = BodyMass{20, {40, 120}, 0};
  loads.handle = Handle{{-5, -70}, Handle::Direction::tangential, 0};
  int compared = 0;
  for (std::size_t cell = 0; cell < map.types().size(); ++cell) {
    const std::size_t row = cell / map.columns(), column = cell % map.columns();
    if (map.type(cell) == LinkageType::degenerate || !map.defects(cell).none()) continue;
    const auto output = given.family->output({map.input_coordinates()[row], map.output_coordinates()[column]});
    const Point pivot = std::get<PlanarOutput>(output.value()).positions.front().bars.input_fixed;
    Spring spring{
        .name = {}, .count = 1, .from = {LoadedBody::ground, pivot}, .to = {LoadedBody::input, {}}, .law = {}};
    spring.law = compared % 2 == 0
                     ? std::variant<GasSpring, CoilSpring, TorsionSpring>(CoilSpring{3, 50})
                     : GasSpring{.extended_length = 300, .stroke = 200, .f1 = 300, .f2 = 400, .friction = 9};
    loads.springs = {spring};
    const std::vector<Measure> measures = asked(*given.family, loads, true);
    const Columns with = filled(*given.family, map, loads, measures);
    loads.springs.clear();
    const Columns without = filled(*given.family, map, loads, measures);
    for (std::size_t k = 0; k < measures.size(); ++k)
      EXPECT_NEAR(with[k][cell], without[k][cell], 1e-6 * std::abs(without[k][cell])) << measures[k].key;
    if (++compared == 8) break;
  }
  EXPECT_EQ(compared, 8);
}

INSTANTIATE_TEST_SUITE_P(Examples, RandomLoadsOnMaps, ::testing::Values("bin_lid", "tailgate", "nose_gear"));

}  // namespace
}  // namespace linkwright::random_loads_test
