#include "support/random_four_bar.hpp"

#include <stdexcept>

#include "linkwright/core/angle.hpp"

namespace linkwright::testing {

double RandomFourBars::uniform(double from, double to) {
  const double fraction = static_cast<double>(engine_() >> 11) * 0x1p-53;
  return from + fraction * (to - from);
}

int RandomFourBars::below(int count) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(count)); }

LinkLengths RandomFourBars::lengths() {
  for (;;) {
    const LinkLengths l{uniform(0.1, 2), uniform(0.1, 2), uniform(0.1, 2), uniform(0.1, 2)};
    if (2 * l.longest() < 0.999 * l.perimeter()) return l;
  }
}

double RandomFourBars::input_angle(const LinkLengths& lengths) {
  for (;;) {
    const double angle = uniform(-pi, pi);
    if (assemble(lengths, angle, Assembly::positive)) return angle;
  }
}

FourBar RandomFourBars::four_bar(const LinkLengths& lengths) {
  const Point center{uniform(-3, 3), uniform(-3, 3)};
  const FourBar frame{center, {}, center + lengths.ground * direction(uniform(-pi, pi)), {}};
  const Configuration c = *assemble(lengths, input_angle(lengths), assembly());
  const Point axis = (frame.output_fixed - center) / lengths.ground;
  const Point input = center + lengths.input * axis * direction(c.input_angle);
  return {center, input, frame.output_fixed, input + lengths.coupler * axis * direction(c.coupler_angle)};
}

FourBar four_bar_at(const LinkLengths& lengths, double input_angle, Assembly assembly) {
  const auto c = assemble(lengths, input_angle, assembly);
  if (!c) throw std::invalid_argument("the four-bar cannot be assembled there");
  const Point output_fixed{lengths.ground, 0};
  return {{},
          lengths.input * direction(c->input_angle),
          output_fixed,
          output_fixed + lengths.output * direction(c->output_angle)};
}

Pose coupler_pose(const FourBar& four_bar, Point offset, double turn) {
  const Point coupler = four_bar.output_moving - four_bar.input_moving;
  return {four_bar.input_moving + coupler / std::abs(coupler) * offset, std::arg(coupler) + turn};
}

double transmission_sine(const FourBar& four_bar) {
  const Point coupler = four_bar.output_moving - four_bar.input_moving,
              output = four_bar.output_moving - four_bar.output_fixed;
  return std::abs(cross(coupler, output)) / (std::abs(coupler) * std::abs(output));
}

double loop_gap(const LinkLengths& lengths, const Configuration& c) {
  return std::abs(lengths.input * direction(c.input_angle) + lengths.coupler * direction(c.coupler_angle) -
                  lengths.ground - lengths.output * direction(c.output_angle));
}

}  // namespace linkwright::testing
