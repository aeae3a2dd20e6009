#if defined(__x86_64__)
#define LINKWRIGHT_ISA isa_avx2
#include "straight_line/line_trace_lanes.hpp"

namespace linkwright {

void line_trace_kernel_avx2(LineTraceBlock& block) { isa_avx2::line_trace::line_trace_kernel<4>(block); }

}  // namespace linkwright
#endif
