#if defined(__x86_64__)
#define LINKWRIGHT_ISA isa_avx2
#include "robust/tolerance_error_lanes.hpp"

namespace linkwright {

void tolerance_error_kernel_avx2(ToleranceErrorBlock& block) {
  isa_avx2::tolerance_error::tolerance_error_kernel<4>(block);
}

}  // namespace linkwright
#endif
