// What the machine can do at most, one thread, for comparison with the region kernel: double precision multiplications
// and additions (not fused, as the kernel's are not), square roots, and writing to memory.

#include <benchmark/benchmark.h>
#include <cstring>
#include <memory>

#if defined(__x86_64__)
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"  // in g++ 12's own header (its bug 105593)
#endif
#include <immintrin.h>
#endif

namespace linkwright::bench::roofline_bench {
namespace {

constexpr int chains = 12;  // independent, to hide the latency of each
constexpr int rounds = 1000;

// Results a second; `lanes` in each of the chains.
void count_results(benchmark::State& state, double lanes) {
  state.counters["per_ns"] =
      benchmark::Counter(chains * rounds * lanes * 1e-9, benchmark::Counter::kIsIterationInvariantRate);
}

#if defined(__x86_64__)

// Chains alternate between the two operations.
#define LINKWRIGHT_ROOFLINE(name, isa, Vector, lanes, set, mul, add, sqrt)               \
  __attribute__((target(isa))) void name##_mul_add(benchmark::State& state) {            \
    if (!__builtin_cpu_supports(isa)) return state.SkipWithError("not on this machine"); \
    Vector product[chains / 2], sum[chains / 2];                                         \
    for (int i = 0; i < chains / 2; ++i) product[i] = sum[i] = set(1.0 + i);             \
    for (auto _ : state) {                                                               \
      for (int round = 0; round < rounds; ++round) {                                     \
        _Pragma("GCC unroll 12") for (int i = 0; i < chains / 2; ++i) {                  \
          product[i] = mul(product[i], set(0.999));                                      \
          sum[i] = add(sum[i], set(0.001));                                              \
        }                                                                                \
      }                                                                                  \
      benchmark::DoNotOptimize(product);                                                 \
      benchmark::DoNotOptimize(sum);                                                     \
      for (int i = 0; i < chains / 2; ++i) product[i] = set(1.0 + i); /* not denormal */ \
    }                                                                                    \
    count_results(state, lanes);                                                         \
  }                                                                                      \
  BENCHMARK(name##_mul_add);                                                             \
  __attribute__((target(isa))) void name##_sqrt(benchmark::State& state) {               \
    if (!__builtin_cpu_supports(isa)) return state.SkipWithError("not on this machine"); \
    Vector x[chains];                                                                    \
    for (int i = 0; i < chains; ++i) x[i] = set(1.0 + i);                                \
    for (auto _ : state) {                                                               \
      for (int round = 0; round < rounds; ++round) {                                     \
        _Pragma("GCC unroll 12") for (int i = 0; i < chains; ++i) x[i] = sqrt(x[i]);     \
      }                                                                                  \
      benchmark::DoNotOptimize(x);                                                       \
    }                                                                                    \
    count_results(state, lanes);                                                         \
  }                                                                                      \
  BENCHMARK(name##_sqrt);

LINKWRIGHT_ROOFLINE(baseline, "sse2", __m128d, 2, _mm_set1_pd, _mm_mul_pd, _mm_add_pd, _mm_sqrt_pd)
LINKWRIGHT_ROOFLINE(avx2, "avx2", __m256d, 4, _mm256_set1_pd, _mm256_mul_pd, _mm256_add_pd, _mm256_sqrt_pd)
LINKWRIGHT_ROOFLINE(avx512, "avx512f", __m512d, 8, _mm512_set1_pd, _mm512_mul_pd, _mm512_add_pd, _mm512_sqrt_pd)

#endif

// Bytes a nanosecond into memory that is there already: as much as a region of 100, 1000 and 3162 samples.
void write(benchmark::State& state) {
  const auto bytes = static_cast<std::size_t>(state.range(0));
  const std::unique_ptr<char[]> memory(new char[bytes]);
  std::memset(memory.get(), 1, bytes);
  for (auto _ : state) {
    std::memset(memory.get(), 2, bytes);
    benchmark::ClobberMemory();
  }
  state.counters["per_ns"] =
      benchmark::Counter(static_cast<double>(bytes) * 1e-9, benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(write)->Arg(180'000)->Arg(18'000'000)->Arg(180'000'000);

}  // namespace
}  // namespace linkwright::bench::roofline_bench
