#if defined(__x86_64__)
#define LINKWRIGHT_ISA isa_avx2
#include "analysis/six_bar_dyads.hpp"
#include "analysis/six_bar_strands.hpp"

namespace linkwright {

void dyad_kernel_avx2(DyadLanes& lanes) { isa_avx2::dyad_kernel<4>(lanes); }
void strand_kernel_avx2(StrandLanes& lanes) { isa_avx2::strand_kernel<4>(lanes); }
void dyad_middles_kernel_avx2(DyadMiddles& middles) { isa_avx2::dyad_middles_kernel<4>(middles); }

}  // namespace linkwright
#endif
