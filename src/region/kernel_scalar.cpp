#define LINKWRIGHT_ISA isa_scalar
#include "region/kernel_rows.hpp"

namespace linkwright {

void region_kernel_scalar(const KernelTask& task) { isa_scalar::region_kernel<1>(task); }

}  // namespace linkwright
