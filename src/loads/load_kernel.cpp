#include "loads/load_lanes.hpp"

namespace linkwright {

void LINKWRIGHT_KERNEL(load_tables_kernel)(LoadTables& tables) {
  LINKWRIGHT_ISA::load_lanes::fill_tables<LINKWRIGHT_LANES>(tables);
}

void LINKWRIGHT_KERNEL(load_kernel)(LoadRow& row) {
  LINKWRIGHT_ISA::load_lanes::fill_row(row);
  LINKWRIGHT_ISA::load_lanes::load_kernel<LINKWRIGHT_LANES>(row);
}

}  // namespace linkwright
