#if defined(__x86_64__)
#define LINKWRIGHT_ISA isa_avx512
#include "straight_line/line_trace_lanes.hpp"

namespace linkwright {

void line_trace_kernel_avx512(LineTraceBlock& block) { isa_avx512::line_trace::line_trace_kernel<8>(block); }

}  // namespace linkwright
#endif
