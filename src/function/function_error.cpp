#include "linkwright/function/function_error.hpp"

#include <algorithm>
#include <cmath>

#include "function/turned_into.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/precondition.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

/// Error of one linkage along its range of inputs.
class ErrorCurve {
 public:
  ErrorCurve(const GeneratedFunction& generated, const ScaledFunction& scaled)
      : generated_(&generated), scaled_function_(&scaled) {}

  [[nodiscard]] ErrorSample sample(double input) const {
    const double wanted = scaled_function_->output_at(input);
    return {input, wanted, generated_->output_at(input, wanted)};
  }

  /// Magnitude of the error; −1 where the drive does not get there.
  [[nodiscard]] static double magnitude(const ErrorSample& sample) {
    return sample.generated ? std::abs(*sample.generated - sample.wanted) : -1;
  }
  [[nodiscard]] double magnitude(double input) const { return magnitude(sample(input)); }

  /// The largest magnitude in an interval that holds one hill: golden sections, each turn of which leaves 0.618 of the
  /// interval. So many leave 4e-14 of it, whatever rounding makes of its ends.
  [[nodiscard]] std::pair<double, double> top_between(double low, double high, double tolerance) const {
    constexpr int max_evaluations = 64;
    const double ratio = (std::sqrt(5.0) - 1) / 2;
    double left = high - ratio * (high - low), right = low + ratio * (high - low);
    double at_left = magnitude(left), at_right = magnitude(right);
    for (int turn = 0; turn < max_evaluations && high - low > tolerance; ++turn) {
      if (at_left >= at_right) {
        high = right;
        right = left;
        at_right = at_left;
        left = high - ratio * (high - low);
        at_left = magnitude(left);
      } else {
        low = left;
        left = right;
        at_left = at_right;
        right = low + ratio * (high - low);
        at_right = magnitude(right);
      }
    }
    return at_left >= at_right ? std::pair{left, at_left} : std::pair{right, at_right};
  }

 private:
  const GeneratedFunction* generated_;
  const ScaledFunction* scaled_function_;
};

// The pieces of [low, high] that the reach covers, ascending; it repeats with every turn.
std::vector<AngleRange> reached_parts(const AngleRange& reach, double low, double high) {
  if (reach.is_full_turn()) return {{low, high}};
  std::vector<AngleRange> parts;
  if (reach.from == reach.to) return parts;
  const double first = turned_into(reach.from, low) - two_pi;  // the last that begins below `low`
  for (double from = first; from <= high; from += two_pi) {
    const AngleRange part{std::max(from, low), std::min(from + (reach.to - reach.from), high)};
    if (part.to >= part.from) parts.push_back(part);
  }
  return parts;
}

std::vector<AngleRange> gaps_between(const std::vector<AngleRange>& parts, double low, double high) {
  std::vector<AngleRange> gaps;
  double from = low;
  for (const AngleRange& part : parts) {
    if (part.from > from + tolerance::end_of_reach) gaps.push_back({from, part.from});
    from = part.to;
  }
  if (high > from + tolerance::end_of_reach || parts.empty()) gaps.push_back({from, high});
  return gaps;
}

// Rows of a table in the range, all or as many by even steps.
void add_rows(const ScaledFunction& scaled, std::size_t most, std::vector<double>& inputs) {
  const auto rows = scaled.rows();
  const std::size_t count = std::min(rows.size(), most);
  for (std::size_t i = 0; i < count; ++i) inputs.push_back(scaled.input_at(rows[i * rows.size() / count][0]));
}

std::vector<double> inputs_looked_at(const ScaledFunction& scaled, const std::vector<AngleRange>& parts, double low,
                                     double high, const ErrorSampling& sampling) {
  std::vector<double> inputs;
  for (int i = 0; i < sampling.steps; ++i) inputs.push_back(low + (high - low) * i / (sampling.steps - 1));
  add_rows(scaled, sampling.max_rows, inputs);
  for (const AngleRange& part : parts) inputs.insert(inputs.end(), {part.from, part.to});
  std::sort(inputs.begin(), inputs.end());
  inputs.erase(std::unique(inputs.begin(), inputs.end()), inputs.end());
  return inputs;
}

// Samples that no neighbour exceeds, highest first: all that may become the highest when they are climbed.
std::vector<std::size_t> highest_hills(const std::vector<ErrorSample>& samples) {
  constexpr double worth_a_look = 0.8;   // of the highest sample: no smooth hill hides more between two of them
  constexpr std::size_t max_hills = 64;  // beyond that they are rows of a table, too close for hills between them
  std::vector<double> heights;
  for (const ErrorSample& sample : samples) heights.push_back(ErrorCurve::magnitude(sample));
  const double least = worth_a_look * *std::max_element(heights.begin(), heights.end());
  std::vector<std::size_t> hills;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::size_t before = i > 0 ? i - 1 : i, after = i + 1 < samples.size() ? i + 1 : i;
    if (heights[i] >= std::max({least, 0.0, heights[before], heights[after]})) hills.push_back(i);
  }
  const auto shown = hills.begin() + static_cast<std::ptrdiff_t>(std::min(hills.size(), max_hills));
  std::partial_sort(hills.begin(), shown, hills.end(), [&](std::size_t a, std::size_t b) {
    return heights[a] != heights[b] ? heights[a] > heights[b] : a < b;
  });
  hills.erase(shown, hills.end());
  return hills;
}

