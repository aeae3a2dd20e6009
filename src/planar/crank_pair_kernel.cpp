#include "planar/crank_pair_rows.hpp"

namespace linkwright {

void LINKWRIGHT_KERNEL(crank_pair_kernel)(const CrankPairTask& task) {
  LINKWRIGHT_ISA::crank_pair_kernel<LINKWRIGHT_LANES>(task);
}

}  // namespace linkwright
