#if defined(__x86_64__)
#define LINKWRIGHT_ISA isa_avx512
#include "spherical/spherical_kernel_rows.hpp"

namespace linkwright {

void spherical_kernel_avx512(const SphericalKernelTask& task) { isa_avx512::spherical_kernel<8>(task); }

}  // namespace linkwright
#endif
