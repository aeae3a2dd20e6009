#define LINKWRIGHT_ISA isa_baseline
#include "robust/draw_lanes.hpp"
#include "robust/sampling_lanes.hpp"
#include "robust/spherical_sampling_lanes.hpp"

namespace linkwright {

void draw_kernel_baseline(DrawBlock& block) { isa_baseline::draw::draw_kernel<2>(block); }
void sampling_kernel_baseline(SamplingBlock& block) { isa_baseline::sampling::sampling_kernel<2>(block); }
void spherical_sampling_kernel_baseline(SphericalSamplingBlock& block) {
  isa_baseline::spherical_sampling::spherical_sampling_kernel<2>(block);
}

}  // namespace linkwright
