#include <algorithm>

#include "robust/block_sampler.hpp"
#include "robust/tangent.hpp"

namespace linkwright {
namespace {

void put(Vector3 from, double to[3]) {
  for (std::size_t axis = 0; axis < 3; ++axis) to[axis] = from[axis];
}

void set_position(const SphericalFourBar& bars, std::size_t j, SphericalSamplingBlock& block) {
  const auto& [g1, w1, w2, g2] = bars;
  put(tangent(g1, w1), block.input_direction[j]);
  block.assembly[j] = determinant(w1, w2, g2) < 0 ? -1 : 1;
  const Vector3 along = tangent(w1, w2), output = tangent(g2, w2), ground = tangent(g1, g2);
  put(w1, block.coupler[j][0]);
  put(along, block.coupler[j][1]);
  put(cross(w1, along), block.coupler[j][2]);
  block.output[j][0] = -dot(output, tangent(g2, g1));
  block.output[j][1] = dot(output, cross(g1, ground));
}

}  // namespace

std::unique_ptr<BlockSampler> block_sampler(const SphericalOutput& output, const Tolerances& tolerances, Simd simd) {
  auto made = std::make_unique<SphericalSamplingBlock>();
  SphericalSamplingBlock& block = *made;
  const SphericalFourBar& bars = output.positions.front();
  const LinkAngles angles = bars.angles();
  const SphericalValues arcs = {angles.input, angles.coupler, angles.output, angles.ground};
  std::copy_n(arcs.begin(), 4, block.arc);
  put(bars.input_fixed, block.fixed_axis);
  put(tangent(bars.input_fixed, bars.output_fixed), block.ground);
  block.of_output = output.kind == SphericalOutput::Kind::angle;
  block.positions = static_cast<int>(output.positions.size());
  for (std::size_t j = 0; j < output.positions.size(); ++j) set_position(output.positions[j], j, block);
  block.driver_errs = tolerances.driver > 0;
  if (tolerances.limit) block.limit_square = tolerances.limit->value * tolerances.limit->value;
  return std::make_unique<KernelSampler<SphericalSamplingBlock>>(std::move(made),
                                                                 spherical_sampling_kernel.for_simd(simd));
}

}  // namespace linkwright
