#include "drawn_poses.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/angle.hpp"

namespace linkwright::soak {
namespace {

using Poses = std::vector<Pose>;

Poses scattered(Draw& draw, std::size_t count) {
  Poses poses(count);
  for (Pose& pose : poses) pose = {draw.point(2), draw.between(-pi, pi)};
  return poses;
}

Poses along_a_path(Draw& draw, std::size_t count) {
  Poses poses(count);
  Pose at{draw.point(2), draw.between(-pi, pi)};
  const double turn = draw.between(-0.8, 0.8);
  Point step = draw.point(1.5);
  for (Pose& pose : poses) {
    pose = at;
    step *= direction(draw.between(-0.6, 0.6));
    at.origin += step * draw.between(0.5, 1.5);
    at.angle += turn * draw.between(0.4, 1.6);
  }
  return poses;
}

Poses on_a_grid(Draw& draw, std::size_t count) {
  Poses poses(count);
  const double step = radians(draw.one_of({15.0, 30.0, 45.0, 90.0}));
  for (Pose& pose : poses) {
    pose.origin = {draw.whole(-4, 4) + 0.0, draw.whole(-4, 4) + 0.0};
    pose.angle = step * draw.whole(-6, 6);
  }
  return poses;
}

Poses equal_steps(Draw& draw, std::size_t count) {
  Poses poses(count);
  const Point step{draw.whole(0, 3) + 0.0, draw.whole(0, 3) + 0.0};
  const double turn = radians(15.0 * draw.whole(-4, 4));
  for (std::size_t j = 0; j < count; ++j) poses[j] = {static_cast<double>(j) * step, static_cast<double>(j) * turn};
  return poses;
}

Poses on_a_line(Draw& draw, std::size_t count) {
  Poses poses = scattered(draw, count);
  const Point along = draw.point(1), from = draw.point(1);
  for (Pose& pose : poses) pose.origin = from + along * draw.between(-2, 2);
  return poses;
}

Poses parallel(Draw& draw, std::size_t count) {
  Poses poses = scattered(draw, count);
  const std::size_t from = draw.chance(0.5) ? 0 : count / 2;
  for (std::size_t j = from; j < count; ++j) poses[j].angle = poses[from].angle;
  return poses;
}

Poses half_turns(Draw& draw, std::size_t count) {
  Poses poses = scattered(draw, count);
  for (std::size_t j = 1; j < count; ++j)
    if (draw.chance(0.6)) poses[j].angle = poses[0].angle + (draw.chance(0.5) ? pi : pi / 2);
  return poses;
}

Poses turned_about_one_pole(Draw& draw, std::size_t count) {
  Poses poses(count);
  const Point pole = draw.point(2), arm = draw.chance(0.2) ? Point{} : draw.point(2);
  double angle = draw.between(-1, 1);
  for (Pose& pose : poses) {
    pose = {pole + direction(angle) * arm, angle};
    angle += draw.between(0.1, 1.2);
  }
  return poses;
}

Poses mirrored(Draw& draw, std::size_t count) {
  Poses poses = scattered(draw, count);
  for (std::size_t j = 0; 2 * j + 1 < count; ++j) poses[count - 1 - j] = {-std::conj(poses[j].origin), -poses[j].angle};
  if (count % 2 == 1) poses[count / 2] = {{0, draw.between(-2, 2)}, 0};
  return poses;
}

Poses nearly_equal(Draw& draw, std::size_t count) {
  Poses poses = scattered(draw, count);
  const double distance = draw.power_of_ten(-7, -1);
  const std::size_t from = draw.chance(0.5) ? 0 : count / 2;  // all, or the last ones
  for (std::size_t j = from + 1; j < count; ++j)
    poses[j] = {poses[from].origin + distance * draw.point(1), poses[from].angle + distance * draw.between(-1, 1)};
  return poses;
}

/// Off its place by so much, in length and in radians.
void disturb(Draw& draw, Poses& poses, double deviation) {
  for (Pose& pose : poses) {
    pose.origin += deviation * draw.point(1);
    pose.angle += deviation * draw.between(-1, 1);
  }
}

Poses arrangement(Draw& draw, std::size_t count) {
  constexpr int ordinary = 8, kinds = 18;
  const int kind = draw.whole(0, kinds - 1);
  if (kind < ordinary) return kind < ordinary / 2 ? scattered(draw, count) : along_a_path(draw, count);
  using Arrange = Poses (*)(Draw&, std::size_t);
  constexpr std::array<Arrange, 10> special = {on_a_grid,
                                               on_a_grid,
                                               equal_steps,
                                               on_a_line,
                                               parallel,
                                               half_turns,
                                               mirrored,
                                               nearly_equal,
                                               turned_about_one_pole,
                                               turned_about_one_pole};
  Poses poses = special[static_cast<std::size_t>(kind - ordinary)](draw, count);
  if (draw.chance(0.4)) disturb(draw, poses, draw.power_of_ten(-13, -1));
  return poses;
}

/// In units of the sheet; `wild`: how fast, 1e-3 … 1e4.
PoseDerivative drawn_derivative(Draw& draw, double wild) {
  PoseDerivative derivative{wild * draw.point(2), draw.between(-2, 2)};
  if (draw.chance(0.1)) derivative.angle = 0;                            // a shift
  if (draw.chance(0.1) && derivative.angle != 0) derivative.origin = 0;  // a turn about the origin
  if (draw.chance(0.2)) derivative.angle *= draw.power_of_ten(-4, 2);
  return derivative;
}

}  // namespace

Sheet drawn_sheet(Draw& draw) {
  Sheet sheet;
  if (draw.chance(0.7)) sheet.scale = draw.power_of_ten(-3, 4);
  if (draw.chance(0.3)) sheet.shift = sheet.scale * draw.power_of_ten(0, 4) * draw.point(1);
  sheet.round = draw.chance(0.3);
  return sheet;
}

double written(const Sheet& sheet, double number) {
  if (!sheet.round) return number;
  const double digits = std::floor(std::log10(sheet.scale)) - 2, grain = std::pow(10.0, std::abs(digits));
  return digits < 0 ? std::round(number * grain) / grain : std::round(number / grain) * grain;
}

std::vector<PrescribedPose> drawn_poses(Draw& draw, const Sheet& sheet, const std::vector<int>& multiplicities) {
  std::vector<PrescribedPose> drawn;
  for (const Pose& pose : arrangement(draw, multiplicities.size())) drawn.push_back({pose, {}});
  const double wild = draw.chance(0.4) ? draw.power_of_ten(-3, 4) : 1;
  for (std::size_t j = 0; j < drawn.size(); ++j) {
    PrescribedPose& pose = drawn[j];
    pose.pose.origin = sheet.scale * pose.pose.origin + sheet.shift;
    pose.pose.origin = {written(sheet, pose.pose.origin.real()), written(sheet, pose.pose.origin.imag())};
    for (int m = 1; m < multiplicities[j]; ++m) {
      pose.derivatives.push_back(drawn_derivative(draw, wild));
      pose.derivatives.back().origin *= sheet.scale;
    }
  }
  return drawn;
}

}  // namespace linkwright::soak
