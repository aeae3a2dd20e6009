#include "linkwright/function/generated_function.hpp"

#include <algorithm>
#include <utility>

#include "function/turned_into.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {

GeneratedFunction::GeneratedFunction(ForwardKinematics output_angle, Start start, std::span<const AngleRange> ranges,
                                     const AnglePair& first)
    : output_angle_(std::move(output_angle)),
      reach_{first.input, first.input},
      input_offset_(start.input_angle - first.input),
      output_offset_(start.output_angle - first.output) {
  double nearest = two_pi;  // from the start to the range: 0 but for rounding
  for (const AngleRange& range : ranges) {
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
    if (from_low > two_pi - tolerance::end_of_reach) from_low = 0;
    if (from_low > length + tolerance::end_of_reach) return std::nullopt;
    from_low = std::min(from_low, length);
  }
  const auto output_angle = output_angle_(reach_.from + from_low + input_offset_);
  if (!output_angle) return std::nullopt;
  return near + wrap_signed(*output_angle - output_offset_ - near);
}

}  // namespace linkwright
