#include "approximate/dyad_scan_lanes.hpp"

namespace linkwright {

void LINKWRIGHT_KERNEL(dyad_scan_kernel)(DyadBlock& block) {
  LINKWRIGHT_ISA::dyad_scan_kernel<LINKWRIGHT_LANES>(block);
}

}  // namespace linkwright
