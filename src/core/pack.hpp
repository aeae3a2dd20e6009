#pragma once

// Several doubles at once through the compilers' vector extensions (GCC, Clang, Emscripten): one source for every
// instruction set, and the same bits on all of them. A file that includes this defines LINKWRIGHT_ISA, a name of its
// own for the instruction set it is compiled for, so that the linker never mixes copies made for different machines.
// No standard library here, for the same reason.

#ifndef LINKWRIGHT_ISA
#error "define LINKWRIGHT_ISA before including pack.hpp"
#endif

#if defined(__SSE2__)
#include <immintrin.h>
#elif defined(__wasm_simd128__)
#include <wasm_simd128.h>
#endif

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wpsabi"  // packs never cross a file
#endif

#define LINKWRIGHT_INLINE inline __attribute__((always_inline))

namespace linkwright::LINKWRIGHT_ISA {

template <int Width>
struct Pack;

template <>
struct Pack<1> {
  using Real = double;
  using Integer = long long;
  using Single = float;
};

#define LINKWRIGHT_PACK(width)                                           \
  template <>                                                            \
  struct Pack<width> {                                                   \
    typedef double Real __attribute__((vector_size(8 * (width))));       \
    typedef long long Integer __attribute__((vector_size(8 * (width)))); \
    typedef float Single __attribute__((vector_size(4 * (width))));      \
  };
LINKWRIGHT_PACK(2)
LINKWRIGHT_PACK(4)
LINKWRIGHT_PACK(8)
#undef LINKWRIGHT_PACK

/// Yes or no for each lane, a bit each, the first lane lowest. Logic on masks is thus left to the integer units, which
/// have nothing else to do, and "in no lane" is a comparison with zero.
using Mask = unsigned;

template <int Width>
inline constexpr Mask all_lanes = (1u << Width) - 1;

template <int Width>
LINKWRIGHT_INLINE Mask negated(Mask mask) {
  return mask ^ all_lanes<Width>;
}

/// Lanes whose sign bit is set. The instructions for it are named, since compilers do not find them.
template <int Width>
LINKWRIGHT_INLINE Mask sign_bits(typename Pack<Width>::Integer a) {
#if defined(__AVX512DQ__)
  if constexpr (Width == 8) return _mm512_movepi64_mask(__builtin_bit_cast(__m512i, a));
#endif
#if defined(__AVX__)
  if constexpr (Width == 4) return static_cast<Mask>(_mm256_movemask_pd(__builtin_bit_cast(__m256d, a)));
#endif
#if defined(__SSE2__)
  if constexpr (Width == 2) return static_cast<Mask>(_mm_movemask_pd(__builtin_bit_cast(__m128d, a)));
#elif defined(__wasm_simd128__)
  if constexpr (Width == 2) return wasm_i64x2_bitmask(__builtin_bit_cast(v128_t, a));
#endif
  if constexpr (Width == 1) {
    return a < 0;
  } else {
    Mask mask = 0;
    for (int lane = 0; lane < Width; ++lane) mask |= Mask{a[lane] < 0} << lane;
    return mask;
  }
}

/// Lanes below zero, or −0.
template <int Width>
LINKWRIGHT_INLINE Mask negative(typename Pack<Width>::Real a) {
  return sign_bits<Width>(__builtin_bit_cast(typename Pack<Width>::Integer, a));
}

template <int Width>
LINKWRIGHT_INLINE Mask less(typename Pack<Width>::Real a, typename Pack<Width>::Real b) {
#if defined(__AVX512DQ__)
  if constexpr (Width == 8)
    return _mm512_cmp_pd_mask(__builtin_bit_cast(__m512d, a), __builtin_bit_cast(__m512d, b), _CMP_LT_OQ);
#endif
  if constexpr (Width == 1)
    return a < b;
  else
    return sign_bits<Width>(a < b);
}

/// The value in the lanes of the mask, 0 in the others.
template <int Width>
LINKWRIGHT_INLINE typename Pack<Width>::Real where(Mask mask, typename Pack<Width>::Real value) {
  using Real = typename Pack<Width>::Real;
  using Integer = typename Pack<Width>::Integer;
#if defined(__AVX512DQ__)
  if constexpr (Width == 8)
    return __builtin_bit_cast(Real,
                              _mm512_maskz_mov_pd(static_cast<__mmask8>(mask), __builtin_bit_cast(__m512d, value)));
#endif
  if constexpr (Width == 1) {
    return mask ? value : 0.0;
  } else {
    Integer bit_of_lane;
    for (int lane = 0; lane < Width; ++lane) bit_of_lane[lane] = 1LL << lane;
    const Integer chosen = ((Integer{} + mask) & bit_of_lane) != 0;
    return __builtin_bit_cast(Real, __builtin_bit_cast(Integer, value) & chosen);
  }
}

template <int Width>
LINKWRIGHT_INLINE typename Pack<Width>::Real select(Mask mask, typename Pack<Width>::Real yes,
                                                    typename Pack<Width>::Real no) {
  return where<Width>(mask, yes) + where<Width>(negated<Width>(mask), no);
}

/// A byte for each lane, the first lane lowest: 1 in the lanes of the mask.
template <int Width>
LINKWRIGHT_INLINE unsigned long long bytes(Mask mask) {
  constexpr static unsigned of_four[16] = {0x0000'0000, 0x0000'0001, 0x0000'0100, 0x0000'0101, 0x0001'0000, 0x0001'0001,
                                           0x0001'0100, 0x0001'0101, 0x0100'0000, 0x0100'0001, 0x0100'0100, 0x0100'0101,
                                           0x0101'0000, 0x0101'0001, 0x0101'0100, 0x0101'0101};
  if constexpr (Width <= 4)
    return of_four[mask];
  else
    return of_four[mask & 15] | static_cast<unsigned long long>(of_four[mask >> 4]) << 32;
}

template <class Real>
LINKWRIGHT_INLINE Real smaller(Real a, Real b) {
  return a < b ? a : b;
}

template <class Real>
LINKWRIGHT_INLINE Real larger(Real a, Real b) {
  return a < b ? b : a;
}

template <int Width>
LINKWRIGHT_INLINE typename Pack<Width>::Real magnitude(typename Pack<Width>::Real a) {
  using Integer = typename Pack<Width>::Integer;
  const Integer bits = __builtin_bit_cast(Integer, a) & 0x7fff'ffff'ffff'ffffLL;
  return __builtin_bit_cast(typename Pack<Width>::Real, bits);
}

template <int Width>
LINKWRIGHT_INLINE typename Pack<Width>::Real square_root(typename Pack<Width>::Real a) {
  using Real = typename Pack<Width>::Real;
#if defined(__wasm_simd128__)
  if constexpr (Width == 2) return __builtin_bit_cast(Real, wasm_f64x2_sqrt(__builtin_bit_cast(v128_t, a)));
#endif
  if constexpr (Width == 1) {
    return __builtin_sqrt(a);
  } else {
    Real root;
    for (int lane = 0; lane < Width; ++lane) root[lane] = __builtin_sqrt(a[lane]);
    return root;
  }
}

template <int Width>
LINKWRIGHT_INLINE typename Pack<Width>::Single single(typename Pack<Width>::Real from) {
  using Single = typename Pack<Width>::Single;
  if constexpr (Width == 1)
    return static_cast<float>(from);
  else
    return __builtin_convertvector(from, Single);
}

template <int Width>
LINKWRIGHT_INLINE typename Pack<Width>::Real load(const double* from) {
  typename Pack<Width>::Real value;
  __builtin_memcpy(&value, from, sizeof value);
  return value;
}

/// A value to each lane's place, the first lane first; `Lane` may be a byte out of `bytes`.
template <int Width, class Value, class Lane>
LINKWRIGHT_INLINE void store(const Value& value, Lane* to) {
  static_assert(Width * sizeof(Lane) <= sizeof value);
  static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "the first lane is the lowest byte");
  __builtin_memcpy(to, &value, Width * sizeof(Lane));
}

}  // namespace linkwright::LINKWRIGHT_ISA
