#include <algorithm>
#include <vector>

#include "linkwright/core/precondition.hpp"
#include "linkwright/planar/burmester_points.hpp"
#include "planar/five_conditions.hpp"
#include "planar/five_pose_kernel.hpp"

namespace linkwright {
namespace {

BurmesterDyads careful(const FivePoses& poses) {
  std::vector<PrescribedPose> prescribed;
  for (const Pose& pose : poses) prescribed.push_back({pose, {}});
  const PoseConditions conditions = pose_conditions(prescribed);
  const BurmesterPoints found = burmester_points(conditions);
  BurmesterDyads result{.frame = conditions.frame};
  for (const BurmesterPoint& point : found.points) {
    const auto i = static_cast<std::size_t>(result.count++);
    result.dyads[i] = point.dyad;
    result.multiplicity[i] = point.multiplicity;
  }
  result.complex_roots = found.complex_roots;
  result.degenerate = found.degeneracy.has_value();
  return result;
}

using Block = FivePoseBlock;

/// The last task fills the lanes that are left.
void fill(Block& block, std::span<const FivePoses> tasks) {
  for (std::size_t i = 0; i < Block::size; ++i) {
    const FivePoses& poses = tasks[std::min(i, tasks.size() - 1)];
    for (std::size_t j = 0; j < poses.size(); ++j) {
      block.x[j][i] = poses[j].origin.real();
      block.y[j][i] = poses[j].origin.imag();
      block.angle[j][i] = poses[j].angle;
    }
  }
}

BurmesterDyads result_of(const Block& block, std::size_t i) {
  BurmesterDyads result{.frame = {{block.x[0][i], block.y[0][i]}, block.length[i]}};
  for (std::size_t place = 0; place < 4; ++place) {
    if (!block.real[place][i]) continue;
    const auto point = [&](const double(&numbers)[3][Block::size]) {
      return Homogeneous{numbers[0][i], numbers[1][i], numbers[2][i]};
    };
    const Dyad dyad{point(block.center[place]), point(block.circle[place]), 0};
    auto to = result.dyads.begin() + result.count;
    for (; to != result.dyads.begin() && comes_before(dyad, to[-1]); --to) *to = to[-1];
    *to = dyad;
    result.multiplicity[static_cast<std::size_t>(result.count++)] = 1;
  }
  result.complex_roots = 4 - result.count;
  for (int k = 0; k < result.count; ++k) result.dyads[static_cast<std::size_t>(k)].coordinate = k + 0.5;
  return result;
}

}  // namespace

void burmester_points_of_all(std::span<const FivePoses> tasks, std::span<BurmesterDyads> dyads, Simd simd) {
  require(dyads.size() >= tasks.size(), "there is room for the dyads of each task");
  const auto kernel = five_pose_kernel.for_simd(simd);
  Block block;
  for (std::size_t begin = 0; begin < tasks.size(); begin += Block::size) {
    const auto some = tasks.subspan(begin, std::min<std::size_t>(Block::size, tasks.size() - begin));
    fill(block, some);
    kernel(block);
    for (std::size_t i = 0; i < some.size(); ++i)
      dyads[begin + i] = block.sure[i] ? result_of(block, i) : careful(some[i]);
  }
}

}  // namespace linkwright
