#include "linkwright/planar/path_crank.hpp"

#include <algorithm>
#include <gtest/gtest.h>

#include "linkwright/planar/burmester_points.hpp"
#include "linkwright/planar/path_task.hpp"
#include "support/path_case.hpp"

namespace linkwright::path_crank_test {
namespace {

TEST(PathCrank, IsTheCrankOfTheCase) {
  const testing::PathCase c = testing::path_case("stirrer_timed_five");
  const PoseConditions conditions = pose_conditions(angled_poses(c.task));
  const BurmesterPoints found = burmester_points(conditions);
  for (const auto& crank : c.json.at("cranks")) {
    const auto is_it = [&](const BurmesterPoint& point) {
      const Dyad link = conditions.frame.to_user(crank_link(point.dyad));
      const auto center = finite_point(link.center), circle = finite_point(link.circle);
      const Point wanted_center{crank["center_point"][0], crank["center_point"][1]},
          wanted_circle{crank["moving_pivot"][0], crank["moving_pivot"][1]};
      return center && circle && std::abs(*center - wanted_center) < 1e-9 && std::abs(*circle - wanted_circle) < 1e-9;
    };
    EXPECT_EQ(std::count_if(found.points.begin(), found.points.end(), is_it), 1);
  }
}

TEST(PathCrank, KeepsWhatIsAtInfinity) {
  const Homogeneous there = Homogeneous::at_infinity({1, 2}), here = Homogeneous::of({3, 4});
  EXPECT_TRUE(is_at_infinity(crank_link({there, here, 0.5}).center));
  EXPECT_TRUE(is_at_infinity(crank_link({there, here, 0.5}).circle)) << "as long as it is far away";
  EXPECT_TRUE(is_at_infinity(crank_link({here, there, 0.5}).circle));
  EXPECT_EQ(crank_link({here, there, 0.5}).center, here);
  EXPECT_EQ(crank_link({here, there, 0.5}).coordinate, 0.5);
}

}  // namespace
}  // namespace linkwright::path_crank_test
