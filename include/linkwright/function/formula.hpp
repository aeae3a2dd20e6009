#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace linkwright {

/// y = factor · f(x) + addend, f being one of a few functions.
struct Formula {
  enum class Kind : std::uint8_t { power, logarithm, natural_logarithm, exponential, sine, cosine, tangent };

  Kind kind = Kind::power;
  double exponent = 1;  ///< of a power
  double unit = 1;      ///< of x in radians, for sine, cosine, tangent
  double factor = 1, addend = 0;

  /// Not finite where the function is not defined at x.
  [[nodiscard]] double y(double x) const;
};

struct FormulaReading {
  std::optional<Formula> formula;
  int wrong_at = 0;  ///< without a formula: the character from which on it is not understood, from 1
};

/// Reads `[number][*] f [* or / number] [+ or − number]` with f one of `x`, `x^p` for a number p, `sqrt`, `log` (of
/// base 10), `log10`, `ln`, `exp`, `sin`, `cos`, `tan`, `sin_deg`, `cos_deg`, `tan_deg`, each also with `(x)` behind
/// it: `2x`, `0.5 x^2 + 1`, `-sin(x)`, `x/3`. Spaces may stand between the parts.
[[nodiscard]] FormulaReading read_formula(std::string_view text);

}  // namespace linkwright
