#define LINKWRIGHT_ISA isa_baseline
#include "analysis/six_bar_dyads.hpp"
#include "analysis/six_bar_strands.hpp"

namespace linkwright {

void dyad_kernel_baseline(DyadLanes& lanes) { isa_baseline::dyad_kernel<2>(lanes); }
void strand_kernel_baseline(StrandLanes& lanes) { isa_baseline::strand_kernel<2>(lanes); }
void dyad_middles_kernel_baseline(DyadMiddles& middles) { isa_baseline::dyad_middles_kernel<2>(middles); }

}  // namespace linkwright
