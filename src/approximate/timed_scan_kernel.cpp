#include "approximate/timed_scan_lanes.hpp"

namespace linkwright {

void LINKWRIGHT_KERNEL(timed_scan_kernel)(TimedBlock& block) {
  LINKWRIGHT_ISA::timed_scan_kernel<LINKWRIGHT_LANES>(block);
}

}  // namespace linkwright
