#define LINKWRIGHT_ISA isa_baseline
#include "straight_line/line_trace_lanes.hpp"

namespace linkwright {

void line_trace_kernel_baseline(LineTraceBlock& block) { isa_baseline::line_trace::line_trace_kernel<2>(block); }

}  // namespace linkwright
