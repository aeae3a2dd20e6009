#define LINKWRIGHT_ISA isa_baseline
#include "spherical/spherical_kernel_rows.hpp"

namespace linkwright {

void spherical_kernel_baseline(const SphericalKernelTask& task) { isa_baseline::spherical_kernel<2>(task); }

}  // namespace linkwright
