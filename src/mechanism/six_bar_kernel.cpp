#include "six_bar_dyads.hpp"
#include "six_bar_strand.hpp"

namespace linkwright {

void LINKWRIGHT_KERNEL(dyad_kernel)(DyadLanes& lanes) { LINKWRIGHT_ISA::dyad_kernel<LINKWRIGHT_LANES>(lanes); }
void LINKWRIGHT_KERNEL(strand_kernel)(StrandLanes& lanes) { LINKWRIGHT_ISA::strand_kernel<LINKWRIGHT_LANES>(lanes); }
void LINKWRIGHT_KERNEL(dyad_middles_kernel)(DyadMiddles& middles) {
  LINKWRIGHT_ISA::dyad_middles_kernel<LINKWRIGHT_LANES>(middles);
}

}  // namespace linkwright
