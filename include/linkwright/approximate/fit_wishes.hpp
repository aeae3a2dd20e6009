#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "linkwright/mechanism/four_bar.hpp"

namespace linkwright {

/// How many places and starts are tried: quick and standard take a fixed number, deep some 16 times that of standard.
enum class FitEffort : std::uint8_t { quick, standard, deep };
/// "quick", "standard", "deep".
[[nodiscard]] std::string_view name(FitEffort effort);

/// What is minimised: the weighted sum of squared distances, or the largest distance of a point of weight above 0.
enum class FitMeasure : std::uint8_t { least_squares, least_largest };
/// "least_squares", "least_largest".
[[nodiscard]] std::string_view name(FitMeasure measure);

/// A linkage from which least squares are to begin, as it lies at the first of the points or poses; user's frame.
struct FitStart {
  FourBar bars;
  std::optional<Point> point;  ///< of a path: that of the coupler
  std::optional<Pose> pose;    ///< past poses: of the body that it carries; nothing: the first of them

  friend bool operator==(const FitStart&, const FitStart&) = default;
};

/// How it is searched for paths that pass near points, and for linkages that pass near poses.
struct FitWishes {
  static constexpr std::size_t most_starts = 100;

  FitEffort effort = FitEffort::standard;
  FitMeasure measure = FitMeasure::least_squares;
  std::optional<double> grashof_margin = 0.003;  ///< as CurveFitOptions::grashof_margin, in [0, 1)
  std::vector<FitStart> starts;                  ///< most_starts at most

  friend bool operator==(const FitWishes&, const FitWishes&) = default;
};

/// What a search showed for the linkages of a task that come near its points or poses.
struct FitSearch {
  std::vector<FitStart> linkages;  ///< without defects and within the limits, best first: FitWishes::starts of the next
  std::optional<double> rms;       ///< root mean square error of the best, user's unit
  std::size_t starts = 0;          ///< of the least squares
  std::size_t minima = 0;          ///< distinct linkages or curves that they led to
  bool cancelled = false;          ///< stopped before the end; what was found so far is listed
};

}  // namespace linkwright
