#define LINKWRIGHT_ISA isa_baseline
#include "planar/four_bar_kernel_rows.hpp"

namespace linkwright {

void four_bar_kernel_baseline(const KernelTask& task) { isa_baseline::four_bar_kernel<2>(task); }

}  // namespace linkwright
