#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace linkwright {

/// How many places and starts are tried: quick and standard take a fixed number, deep some 16 times that of standard.
enum class FitEffort : std::uint8_t { quick, standard, deep };
/// "quick", "standard", "deep".
[[nodiscard]] std::string_view name(FitEffort effort);

/// What is minimised: the weighted sum of squared distances, or the largest distance of a point of weight above 0.
enum class FitMeasure : std::uint8_t { least_squares, least_largest };
/// "least_squares", "least_largest".
[[nodiscard]] std::string_view name(FitMeasure measure);

/// How it is searched for paths that pass near points.
struct FitWishes {
  FitEffort effort = FitEffort::standard;
  FitMeasure measure = FitMeasure::least_squares;
  std::optional<double> grashof_margin = 0.003;  ///< as CurveFitOptions::grashof_margin, in [0, 1)

  friend bool operator==(const FitWishes&, const FitWishes&) = default;
};

}  // namespace linkwright
