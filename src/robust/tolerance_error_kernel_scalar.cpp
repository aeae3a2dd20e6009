#define LINKWRIGHT_ISA isa_scalar
#include "robust/tolerance_error_lanes.hpp"

namespace linkwright {

void tolerance_error_kernel_scalar(ToleranceErrorBlock& block) {
  isa_scalar::tolerance_error::tolerance_error_kernel<1>(block);
}

}  // namespace linkwright
