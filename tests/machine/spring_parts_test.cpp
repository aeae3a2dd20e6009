#include "machine/spring_parts.hpp"

#include <gtest/gtest.h>
#include <map>
#include <set>
#include <variant>

#include "loads/carried.hpp"
#include "support/file_support.hpp"
#include "support/solved.hpp"

namespace linkwright::spring_parts_test {
namespace {

/// The tailgate on two struts as it is listed first.
struct Tailgate {
  Machine made;
  LinkageLoads on;
};

Tailgate tailgate() {
  const Problem problem = testing::example("tailgate_struts.json", 60);
  const StoredLinkage stored = std::get<StoredLinkage>(stored_linkages(problem, testing::answer_of(problem)).front());
  return {machine(moving_linkage(stored), {}).value(), {*problem.options.loads, stored.four_bar, stored.poses}};
}

Point middle(Vector3 point) { return {point.x, point.y}; }

TEST(SpringParts, StudsStandWhereTheFileSaysAndMoveWithTheirBodies) {
  const auto [made, on] = tailgate();
  std::map<std::string, Part> parts;
  for (const Part& part : spring_parts(made, on, 0)) parts[part.name] = part;
  const Part &from = parts.at("stud_strut_from"), &to = parts.at("stud_strut_to");
  EXPECT_EQ(from.body, 0);
  EXPECT_EQ(to.body, 2);
  EXPECT_LT(std::abs(middle(std::get<RoundPin>(from.shape).from) - Point{150, 115}), 1e-12);
  EXPECT_LT(std::abs(middle(std::get<RoundPin>(to.shape).to) - Point{60, 298}), 1e-12);
  EXPECT_DOUBLE_EQ(std::get<RoundPin>(to.shape).from.z, std::get<FlatPlate>(made.parts[2].shape).low);
}

TEST(SpringParts, AGasSpringReachesFromStudToStudInEveryPosition) {
  const auto [made, on] = tailgate();
  const double stud = made.sizes.pin / 2;
  for (int position = 0; position < made.linkage.positions; ++position) {
    std::map<std::string, RoundPin> parts;
    for (const Part& part : spring_parts(made, on, position)) parts[part.name] = std::get<RoundPin>(part.shape);
    const Pose& pose = on.poses[static_cast<std::size_t>(position)].pose;
    const Point ground{150, 115}, body = frame_of(LoadedBody::body, on.bars, pose).place({60, 298});
    const double length = std::abs(body - ground);
    const RoundPin &tube = parts.at("strut_tube"), &rod = parts.at("strut_rod");
    const Point along = (body - ground) / length;
    EXPECT_LT(std::abs(middle(tube.to) - (body - stud * along)), 1e-6) << position;
    EXPECT_LT(std::abs(middle(rod.from) - (ground + stud * along)), 1e-6) << position;
    EXPECT_NEAR(norm(tube.to - tube.from), 325 - 128 - 3 * stud, 1e-9);
    EXPECT_NEAR(norm(rod.to - rod.from), length - (325 - 128) + stud, 1e-6);
    EXPECT_NEAR(norm(rod.to - tube.from), 0, 1e-12);
    EXPECT_DOUBLE_EQ(rod.radius, 4);
    EXPECT_GT(tube.from.z - tube.radius, made.sizes.pitch() * 2) << "above the layers";
  }
  EXPECT_TRUE(spring_parts(made, on, 9).empty());
}

TEST(SpringParts, OfTorsionSpringsThereIsNothing) {
  auto [made, on] = tailgate();
  on.loads.springs = {{"", 1, {}, {}, TorsionSpring{}}};
  EXPECT_TRUE(spring_parts(made, on, 0).empty());
  on.loads.drive = LoadDrive::cylinder;
  on.loads.cylinder = {{LoadedBody::ground, {0, 0}}, {LoadedBody::input, {50, 0}}};
  const auto studs = spring_parts(made, on, 0);
  ASSERT_EQ(studs.size(), 2U);
  EXPECT_EQ(studs[1].name, "stud_cylinder_to");
  EXPECT_EQ(studs[1].body, 1);
}

// A spring without a name is told by its number, which another may be called.
TEST(SpringParts, NoTwoPartsHaveOneName) {
  auto [made, on] = tailgate();
  Spring unnamed = on.loads.springs.front(), named = unnamed, other = unnamed;
  unnamed.name = "";
  named.name = "spring_1";
  other.name = "cylinder";
  on.loads.springs = {unnamed, named, other};
  on.loads.drive = LoadDrive::cylinder;
  on.loads.cylinder = {{LoadedBody::ground, {0, 0}}, {LoadedBody::input, {50, 0}}};
  std::set<std::string> names;
  const std::vector<Part> parts = spring_parts(made, on, 0);
  for (const Part& part : parts) names.insert(part.name);
  EXPECT_EQ(parts.size(), 3U * 4 + 2);
  EXPECT_EQ(names.size(), parts.size());
}

}  // namespace
}  // namespace linkwright::spring_parts_test
