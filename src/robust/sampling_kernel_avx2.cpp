#if defined(__x86_64__)
#define LINKWRIGHT_ISA isa_avx2
#include "robust/draw_lanes.hpp"
#include "robust/sampling_lanes.hpp"
#include "robust/spherical_sampling_lanes.hpp"

namespace linkwright {

void draw_kernel_avx2(DrawBlock& block) { isa_avx2::draw::draw_kernel<4>(block); }
void sampling_kernel_avx2(SamplingBlock& block) { isa_avx2::sampling::sampling_kernel<4>(block); }
void spherical_sampling_kernel_avx2(SphericalSamplingBlock& block) {
  isa_avx2::spherical_sampling::spherical_sampling_kernel<4>(block);
}

}  // namespace linkwright
#endif
