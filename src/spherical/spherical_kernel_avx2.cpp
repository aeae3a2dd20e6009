#if defined(__x86_64__)
#define LINKWRIGHT_ISA isa_avx2
#include "spherical/spherical_kernel_rows.hpp"

namespace linkwright {

void spherical_kernel_avx2(const SphericalKernelTask& task) { isa_avx2::spherical_kernel<4>(task); }

}  // namespace linkwright
#endif
