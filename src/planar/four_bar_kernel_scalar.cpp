#define LINKWRIGHT_ISA isa_scalar
#include "planar/four_bar_kernel_rows.hpp"

namespace linkwright {

void four_bar_kernel_scalar(const KernelTask& task) { isa_scalar::four_bar_kernel<1>(task); }

}  // namespace linkwright
