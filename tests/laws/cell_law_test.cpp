// What a family says of one place its kernels say of the cell of a map: type, defects and every measure.

#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>
#include <variant>

#include "linkwright/files/problem_file.hpp"
#include "linkwright/synthesis/solve.hpp"

namespace linkwright::cell_law_test {
namespace {

struct Compared {
  int cells = 0, whole = 0, numbers = 0, apart = 0;
};

// Kernels write single precision; of straight lines they estimate, where a place is measured exactly or not at all.
constexpr double single = 1e-5, estimated = 1e-2;

bool agree(double one, double of_map, double within) {
  if (!std::isfinite(one)) return within == estimated || !std::isfinite(of_map);
  return std::abs(one - of_map) <= within * (std::abs(of_map) + 1e-3);
}

void compare(const LinkageFamily& family, const RegionMap& map, bool respect_direction, double within,
             Compared& compared) {
  const auto cell_at = family.cells(respect_direction);
  for (std::size_t row = 0; row < map.rows(); ++row)
    for (std::size_t column = 0; column < map.columns(); ++column) {
      const std::size_t there = map.index(row, column);
      const MapPoint place{map.input_coordinates()[row], map.output_coordinates()[column]};
      const auto cell = cell_at(place, [](const Cell&) { return true; });
      ++compared.cells;
      if (!cell && within == estimated) continue;
      ASSERT_EQ(cell ? cell->type : LinkageType::degenerate, map.type(there)) << row << ' ' << column;
      if (!cell) continue;
      ++compared.whole;
      EXPECT_EQ(cell->defects, map.defects(there)) << row << ' ' << column;
      EXPECT_NEAR(family.axis(Side::input).onto(cell->place.input), place.input, 1e-13);
      for (std::size_t i = 0; i < family.measures().size(); ++i) {
        const double of_map = static_cast<double>(map.values(family.measures()[i])[there]);
        const bool is_same = agree(cell->values[i], of_map, within);
        ++compared.numbers;
        compared.apart += is_same ? 0 : 1;
        EXPECT_TRUE(is_same || within == estimated)
            << family.measures()[i].key << ' ' << cell->values[i] << ' ' << of_map;
      }
    }
}

TEST(CellLaw, AgreesWithTheMapOfEveryKind) {
  for (const std::string name : {"tailgate",
                                 "landing_gear",
                                 "dump_bucket",
                                 "hood_hinge",
                                 "sine_generator",
                                 "log_generator",
                                 "loader_bucket_chain",
                                 "wrist_orthosis",
                                 "antenna_pointing",
                                 "universal_joint_like",
                                 "straight_stage",
                                 "straight_indicator",
                                 "straight_luffing_crane",
                                 "film_claw",
                                 "dough_mixer",
                                 "windscreen_wiper",
                                 "thread_take_up",
                                 "walking_leg_path",
                                 "packaging_feeder",
                                 "garage_door_point"}) {
    SCOPED_TRACE(name);
    auto problem = read_problem_file(std::filesystem::path(LINKWRIGHT_EXAMPLES_DIR) / (name + ".json"));
    ASSERT_TRUE(problem);
    problem->options.region_samples = 40;
    problem->options.best = 0;
    const auto answer = solve(*problem);
    ASSERT_TRUE(answer);
    const Findings& found = findings(*answer);
    const double within = std::holds_alternative<StraightLineAnswer>(*answer) ? estimated : single;
    Compared compared;
    std::visit(
        [&](const auto& of_kind) {
          ASSERT_TRUE(of_kind.family());
          compare(*of_kind.family(), found.region, found.requirements.respect_direction, within, compared);
        },
        *answer);
    EXPECT_GT(compared.whole, compared.cells / 20);
    EXPECT_LE(compared.apart, compared.numbers / 100);
  }
}

}  // namespace
}  // namespace linkwright::cell_law_test
