#include "linkwright/region/cell_judge.hpp"

#include <array>
#include <gtest/gtest.h>
#include <limits>

namespace linkwright::cell_judge_test {
namespace {

constexpr std::array kept = {measures::longest_link, measures::link_ratio, measures::min_transmission_angle};
constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

// Longest link 6, shortest 2, at 60°, between (0, 0) and (4, 0) on the ground.
Cell cell() {
  Cell cell{{LinkageType::crank_rocker, {}, {6, 3, versine_of_angle(radians(60))}}, {}};
  cell.pivots = {{{0, 0, 0}, {4, 0, 0}}, {{0, 2, 0}, {4, 3, 0}}};
  return cell;
}

std::vector<RequirementKind> failed(const Requirements& wanted, const Cell& of = cell(),
                                    const LinkageClass& linkages = planar_linkages) {
  const CellJudge judge(wanted, linkages, kept);
  return kinds_of(judge.failures(of), judge.kinds());
}
using Kinds = std::vector<RequirementKind>;

TEST(CellJudge, LetsPassWhatReachesItsLimits) {
  Requirements wanted;
  EXPECT_EQ(failed(wanted), Kinds{});
  wanted.max_length = 6;
  wanted.min_length = 2;
  wanted.max_link_ratio = 3;
  wanted.min_transmission_angle = radians(60);
  wanted.types = {LinkageType::double_crank, LinkageType::crank_rocker};
  wanted.ground_pivots_within = Box{0, 4, 0, 0};
  wanted.moving_pivots_within = Box{0, 4, 2, 3};
  EXPECT_EQ(failed(wanted), Kinds{});
}

TEST(CellJudge, NamesEachRequirementThatFails) {
  Requirements wanted;
  wanted.types = {LinkageType::double_crank};
  wanted.max_length = 5.9;
  wanted.min_length = 2.1;
  wanted.max_link_ratio = 2.9;
  wanted.min_transmission_angle = radians(61);
  wanted.ground_pivots_within = Box{0, 3.9, 0, 0};
  wanted.moving_pivots_within = Box{0, 4, 2.1, 3};
  EXPECT_EQ(failed(wanted),
            (Kinds{RequirementKind::types, RequirementKind::min_transmission_angle, RequirementKind::max_link_ratio,
                   RequirementKind::max_length, RequirementKind::min_length, RequirementKind::ground_pivots_within,
                   RequirementKind::moving_pivots_within}));
}

TEST(CellJudge, AFullTurnIsThatOfACrank) {
  Requirements wanted;
  wanted.full_turn = true;
  const auto failed_by = [&](LinkageType type) {
    Cell of_type = cell();
    of_type.type = type;
    return failed(wanted, of_type, path_linkages);
  };
  EXPECT_EQ(failed_by(LinkageType::crank_rocker), Kinds{});
  EXPECT_EQ(failed_by(LinkageType::double_crank), Kinds{});
  for (const LinkageType type : {LinkageType::rocker_crank, LinkageType::double_rocker, LinkageType::change_point,
                                 LinkageType::triple_rocker_input})
    EXPECT_EQ(failed_by(type), Kinds{RequirementKind::full_turn});
  wanted.types = {LinkageType::double_rocker};
  EXPECT_EQ(failed_by(LinkageType::crank_rocker), Kinds{RequirementKind::types});
  EXPECT_EQ(failed_by(LinkageType::rocker_crank), (Kinds{RequirementKind::types, RequirementKind::full_turn}));
  wanted = {};
  EXPECT_EQ(failed_by(LinkageType::rocker_crank), Kinds{});
}

TEST(CellJudge, HoldsNothingAgainstWhatIsNotKnownYet) {
  Requirements wanted;
  wanted.min_transmission_angle = radians(80);
  wanted.max_deviation = 1;
  wanted.min_stroke = 1;
  Cell unknown = cell();
  unknown.values[2] = not_known;
  EXPECT_TRUE(CellJudge(wanted, planar_linkages, kept).may_pass(unknown));
  EXPECT_EQ(failed(wanted, unknown), Kinds{RequirementKind::min_transmission_angle}) << "in the end";
  wanted.min_transmission_angle = 0;
  EXPECT_EQ(failed(wanted, cell(), straight_line_linkages), Kinds{}) << "measures that the cells do not hold";
}

TEST(CellJudge, LetsNoDefectPassWhereItCannotBeAskedFor) {
  Cell defective = cell();
  defective.defects = {Defects::order_bit};
  Requirements wanted;
  EXPECT_EQ(failed(wanted, defective), Kinds{RequirementKind::no_defects});
  wanted.no_defects = false;
  EXPECT_EQ(failed(wanted, defective), Kinds{});
  EXPECT_EQ(failed(wanted, defective, straight_line_linkages).size(), straight_line_linkages.requirements.size());
}

TEST(CellJudge, TakesADeadPointInAPositionForADefect) {
  Cell dead = cell();
  dead.values[2] = versine_of_angle(1e-7);
  Requirements wanted;
  EXPECT_EQ(failed(wanted, dead), Kinds{RequirementKind::no_defects});
  wanted.no_defects = false;
  EXPECT_EQ(failed(wanted, dead), Kinds{});
}

TEST(CellJudge, LetsNothingDegeneratePass) {
  Cell degenerate = cell();
  degenerate.type = LinkageType::degenerate;
  EXPECT_EQ(failed({}, degenerate).size(), planar_linkages.requirements.size());
}

}  // namespace
}  // namespace linkwright::cell_judge_test
