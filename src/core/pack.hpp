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

/// The magnitude of one value and the sign of another.
template <int Width>
LINKWRIGHT_INLINE typename Pack<Width>::Real with_sign_of(typename Pack<Width>::Real size,
                                                          typename Pack<Width>::Real sign) {
  using Integer = typename Pack<Width>::Integer;
  constexpr long long others = 0x7fff'ffff'ffff'ffffLL;
  const Integer bits = (__builtin_bit_cast(Integer, size) & others) | (__builtin_bit_cast(Integer, sign) & ~others);
  return __builtin_bit_cast(typename Pack<Width>::Real, bits);
}

/// Within 3.2 %, for a > 0: by a third of the bits, which grow about as the logarithm does.
template <int Width>
LINKWRIGHT_INLINE typename Pack<Width>::Real cube_root_estimate(typename Pack<Width>::Real a) {
  using Real = typename Pack<Width>::Real;
  using Integer = typename Pack<Width>::Integer;
  constexpr double two_thirds_of_bias = 0x2a9f'75e8p32;  // least error
  if constexpr (Width == 1) {
    const double bits = static_cast<double>(__builtin_bit_cast(Integer, a));
    return __builtin_bit_cast(Real, static_cast<Integer>(bits / 3 + two_thirds_of_bias));
  } else {
    const Real bits = __builtin_convertvector(__builtin_bit_cast(Integer, a), Real);
    return __builtin_bit_cast(Real, __builtin_convertvector(bits / 3.0 + two_thirds_of_bias, Integer));
  }
}

template <int Width>
struct SineCosine {
  typename Pack<Width>::Real sine, cosine;
};

/// Within 1.5 units of the last place for |angle| ≤ 1e5 rad: a multiple of π/2 in three parts is taken away (W. J.
/// Cody, W. Waite, Software Manual for the Elementary Functions, 1980), the rest goes into the polynomials of FDLIBM
/// (Sun Microsystems, 1993: k_sin.c, k_cos.c).
template <int Width>
LINKWRIGHT_INLINE SineCosine<Width> sine_cosine(typename Pack<Width>::Real angle) {
  using Real = typename Pack<Width>::Real;
  using Integer = typename Pack<Width>::Integer;
  constexpr double to_integer = 0x1.8p52;  // added, it leaves the nearest integer in the lowest bits
  const Real shifted = angle * 0x1.45f306dc9c883p-1 + to_integer;
  const Real turns = shifted - to_integer;
  const Real x = ((angle - turns * 0x1.921fb544p0) - turns * 0x1.0b4611a6p-34) - turns * 0x1.3198a2e037073p-69;
  const Real z = x * x;
  const Real sine_tail =
      -0x1.5555555555549p-3 +
      z * (0x1.111111110f8a6p-7 +
           z * (-0x1.a01a019c161d5p-13 +
                z * (0x1.71de357b1fe7dp-19 + z * (-0x1.ae5e68a2b9cebp-26 + z * 0x1.5d93a5acfd57cp-33))));
  const Real cosine_tail =
      0x1.555555555554cp-5 +
      z * (-0x1.6c16c16c15177p-10 +
           z * (0x1.a01a019cb159p-16 +
                z * (-0x1.27e4f809c52adp-22 + z * (0x1.1ee9ebdb4b1c4p-29 + z * -0x1.8fae9be8838d4p-37))));
  const Real half = z * 0.5, rest = 1.0 - half;
  const Real sine = x + x * (z * sine_tail);
  const Real cosine = rest + (((1.0 - rest) - half) + z * (z * cosine_tail));
  const Integer quarter = __builtin_bit_cast(Integer, shifted);
  const Integer swap = Integer{} - (quarter & 1);  // all bits where sine and cosine change places
  const Integer s = __builtin_bit_cast(Integer, sine), c = __builtin_bit_cast(Integer, cosine);
  constexpr long long sign = ~0x7fff'ffff'ffff'ffffLL;
  return {__builtin_bit_cast(Real, ((s & ~swap) | (c & swap)) ^ ((quarter << 62) & sign)),
          __builtin_bit_cast(Real, ((c & ~swap) | (s & swap)) ^ (((quarter + 1) << 62) & sign))};
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

/// Lanes in which no decision was close.
template <int Width>
struct Certainty {
  Mask sure = all_lanes<Width>;

  /// Of a pack of sizes, in the lanes of `where`. NaN is never large enough.
  LINKWRIGHT_INLINE void demand(typename Pack<Width>::Real size, double least, Mask where = all_lanes<Width>) {
    sure &= less<Width>(typename Pack<Width>::Real{} + least, size) | negated<Width>(where);
  }
};

}  // namespace linkwright::LINKWRIGHT_ISA
