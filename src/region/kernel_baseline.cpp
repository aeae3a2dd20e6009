#define LINKWRIGHT_ISA isa_baseline
#include "region/kernel_rows.hpp"

namespace linkwright {

void region_kernel_baseline(const KernelTask& task) { isa_baseline::region_kernel<2>(task); }

}  // namespace linkwright
