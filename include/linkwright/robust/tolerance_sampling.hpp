#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "linkwright/core/simd.hpp"
#include "linkwright/robust/made_dimension.hpp"
#include "linkwright/robust/tolerances.hpp"

namespace linkwright {

/// A share that was counted, and the interval in which the true one lies with 95 % (E. B. Wilson, J. Am. Stat. Assoc.
/// 22, 1927).
struct CountedShare {
  double share = 0, low = 0, high = 1;
};
/// 0 ≤ count ≤ of, of > 0.
[[nodiscard]] CountedShare counted_share(std::int64_t count, std::int64_t of);

/// What samples of a linkage made with errors do. Errors are those of LinkageOutput: user's unit, of angles radians.
struct SampledErrors {
  std::int64_t samples = 0, not_assembled = 0;  ///< the latter in some position; they count in yield alone
  std::vector<double> deviations;               ///< in each position, root of the mean square off the nominal
  double error = 0;                             ///< as tolerance_error(), or line_tolerance_error()
  /// Of each sample's largest error over the positions; of a line the distance from it, the nominal one included, and
  /// of a realigned line that from the middle of the strip which holds all positions.
  double mean = 0, standard_deviation = 0;
  std::optional<CountedShare> yield;  ///< assembled and within the limit in all positions; nothing without a limit

  [[nodiscard]] std::int64_t assembled() const { return samples - not_assembled; }
  /// Half the interval around `error` in which the true one lies with 95 %: that of a normal number's standard
  /// deviation, positions counting as one since they share their samples.
  [[nodiscard]] double error_interval() const;
  /// The error to first order is beyond that interval: dimensions are too coarse, or a dead point too near, for it.
  [[nodiscard]] bool is_beyond_first_order(double first_order_error) const;

  [[nodiscard]] double mean_plus_3_sigma() const { return mean + 3 * standard_deviation; }
  /// Taguchi's ratio, smaller being better: −10 log₁₀ of the mean square of the largest errors, dB.
  [[nodiscard]] double signal_to_noise() const;
};

/// Most positions that can be sampled.
inline constexpr std::size_t most_sampled_positions = 64;

/// Monte Carlo: `tolerances.samples` linkages, assembled as in each position, driven to its input's direction. The
/// errors of sample number k depend on seed and k alone (Philox4x32-10), so that all linkages are made with the same
/// ones, and neither threads nor instruction sets show in the answer. A limit of a kind that the output does not have
/// is one on its error. At most most_sampled_positions.
[[nodiscard]] SampledErrors sample_errors(const LinkageOutput& output, const Tolerances& tolerances, int threads = 0,
                                          Simd simd = Simd::automatic);

/// The same of many linkages, on one thread each: what takes longest, the numbers, is drawn once and kept, 8 bytes a
/// parameter and sample.
class ToleranceSampler {
 public:
  /// Of planar four-bars.
  explicit ToleranceSampler(const Tolerances& tolerances, Simd simd = Simd::automatic)
      : ToleranceSampler(PlanarOutput{}, tolerances, simd) {}
  /// Of linkages with the same parameters as `like`.
  ToleranceSampler(const LinkageOutput& like, const Tolerances& tolerances, Simd simd = Simd::automatic);

  [[nodiscard]] SampledErrors errors_of(const LinkageOutput& output) const;

 private:
  Tolerances tolerances_;
  Simd simd_;
  std::size_t draws_a_block_ = 0;
  std::vector<double> draws_;  ///< by block, parameter, sample
};

/// The errors of single samples.
struct ErrorSamples {
  /// By position, of the samples that assemble in all of them: sizes ≥ 0, of lines distances to their left.
  std::vector<std::vector<double>> errors;
  std::int64_t not_assembled = 0;
};
/// Of the samples number 0 … count − 1, as sample_errors() takes them.
[[nodiscard]] ErrorSamples error_samples(const LinkageOutput& output, const Tolerances& tolerances, std::size_t count,
                                         Simd simd = Simd::automatic);

/// By how much each dimension (made_dimensions) is off in the samples number 0, 1, …: clearance included; user's unit,
/// radians.
[[nodiscard]] std::vector<std::vector<double>> sampled_deviations(const LinkageOutput& output,
                                                                  const Tolerances& tolerances, std::size_t count);

}  // namespace linkwright
