#include "spherical/spherical_kernel_rows.hpp"

namespace linkwright {

void LINKWRIGHT_KERNEL(spherical_kernel)(const SphericalKernelTask& task) {
  LINKWRIGHT_ISA::spherical_kernel<LINKWRIGHT_LANES>(task);
}

}  // namespace linkwright
