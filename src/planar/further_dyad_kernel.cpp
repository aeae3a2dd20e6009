#include "planar/further_dyad_lanes.hpp"

namespace linkwright {

void LINKWRIGHT_KERNEL(further_dyad_kernel)(FurtherDyadBlock& block) {
  LINKWRIGHT_ISA::further_dyad_kernel<LINKWRIGHT_LANES>(block);
}

}  // namespace linkwright
