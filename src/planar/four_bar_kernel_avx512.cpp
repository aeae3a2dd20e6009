#if defined(__x86_64__)
#define LINKWRIGHT_ISA isa_avx512
#include "planar/four_bar_kernel_rows.hpp"

namespace linkwright {

void four_bar_kernel_avx512(const KernelTask& task) { isa_avx512::four_bar_kernel<8>(task); }

}  // namespace linkwright
#endif
