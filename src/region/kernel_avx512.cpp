#if defined(__x86_64__)
#define LINKWRIGHT_ISA isa_avx512
#include "region/kernel_rows.hpp"

namespace linkwright {

void region_kernel_avx512(const KernelTask& task) { isa_avx512::region_kernel<8>(task); }

}  // namespace linkwright
#endif
