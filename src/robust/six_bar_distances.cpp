#include "robust/six_bar_distances.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

constexpr Point quarter_turn{0, 1};

// Coordinates of the moving hinges by all parameters.
std::optional<SixBarDistances::Matrix> hinges_by_parameters(const SixBarDistances& distances,
                                                            const SixBarDistances::Joints& joints) {
  const auto inverse = distances.inverse(joints);
  if (!inverse) return std::nullopt;
  const auto lengths = static_cast<int>(distances.lengths().size());
  const auto parameters = static_cast<int>(distances.parameters());
  SixBarDistances::Matrix by = SixBarDistances::Matrix::Zero(distances.equations(), parameters);
  by.leftCols(lengths) = inverse->leftCols(lengths);
  by.middleCols(lengths, parameters - lengths - 3) = -*inverse * distances.jacobian(joints, distances.ground());
  by.rightCols(1) = std::abs(joints[SixBar::b] - joints[SixBar::a]) * inverse->rightCols(1);
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

SixBarDistances::Matrix SixBarDistances::jacobian(const Joints& joints, const std::vector<std::size_t>& by) const {
  const int rows = equations(), driver = rows - 1;
  Matrix matrix = Matrix::Zero(rows, 2 * static_cast<int>(by.size()));
  std::array<int, SixBar::joint_count> column_of{};
  column_of.fill(-1);
  for (std::size_t k = 0; k < by.size(); ++k) column_of[by[k]] = 2 * static_cast<int>(k);
  const auto add = [&](int row, std::size_t joint, Point along) {
    const int column = column_of[joint];
    if (column < 0) return;
    matrix(row, column) = along.real();
    matrix(row, column + 1) = along.imag();
  };
  const auto unit_vector = [&](std::size_t from, std::size_t to) {
    return (joints[to] - joints[from]) / std::abs(joints[to] - joints[from]);
  };
  for (int row = 0; row < driver; ++row) {
    const auto [from, to] = lengths_[static_cast<std::size_t>(row)].joints;
    const Point along = unit_vector(from, to);
    add(row, to, along);
    add(row, from, -along);
  }
  const Point across = quarter_turn * unit_vector(SixBar::a, SixBar::b);
  add(driver, SixBar::b, across);
  add(driver, SixBar::a, -across);
  return matrix;
}

std::optional<SixBarDistances::Matrix> SixBarDistances::inverse(const Joints& joints) const {
  const Eigen::FullPivLU<Matrix> factors(jacobian(joints, moving_));
  const auto pivots = factors.matrixLU().diagonal().cwiseAbs();
  if (!(pivots.minCoeff() >= tolerance::dead_point_sine * pivots.maxCoeff())) return std::nullopt;
  return Matrix(factors.inverse());
}

std::optional<SensitivityMatrix> six_bar_sensitivities(const SixBarOutput& output) {
  const SixBarDistances distances(output.six_bar);
  const auto [from, to] = distances.guided();
  const auto& moving = distances.moving();
  const auto row_of = [&](std::size_t joint) {
    return 2 * (std::find(moving.begin(), moving.end(), joint) - moving.begin());
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
      const auto moved = [&](auto row) {
        return Point{(*by)(row, static_cast<int>(i)), (*by)(row + 1, static_cast<int>(i))};
      };
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