// From the highest hills of the samples to the true top.
void find_worst(const ErrorCurve& curve, FunctionError& error) {
  const std::vector<ErrorSample>& samples = error.samples;
  constexpr double resolution = 1e-10;  // at a top the error is level: twice as many of its digits are found
  const double width = resolution * (samples.back().input - samples.front().input);
  for (const std::size_t hill : highest_hills(samples)) {
    const std::size_t before = hill > 0 ? hill - 1 : hill, after = hill + 1 < samples.size() ? hill + 1 : hill;
    const auto look_at = [&](double input, double height) {
      if (error.max_structural_error && height <= *error.max_structural_error) return;
      error.max_structural_error = height;
      error.worst_input = input;
    };
    look_at(samples[hill].input, ErrorCurve::magnitude(samples[hill]));
    const auto [input, top] = curve.top_between(samples[before].input, samples[after].input, width);
    look_at(input, top);
  }
}

// Too many for a plot: of each short stretch the least and the greatest error.
void thin_out(std::vector<ErrorSample>& samples) {
  constexpr std::size_t most = 2000, stretches = 500;
  if (samples.size() <= most) return;
  const auto signed_error = [](const ErrorSample& s) { return s.generated ? *s.generated - s.wanted : 0; };
  const auto less = [&](const ErrorSample& a, const ErrorSample& b) { return signed_error(a) < signed_error(b); };
  std::vector<ErrorSample> kept = {samples.front()};
  for (std::size_t i = 0; i < stretches; ++i) {
    const auto from = samples.begin() + static_cast<std::ptrdiff_t>(i * samples.size() / stretches);
    const auto to = samples.begin() + static_cast<std::ptrdiff_t>((i + 1) * samples.size() / stretches);
    const auto [least, greatest] = std::minmax_element(from, to, less);
    for (const auto& extreme : {std::min(least, greatest), std::max(least, greatest)})
      if (extreme->input > kept.back().input) kept.push_back(*extreme);
  }
  if (samples.back().input > kept.back().input) kept.push_back(samples.back());
  samples = std::move(kept);
}

void add_structural_error(const GeneratedFunction& generated, const ScaledFunction& scaled,
                          const ErrorSampling& sampling, FunctionError& error) {
  const auto [low, high] = std::minmax({scaled.input_range()[0], scaled.input_range()[1]});
  const std::vector<AngleRange> parts = reached_parts(generated.reach(), low, high);
  error.unreached = gaps_between(parts, low, high);
  const ErrorCurve curve(generated, scaled);
  for (const double input : inputs_looked_at(scaled, parts, low, high, sampling))
    error.samples.push_back(curve.sample(input));
  find_worst(curve, error);
  thin_out(error.samples);
}

}  // namespace

FunctionError function_error(const GeneratedFunction& generated, std::span<const AnglePair> pairs,
                             const ScaledFunction* function, const ErrorSampling& sampling) {
  require(!pairs.empty() && sampling.steps >= 2, "an error is that at pairs, over two samples or more");
  FunctionError error;
  error.reaches_pairs = true;
  for (const AnglePair& pair : pairs) {
    const auto output = generated.output_at(pair.input, pair.output);
    error.at_pairs.push_back(output ? std::optional(*output - pair.output) : std::nullopt);
    error.reaches_pairs = error.reaches_pairs && output;
    if (output) error.precision_error = std::max(error.precision_error, std::abs(*output - pair.output));
  }
  if (function != nullptr) add_structural_error(generated, *function, sampling, error);
  return error;
}

void structural_errors_deg(const RegionMap& map, std::span<float> values,
                           const std::function<std::optional<FunctionError>(MapPoint place)>& error_at) {
  for (std::size_t row = 0; row < map.rows(); ++row)
    for (std::size_t column = 0; column < map.columns(); ++column) {
      const std::size_t cell = map.index(row, column);
      values[cell] = 0;
      if (map.defects()[cell] != 0) continue;
      const auto error = error_at({map.input_coordinates()[row], map.output_coordinates()[column]});
      if (error && error->max_structural_error && error->unreached.empty())
        values[cell] = static_cast<float>(degrees(*error->max_structural_error));
    }
}

}  // namespace linkwright
