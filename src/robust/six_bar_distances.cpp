#include "robust/six_bar_distances.hpp"

#include <algorithm>

#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

constexpr Point quarter_turn{0, 1};

// Coordinates of the moving hinges by all parameters.
std::optional<SmallMatrix> hinges_by_parameters(const SixBarDistances& distances,
                                                const SixBarDistances::Joints& joints) {
  const auto inverse = distances.inverse(joints);
  if (!inverse) return std::nullopt;
  const std::size_t equations = distances.equations(), lengths = distances.lengths().size();
  const SmallMatrix ground = distances.jacobian(joints, distances.ground());
  const double driver = std::abs(joints[SixBar::b] - joints[SixBar::a]);
  SmallMatrix by(equations, distances.parameters());
  for (std::size_t i = 0; i < equations; ++i) {
    for (std::size_t j = 0; j < lengths; ++j) by(i, j) = (*inverse)(i, j);
    for (std::size_t j = 0; j < ground.columns(); ++j)
      for (std::size_t k = 0; k < equations; ++k) by(i, lengths + j) -= (*inverse)(i, k) * ground(k, j);
    by(i, by.columns() - 1) = driver * (*inverse)(i, equations - 1);
  }
  return by;
}

// The guided frame by one parameter: `from` and `to` are the first two hinges of its body, whose motions are given.
struct FrameMotion {
  Point shift;
  double turn = 0;
};
FrameMotion frame_motion(Point from, Point to, Point origin, Point from_moved, Point to_moved) {
  const Point base = to - from;
  const double turn = cross(base, to_moved - from_moved) / std::norm(base);
  return {from_moved + quarter_turn * (origin - from) * turn, turn};
}

}  // namespace

SixBarDistances::SixBarDistances(const SixBar& six_bar) : lengths_(six_bar.lengths()) {
  std::erase_if(lengths_, [](const SixBarLength& length) { return length.body == 0; });
  for (std::size_t j = 0; j < SixBar::joint_count; ++j)
    (is_on_ground(six_bar.joints[j]) ? ground_ : moving_).push_back(j);
  for (std::size_t k = 0; k + 2 < lengths_.size(); ++k)
    if (lengths_[k].body == lengths_[k + 2].body) triangles_.push_back(k);
  const std::vector<std::size_t> own = six_bar.joints_of(SixBar::guided);
  guided_ = {own.at(0), own.at(1)};
}

SmallMatrix SixBarDistances::jacobian(const Joints& joints, const std::vector<std::size_t>& by) const {
  const std::size_t driver = equations() - 1;
  SmallMatrix matrix(equations(), 2 * by.size());
  const auto add = [&](std::size_t row, std::size_t joint, Point along) {
    const auto found = std::find(by.begin(), by.end(), joint);
    if (found == by.end()) return;
    const auto column = 2 * static_cast<std::size_t>(found - by.begin());
    matrix(row, column) = along.real();
    matrix(row, column + 1) = along.imag();
  };
  const auto unit_vector = [&](std::size_t from, std::size_t to) {
    return (joints[to] - joints[from]) / std::abs(joints[to] - joints[from]);
  };
  for (std::size_t row = 0; row < driver; ++row) {
    const auto [from, to] = lengths_[row].joints;
    const Point along = unit_vector(from, to);
    add(row, to, along);
    add(row, from, -along);
  }
  const Point across = quarter_turn * unit_vector(SixBar::a, SixBar::b);
  add(driver, SixBar::b, across);
  add(driver, SixBar::a, -across);
  return matrix;
}

std::optional<SmallMatrix> SixBarDistances::inverse(const Joints& joints) const {
  return linkwright::inverse(jacobian(joints, moving_), tolerance::dead_point_sine);
}

std::optional<SensitivityMatrix> six_bar_sensitivities(const SixBarOutput& output) {
  const SixBarDistances distances(output.six_bar);
  const auto [from, to] = distances.guided();
  const auto& moving = distances.moving();
  const auto row_of = [&](std::size_t joint) {
    return 2 * static_cast<std::size_t>(std::find(moving.begin(), moving.end(), joint) - moving.begin());
  };
  const auto from_row = row_of(from), to_row = row_of(to);
  SensitivityMatrix matrix(output.positions.size(), 3, distances.parameters());
  const std::size_t along = matrix.parameters() - 3, across = matrix.parameters() - 2;
  for (std::size_t j = 0; j < matrix.positions(); ++j) {
    const auto joints = joints_at(output.six_bar, output.positions[j]);
    const Point origin = guided_pose(output.six_bar, output.positions[j], output.reference).origin;
    const auto by = hinges_by_parameters(distances, joints);
    if (!by) return std::nullopt;
    for (std::size_t i = 0; i < matrix.parameters(); ++i) {
      const auto moved = [&](std::size_t row) { return Point{(*by)(row, i), (*by)(row + 1, i)}; };
      FrameMotion motion = frame_motion(joints[from], joints[to], origin, moved(from_row), moved(to_row));
      if (i == along || i == across)
        motion.shift =
            (i == along ? 1.0 : quarter_turn) * (joints[to] - joints[from]) / std::abs(joints[to] - joints[from]);
      matrix.row(j, 0)[i] = motion.shift.real();
      matrix.row(j, 1)[i] = motion.shift.imag();
      matrix.row(j, 2)[i] = output.turning_length * motion.turn;
    }
  }
  return matrix;
}

}  // namespace linkwright
