#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace linkwright {

/// A parameter of a function task that is left open: the second axis of the map.
struct FreeParameter {
  enum class Kind : std::uint8_t {
    output_scale,  ///< factor s > 0 on the output's travel: ψⱼ − ψ₁ becomes s(ψⱼ − ψ₁); spaced by its logarithm
    pair_output,  ///< output angle of one pair, radians
  };
  Kind kind = Kind::output_scale;
  std::array<double, 2> range = {0.5, 2};  ///< low first
  std::size_t pair = 0;                    ///< of pair_output

  /// The value at t ∈ [0, 1] of the range, and back.
  [[nodiscard]] double at(double t) const;
  [[nodiscard]] double place_of(double value) const;

  friend bool operator==(const FreeParameter&, const FreeParameter&) = default;
};
/// Key in problem files: "output_scale", "pair_output".
[[nodiscard]] std::string_view name(FreeParameter::Kind kind);

}  // namespace linkwright
