#include "planar/four_bar_kernel_rows.hpp"

namespace linkwright {

void LINKWRIGHT_KERNEL(four_bar_kernel)(const KernelTask& task) {
  LINKWRIGHT_ISA::four_bar_kernel<LINKWRIGHT_LANES>(task);
}

}  // namespace linkwright
