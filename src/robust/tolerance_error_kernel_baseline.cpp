#define LINKWRIGHT_ISA isa_baseline
#include "robust/tolerance_error_lanes.hpp"

namespace linkwright {

void tolerance_error_kernel_baseline(ToleranceErrorBlock& block) {
  isa_baseline::tolerance_error::tolerance_error_kernel<2>(block);
}

}  // namespace linkwright
