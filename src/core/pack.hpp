#pragma once

// Several doubles at once through the compilers' vector extensions (GCC, Clang, Emscripten): one source for every
// instruction set, and the same bits on all of them. A file that includes this defines LINKWRIGHT_ISA, a name of its
// own for the instruction set it is compiled for, so that the linker never mixes copies made for different machines.
// No standard library here, for the same reason.

#ifndef LINKWRIGHT_ISA
#error "define LINKWRIGHT_ISA before including pack.hpp"
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
  using Mask = bool;
  using Integer = long long;
  using Single = float;
  using Byte = unsigned char;
};

#define LINKWRIGHT_PACK(width)                                                     \
  template <>                                                                      \
  struct Pack<width> {                                                             \
    typedef double Real __attribute__((vector_size(8 * (width))));                 \
    typedef long long Mask __attribute__((vector_size(8 * (width))));              \
    typedef long long Integer __attribute__((vector_size(8 * (width))));           \
    typedef float Single __attribute__((vector_size(4 * (width))));                \
    typedef unsigned char Byte __attribute__((vector_size(width)));                \
  };
LINKWRIGHT_PACK(2)
LINKWRIGHT_PACK(4)
LINKWRIGHT_PACK(8)
#undef LINKWRIGHT_PACK

template <class Mask, class Value>
LINKWRIGHT_INLINE Value select(Mask mask, Value yes, Value no) {
  return mask ? yes : no;
}

template <class Mask>
LINKWRIGHT_INLINE Mask negated(Mask mask) {
  return mask == Mask{};
}

template <class Real>
LINKWRIGHT_INLINE Real smaller(Real a, Real b) {
  return a < b ? a : b;
}

template <class Real>
LINKWRIGHT_INLINE Real larger(Real a, Real b) {
  return a > b ? a : b;
}

template <int Width>
LINKWRIGHT_INLINE typename Pack<Width>::Real magnitude(typename Pack<Width>::Real a) {
  using Integer = typename Pack<Width>::Integer;
  const Integer bits = __builtin_bit_cast(Integer, a) & 0x7fff'ffff'ffff'ffffLL;
  return __builtin_bit_cast(typename Pack<Width>::Real, bits);
}

template <int Width>
LINKWRIGHT_INLINE typename Pack<Width>::Real square_root(typename Pack<Width>::Real a) {
  if constexpr (Width == 1) {
    return __builtin_sqrt(a);
  } else {
    typename Pack<Width>::Real root;
    for (int lane = 0; lane < Width; ++lane) root[lane] = __builtin_sqrt(a[lane]);
    return root;
  }
}

template <int Width, class To, class From>
LINKWRIGHT_INLINE To converted(From from) {
  if constexpr (Width == 1)
    return static_cast<To>(from);
  else
    return __builtin_convertvector(from, To);
}

template <int Width>
LINKWRIGHT_INLINE typename Pack<Width>::Real load(const double* from) {
  typename Pack<Width>::Real value;
  __builtin_memcpy(&value, from, sizeof value);
  return value;
}

}  // namespace linkwright::LINKWRIGHT_ISA
