#if defined(__x86_64__)
#define LINKWRIGHT_ISA isa_avx512
#include "analysis/six_bar_dyads.hpp"
#include "analysis/six_bar_strands.hpp"

namespace linkwright {

void dyad_kernel_avx512(DyadLanes& lanes) { isa_avx512::dyad_kernel<8>(lanes); }
void strand_kernel_avx512(StrandLanes& lanes) { isa_avx512::strand_kernel<8>(lanes); }
void dyad_middles_kernel_avx512(DyadMiddles& middles) { isa_avx512::dyad_middles_kernel<8>(middles); }

}  // namespace linkwright
#endif
