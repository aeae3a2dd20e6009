#include "straight_line/line_trace_lanes.hpp"

namespace linkwright {

void LINKWRIGHT_KERNEL(line_trace_kernel)(LineTraceBlock& block) {
  LINKWRIGHT_ISA::line_trace::line_trace_kernel<LINKWRIGHT_LANES>(block);
}

}  // namespace linkwright
