#include "linkwright/robust/sensitivity.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "linkwright/core/precondition.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

constexpr Point left_turn{0, 1};  // e^{iπ/2}

constexpr std::size_t at_parameter(SphericalParameter parameter) { return static_cast<std::size_t>(parameter); }

// Rows of all positions, `fill(matrix, position)` returning whether that position has any.
template <class Fill>
std::optional<SensitivityMatrix> filled(SensitivityMatrix matrix, const Fill& fill) {
  for (std::size_t position = 0; position < matrix.positions(); ++position)
    if (!fill(matrix, position)) return std::nullopt;
  return matrix;
}

void set_pose_rows(SensitivityMatrix& matrix, std::size_t position, const PlanarSensitivity& by, double length) {
  for (std::size_t i = 0; i < planar_parameters; ++i) {
    matrix.row(position, 0)[i] = by.point[i].real();
    matrix.row(position, 1)[i] = by.point[i].imag();
    matrix.row(position, 2)[i] = length * by.coupler_angle[i];
  }
}

// Of every parameter, over the stroke.
void realign(SensitivityMatrix& matrix, const PlanarOutput& output) {
  std::vector<double> places, column(matrix.positions());
  for (const TracingFourBar& linkage : output.positions) places.push_back(output.line.to_line(linkage.point).real());
  for (std::size_t i = 0; i < matrix.parameters(); ++i) {
    for (std::size_t j = 0; j < column.size(); ++j) column[j] = matrix.row(j, 0)[i];
    take_away_best_line(places, column);
    for (std::size_t j = 0; j < column.size(); ++j) matrix.row(j, 0)[i] = column[j];
  }
}

}  // namespace

// The loop a uA + h uH = B0 − A0 + b uB, varied: Σ v_i δp_i + h δθ i uH − b δψ i uB = 0. Its product with uB has no δψ,
// that with uH no δθ.
std::optional<PlanarSensitivity> sensitivity_of(const TracingFourBar& linkage) {
  const FourBar& bars = linkage.bars;
  const LinkLengths lengths = bars.lengths();
  const Point input = (bars.input_moving - bars.input_fixed) / lengths.input;
  const Point coupler = (bars.output_moving - bars.input_moving) / lengths.coupler;
  const Point output = (bars.output_moving - bars.output_fixed) / lengths.output;
  const double sine = cross(coupler, output);  // ± that of the transmission angle
  if (!(std::abs(sine) >= tolerance::dead_point_sine)) return std::nullopt;
  const Point driven = left_turn * (bars.input_moving - bars.input_fixed);
  const std::array<Point, planar_parameters> opens = {input, coupler,    -output, 1, left_turn,
                                                      -1,    -left_turn, 0,       0, driven};
  const std::array<Point, planar_parameters> carries = {input, 0, 0, 1, left_turn, 0, 0, coupler, left_turn * coupler,
                                                        driven};
  const Point turns = left_turn * (linkage.point - bars.input_moving);
  PlanarSensitivity by;
  for (std::size_t i = 0; i < planar_parameters; ++i) {
    by.coupler_angle[i] = -dot(opens[i], output) / (lengths.coupler * sine);
    by.output_angle[i] = -dot(opens[i], coupler) / (lengths.output * sine);
    by.point[i] = carries[i] + turns * by.coupler_angle[i];
  }
  return by;
}

// Once round the loop: Σ δα_i n_i + δθ G₁ + δφ W₁ + δχ W₂ + δψ G₂ = 0, n_i being the normals of the arcs. The coupler
// turns by what comes before W₂.
std::optional<SphericalSensitivity> sensitivity_of(const SphericalFourBar& linkage) {
  const auto& [g1, w1, w2, g2] = linkage;
  const double joint = determinant(w1, w2, g2);
  const std::array<Vector3, 4> arcs = {cross(g1, w1), cross(w1, w2), cross(w2, g2), cross(g2, g1)};
  const auto vanishes = [](Vector3 arc) { return !(norm(arc) >= tolerance::dead_point_sine); };
  if (std::any_of(arcs.begin(), arcs.end(), vanishes)) return std::nullopt;
  if (!(std::abs(joint) >= tolerance::dead_point_sine * norm(arcs[1]) * norm(arcs[2]))) return std::nullopt;
  std::array<Vector3, spherical_parameters> opens{};
  for (std::size_t i = 0; i < arcs.size(); ++i) opens[i] = normalized(arcs[i]);
  opens[at_parameter(SphericalParameter::driver)] = g1;
  SphericalSensitivity by;
  for (std::size_t i = 0; i < spherical_parameters; ++i) {
    by.coupler[i] = -dot(opens[i], arcs[2]) / joint * w1;
    // The output turns with the loop's sense reversed: what opens it from the other side.
    by.output_angle[i] = dot(opens[i], arcs[1]) / joint;
  }
  for (const auto parameter : {SphericalParameter::input, SphericalParameter::driver}) {
    Vector3& turn = by.coupler[at_parameter(parameter)];
    turn = turn + opens[at_parameter(parameter)];
  }
  return by;
}

std::optional<SensitivityMatrix> sensitivities(const PlanarOutput& output) {
  const std::size_t components = output.kind == PlanarOutput::Kind::pose ? 3 : 1;
  auto matrix = filled({output.positions.size(), components, planar_parameters}, [&](auto& rows, std::size_t j) {
    const auto by = sensitivity_of(output.positions[j]);
    if (!by) return false;
    if (output.kind == PlanarOutput::Kind::pose) {
      set_pose_rows(rows, j, *by, output.turning_length);
    } else {
      const auto row = rows.row(j, 0);
      for (std::size_t i = 0; i < planar_parameters; ++i)
        row[i] = output.kind == PlanarOutput::Kind::angle ? by->output_angle[i] : dot(output.line.left(), by->point[i]);
    }
    return true;
  });
  if (matrix && output.realigned) realign(*matrix, output);
  return matrix;
}

std::optional<SensitivityMatrix> orientation_sensitivities(std::span<const SphericalFourBar> positions) {
  return filled({positions.size(), 3, spherical_parameters}, [&](auto& rows, std::size_t j) {
    const auto by = sensitivity_of(positions[j]);
    for (std::size_t i = 0; by && i < spherical_parameters; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis) rows.row(j, axis)[i] = by->coupler[i][axis];
    return by.has_value();
  });
}

std::optional<SensitivityMatrix> angle_sensitivities(std::span<const SphericalFourBar> positions) {
  return filled({positions.size(), 1, spherical_parameters}, [&](auto& rows, std::size_t j) {
    const auto by = sensitivity_of(positions[j]);
    if (by) std::copy(by->output_angle.begin(), by->output_angle.end(), rows.row(j, 0).begin());
    return by.has_value();
  });
}

void take_away_best_line(std::span<const double> places, std::span<double> values) {
  const auto count = static_cast<double>(places.size());
  double place = 0, value = 0;
  for (std::size_t j = 0; j < places.size(); ++j) {
    place += places[j] / count;
    value += values[j] / count;
  }
  double square = 0, product = 0;
  for (std::size_t j = 0; j < places.size(); ++j) {
    square += (places[j] - place) * (places[j] - place);
    product += (places[j] - place) * values[j];
  }
  for (std::size_t j = 0; j < places.size(); ++j) values[j] -= value + product / square * (places[j] - place);
}

}  // namespace linkwright
