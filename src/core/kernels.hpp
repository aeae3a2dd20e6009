#pragma once

#include "linkwright/core/simd.hpp"

namespace linkwright {

/// One kernel as it is compiled for each instruction set (cmake/kernel_options.cmake).
template <class Kernel>
struct Kernels {
  Kernel scalar, baseline, avx2, avx512;

  [[nodiscard]] Kernel for_simd(Simd simd) const {
    switch (simd == Simd::automatic ? best_simd() : simd) {
      case Simd::scalar:
        return scalar;
      case Simd::avx2:
        return avx2;
      case Simd::avx512:
        return avx512;
      default:
        return baseline;
    }
  }
};

#if defined(__x86_64__)
#define LINKWRIGHT_DECLARE_KERNELS(name, Task) \
  void name##_scalar(Task);                    \
  void name##_baseline(Task);                  \
  void name##_avx2(Task);                      \
  void name##_avx512(Task);                    \
  inline constexpr Kernels<void (*)(Task)> name { name##_scalar, name##_baseline, name##_avx2, name##_avx512 }
#elif defined(__EMSCRIPTEN__)  // the page chooses none, and a kernel has the same bits whatever its width
#define LINKWRIGHT_DECLARE_KERNELS(name, Task) \
  void name##_baseline(Task);                  \
  inline constexpr Kernels<void (*)(Task)> name { name##_baseline, name##_baseline, name##_baseline, name##_baseline }
#else
#define LINKWRIGHT_DECLARE_KERNELS(name, Task) \
  void name##_scalar(Task);                    \
  void name##_baseline(Task);                  \
  inline constexpr Kernels<void (*)(Task)> name { name##_scalar, name##_baseline, name##_baseline, name##_baseline }
#endif

}  // namespace linkwright
