#include "planar/timed_path_family.hpp"

#include <gtest/gtest.h>
#include <random>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/defects.hpp"
#include "linkwright/planar/four_bar_solution.hpp"
#include "linkwright/region/pivot_windows.hpp"
#include "planar/path_drive.hpp"
#include "support/path_case.hpp"

namespace linkwright::timed_path_family_test {
namespace {

RegionMap map_of(const FourBarFamily& family, int samples) {
  RegionMap map;
  const auto input = family.samples(Side::input, samples, Spacing::coordinate);
  const auto output = family.samples(Side::output, samples, Spacing::coordinate);
  constexpr bool respect_direction = true;
  family.classify(map, input, output, respect_direction);
  return map;
}

// Counts of a map that an independent implementation judged by the joints of each linkage.
void expect_counts_of_case(const std::string& name) {
  const testing::PathCase c = testing::path_case(name);
  const auto& region = c.json.at("region");
  const TaskFamily given = family_of_timed(c.task);
  ASSERT_TRUE(given.paths) << name;
  const RegionMap map = map_of(*given.family, region.at("samples"));
  const RegionCounts found = map.counts();
  const auto& counts = region.at("counts");
  for (const LinkageType type : path_linkages.types)
    EXPECT_EQ(found.types[static_cast<std::size_t>(type)], counts.at(std::string(linkwright::name(type))))
        << name << ": " << linkwright::name(type);
  EXPECT_EQ(found.order, counts.at("order")) << name;
  EXPECT_EQ(found.branch, counts.at("branch")) << name;
  EXPECT_EQ(found.circuit, counts.at("circuit")) << name;
  EXPECT_EQ(found.defect_free, counts.at("defect_free")) << name;
  std::int64_t turning = 0;
  for (std::size_t cell = 0; cell < map.rows() * map.columns(); ++cell)
    turning += map.defects(cell).none() && input_is_crank(map.type(cell));
  EXPECT_EQ(turning, counts.at("full_turn_defect_free")) << name;
}

TEST(TimedPathFamily, CountsWhatTheCaseFilesCount) {
  expect_counts_of_case("film_claw_timed");
  expect_counts_of_case("dough_mixer_timed_full_turn");
  expect_counts_of_case("thread_takeup_timed_mixed");
}

// The linkages at places of the map, to nine digits.
void expect_linkages_of_case(const std::string& name) {
  const testing::PathCase c = testing::path_case(name);
  const TaskFamily given = family_of_timed(c.task);
  ASSERT_TRUE(given.paths) << name;
  for (const auto& linkage : c.json.at("linkages")) {
    const MapPoint place{linkage.at("input_coordinate"), linkage.at("output_coordinate")};
    const auto links = given.family->dyad_pair(place);
    const auto bars = links ? four_bar_of(*links) : std::nullopt;
    ASSERT_TRUE(bars) << name;
    const FourBar found = given.frame().to_user(*bars), wanted = testing::bars_of(linkage);
    const double close = 1e-9 * wanted.lengths().longest();
    EXPECT_NEAR(std::abs(found.input_fixed - wanted.input_fixed), 0, close) << name;
    EXPECT_NEAR(std::abs(found.input_moving - wanted.input_moving), 0, close) << name;
    EXPECT_NEAR(std::abs(found.output_fixed - wanted.output_fixed), 0, close) << name;
    EXPECT_NEAR(std::abs(found.output_moving - wanted.output_moving), 0, close) << name;
    const auto made = make_four_bar(given, place, true, true);
    ASSERT_TRUE(made) << name;
    EXPECT_EQ(linkwright::name(made->report.type), linkage.at("type").get<std::string>()) << name;
    EXPECT_EQ(linkwright::name(made->swapped.type), linkage.at("type_swapped").get<std::string>()) << name;
    EXPECT_EQ(made->report.defects.order(), linkage.at("defects").at("order").get<bool>()) << name;
    EXPECT_EQ(made->report.defects.branch(), linkage.at("defects").at("branch").get<bool>()) << name;
    EXPECT_EQ(made->report.defects.circuit(), linkage.at("defects").at("circuit").get<bool>()) << name;
    EXPECT_TRUE(made->verified_by_driving) << name;
    if (!made->report.defects.none()) continue;
    EXPECT_EQ(linkwright::name(made->report.sense), linkage.at("drive").get<std::string>()) << name;
    EXPECT_NEAR(degrees(made->report.min_transmission_angle), linkage.at("min_transmission_angle_deg"), 1e-7) << name;
    const auto& full_turn = linkage.at("min_transmission_angle_full_turn_deg");
    EXPECT_NEAR(degrees(made->report.min_transmission_angle_full_turn),
                full_turn.is_null() ? 0 : full_turn.get<double>(), 1e-7)
        << name;
  }
}

TEST(TimedPathFamily, HasTheLinkagesOfTheCaseFiles) {
  expect_linkages_of_case("film_claw_timed");
  expect_linkages_of_case("dough_mixer_timed_full_turn");
  expect_linkages_of_case("thread_takeup_timed_mixed");
}

PathTask random_task(std::mt19937_64& random, const std::vector<int>& multiplicity, bool clockwise) {
  std::uniform_real_distribution<double> place(-10, 10), step(0.2, 1.4);
  PathTask task;
  double angle = step(random);
  for (const int m : multiplicity) {
    PathPoint point{{place(random), place(random)}, clockwise ? -angle : angle, {}};
    for (int k = 1; k < m; ++k) point.derivatives.push_back({{place(random), place(random)}, std::nullopt});
    task.points.push_back(point);
    angle += step(random);
  }
  return task;
}

const std::vector<std::vector<int>> patterns = {{1, 1, 1, 1}, {2, 1, 1}, {1, 2, 1}, {1, 1, 2},
                                                {2, 2},       {3, 1},    {1, 3},    {4}};

struct Compared {
  int cells = 0, clean = 0, differences = 0;
};

// Each cell of the map, which the kernel judged by its virtual loop, beside the verdict over the joints of its linkage
// in all positions.
Compared compare_with_joints(const PathTask& task, int samples) {
  const TaskFamily given = family_of_timed(task);
  EXPECT_TRUE(given.paths);
  const FourBarFamily& family = *given.family;
  const RegionMap map = map_of(family, samples);
  Compared compared;
  for (std::size_t row = 0; row < map.rows(); ++row)
    for (std::size_t column = 0; column < map.columns(); ++column) {
      const std::size_t cell = map.index(row, column);
      const MapPoint place{map.input_coordinates()[row], map.output_coordinates()[column]};
      const auto links = family.dyad_pair(place);
      const auto bars = links ? four_bar_of(*links) : std::nullopt;
      if (!bars) {
        EXPECT_EQ(map.type(cell), LinkageType::degenerate);
        EXPECT_EQ(map.is_diagonal(row, column), row == column);
        continue;
      }
      const auto report = find_defects(*bars, family.working_poses(place, *bars));
      ++compared.cells;
      if (report.type != map.type(cell) || report.defects != map.defects(cell)) {
        ++compared.differences;
        continue;
      }
      const LinkLengths lengths = bars->lengths();
      EXPECT_NEAR(map.values(measures::longest_link)[cell] / (family.frame().scale * lengths.longest()), 1, 1e-5);
      EXPECT_NEAR(map.values(measures::link_ratio)[cell] / (lengths.longest() / lengths.shortest()), 1, 1e-5);
      if (!report.defects.none()) continue;
      ++compared.clean;
      EXPECT_NEAR(map.values(measures::min_transmission_angle)[cell], versine_of_angle(report.min_transmission_angle),
                  1e-5);
      EXPECT_EQ(map.drive_sense(row, column), report.sense);
      EXPECT_NEAR(map.driver_sweep(row, column), report.sweep, 1e-5);
    }
  return compared;
}

TEST(TimedPathFamily, TheVirtualLoopHasTheVerdictOfTheJoints) {
  std::mt19937_64 random(11);
  Compared all;
  for (int i = 0; i < 32; ++i) {
    const auto one =
        compare_with_joints(random_task(random, patterns[static_cast<std::size_t>(i) % patterns.size()], i >= 16), 31);
    all.cells += one.cells;
    all.clean += one.clean;
    all.differences += one.differences;
  }
  EXPECT_GT(all.cells, 25'000);
  EXPECT_GT(all.clean, 1'000);
  EXPECT_LE(all.differences, all.cells / 2'000) << "next to change points and dead points rounding decides";
}

// What the crank does when it is turned, for every third cell of a map.
TEST(TimedPathFamily, CellsAreCleanWhereTheCrankGetsThroughThePoints) {
  std::mt19937_64 random(3);
  int compared = 0, passing = 0, differences = 0;
  for (const auto& multiplicity : patterns) {
    const TaskFamily given = family_of_timed(random_task(random, multiplicity, passing % 2 == 1));
    ASSERT_TRUE(given.paths);
    const RegionMap map = map_of(*given.family, 24);
    for (std::size_t cell = 0; cell < map.rows() * map.columns(); cell += 3) {
      const MapPoint place{map.input_coordinates()[cell / map.columns()],
                           map.output_coordinates()[cell % map.columns()]};
      const auto links = given.family->dyad_pair(place);
      const auto seen = links ? four_bar_of(*links) : std::nullopt;
      if (!seen) continue;
      const FourBar bars = given.frame().to_user(*seen);
      const Point point = given.paths->crank_poses({}, {}).front().pose.origin;
      const PathDrive drive =
          drive_along_path(bars, point, given.paths->crank_poses({}, {}), 1e-5 * bars.lengths().longest());
      ++compared;
      passing += drive.passes;
      differences += drive.passes != map.defects(cell).none();
    }
  }
  EXPECT_GT(compared, 1'000);
  EXPECT_GT(passing, 100);
  EXPECT_LE(differences, compared / 250) << "next to change points and dead points";
}

// The transposed map has the cognates: the same but for their size.
TEST(TimedPathFamily, CognatesDoTheSame) {
  const TaskFamily given = family_of_timed(testing::path_case("dough_mixer_timed_full_turn").task);
  const RegionMap map = map_of(*given.family, 40);
  const auto transposed_type = [](LinkageType type) {
    switch (type) {
      case LinkageType::rocker_crank:
        return LinkageType::double_rocker;
      case LinkageType::double_rocker:
        return LinkageType::rocker_crank;
      case LinkageType::triple_rocker_coupler:
        return LinkageType::triple_rocker_output;
      case LinkageType::triple_rocker_output:
        return LinkageType::triple_rocker_coupler;
      default:
        return type;
    }
  };
  for (std::size_t row = 0; row < map.rows(); ++row)
    for (std::size_t column = 0; column < map.columns(); ++column) {
      const std::size_t here = map.index(row, column), there = map.index(column, row);
      EXPECT_EQ(map.type(there), transposed_type(map.type(here)));
      EXPECT_EQ(map.defects(there), map.defects(here));
      EXPECT_NEAR(map.values(measures::min_transmission_angle)[there],
                  map.values(measures::min_transmission_angle)[here], 1e-5);
    }
}

// A fifth point taken from a linkage of four is passed by that linkage among those of all five.
TEST(TimedPathFamily, AFifthPointOfALinkageLeavesIt) {
  const testing::PathCase c = testing::path_case("film_claw_timed");
  const TaskFamily four = family_of_timed(c.task);
  const auto links = four.family->dyad_pair({0.31, 1.27});
  ASSERT_TRUE(links);
  const FourBar bars = four.frame().to_user(*four_bar_of(*links));
  // The configuration in which the crank has turned by 20°, by the triangle of coupler, output and diagonal.
  const Point a = bars.input_fixed + direction(radians(20)) * (bars.input_moving - bars.input_fixed);
  const LinkLengths lengths = bars.lengths();
  const Point diagonal = bars.output_fixed - a;
  const double d = std::abs(diagonal),
               share = (d * d + lengths.coupler * lengths.coupler - lengths.output * lengths.output) / (2 * d);
  const double up = std::sqrt(lengths.coupler * lengths.coupler - share * share);
  PathTask five = c.task;
  int found = 0;
  for (const double side : {1.0, -1.0}) {
    const Point b = a + diagonal / d * Point{share, side * up};
    const Point p = a + (five.points[0].point - bars.input_moving) * (b - a) / (bars.output_moving - bars.input_moving);
    PathTask task = c.task;
    task.points.insert(task.points.begin() + 1, {p, radians(20), {}});
    ASSERT_TRUE(mistakes_in(task).empty());
    const TaskFamily given = family_of_timed(task);
    ASSERT_TRUE(given.paths);
    EXPECT_EQ(given.family->axis(Side::input).quantity, AxisQuantity::burmester_point);
    const auto places = given.family->samples(Side::input, 0, Spacing::coordinate);
    for (const double crank : places)
      for (const double cognate : places) {
        const auto pair = given.family->dyad_pair({crank, cognate});
        const auto seen = pair ? four_bar_of(*pair) : std::nullopt;
        if (!seen) continue;
        const FourBar user = given.frame().to_user(*seen);
        found += std::abs(user.input_moving - bars.input_moving) < 1e-6 &&
                 std::abs(user.output_fixed - bars.output_fixed) < 1e-6;
      }
  }
  EXPECT_EQ(found, 2) << "in both assemblies";
}

// Neither the place of the drawing nor its size nor the sense of turning matters.
TEST(TimedPathFamily, AMirroredTaskHasMirroredLinkages) {
  const testing::PathCase c = testing::path_case("thread_takeup_timed_mixed");
  PathTask mirrored = c.task;
  for (PathPoint& point : mirrored.points) {
    point.point = 7.0 * std::conj(point.point) + Point{1e4, -2e3};
    *point.input = 3 - *point.input;
    for (PathDerivative& d : point.derivatives) d.point = 7.0 * std::conj(d.point);
  }
  ASSERT_TRUE(mistakes_in(mirrored).empty());
  const TaskFamily one = family_of_timed(c.task), other = family_of_timed(mirrored);
  const RegionCounts a = map_of(*one.family, 80).counts(), b = map_of(*other.family, 80).counts();
  // The curve's coordinate may run the other way: the samples are the same places or lie between them.
  EXPECT_NEAR(static_cast<double>(a.defect_free), static_cast<double>(b.defect_free), 0.03 * 6400);
  EXPECT_NEAR(static_cast<double>(a.branch), static_cast<double>(b.branch), 0.03 * 6400);
  for (const double tau : {0.21, 1.4}) {
    const auto links = one.family->dyad_pair({tau, 0.83});
    const FourBar bars = one.frame().to_user(*four_bar_of(*links));
    const auto image = [](Point p) { return 7.0 * std::conj(p) + Point{1e4, -2e3}; };
    const FourBar mirror{image(bars.input_fixed), image(bars.input_moving), image(bars.output_fixed),
                         image(bars.output_moving)};
    const auto poses = other.family->user_poses({}, mirror);
    const DefectReport here = find_defects(bars, one.family->user_poses({}, bars)), there = find_defects(mirror, poses);
    EXPECT_EQ(here.type, there.type);
    EXPECT_EQ(here.defects, there.defects);
    EXPECT_EQ(here.sense == DriveSense::ccw, there.sense == DriveSense::cw);
  }
}

TEST(TimedPathFamily, TellsDegenerateTasks) {
  const auto items = testing::path_case("nasty_timed").json.at("items");
  int solved = 0, degenerate = 0;
  for (const auto& item : items) {
    const PathTask task = testing::path_task(item.at("task"));
    if (!mistakes_in(task).empty()) continue;
    const TaskFamily given = family_of_timed(task);
    const std::string name = item.at("name");
    if (item.at("expect").at("status") == "degenerate") {
      ASSERT_TRUE(given.degeneracy) << name;
      EXPECT_EQ(given.degeneracy->code, item.at("expect").at("code").get<std::string>()) << name;
      EXPECT_NEAR(std::get<double>(given.degeneracy->values[0].value), item.at("expect").at("at")[0], 1e-6) << name;
      EXPECT_NEAR(std::get<double>(given.degeneracy->values[1].value), item.at("expect").at("at")[1], 1e-6) << name;
      EXPECT_FALSE(given.paths) << name;
      ++degenerate;
    } else {
      EXPECT_FALSE(given.degeneracy) << name;
      ASSERT_TRUE(given.paths) << name;
      const RegionCounts counts = map_of(*given.family, 30).counts();
      EXPECT_GT(counts.pairs - counts.types[static_cast<std::size_t>(LinkageType::degenerate)], 0) << name;
      ++solved;
    }
  }
  EXPECT_EQ(degenerate, 1);
  EXPECT_EQ(solved, 6);
}

TEST(TimedPathFamily, FivePositionsWithoutACrankSayWhy) {
  std::mt19937_64 random(2);
  int without = 0;
  for (int i = 0; i < 40 && without == 0; ++i) {
    const TaskFamily given = family_of_timed(random_task(random, {1, 1, 1, 1, 1}, false));
    if (!given.has_no_dyads) continue;
    ++without;
    EXPECT_EQ(given.degeneracy->code, "no_crank");
    EXPECT_EQ(given.pattern, "P-P-P-P-P");
    EXPECT_FALSE(given.paths);
  }
  EXPECT_EQ(without, 1);
}

TEST(TimedPathFamily, KnowsTheStretchesOfCranksInsideWindows) {
  const TaskFamily given = family_of_timed(testing::path_case("film_claw_timed").task);
  const PivotWindows windows{Box{20, 60, -60, 60}, {}};
  const auto arcs = given.family->arcs_within(Side::input, windows);
  ASSERT_TRUE(arcs);
  ASSERT_FALSE(arcs->arcs.empty());
  for (const AxisArc& arc : arcs->arcs) {
    const auto link = given.family->dyad(Side::input, (arc.from + arc.to) / 2);
    ASSERT_TRUE(link);
    const Point center = given.frame().to_user(*finite_point(link->center));
    EXPECT_TRUE((Box{20, 60, -60, 60}.contains(center)));
  }
  EXPECT_FALSE(given.family->arcs_within(Side::output, windows)) << "it depends on the crank";
}

}  // namespace
}  // namespace linkwright::timed_path_family_test
