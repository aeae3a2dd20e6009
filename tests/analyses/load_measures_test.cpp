#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <gtest/gtest.h>
#include <limits>

#include "analyses/loads/loads_analysis.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/loads/load_report.hpp"
#include "linkwright/planar/task_family.hpp"
#include "linkwright/region/region_map.hpp"
#include "linkwright/region/requirement_filter.hpp"
#include "linkwright/synthesis/solve.hpp"
#include "loads/cell_loads.hpp"
#include "loads/free_strength.hpp"
#include "support/draws.hpp"
#include "support/file_support.hpp"
#include "support/load_cases.hpp"

namespace linkwright::load_measures_test {
namespace {

using nlohmann::json;

/// The tailgate's map, with loads.
struct LoadedMap {
  TaskFamily given;
  RegionMap map;

  explicit LoadedMap(int samples) : given(task_family(testing::motion(testing::tailgate()), {}, Objective::size)) {
    const auto along = [&](Side side) { return given.family->samples(side, samples, Spacing::coordinate); };
    given.family->classify(map, along(Side::input), along(Side::output), true);
  }
  [[nodiscard]] MapPoint place(std::size_t row, std::size_t column) const {
    return {map.input_coordinates()[row], map.output_coordinates()[column]};
  }
  [[nodiscard]] PlanarOutput output(std::size_t row, std::size_t column) const {
    return std::get<PlanarOutput>(given.family->output(place(row, column)).value());
  }
};

std::vector<float> column_of(LoadedMap& of, const Loads& loads, const Measure& measure) {
  load_measures(*of.given.family, loads).add_to(of.map, *of.given.family, {}, false);
  const auto values = of.map.values(measure);
  return {values.begin(), values.end()};
}

TEST(LoadMeasures, AreThoseOfTheFilesCells) {
  const json file = testing::load_file("map_cells");
  const Loads loads = testing::loads_from(file["loads"]);
  for (const json& cell : file["results"]) {
    const auto& pivots = cell["pivots"];
    const FourBar bars{testing::point_from(pivots["input_fixed"]), testing::point_from(pivots["input_moving"]),
                       testing::point_from(pivots["output_fixed"]), testing::point_from(pivots["output_moving"])};
    std::vector<PrescribedPose> poses;
    for (const json& pose : file["poses"])
      poses.push_back({{testing::point_from(pose), radians(pose[2].get<double>())}, {}});
    const PlanarOutput output = pose_output(bars, poses);
    for (const json& told : cell["cases"]) {
      Loads one = loads;
      one.cases = {{.name = "one", .temperature = told["case"] == "cold" ? -30.0 : 20.0}};
      const auto value = [&](ReadOut read_out) {
        return CellLoads(one, output, CellLook::map).read_out(read_out).value();
      };
      // The parabola stands at the stations' maximum or above it, and nearer to that of 181 stations.
      const auto expect_between = [&](ReadOut read_out, const json& most) {
        const double found = value(read_out), stations = most["stations_13"], fine = most["stations_181"];
        EXPECT_GE(found, stations - 1e-7);
        EXPECT_LE(std::abs(found - fine), std::abs(stations - fine) + 0.03);
      };
      expect_between(ReadOut::max_open_force, told["max_open_force"]);
      expect_between(ReadOut::max_close_force, told["max_close_force"]);
      EXPECT_NEAR(value(ReadOut::hold_open), told["hold_open"].get<double>(), 1e-7);
    }
  }
}

// All that kernels know at once: weights of three kinds, forces that turn and that do not, springs of both kinds
// between any bodies, friction, three cases.
Loads everything(LoadDrive drive) {
  Loads loads = testing::loads_from(json::parse(R"({
    "body": {"mass": 24, "center": [40, 120]}, "handle": {"point": [-5, -70]},
    "links": {"input": {"kg_per_m": 1.2}, "coupler": {"mass": 0.4}, "output": {"mass": 0.7, "center": [60, 5]}},
    "extra": [{"name": "snow", "on": "body", "at": [70, 200], "mass": 6},
              {"name": "tool", "on": "body", "at": [10, 20], "force": [30, -12], "frame": "body", "always": true},
              {"name": "pull", "on": "output", "at": [30, 8], "force": [5, 9], "always": true}],
    "springs": [{"kind": "gas", "count": 2, "from": {"on": "ground", "at": [150, 115]},
                 "to": {"on": "body", "at": [60, 298]}, "extended_length": 325, "stroke": 128,
                 "F1": 375, "F2": 500, "F3": 425, "F4": 560, "rod_diameter": 8},
                {"kind": "coil", "from": {"on": "input", "at": [40, 15]}, "to": {"on": "output", "at": [50, -10]},
                 "rate": 0.7, "free_length": 60, "acts": "tension"},
                {"kind": "coil", "from": {"on": "ground", "at": [300, 300]}, "to": {"on": "coupler", "at": [10, 3]},
                 "rate": 0.2, "free_length": 90}],
    "pins": {"radius": 6, "friction": 0.15},
    "cases": [{"name": "room"}, {"name": "cold", "temperature_C": -30, "slope_deg": 6, "extra": ["snow"]},
              {"name": "aged", "spring_percent": 85, "for": ["hold_open", "max_pin_force"]}]})"));
  loads.drive = drive;
  loads.cylinder = {{LoadedBody::ground, {150, 60}}, {LoadedBody::output, {40, 20}}};
  return loads;
}

TEST(LoadMeasures, AreTheSameInPacksAsOneByOne) {
  LoadedMap of(20);
  int compared = 0;
  for (const LoadDrive drive : {LoadDrive::hand, LoadDrive::input, LoadDrive::output, LoadDrive::cylinder}) {
    for (const auto way : {Handle::Direction::tangential, Handle::Direction::vertical, Handle::Direction::fixed}) {
      Loads loads = everything(drive);
      loads.handle->direction = way;
      loads.handle->angle = 2;
      for (const AddedMeasure& added : load_measures(*of.given.family, loads).all) {
        const Measure& measure = added.measure->measure();
        const auto values = column_of(of, loads, measure);
        for (std::size_t cell = 0; cell < values.size(); ++cell) {
          if (of.map.type(cell) == LinkageType::degenerate) continue;
          if (!of.map.defects(cell).none()) {
            EXPECT_TRUE(std::isinf(values[cell]));
            continue;
          }
          const auto output = of.output(cell / of.map.columns(), cell % of.map.columns());
          const ReadOut read_out = read_out_of(measure).value();
          const auto alone = CellLoads(loads, output, CellLook::map).read_out(read_out);
          if (!alone || std::abs(*alone) > 1e5) continue;
          const double expected = *alone;
          EXPECT_NEAR(values[cell], expected, 1e-4 + 1e-6 * std::abs(expected)) << measure.key << " " << cell;
          ++compared;
        }
      }
    }
  }
  EXPECT_GT(compared, 1000);
}

// The search looks at a linkage as closely as lists do, within the margin that it keeps.
TEST(LoadMeasures, AreNearThoseOfListsWhereASearchLooks) {
  LoadedMap of(30);
  const Loads loads = everything(LoadDrive::hand);
  const std::vector<PrescribedPose>& poses = testing::motion(testing::tailgate()).poses;
  const AddedMeasures added = load_measures(*of.given.family, loads);
  int compared = 0;
  for (std::size_t cell = 0; cell < of.map.types().size() && compared < 40; ++cell) {
    if (of.map.type(cell) == LinkageType::degenerate || !of.map.defects(cell).none()) continue;
    const std::size_t row = cell / of.map.columns(), column = cell % of.map.columns();
    const auto report = load_report(loads, of.output(row, column).positions.front().bars, poses).value();
    for (const AddedMeasure& each : added.all) {
      const ReadOut read_out = read_out_of(each.measure->measure()).value();
      if (read_out == ReadOut::hand_force_error) continue;  // of the stations of a map
      const auto& worst = report.worst_of(read_out);
      if (!worst || std::abs(worst->value) > 1e4) continue;
      const double listed = worst->value;
      EXPECT_NEAR(each.measure->at(of.place(row, column)).value(), listed, each.margin_of(listed))
          << each.measure->measure().key;
    }
    ++compared;
  }
  EXPECT_GT(compared, 20);
}

/// The tailgate's, its struts of any strength.
Loads with_free_struts() {
  Loads loads = everything(LoadDrive::hand);
  loads.pins.reset();
  std::get<GasSpring>(loads.springs.front().law).free = FreeStrength{.max_f1 = 900, .min_hold_open = 5};
  return loads;
}

/// What a map has of its linkages without defects, and what lists have of them.
struct MapAndList {
  double of_map, listed, error;
};
std::vector<MapAndList> in_map_and_list(const Loads& loads, const Measure& measure) {
  LoadedMap of(24);
  const std::vector<PrescribedPose>& poses = testing::motion(testing::tailgate()).poses;
  const auto values = column_of(of, loads, measure);
  const auto errors = of.map.values(measures::hand_force_error);
  std::vector<MapAndList> found;
  for (std::size_t cell = 0; cell < values.size(); ++cell) {
    // Near dead points no number of stations tells the largest force.
    if (!of.map.defects(cell).none() || of.map.min_transmission_angle(cell) < radians(15)) continue;
    const auto output = of.output(cell / of.map.columns(), cell % of.map.columns());
    const auto report = load_report(loads, output.positions.front().bars, poses).value();
    const ReadOut read_out = read_out_of(measure).value();
    const auto listed = read_out == ReadOut::best_f1 ? report.best_f1
                        : report.worst_of(read_out)  ? std::optional(report.worst_of(read_out)->value)
                                                     : std::nullopt;
    if (listed && std::abs(*listed) < 1e3 && std::isfinite(values[cell]))
      found.push_back({values[cell], *listed, errors[cell]});
  }
  return found;
}

/// How many are within.
template <class Within>
double share_within(const std::vector<MapAndList>& all, const Within& within) {
  return static_cast<double>(std::count_if(all.begin(), all.end(), within)) / static_cast<double>(all.size());
}

TEST(LoadMeasures, ToldErrorsOfStationsCoverNearlyAll) {
  Loads given = with_free_struts();
  std::get<GasSpring>(given.springs.front().law).free.reset();
  for (const Loads& loads : {given, with_free_struts()}) {
    const auto all = in_map_and_list(loads, measures::hand_force);
    ASSERT_GT(all.size(), 50U);
    EXPECT_GT(share_within(all, [](const auto& of) { return std::abs(of.of_map - of.listed) <= of.error; }), 0.95);
    EXPECT_GT(share_within(all, [](const auto& of) { return std::abs(of.of_map - of.listed) <= 4 * of.error; }), 0.97);
  }
}

TEST(LoadMeasures, TellTheStrengthThatListsFind) {
  const auto all = in_map_and_list(with_free_struts(), measures::best_f1);
  ASSERT_GT(all.size(), 50U);
  EXPECT_GT(share_within(all, [](const auto& of) { return std::abs(of.of_map - of.listed) <= 2 + 0.01 * of.listed; }),
            0.95);
}

// No other F1 does better at the stations, and none below or above it holds open.
TEST(LoadMeasures, TellTheStrengthThatASlowSearchFinds) {
  LoadedMap of(16);
  const Loads loads = with_free_struts();
  const FreeStrength free = *std::get<GasSpring>(loads.springs.front().law).free;
  const auto values = column_of(of, loads, measures::best_f1);
  const auto forces = of.map.values(measures::hand_force);
  // Of the stations alone, without parabolas between them.
  const auto at_stations = [&](const PlanarOutput& output, double f1) {
    const Loads with = with_f1(loads, f1);
    double most = -1e300, least_hold = 1e300;
    for (const LoadCase& each : with.cases) {
      const auto curve = load_curve(with, each, output.positions.front().bars, poses_of(output), 4);
      for (const LoadStation& at : curve)
        if (each.counts(ReadOut::hand_force)) most = std::max({most, at.open.value(), at.close.value()});
      least_hold = std::min(least_hold, -curve.back().open.value());
    }
    return least_hold >= *free.min_hold_open ? most : std::numeric_limits<double>::infinity();
  };
  int compared = 0;
  for (std::size_t cell = 0; cell < values.size() && compared < 12; ++cell) {
    if (!of.map.defects(cell).none() || of.map.min_transmission_angle(cell) < radians(15)) continue;
    const auto output = of.output(cell / of.map.columns(), cell % of.map.columns());
    double best = std::numeric_limits<double>::infinity(), at = 0;
    for (double f1 = 1; f1 <= free.max_f1; f1 += 0.5)
      if (const double force = at_stations(output, f1); force < best) best = force, at = f1;
    EXPECT_EQ(std::isinf(values[cell]), std::isinf(best)) << cell;
    if (std::isinf(best)) continue;
    EXPECT_NEAR(values[cell], at, 0.51) << cell;
    EXPECT_GE(forces[cell], best - 2) << cell;
    ++compared;
  }
  EXPECT_EQ(compared, 12);
}

TEST(LoadMeasures, TellTheTurnsThatListsFind) {
  for (const Measure& measure : {measures::self_rise, measures::self_close}) {
    Loads loads = everything(LoadDrive::hand);
    loads.pins.reset();  // their friction is of first order in maps
    loads.cases.resize(1);
    const auto all = in_map_and_list(loads, measure);
    ASSERT_GT(all.size(), 20U) << measure.key;
    EXPECT_GT(share_within(all, [](const auto& of) { return std::abs(of.of_map - of.listed) <= radians(1); }), 0.9)
        << measure.key;
  }
}

/// A requirement on a column of loads, and loads that give it values.
struct Required {
  RequirementKind kind;
  const Measure* measure;
  Loads loads;
};
std::vector<Required> required() {
  Loads freely = everything(LoadDrive::cylinder);
  freely.pins.reset();
  freely.cases.resize(1);
  Loads free = with_free_struts();
  return {{RequirementKind::max_cylinder_force, &measures::cylinder_force, freely},
          {RequirementKind::max_self_rise, &measures::self_rise, freely},
          {RequirementKind::min_self_close, &measures::self_close, freely},
          {RequirementKind::max_best_f1, &measures::best_f1, free}};
}

// A limit in the middle of what the map tells, as files have it, parts the linkages without defects as their numbers
// do.
TEST(LoadMeasures, AreRequiredAsTheMapTellsThem) {
  for (const auto& [kind, measure, loads] : required()) {
    LoadedMap of(40);
    column_of(of, loads, *measure);
    const Criterion& asked = criterion(kind);
    Requirements wanted;
    wanted.max_link_ratio = Requirements::unlimited;
    wanted.max_length = Requirements::unlimited;
    const RequirementFilter all_else = filter_of(*of.given.family, of.map, wanted);
    std::vector<double> told;
    for (std::size_t row = 0; row < of.map.rows(); ++row) {
      std::vector<float> values(of.map.columns());
      row_values(of.map, *measure, row, values);
      for (std::size_t column = 0; column < values.size(); ++column)
        if (all_else.failures(row, column) == 0 && std::isfinite(of.map.values(*measure)[of.map.index(row, column)]))
          told.push_back(values[column]);
    }
    ASSERT_GT(told.size(), 50U) << asked.key;
    std::sort(told.begin(), told.end());
    // Between two different numbers.
    std::size_t k = told.size() / 2;
    while (k + 1 < told.size() && told[k + 1] - told[k] <= 1e-3 * std::abs(told[k])) ++k;
    ASSERT_LT(k + 1, told.size()) << asked.key;
    const double limit = (told[k] + told[k + 1]) / 2;
    asked.set(wanted, asked.is_angle() ? radians(limit) : limit);
    const RequirementFilter filter = filter_of(*of.given.family, of.map, wanted);
    const auto below = static_cast<std::int64_t>(k + 1), all = static_cast<std::int64_t>(told.size());
    EXPECT_EQ(filter.census().meeting, asked.rule == Criterion::Rule::at_most ? below : all - below) << asked.key;
  }
}

// What is listed keeps the limit that was asked for by what its report tells.
TEST(LoadMeasures, AreKeptByWhatIsListed) {
  struct Asked {
    const char* key;
    double limit, sign;
    std::function<double(const LoadReport& report)> told;
  };
  const auto worst = [](ReadOut read_out) {
    return [read_out](const LoadReport& report) { return degrees(report.worst_of(read_out).value().value); };
  };
  const std::vector<Asked> all = {
      {"max_self_rise_deg", 12, 1, worst(ReadOut::self_rise)},
      {"min_self_close_deg", 10, -1, worst(ReadOut::self_close)},
      {"max_best_F1", 330, 1, [](const LoadReport& report) { return report.best_f1.value(); }}};
  for (const auto& [key, limit, sign, told] : all) {
    json file = json::parse(testing::text_of(std::filesystem::path(LINKWRIGHT_EXAMPLES_DIR) / "tailgate_struts.json"),
                            nullptr, true, true);
    file["requirements"] = {{"no_defects", true}, {key, limit}};
    file["options"] = {{"region_samples", 40}, {"objective", "hand_force"}};
    file["loads"]["cases"] = {{{"name", "room"}}};
    if (std::string(key) == "min_self_close_deg") file["loads"]["cases"][0]["spring_percent"] = 20;
    if (std::string(key) == "max_best_F1") file["loads"]["springs"][0]["best_F1"] = {{"max_F1", 900}};
    const Answer answer = solve(read_problem(file.dump()).value()).value();
    const Findings& found = findings(answer);
    EXPECT_FALSE(found.loads.empty()) << key;
    for (const auto& report : found.loads) EXPECT_LE(sign * told(report.value()), sign * limit + 1e-9) << key;
  }
}

// What is between ground and body does the same work in all linkages of the map.
TEST(LoadMeasures, DoTheWorkThatTheTaskTakes) {
  LoadedMap of(40);
  Loads loads = everything(LoadDrive::hand);
  loads.input = loads.coupler = loads.output = std::nullopt;
  loads.springs.resize(1);
  loads.extra.resize(1);
  const std::vector<PrescribedPose>& poses = testing::motion(testing::tailgate()).poses;
  std::optional<double> work;
  int compared = 0;
  for (std::size_t cell = 0; cell < of.map.types().size(); ++cell) {
    if (of.map.type(cell) == LinkageType::degenerate || !of.map.defects(cell).none()) continue;
    const auto output = of.output(cell / of.map.columns(), cell % of.map.columns());
    const auto curve = load_curve(loads, loads.cases.front(), output.positions.front().bars, poses, 1);
    ASSERT_EQ(curve.size(), poses.size());
    const double energy = curve.back().energy.value();
    if (!work) work = energy;
    EXPECT_NEAR(energy, *work, 1e-9 * std::abs(*work));
    ++compared;
  }
  EXPECT_GT(compared, 20);
}

}  // namespace
}  // namespace linkwright::load_measures_test
