#define LINKWRIGHT_ISA isa_scalar
#include "robust/draw_lanes.hpp"
#include "robust/sampling_lanes.hpp"
#include "robust/spherical_sampling_lanes.hpp"

namespace linkwright {

void draw_kernel_scalar(DrawBlock& block) { isa_scalar::draw::draw_kernel<1>(block); }
void sampling_kernel_scalar(SamplingBlock& block) { isa_scalar::sampling::sampling_kernel<1>(block); }
void spherical_sampling_kernel_scalar(SphericalSamplingBlock& block) {
  isa_scalar::spherical_sampling::spherical_sampling_kernel<1>(block);
}

}  // namespace linkwright
