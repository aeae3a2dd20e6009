#include "linkwright/core/simd.hpp"

#include <array>
#include <cstddef>

namespace linkwright {
namespace {

constexpr std::array<std::string_view, 5> names = {"automatic", "scalar", "baseline", "avx2", "avx512"};

}  // namespace

std::string_view name(Simd simd) { return names[static_cast<std::size_t>(simd)]; }

bool is_supported(Simd simd) {
#if defined(__x86_64__)
  if (simd == Simd::avx2) return __builtin_cpu_supports("avx2");
  if (simd == Simd::avx512)
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl");
  return true;
#else
  return simd != Simd::avx2 && simd != Simd::avx512;
#endif
}

Simd best_simd() {
  for (const Simd simd : {Simd::avx512, Simd::avx2})
    if (is_supported(simd)) return simd;
  return Simd::baseline;
}

}  // namespace linkwright
