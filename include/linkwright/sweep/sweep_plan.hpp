#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "linkwright/core/result.hpp"
#include "linkwright/sweep/sampling.hpp"
#include "linkwright/sweep/sweep_table.hpp"
#include "linkwright/synthesis/solve.hpp"

namespace linkwright {

/// A number of the base problem that follows a variable: scale · value + offset.
struct VariedNumber {
  std::string pointer;  ///< JSON pointer (RFC 6901) into the problem
  double scale = 1, offset = 0;
};

/// What varies over a sweep, with the numbers of the problem that follow it.
struct SweepVariable {
  std::string name;  ///< of its column
  std::string unit;
  std::vector<VariedNumber> numbers;
  double from = 0, to = 0;
  bool logarithmic = false, whole = false;  ///< evenly spaced in the logarithm; rounded to whole numbers
  std::int64_t count = 0;                   ///< of a grid; 0 elsewhere
  std::vector<double> values;               ///< of a grid instead of from, to and count

  /// At a share of the way from `from` to `to`, in [0, 1]; of whole numbers all from both ends on are as likely.
  [[nodiscard]] double at(double share) const;
  /// Of a grid: the value number k, from 0.
  [[nodiscard]] double on_grid(std::int64_t k) const;
};

/// A sweep that was read and checked: a problem to each sample, any of them at once, and what is kept of its answer.
class SweepPlan {
 public:
  static constexpr std::int64_t most_samples = std::int64_t{1} << 53;

  /// The plan of the text of a sweep file (schema/sweep.schema.json); `folder`: from which a problem file is named.
  [[nodiscard]] static Result<SweepPlan> read(std::string_view text, const std::filesystem::path& folder);

  [[nodiscard]] const std::string& title() const { return title_; }
  [[nodiscard]] Sampling sampling() const { return sampling_; }
  [[nodiscard]] std::uint64_t seed() const { return seed_; }
  [[nodiscard]] std::int64_t samples() const { return samples_; }
  [[nodiscard]] std::span<const SweepVariable> variables() const { return variables_; }
  [[nodiscard]] const SweepColumns& columns() const { return columns_; }
  /// Of each sample: SynthesisOptions::best of its problem.
  [[nodiscard]] int kept_linkages() const { return kept_linkages_; }

  /// What the variables are for a sample, from 0.
  [[nodiscard]] std::vector<double> values(std::int64_t sample) const;
  /// The problem of a sample as JSON text: what `linkwright solve` solves.
  [[nodiscard]] std::string problem_text(std::int64_t sample) const;
  /// The mistakes of a problem that its values make impossible.
  [[nodiscard]] Result<Problem> problem(std::int64_t sample) const;

  /// The base problem and the rest of the sweep, as JSON text on one line without comments: who has both equal has the
  /// same samples.
  [[nodiscard]] const std::string& base_text() const { return base_text_; }
  [[nodiscard]] const std::string& sweep_text() const { return sweep_text_; }

  /// Samples are computed and kept in blocks of so many, the last one of what is left: of the number of samples alone.
  [[nodiscard]] std::int64_t block_samples() const;
  [[nodiscard]] std::int64_t blocks() const { return (samples_ + block_samples() - 1) / block_samples(); }

 private:
  friend class SweepReader;
  SweepPlan() = default;

  struct Base;  // the tree of the problem and the places of the numbers in it
  std::string title_;
  Sampling sampling_ = Sampling::grid;
  std::uint64_t seed_ = 0;
  std::int64_t samples_ = 0;
  int kept_linkages_ = 1;
  std::vector<SweepVariable> variables_;
  std::vector<std::vector<double>> rows_;  ///< of a list
  SweepColumns columns_;
  std::string base_text_, sweep_text_;
  std::shared_ptr<const PointSequence> sequence_;
  std::shared_ptr<const Base> base_;
};

/// The same from a file, or from standard input for "-".
[[nodiscard]] Result<SweepPlan> read_sweep_file(const std::filesystem::path& path);

}  // namespace linkwright
