#define LINKWRIGHT_ISA isa_scalar
#include "straight_line/line_trace_lanes.hpp"

namespace linkwright {

void line_trace_kernel_scalar(LineTraceBlock& block) { isa_scalar::line_trace::line_trace_kernel<1>(block); }

}  // namespace linkwright
