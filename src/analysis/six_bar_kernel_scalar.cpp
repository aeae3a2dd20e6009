#define LINKWRIGHT_ISA isa_scalar
#include "analysis/six_bar_dyads.hpp"
#include "analysis/six_bar_strands.hpp"

namespace linkwright {

void dyad_kernel_scalar(DyadLanes& lanes) { isa_scalar::dyad_kernel<1>(lanes); }
void strand_kernel_scalar(StrandLanes& lanes) { isa_scalar::strand_kernel<1>(lanes); }
void dyad_middles_kernel_scalar(DyadMiddles& middles) { isa_scalar::dyad_middles_kernel<1>(middles); }

}  // namespace linkwright
