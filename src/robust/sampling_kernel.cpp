#include "robust/draw_lanes.hpp"
#include "robust/sampling_lanes.hpp"
#include "robust/spherical_sampling_lanes.hpp"

namespace linkwright {

void LINKWRIGHT_KERNEL(draw_kernel)(DrawBlock& block) { LINKWRIGHT_ISA::draw::draw_kernel<LINKWRIGHT_LANES>(block); }
void LINKWRIGHT_KERNEL(sampling_kernel)(SamplingBlock& block) {
  LINKWRIGHT_ISA::sampling::sampling_kernel<LINKWRIGHT_LANES>(block);
}
void LINKWRIGHT_KERNEL(spherical_sampling_kernel)(SphericalSamplingBlock& block) {
  LINKWRIGHT_ISA::spherical_sampling::spherical_sampling_kernel<LINKWRIGHT_LANES>(block);
}

}  // namespace linkwright
