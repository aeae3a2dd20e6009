#define LINKWRIGHT_ISA isa_scalar
#include "spherical/spherical_kernel_rows.hpp"

namespace linkwright {

void spherical_kernel_scalar(const SphericalKernelTask& task) { isa_scalar::spherical_kernel<1>(task); }

}  // namespace linkwright
