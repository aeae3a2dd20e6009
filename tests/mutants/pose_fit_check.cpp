// What fits of poses stand on: the field of best circles, the error of a pair of dyads, rows of the least squares,
// exact poses by weights, what is told of errors and of the way. Random linkages, moved by the tree's own motion.
// Prints the number of disagreements; exits with 1 when there are any. mutants.py builds it with wrong signs.

#include <cmath>
#include <cstdio>
#include <vector>

#include "approximate/pose_field.hpp"
#include "approximate/pose_least_squares.hpp"
#include "approximate/pose_pairs.hpp"
#include "approximate/pose_result.hpp"
#include "approximate/pose_target.hpp"
#include "linkwright/approximate/pose_fit.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/coupler_curve.hpp"
#include "linkwright/mechanism/linkage_type.hpp"
#include "support/random_four_bar.hpp"

namespace linkwright {
namespace {

using testing::RandomFourBars;

constexpr double turning_length = 0.8;

struct Moved {
  FourBar bars;
  BodyLinkage linkage;
  std::vector<BodyPose> states;  // over a third of a turn of the crank
  std::vector<Pose> poses;
};

Moved drawn(RandomFourBars& draw, std::size_t count) {
  Moved m;
  do {
    m.bars = draw.four_bar();
  } while (change_point_margin(m.bars.lengths()) < 0.05 || m.bars.lengths().shortest() < 0.3 ||
           linkage_type(m.bars.lengths()) != LinkageType::crank_rocker);
  const BodyPose there{{draw.uniform(-1, 1), draw.uniform(-1, 1)}, direction(draw.uniform(-3, 3))};
  m.linkage = body_linkage(m.bars, there);
  const auto coupler = [](const FourBar& bars) { return std::arg(bars.output_moving - bars.input_moving); };
  const auto cycle = motion_cycle(m.bars, there.origin, static_cast<int>(3 * count) + 1);
  for (std::size_t j = 0; j < count; ++j) {
    const double turn = coupler(cycle[j].four_bar) - coupler(m.bars);
    m.states.push_back({cycle[j].coupler_point, there.axis * direction(turn)});
    m.poses.push_back({m.states.back().origin, std::arg(m.states.back().axis)});
  }
  return m;
}

bool differs(double a, double b, double tolerance) { return !(std::abs(a - b) <= tolerance * (1 + std::abs(b))); }

BodyLinkage changed(BodyLinkage l, std::size_t number, double by) {
  const Point step = number % 2 == 0 ? Point{by, 0} : Point{0, by};
  if (number < 2) l.a0 += step;
  if (number == 2 || number == 3) l.b0 += step;
  if (number == 4) l.a += by;
  if (number == 5) l.b += by;
  if (number == 6 || number == 7) l.za += step;
  if (number > 7) l.zb += step;
  return l;
}

std::vector<BodyPose> noisy(RandomFourBars& draw, const std::vector<BodyPose>& poses, double noise) {
  std::vector<BodyPose> off;
  for (const BodyPose& pose : poses)
    off.push_back(moved(pose, {{draw.uniform(-noise, noise), draw.uniform(-noise, noise)}, draw.uniform(-noise, noise)},
                        turning_length));
  return off;
}

// ---- field

// Centre and error against the mean square of |Z − C|² − R² itself, which nothing about them lowers.
int wrong_circles(RandomFourBars& draw) {
  const std::vector<BodyPose> poses = noisy(draw, drawn(draw, 9).states, 0.1);
  std::vector<double> weights;
  double sum = 0;
  for (std::size_t j = 0; j < poses.size(); ++j) sum += weights.emplace_back(1 + 0.5 * static_cast<double>(j % 3));
  const PoseField field(poses, weights);
  const Point z{draw.uniform(-1, 1), draw.uniform(-1, 1)};
  const BodyDyad dyad = field.dyad(z);
  const auto mean = [&](Point center, double square) {
    double total = 0;
    for (std::size_t j = 0; j < poses.size(); ++j)
      total += weights[j] * std::pow(std::norm(carried(poses[j], z) - center) - square, 2);
    return total / sum;
  };
  const double square = dyad.radius * dyad.radius, least = mean(dyad.center, square);
  int wrong = differs(std::sqrt(least) / (2 * dyad.radius), dyad.error, 1e-6) ? 1 : 0;
  if (differs(field.mean_square(z), dyad.error * dyad.error, 1e-9)) ++wrong;
  for (int k = 0; k < 8; ++k) {
    const Point by = 1e-3 * direction(k * pi / 4);
    if (mean(dyad.center + by, square) < least * (1 - 1e-9) ||
        mean(dyad.center, square + by.real()) < least * (1 - 1e-9))
      ++wrong;
  }
  return wrong;
}

// Pivots of the linkage itself are zeros of the field, with its circles, and among the minima.
int wrong_zeros(RandomFourBars& draw) {
  const Moved m = drawn(draw, 12);
  const PoseField field(m.states, std::vector<double>(m.states.size(), 1));
  int wrong = 0;
  const std::vector<Point> minima = field.minima();
  const auto check = [&](Point z, Point center, double radius) {
    const BodyDyad dyad = field.dyad(z);
    if (!(dyad.error < 1e-6) || std::abs(dyad.center - center) > 1e-5 || std::abs(dyad.radius - radius) > 1e-5) ++wrong;
    double nearest = 1e9;
    for (const Point found : minima) nearest = std::min(nearest, std::abs(found - z));
    if (nearest > 1e-2) ++wrong;
  };
  check(m.linkage.za, m.linkage.a0, m.linkage.a);
  check(m.linkage.zb, m.linkage.b0, m.linkage.b);
  return wrong > 0 ? 1 : 0;
}

int wrong_valleys(RandomFourBars& draw) {
  const std::vector<BodyPose> poses = noisy(draw, drawn(draw, 9).states, 0.02);
  const PoseField field(poses, std::vector<double>(poses.size(), 1));
  const std::vector<Point> valleys = field.valleys(60);
  int wrong = valleys.size() == 60 ? 0 : 1;
  const auto weighed = [&](Point z) { return field.mean_square(z) / (1 + 0.5 * std::norm(z)); };
  int lower = 0;
  for (int k = 0; k < 100; ++k)
    if (weighed(direction(draw.uniform(0, two_pi)) * 5.0 * std::sqrt(draw.uniform(0, 1))) < weighed(valleys.back()))
      ++lower;
  if (lower > 60) ++wrong;
  for (std::size_t k = 1; k < valleys.size(); ++k)
    if (std::abs(valleys[k]) > 6 || weighed(valleys[k]) < weighed(valleys[k - 1]) * (1 - 1e-9)) ++wrong;
  const auto on_disc = [](Point z) { return z / (1 + std::abs(z)); };
  for (std::size_t k = 0; k < valleys.size(); ++k)
    for (std::size_t i = 0; i < k; ++i)
      if (std::abs(on_disc(valleys[k]) - on_disc(valleys[i])) < 0.04) ++wrong;
  return wrong;
}

// ---- pairs and least squares

int wrong_pairs(RandomFourBars& draw) {
  const Moved m = drawn(draw, 8);
  int wrong = 0;
  for (const BodyPose& there : m.states) {
    constexpr double off = 1e-4;
    const std::vector<BodyPose> poses = noisy(draw, {there}, off);
    const std::vector<double> weights = {1};
    const DyadAtPoses input({m.linkage.za, m.linkage.a0, m.linkage.a}, poses, turning_length);
    const DyadAtPoses output({m.linkage.zb, m.linkage.b0, m.linkage.b}, poses, turning_length);
    const double first_order = std::sqrt(DyadAtPoses::square_error(input, output, weights));
    if (BodyHold(m.linkage, there, turning_length).second_length < 0.2) continue;
    const BodyPose nearest = nearest_state(m.linkage, there, poses[0], turning_length);
    const double apart = std::sqrt(square(move_between(poses[0], nearest, turning_length)));
    if (std::abs(first_order - apart) > 0.02 * apart + 2e-3 * off) ++wrong;
  }
  return wrong;
}

int wrong_rows(RandomFourBars& draw) {
  const Moved m = drawn(draw, 6);
  constexpr double h = 1e-6;
  int wrong = 0;
  for (const BodyPose& there : m.states) {
    if (BodyHold(m.linkage, there, turning_length).second_length < 0.3) continue;
    const BodyPose pose = noisy(draw, {there}, 1e-3)[0];
    const BodyPose state = nearest_state(m.linkage, there, pose, turning_length);
    const auto rows = displacement_rows(m.linkage, state, pose, turning_length);
    const BodyRow sine = transmission_sine_row(m.linkage, state, state, turning_length);
    for (std::size_t i = 0; i < body_dimensions; ++i) {
      const BodyLinkage more = changed(m.linkage, i, h), less = changed(m.linkage, i, -h);
      const auto square_of = [&](const BodyLinkage& l) {
        return square(move_between(pose, nearest_state(l, state, pose, turning_length), turning_length));
      };
      const auto sine_of = [&](const BodyLinkage& l) {
        return transmission_sine(l, nearest_state(l, state, state, turning_length));
      };
      const double by = (square_of(more) - square_of(less)) / (2 * h),
                   by_sine = (sine_of(more) - sine_of(less)) / (2 * h);
      if (differs(2 * (rows[0].residual * rows[0].row[i] + rows[1].residual * rows[1].row[i]), by, 1e-4)) ++wrong;
      if (differs(sine.row[i], by_sine, 1e-3)) ++wrong;
    }
  }
  return wrong;
}

// Limits beside the poses, so that their rows are needed on the way; they end just kept.
bool returns(RandomFourBars& draw) {
  const Moved m = drawn(draw, 12);
  const std::vector<double> weights(m.states.size(), 1);
  PoseFitTask task{m.states, weights, turning_length, {}};
  const LinkLengths lengths = m.linkage.lengths();
  task.limits.max_length = lengths.longest();
  task.limits.min_length = 0.9 * lengths.shortest();
  BodyStart start{m.linkage, m.states};
  for (std::size_t i = 0; i < body_dimensions; ++i)
    start.linkage = changed(start.linkage, i, draw.uniform(-5e-3, 5e-3));
  const BodyClosing closing(start.linkage, turning_length);
  for (BodyPose& state : start.states)
    if (!closing.close(state)) return true;
  double least = 1;
  for (const BodyPose& state : m.states) least = std::min(least, std::abs(transmission_sine(m.linkage, state)));
  start.branch = transmission_sine(m.linkage, m.states[0]) > 0 ? 1 : -1;
  task.limits.min_sine = least;
  evaluate(task, start);
  improve(task, start, 25);
  return start.cost() < 1e-14;
}

// Held by limits that the poses would break: where the steps end, no number of the linkage can be changed to the
// better.
int wrong_limits(RandomFourBars& draw) {
  const Moved m = drawn(draw, 10);
  const std::vector<BodyPose> poses = noisy(draw, m.states, 0.02);
  const std::vector<double> weights(poses.size(), 1);
  PoseFitTask task{poses, weights, turning_length, {}};
  task.limits.max_length = 0.95 * m.linkage.lengths().longest();
  task.limits.max_link_ratio = 0.95 * m.linkage.lengths().longest() / m.linkage.lengths().shortest();
  double least = 1;
  for (const BodyPose& state : m.states) least = std::min(least, std::abs(transmission_sine(m.linkage, state)));
  task.limits.min_sine = std::min(1.02 * least, 0.98);
  BodyStart start{m.linkage, m.states, transmission_sine(m.linkage, m.states[0]) > 0 ? 1 : -1};
  slide_to_nearest(task, start);
  improve(task, start, 400);
  slide_to_nearest(task, start);
  for (std::size_t i = 0; i < body_dimensions; ++i)
    for (const double by : {3e-4, -3e-4}) {
      BodyStart other = start;
      other.linkage = changed(start.linkage, i, by);
      slide_to_nearest(task, other);
      if (other.cost() < start.cost() * (1 - 1e-4)) return 1;
    }
  return 0;
}

// ---- fits and what is told of them

int wrong_fits(RandomFourBars& draw) {
  const Moved m = drawn(draw, 9);
  PoseTarget target{m.poses, {}, {0, 4, 8}, turning_length};
  for (const std::size_t j : {1, 2, 3, 5, 6, 7})
    target.poses[j].origin += Point{draw.uniform(-0.02, 0.02), draw.uniform(-0.02, 0.02)};
  PoseFitOptions options;
  options.effort = FitEffort::quick;
  options.threads = 1;
  const PoseFits found = fit_poses(target, options);
  if (found.fits.empty()) return 1;
  int wrong = 0;
  for (const PoseFit& fit : found.fits)
    if (!(fit.error.exact_residual < 1e-8) || !fit.drive.no_defects(false) || !fit.within_limits) ++wrong;
  const auto itself = compare_with_poses(m.bars, m.poses[0], target);
  if (!itself || found.fits[0].error.rms > 1.05 * itself->error.rms) ++wrong;
  return wrong > 0 ? 1 : 0;
}

// Against the nearest pose over a fine motion: all that is told of the errors, and where.
int wrong_errors(RandomFourBars& draw) {
  const Moved m = drawn(draw, 8);
  PoseTarget target{m.poses, {}, {2}, turning_length};
  for (std::size_t j = 0; j < target.poses.size(); ++j) {
    target.weights.push_back(j == 5 ? 0 : 1 + 0.3 * static_cast<double>(j));
    if (j == 2) continue;
    target.poses[j].origin += Point{draw.uniform(-0.01, 0.01), draw.uniform(-0.01, 0.01)};
    target.poses[j].angle += draw.uniform(-0.01, 0.01);
  }
  const auto told = compare_with_poses(m.bars, m.poses[0], target);
  if (!told) return 1;
  int wrong = told->drive.one_circuit && told->drive.in_order && told->drive.input_drives ? 0 : 1;
  double sum = 0, weights = 0, positions = 0, angles = 0, largest = 0;
  std::size_t at = 0;
  for (std::size_t j = 0; j < target.poses.size(); ++j) {
    const PoseState& state = told->states[j];
    const BodyPose wanted = body_pose(target.poses[j]), there = body_pose(state.body);
    const BodyPose nearest = nearest_state(m.linkage, m.states[j], wanted, turning_length);
    const double apart = square(move_between(wanted, there, turning_length));
    if (differs(apart, square(move_between(wanted, nearest, turning_length)), 1e-9)) ++wrong;
    if (std::abs(there.axis - nearest.axis) > 1e-4) ++wrong;
    if (differs(state.position_error, std::abs(there.origin - wanted.origin), 1e-9)) ++wrong;
    if (differs(state.angle_error, std::abs(turn_between(wanted.axis, there.axis)), 1e-9)) ++wrong;
    if (j == 2) continue;
    sum += target.weights[j] * apart;
    weights += target.weights[j];
    if (j == 5) continue;
    positions += std::pow(state.position_error, 2);
    angles += std::pow(state.angle_error, 2);
    if (apart > largest) {
      largest = apart;
      at = j;
    }
  }
  const PoseFitError& error = told->error;
  if (std::abs(error.sum_of_squares - sum) > 1e-6 * sum ||
      std::abs(error.rms - std::sqrt(sum / weights)) > 1e-6 * error.rms)
    ++wrong;
  if (std::abs(error.position_rms - std::sqrt(positions / 6)) > 1e-6 * error.position_rms || error.max_at != at)
    ++wrong;
  if (std::abs(error.angle_rms - std::sqrt(angles / 6)) > 1e-6 * error.angle_rms || error.exact_residual > 1e-9)
    ++wrong;
  std::swap(target.poses[3], target.poses[6]);
  const auto out_of_order = compare_with_poses(m.bars, m.poses[0], target);
  if (!out_of_order || (out_of_order->drive.in_order && out_of_order->error.rms < 5 * error.rms)) ++wrong;
  target.exact = {6};  // the others give way
  const auto by_the_exact = compare_with_poses(m.bars, m.poses[0], target);
  if (!by_the_exact || by_the_exact->error.exact_residual > 0.02) ++wrong;
  return wrong > 0 ? 1 : 0;
}

}  // namespace
}  // namespace linkwright

int main() {
  using namespace linkwright;
  RandomFourBars draw(23);
  int circles = 0, zeros = 0, valleys = 0, pairs = 0, rows = 0, back = 0, limits = 0, fits = 0, errors = 0;
  constexpr int trials = 30;
  for (int k = 0; k < trials; ++k) {
    circles += wrong_circles(draw);
    zeros += wrong_zeros(draw);
    valleys += wrong_valleys(draw);
    pairs += wrong_pairs(draw);
    rows += wrong_rows(draw);
    back += returns(draw) ? 1 : 0;
    limits += wrong_limits(draw);
    errors += wrong_errors(draw);
    if (k % 5 == 0) fits += wrong_fits(draw);
  }
  std::printf("circles %d, zeros %d, valleys %d, pairs %d, rows %d, not back %d, limits %d, fits %d, errors %d\n",
              circles, zeros, valleys, pairs, rows, trials - back, limits, fits, errors);
  return circles + valleys + pairs + rows + fits + errors + (zeros > 8) + (back < trials - 8) + (limits > 3) > 0 ? 1
                                                                                                                 : 0;
}
