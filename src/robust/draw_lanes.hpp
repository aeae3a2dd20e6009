#pragma once

// Random numbers, one sample to each lane: a sample's depend on the seed and its number alone, whoever draws them.

#include "core/pack.hpp"
#include "robust/sampling_kernel.hpp"

namespace linkwright::LINKWRIGHT_ISA::draw {

template <int Width>
using Real = typename Pack<Width>::Real;
template <int Width>
using Integer = typename Pack<Width>::Integer;

constexpr long long low_half = 0xffff'ffffLL;

/// Of the low halves of each lane, all 64 bits. Compilers do not see that the high halves play no part.
template <int Width>
LINKWRIGHT_INLINE Integer<Width> product_of_halves(Integer<Width> a, Integer<Width> b) {
#if defined(__AVX512F__)
  if constexpr (Width == 8)
    return __builtin_bit_cast(
        Integer<Width>, _mm512_maskz_mul_epu32(0xff, __builtin_bit_cast(__m512i, a), __builtin_bit_cast(__m512i, b)));
#endif
#if defined(__AVX2__)
  if constexpr (Width == 4)
    return __builtin_bit_cast(Integer<Width>,
                              _mm256_mul_epu32(__builtin_bit_cast(__m256i, a), __builtin_bit_cast(__m256i, b)));
#endif
#if defined(__SSE2__)
  if constexpr (Width == 2)
    return __builtin_bit_cast(Integer<Width>,
                              _mm_mul_epu32(__builtin_bit_cast(__m128i, a), __builtin_bit_cast(__m128i, b)));
#endif
  if constexpr (Width == 1)
    return static_cast<long long>(static_cast<unsigned long long>(a & low_half) *
                                  static_cast<unsigned long long>(b & low_half));
  else
    return (a & low_half) * (b & low_half);
}

/// Four numbers of 32 bits, the low halves of the lanes; what stands above them is void.
template <int Width>
struct Words {
  Integer<Width> word[4];
};

/// Philox4x32-10 (J. K. Salmon, M. A. Moraes, R. O. Dror, D. E. Shaw, "Parallel random numbers: as easy as 1, 2, 3",
/// SC11, 2011).
template <int Width>
LINKWRIGHT_INLINE Words<Width> philox(Words<Width> counter, unsigned key0, unsigned key1) {
  const Integer<Width> none{};
  auto [x0, x1, x2, x3] = counter.word;
  for (int round = 0; round < 10; ++round) {
    const Integer<Width> p0 = product_of_halves<Width>(x0, none + 0xd251'1f53LL);
    const Integer<Width> p1 = product_of_halves<Width>(x2, none + 0xcd9e'8d57LL);
    x0 = (p1 >> 32) ^ x1 ^ (none + static_cast<long long>(key0));
    x1 = p1;
    x2 = (p0 >> 32) ^ x3 ^ (none + static_cast<long long>(key1));
    x3 = p0;
    key0 += 0x9e37'79b9u;
    key1 += 0xbb67'ae85u;
  }
  return {{x0, x1, x2, x3}};
}

/// The middle of one of 2³² equal parts of (0, 1).
template <int Width>
LINKWRIGHT_INLINE Real<Width> fraction(Integer<Width> word) {
  constexpr long long bits_of_2_to_52 = 0x4330'0000'0000'0000LL;
  const Real<Width> shifted = __builtin_bit_cast(Real<Width>, (word & low_half) | bits_of_2_to_52);
  return (shifted - (0x1p52 - 0.5)) * 0x1p-32;
}

/// Within a unit of the last place, for normal numbers > 0: the method and the polynomial of FDLIBM (Sun Microsystems,
/// 1993: e_log.c), with one reduction for all.
template <int Width>
LINKWRIGHT_INLINE Real<Width> logarithm(Real<Width> a) {
  constexpr long long bits_of_1 = 0x3ff0'0000'0000'0000LL, bits_of_root_half = 0x3fe6'a09e'667f'3bcdLL;
  constexpr long long bits_of_2_to_52 = 0x4330'0000'0000'0000LL, mantissa = 0x000f'ffff'ffff'ffffLL;
  const Integer<Width> bits = __builtin_bit_cast(Integer<Width>, a) + (bits_of_1 - bits_of_root_half);
  const Integer<Width> rest = (bits & mantissa) + bits_of_root_half;
  // The exponent counts from 1023, so that it is no negative number.
  const Real<Width> exponent =
      __builtin_bit_cast(Real<Width>, ((bits >> 52) & 0x7ff) | bits_of_2_to_52) - (0x1p52 + 1023.0);
  const Real<Width> f = __builtin_bit_cast(Real<Width>, rest) - 1.0;
  const Real<Width> s = f / (2.0 + f), z = s * s, half = 0.5 * f * f;
  const Real<Width> tail = z * (6.666666666666735130e-01 +
                                z * (3.999999999940941908e-01 +
                                     z * (2.857142874366239149e-01 +
                                          z * (2.222219843214978396e-01 +
                                               z * (1.818357216161805012e-01 +
                                                    z * (1.531383769920937332e-01 + z * 1.479819860511658591e-01))))));
  return exponent * 6.93147180369123816490e-01 -
         ((half - (s * (half + tail) + exponent * 1.90821492927058770002e-10)) - f);
}

template <int Width>
struct Pair {
  Real<Width> a, b;
};

constexpr double two_pi = 0x1.921fb54442d18p2;

/// Two independent normal numbers, σ = 1 (G. E. P. Box, M. E. Muller, Ann. Math. Stat. 29, 1958).
template <int Width>
LINKWRIGHT_INLINE Pair<Width> normal_pair(Integer<Width> first, Integer<Width> second) {
  const Real<Width> radius = square_root<Width>(-2.0 * logarithm<Width>(fraction<Width>(first)));
  const auto turn = sine_cosine<Width>(two_pi * fraction<Width>(second));
  return {radius * turn.cosine, radius * turn.sine};
}

/// One coordinate of a point that lies anywhere in the unit disc, evenly.
template <int Width>
LINKWRIGHT_INLINE Real<Width> in_disc(Integer<Width> first, Integer<Width> second) {
  return square_root<Width>(fraction<Width>(first)) * sine_cosine<Width>(two_pi * fraction<Width>(second)).cosine;
}

/// The samples of the lanes and who draws them.
template <int Width>
struct Stream {
  Integer<Width> low, high;  ///< halves of the samples' numbers
  unsigned key0 = 0, key1 = 0;

  LINKWRIGHT_INLINE Words<Width> words(int block, int attempt) const {
    const Integer<Width> none{};
    return philox<Width>({{low, high, none + static_cast<long long>(block), none + static_cast<long long>(attempt)}},
                         key0, key1);
  }
};

/// Puts others in the place of numbers beyond ± 3, one lane at a time, by further attempts of the sample's own.
template <int Width>
LINKWRIGHT_INLINE void sort_out(const Stream<Width>& stream, int block, Pair<Width> pair[2]) {
  const auto beyond = [](Real<Width> z) { return negative<Width>(3.0 - magnitude<Width>(z)); };
  Mask bad[4];
  const auto judge = [&] {
    for (int k = 0; k < 2; ++k) {
      bad[2 * k] = beyond(pair[k].a);
      bad[2 * k + 1] = beyond(pair[k].b);
    }
    return bad[0] | bad[1] | bad[2] | bad[3];
  };
  for (int attempt = 1; judge(); ++attempt) {
    const Words<Width> words = stream.words(block, attempt);
    for (int k = 0; k < 2; ++k) {
      const Pair<Width> other = normal_pair<Width>(words.word[2 * k], words.word[2 * k + 1]);
      pair[k].a = select<Width>(bad[2 * k], other.a, pair[k].a);
      pair[k].b = select<Width>(bad[2 * k + 1], other.b, pair[k].b);
    }
  }
}

/// Four numbers of half tolerance one; only the first two where no others are wanted.
template <int Width>
LINKWRIGHT_INLINE void draw_four(const Stream<Width>& stream, int block, DrawBlock::Distribution distribution, bool all,
                                 Real<Width> four[4]) {
  const Words<Width> words = stream.words(block, 0);
  if (distribution == DrawBlock::uniform) {
    for (int k = 0; k < 4; ++k) four[k] = 2.0 * fraction<Width>(words.word[k]) - 1.0;
    return;
  }
  Pair<Width> pair[2] = {normal_pair<Width>(words.word[0], words.word[1]), {}};
  if (all) pair[1] = normal_pair<Width>(words.word[2], words.word[3]);
  if (distribution == DrawBlock::truncated_normal) sort_out<Width>(stream, block, pair);
  four[0] = pair[0].a * (1.0 / 3);
  four[1] = pair[0].b * (1.0 / 3);
  four[2] = pair[1].a * (1.0 / 3);
  four[3] = pair[1].b * (1.0 / 3);
}

template <int Width>
LINKWRIGHT_INLINE void draw_lanes(DrawBlock& block, int at) {
  Stream<Width> stream{{}, {}, static_cast<unsigned>(block.seed), static_cast<unsigned>(block.seed >> 32)};
  long long low[Width], high[Width];
  for (int lane = 0; lane < Width; ++lane) {
    const unsigned long long number = block.first + static_cast<unsigned long long>(at + lane);
    low[lane] = static_cast<long long>(number & low_half);
    high[lane] = static_cast<long long>(number >> 32);
  }
  __builtin_memcpy(&stream.low, low, sizeof low);
  __builtin_memcpy(&stream.high, high, sizeof high);
  const int blocks = (block.parameters + 3) / 4;
  Real<Width> drawn[DrawBlock::most_parameters] = {};
  for (int b = 0; b < blocks; ++b) {
    const auto wanted = [&](int i) { return i < block.parameters && block.half_tolerance[i] > 0; };
    const bool last = wanted(4 * b + 2) || wanted(4 * b + 3);
    if (last || wanted(4 * b) || wanted(4 * b + 1))
      draw_four<Width>(stream, b, block.distribution, last, drawn + 4 * b);
  }
  for (int i = 0; i < block.parameters; ++i) drawn[i] = drawn[i] * block.half_tolerance[i];
  for (int length = 0; length < block.pinned && block.clearance > 0; ++length) {
    const Words<Width> words = stream.words(blocks + length, 0);
    drawn[length] = drawn[length] + block.clearance * (in_disc<Width>(words.word[0], words.word[1]) +
                                                       in_disc<Width>(words.word[2], words.word[3]));
  }
  for (int i = 0; i < block.parameters; ++i) store<Width>(drawn[i], &block.deviation[i][at]);
}

template <int Width>
void draw_kernel(DrawBlock& block) {
  for (int at = 0; at < DrawBlock::size; at += Width) draw_lanes<Width>(block, at);
}

}  // namespace linkwright::LINKWRIGHT_ISA::draw
