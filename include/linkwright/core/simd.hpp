#pragma once

#include <cstdint>
#include <string_view>

namespace linkwright {

/// Instruction set of the kernels. All give the same bits.
enum class Simd : std::uint8_t { automatic, scalar, baseline, avx2, avx512 };
/// "automatic", "scalar", …
[[nodiscard]] std::string_view name(Simd simd);
/// What `automatic` stands for on this machine.
[[nodiscard]] Simd best_simd();
/// This processor has it.
[[nodiscard]] bool is_supported(Simd simd);

}  // namespace linkwright
