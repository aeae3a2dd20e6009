#include "sampled_positions.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "linkwright/mechanism/position.hpp"
#include "linkwright/robust/tolerance_sampling.hpp"
#include "robust/six_bar_solver.hpp"
#include "robust/tangent.hpp"

namespace linkwright {
namespace {

// `made(position, deviations)` returning nothing where the sample does not assemble.
template <class Made, class Output, class Make>
std::vector<std::vector<Made>> all_positions(const Output& output, const Tolerances& tolerances, std::size_t count,
                                             const Make& made) {
  std::vector<std::vector<Made>> samples;
  for (const std::vector<double>& deviations : sampled_deviations(output, tolerances, count)) {
    std::vector<Made> positions;
    for (std::size_t j = 0; j < output.positions.size(); ++j)
      if (auto there = positions.size() == j ? made(j, deviations) : std::nullopt)
        positions.push_back(std::move(*there));
    if (positions.size() == output.positions.size()) samples.push_back(std::move(positions));
  }
  return samples;
}

std::optional<TracingFourBar> made_planar(const TracingFourBar& nominal, const std::vector<double>& off) {
  const FourBar& bars = nominal.bars;
  const LinkLengths was = bars.lengths();
  const Point input_fixed = bars.input_fixed + Point{off[3], off[4]};
  const Point output_fixed = bars.output_fixed + Point{off[5], off[6]}, ground = output_fixed - input_fixed;
  const LinkLengths lengths{std::abs(ground), was.input + off[0], was.coupler + off[1], was.output + off[2]};
  if (!(lengths.shortest() > 0)) return std::nullopt;
  const double input = std::arg(bars.input_moving - bars.input_fixed) + off[9];
  const auto there = assemble(lengths, input - std::arg(ground), assembly_of(bars));
  if (!there) return std::nullopt;
  const Point input_moving = input_fixed + lengths.input * direction(input);
  const Point along = direction(there->coupler_angle + std::arg(ground));
  const Point arm = (nominal.point - bars.input_moving) * was.coupler / (bars.output_moving - bars.input_moving);
  return TracingFourBar{{input_fixed, input_moving, output_fixed, input_moving + lengths.coupler * along},
                        input_moving + (arm + Point{off[7], off[8]}) * along};
}

Vector3 along_arc(Vector3 from, Vector3 toward, double angle) {
  return std::cos(angle) * from + std::sin(angle) * toward;
}

// W₂ in the oblique frame of W₁, G₂ and G₂ × W₁, as the samplers' lanes do.
std::optional<SphericalFourBar> made_spherical(const SphericalFourBar& nominal, const std::vector<double>& off) {
  const auto& [g1, w1, w2, g2] = nominal;
  const LinkAngles was = nominal.angles();
  const LinkAngles angles{was.ground + off[3], was.input + off[0], was.coupler + off[1], was.output + off[2]};
  const auto all = angles.all();
  if (!std::all_of(all.begin(), all.end(), [](double angle) { return angle > 0 && angle < pi; })) return std::nullopt;
  const Vector3 output_fixed = along_arc(g1, tangent(g1, g2), angles.ground);
  const Vector3 input = tangent(g1, w1), driven = along_arc(input, cross(g1, input), off[4]);
  const Vector3 input_moving = along_arc(g1, driven, angles.input), across = cross(output_fixed, input_moving);
  const double square = dot(across, across), diagonal = dot(input_moving, output_fixed);
  const double coupler = std::cos(angles.coupler), output = std::cos(angles.output);
  const double along_moving = (coupler - diagonal * output) / square,
               along_fixed = (output - diagonal * coupler) / square;
  const double rest = (1 - along_moving * coupler - along_fixed * output) / square;
  if (!(rest >= 0)) return std::nullopt;
  const double part = determinant(w1, w2, g2) < 0 ? -std::sqrt(rest) : std::sqrt(rest);
  return SphericalFourBar{g1, input_moving, along_moving * input_moving + along_fixed * output_fixed + part * across,
                          output_fixed};
}

}  // namespace

std::vector<std::vector<TracingFourBar>> sampled_positions(const PlanarOutput& output, const Tolerances& tolerances,
                                                           std::size_t count) {
  return all_positions<TracingFourBar>(output, tolerances, count, [&](std::size_t j, const auto& deviations) {
    return made_planar(output.positions[j], deviations);
  });
}

std::vector<std::vector<SphericalFourBar>> sampled_positions(const SphericalOutput& output,
                                                             const Tolerances& tolerances, std::size_t count) {
  return all_positions<SphericalFourBar>(output, tolerances, count, [&](std::size_t j, const auto& deviations) {
    return made_spherical(output.positions[j], deviations);
  });
}

std::vector<std::vector<SampledSixBar>> sampled_positions(const SixBarOutput& output, const Tolerances& tolerances,
                                                          std::size_t count) {
  const SixBarDistances distances(output.six_bar);
  std::vector<SixBarSolver> solvers;
  for (std::size_t j = 0; j < output.positions.size(); ++j) solvers.emplace_back(distances, output, j);
  return all_positions<SampledSixBar>(output, tolerances, count, [&](std::size_t j, const auto& deviations) {
    SixBarDeviations off{};
    std::copy(deviations.begin(), deviations.end(), off.begin());
    std::optional<SampledSixBar> sample;
    if (const auto made = solvers[j].made(off)) {
      const double turned = std::arg(made->direction * std::conj(solvers[j].nominal().direction));
      const Pose nominal = guided_pose(output.six_bar, output.positions[j], output.reference);
      sample = {made->joints, {made->origin, nominal.angle + turned}};
    }
    return sample;
  });
}

}  // namespace linkwright
