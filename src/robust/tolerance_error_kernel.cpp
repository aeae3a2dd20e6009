#include "robust/tolerance_error_lanes.hpp"

namespace linkwright {

void LINKWRIGHT_KERNEL(tolerance_error_kernel)(ToleranceErrorBlock& block) {
  LINKWRIGHT_ISA::tolerance_error::tolerance_error_kernel<LINKWRIGHT_LANES>(block);
}

}  // namespace linkwright
