#include <algorithm>
#include <vector>

#include "linkwright/core/precondition.hpp"
#include "linkwright/spherical/five_orientations.hpp"
#include "spherical/dyad_order.hpp"
#include "spherical/five_orientation_kernel.hpp"

namespace linkwright {
namespace {

using OrientationBlock = FiveOrientationBlock;

SphericalDyads careful_dyads(const FiveOrientations& orientations) {
  std::vector<PrescribedOrientation> prescribed;
  for (const UnitQuaternion& there : orientations) prescribed.push_back({there, {}});
  const FiveOrientationDyads found = five_orientation_dyads(orientation_conditions(prescribed));
  SphericalDyads result;
  for (const SphericalDyadPoint& point : found.points) {
    const auto i = static_cast<std::size_t>(result.count++);
    result.dyads[i] = point.dyad;
    result.multiplicity[i] = point.multiplicity;
  }
  result.complex_roots = found.complex_roots;
  result.degenerate = found.degeneracy.has_value();
  return result;
}

/// The last task fills the lanes that are left.
void fill_block(OrientationBlock& block, std::span<const FiveOrientations> tasks) {
  for (std::size_t i = 0; i < OrientationBlock::size; ++i) {
    const FiveOrientations& orientations = tasks[std::min(i, tasks.size() - 1)];
    for (std::size_t j = 0; j < orientations.size(); ++j) {
      block.quaternion[j][0][i] = orientations[j].w();
      for (std::size_t axis = 0; axis < 3; ++axis) block.quaternion[j][axis + 1][i] = orientations[j].v()[axis];
    }
  }
}

SphericalDyads dyads_in(const OrientationBlock& block, std::size_t i) {
  SphericalDyads result;
  for (std::size_t place = 0; place < 6 && block.real[place][i]; ++place) {
    const auto axis = [&](const double(&numbers)[3][OrientationBlock::size]) {
      return Vector3{numbers[0][i], numbers[1][i], numbers[2][i]};
    };
    const SphericalDyad dyad = with_acute_link({axis(block.fixed[place]), axis(block.moving[place]), 0});
    auto to = result.dyads.begin() + result.count;
    for (; to != result.dyads.begin() && has_shorter_link(dyad, to[-1]); --to) *to = to[-1];
    *to = dyad;
    result.multiplicity[static_cast<std::size_t>(result.count++)] = 1;
  }
  result.complex_roots = 6 - result.count;
  for (int k = 0; k < result.count; ++k) result.dyads[static_cast<std::size_t>(k)].coordinate = k + 0.5;
  return result;
}

}  // namespace

void five_orientation_dyads_of_all(std::span<const FiveOrientations> tasks, std::span<SphericalDyads> dyads,
                                   Simd simd) {
  require(dyads.size() >= tasks.size(), "there is room for the dyads of each task");
  const auto kernel = five_orientation_kernel.for_simd(simd);
  OrientationBlock block;
  for (std::size_t begin = 0; begin < tasks.size(); begin += OrientationBlock::size) {
    const auto some = tasks.subspan(begin, std::min<std::size_t>(OrientationBlock::size, tasks.size() - begin));
    fill_block(block, some);
    kernel(block);
    for (std::size_t i = 0; i < some.size(); ++i)
      dyads[begin + i] = block.sure[i] ? dyads_in(block, i) : careful_dyads(some[i]);
  }
}

}  // namespace linkwright
