#if defined(__x86_64__)
#define LINKWRIGHT_ISA isa_avx512
#include "robust/draw_lanes.hpp"
#include "robust/sampling_lanes.hpp"
#include "robust/spherical_sampling_lanes.hpp"

namespace linkwright {

void draw_kernel_avx512(DrawBlock& block) { isa_avx512::draw::draw_kernel<8>(block); }
void sampling_kernel_avx512(SamplingBlock& block) { isa_avx512::sampling::sampling_kernel<8>(block); }
void spherical_sampling_kernel_avx512(SphericalSamplingBlock& block) {
  isa_avx512::spherical_sampling::spherical_sampling_kernel<8>(block);
}

}  // namespace linkwright
#endif
