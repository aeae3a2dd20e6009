#if defined(__x86_64__)
#define LINKWRIGHT_ISA isa_avx2
#include "planar/four_bar_kernel_rows.hpp"

namespace linkwright {

void four_bar_kernel_avx2(const KernelTask& task) { isa_avx2::four_bar_kernel<4>(task); }

}  // namespace linkwright
#endif
