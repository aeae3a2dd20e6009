#include "linkwright/planar/function_error.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "linkwright/core/angle.hpp"

namespace linkwright {
namespace {

// An input angle this close to the end of the reach is the end: rounding of angles and of the reach itself, radians.
constexpr double at_the_end = 1e-12;

// The one of the angles φ + 2πk in [from, from + 2π).
double turned_into(double angle, double from) { return from + wrap_positive(angle - from); }

/// Error of one four-bar along its range of inputs.
class ErrorCurve {
 public:
  ErrorCurve(const GeneratedFunction& generated, const DialFunction& dial) : generated_(&generated), dial_(&dial) {}

  [[nodiscard]] ErrorSample sample(double input) const {
    const double wanted = dial_->output_at(input);
    return {input, wanted, generated_->output_at(input, wanted)};
  }

  /// Magnitude of the error; −1 where the drive does not get there.
  [[nodiscard]] static double magnitude(const ErrorSample& sample) {
    return sample.generated ? std::abs(*sample.generated - sample.wanted) : -1;
  }
  [[nodiscard]] double magnitude(double input) const { return magnitude(sample(input)); }

  /// The largest magnitude in an interval that holds one hill: golden sections.
  [[nodiscard]] std::pair<double, double> top_between(double low, double high, double tolerance) const {
    const double ratio = (std::sqrt(5.0) - 1) / 2;
    double left = high - ratio * (high - low), right = low + ratio * (high - low);
    double at_left = magnitude(left), at_right = magnitude(right);
    while (high - low > tolerance) {
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
  const DialFunction* dial_;
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
    if (part.from > from + at_the_end) gaps.push_back({from, part.from});
    from = part.to;
  }
  if (high > from + at_the_end || parts.empty()) gaps.push_back({from, high});
  return gaps;
}

std::vector<double> plot_inputs(const DialFunction& dial, const std::vector<AngleRange>& parts, double low, double high,
                                int samples) {
  std::vector<double> inputs;
  for (int i = 0; i < samples; ++i) inputs.push_back(low + (high - low) * i / (samples - 1));
  for (const double x : dial.corners()) inputs.push_back(dial.input_at(x));
  for (const AngleRange& part : parts) inputs.insert(inputs.end(), {part.from, part.to});
  std::sort(inputs.begin(), inputs.end());
  inputs.erase(std::unique(inputs.begin(), inputs.end()), inputs.end());
  return inputs;
}

// From the plot's highest hills to the true top.
void find_worst(const ErrorCurve& curve, FunctionError& error) {
  constexpr double worth_a_look = 0.8;  // of the highest sample: no smooth hill hides more between two of them
  const std::vector<ErrorSample>& samples = error.samples;
  std::size_t highest = 0;
  for (std::size_t i = 1; i < samples.size(); ++i)
    if (ErrorCurve::magnitude(samples[i]) > ErrorCurve::magnitude(samples[highest])) highest = i;
  double worst = ErrorCurve::magnitude(samples[highest]);
  if (worst < 0) return;
  error.worst_input = samples[highest].input;
  const double least = worth_a_look * worst, tolerance = 1e-10 * (samples.back().input - samples.front().input);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double here = ErrorCurve::magnitude(samples[i]);
    const std::size_t before = i > 0 ? i - 1 : i, after = i + 1 < samples.size() ? i + 1 : i;
    if (here < least || here < ErrorCurve::magnitude(samples[before]) || here < ErrorCurve::magnitude(samples[after]))
      continue;
    const auto [input, top] = curve.top_between(samples[before].input, samples[after].input, tolerance);
    if (top <= worst) continue;
    worst = top;
    error.worst_input = input;
  }
  error.max_structural_error = worst;
}

void add_structural_error(const GeneratedFunction& generated, const NamedFunction& function, int samples,
                          FunctionError& error) {
  const DialFunction dial(function);
  const auto [low, high] = std::minmax({dial.input_range()[0], dial.input_range()[1]});
  const std::vector<AngleRange> parts = reached_parts(generated.reach(), low, high);
  error.unreached = gaps_between(parts, low, high);
  const ErrorCurve curve(generated, dial);
  for (const double input : plot_inputs(dial, parts, low, high, samples)) error.samples.push_back(curve.sample(input));
  find_worst(curve, error);
}

}  // namespace

GeneratedFunction::GeneratedFunction(const FourBar& four_bar, const AnglePair& first)
    : lengths_(four_bar.lengths()), assembly_(assembly_of(four_bar)), reach_{first.input, first.input} {
  const Configuration start = configuration_of(four_bar);
  input_offset_ = start.input_angle - first.input;
  output_offset_ = start.output_angle - first.output;
  double nearest = two_pi;  // from the start to the range: 0 but for rounding
  for (const AngleRange& range : input_ranges(lengths_)) {
    const double from_low = turned_into(start.input_angle, range.from) - range.from, length = range.to - range.from;
    const double missed = std::max(0.0, std::min(from_low - length, two_pi - from_low));
    if (missed >= nearest) continue;
    nearest = missed;
    const double low =
        from_low - length > two_pi - from_low ? first.input + (two_pi - from_low) : first.input - from_low;
    reach_ = {low, low + length};
  }
}

std::optional<double> GeneratedFunction::output_at(double input, double near) const {
  const double length = reach_.to - reach_.from;
  double from_low = turned_into(input, reach_.from) - reach_.from;
  if (!reach_.is_full_turn()) {
    if (from_low > two_pi - at_the_end) from_low = 0;
    if (from_low > length + at_the_end) return std::nullopt;
    from_low = std::min(from_low, length);
  }
  const auto configuration = assemble(lengths_, reach_.from + from_low + input_offset_, assembly_);
  if (!configuration) return std::nullopt;
  return near + wrap_signed(configuration->output_angle - output_offset_ - near);
}

FunctionError function_error(const FourBar& four_bar, const FunctionTask& task, int samples) {
  assert(!task.pairs.empty() && samples >= 2);
  const GeneratedFunction generated(four_bar, task.pairs.front());
  FunctionError error;
  error.reaches_pairs = true;
  for (const AnglePair& pair : task.pairs) {
    const auto output = generated.output_at(pair.input, pair.output);
    error.at_pairs.push_back(output ? std::optional(*output - pair.output) : std::nullopt);
    error.reaches_pairs = error.reaches_pairs && output;
    if (output) error.precision_error = std::max(error.precision_error, std::abs(*output - pair.output));
  }
  if (task.function) add_structural_error(generated, *task.function, samples, error);
  return error;
}

}  // namespace linkwright
