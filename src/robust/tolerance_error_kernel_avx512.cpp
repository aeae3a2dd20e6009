#if defined(__x86_64__)
#define LINKWRIGHT_ISA isa_avx512
#include "robust/tolerance_error_lanes.hpp"

namespace linkwright {

void tolerance_error_kernel_avx512(ToleranceErrorBlock& block) {
  isa_avx512::tolerance_error::tolerance_error_kernel<8>(block);
}

}  // namespace linkwright
#endif
