#if defined(__x86_64__)
#define LINKWRIGHT_ISA isa_avx2
#include "region/kernel_rows.hpp"

namespace linkwright {

void region_kernel_avx2(const KernelTask& task) { isa_avx2::region_kernel<4>(task); }

}  // namespace linkwright
#endif
