#include "linkwright/approximate/pose_fit.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "approximate/pose_field.hpp"
#include "approximate/pose_least_squares.hpp"
#include "approximate/pose_pairs.hpp"
#include "linkwright/core/angle.hpp"
#include "support/curve_case.hpp"
#include "support/random_four_bar.hpp"

namespace linkwright::pose_fit_test {
namespace {

BodyPose drawn_pose(testing::RandomFourBars& draw) {
  return {{draw.uniform(-1, 1), draw.uniform(-1, 1)}, direction(draw.uniform(-pi, pi))};
}

// Poses that a random linkage leaves while its input turns by `range`; nothing where it cannot.
std::vector<Pose> drawn_motion(testing::RandomFourBars& draw, std::size_t count, double range) {
  const BodyLinkage linkage{{0, 0},
                            {1, 0},
                            draw.uniform(0.4, 1.5),
                            draw.uniform(0.4, 1.5),
                            {draw.uniform(-1, 1), draw.uniform(-1, 1)},
                            {draw.uniform(-1, 1), draw.uniform(-1, 1)}};
  const double h = std::abs(linkage.zb - linkage.za), first = draw.uniform(0, two_pi);
  std::vector<Pose> poses;
  for (std::size_t j = 0; j < count; ++j) {
    const Point e = direction(first + range * static_cast<double>(j) / static_cast<double>(count - 1));
    const Point to = linkage.b0 - linkage.a * e;
    const double d = std::abs(to), cosine = (h * h + d * d - linkage.b * linkage.b) / (2 * h * d);
    if (!(std::abs(cosine) < 0.95)) return {};
    const Point u = to / d * Point{cosine, std::sqrt(1 - cosine * cosine)};
    const BodyPose body = body_pose(linkage, LoopState{e, u});
    poses.push_back({body.origin, std::arg(body.axis)});
  }
  return poses;
}

PoseTarget drawn_target(testing::RandomFourBars& draw, std::size_t count) {
  PoseTarget target;
  while (target.poses.empty()) target.poses = drawn_motion(draw, count, draw.uniform(1, 3));
  target.turning_length = 0.7;
  return target;
}

PoseTarget hsieh() { return testing::pose_case("poses_hsieh1"); }

// Drawn by hand, all poses near.
PoseTarget tailgate() {
  PoseTarget target = testing::pose_case("poses_tailgate8");
  target.exact.clear();
  return target;
}

// By turning the input by itself, in both assemblies: the least displacement from a pose.
double nearest_by_input(const BodyLinkage& l, const Pose& pose, double turning_length) {
  const double h = std::abs(l.zb - l.za);
  double least = 1e300;
  constexpr int steps = 40000;
  for (int k = 0; k < steps; ++k) {
    const Point e = direction(two_pi * k / steps), to = l.b0 - l.a0 - l.a * e;
    const double d = std::abs(to), cosine = (h * h + d * d - l.b * l.b) / (2 * h * d);
    if (std::abs(cosine) > 1) continue;
    for (const int side : {-1, 1}) {
      const Point u = to / d * Point{cosine, side * std::sqrt(1 - cosine * cosine)};
      const BodyPose there = body_pose(l, LoopState{e, u});
      least = std::min(least, square(move_between(body_pose(pose), there, turning_length)));
    }
  }
  return std::sqrt(least);
}

// By either grounded link: near a dead point of one the other still turns evenly.
double nearest_of_all(const FourBar& bars, const Pose& body, const Pose& pose, double turning_length) {
  const BodyLinkage linkage = body_linkage(bars, body_pose(body));
  return std::min(nearest_by_input(linkage, pose, turning_length),
                  nearest_by_input(swapped(linkage), pose, turning_length));
}

TEST(PoseField, DeterminantIsTheMeanOfSquaresOverTheQuadruplesOfPoses) {
  testing::RandomFourBars draw(11);
  for (int k = 0; k < 20; ++k) {
    std::vector<BodyPose> poses;
    for (int j = 0; j < 7; ++j) poses.push_back(drawn_pose(draw));
    const std::vector<double> weights(poses.size(), 1);
    const Point z{draw.uniform(-2, 2), draw.uniform(-2, 2)};
    // Of four poses the circle points are where the places lie on a circle: the determinant of rows (|Z|², X, Y, 1).
    const auto row = [&](std::size_t j) {
      const Point at = carried(poses[j], z);
      return std::array<double, 3>{std::norm(at), at.real(), at.imag()};
    };
    const auto on_circle = [&](std::array<std::size_t, 4> of) {
      std::array<std::array<double, 3>, 3> m;
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t c = 0; c < 3; ++c) m[i][c] = row(of[i + 1])[c] - row(of[0])[c];
      return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
             m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    };
    double sum = 0;
    const std::size_t n = poses.size();
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = a + 1; b < n; ++b)
        for (std::size_t c = b + 1; c < n; ++c)
          for (std::size_t d = c + 1; d < n; ++d) sum += std::pow(on_circle({a, b, c, d}), 2);
    const double three = PoseField(poses, weights).scatter(z).three() * std::pow(static_cast<double>(n), 3);
    EXPECT_NEAR(three * static_cast<double>(n), sum, 1e-9 * sum);
  }
}

TEST(PoseField, MinimaAreNoHigherThanWhatIsAboutThem) {
  testing::RandomFourBars draw(12);
  for (int k = 0; k < 20; ++k) {
    const PoseTarget target = drawn_target(draw, 9);
    std::vector<BodyPose> poses;
    for (const Pose& pose : target.poses)
      poses.push_back(body_pose({pose.origin + Point{draw.uniform(-.1, .1), draw.uniform(-.1, .1)}, pose.angle}));
    const PoseField field(poses, std::vector<double>(poses.size(), 1));
    for (const Point z : field.minima()) {
      if (std::abs(z) > 20) continue;
      for (int i = 0; i < 8; ++i)
        EXPECT_GE(field.mean_square(z + 1e-2 * (1 + std::abs(z)) * direction(i * pi / 4)),
                  field.mean_square(z) * (1 - 1e-6));
    }
  }
}

TEST(PosePairs, ErrorIsThatOfTheNearestConfigurationToFirstOrder) {
  testing::RandomFourBars draw(13);
  int tried = 0;
  while (tried < 200) {
    const FourBar bars = draw.four_bar(draw.lengths());
    const BodyPose there{{0.2, 0.1}, direction(0.3)};
    const BodyLinkage linkage = body_linkage(bars, there);
    constexpr double turning_length = 0.8, off = 1e-4;
    const std::vector<BodyPose> poses = {
        moved(there, {{draw.uniform(-off, off), draw.uniform(-off, off)}, draw.uniform(-off, off)}, turning_length)};
    const std::vector<double> weights = {1};
    const DyadAtPoses input({linkage.za, linkage.a0, linkage.a}, poses, turning_length);
    const DyadAtPoses output({linkage.zb, linkage.b0, linkage.b}, poses, turning_length);
    const double first_order = std::sqrt(DyadAtPoses::square_error(input, output, weights));
    const BodyHold hold(linkage, there, turning_length);
    if (hold.second_length < 0.2 || first_order < 0.02 * off) continue;  // all but two freedoms; all but none
    const BodyPose nearest = nearest_state(linkage, there, poses[0], turning_length);
    const double apart = std::sqrt(square(move_between(poses[0], nearest, turning_length)));
    EXPECT_NEAR(first_order, apart, 0.02 * apart + 1e-3 * off);
    ++tried;
  }
}

TEST(PoseFit, PublishedAndDrawnTasksComeOutAsNearAsAnyoneFound) {
  PoseFitOptions options;
  options.max_link_ratio = 20;
  for (const FitEffort effort : {FitEffort::quick, FitEffort::standard}) {
    options.effort = effort;
    const PoseFits nine = fit_poses(hsieh(), options), eight = fit_poses(tailgate(), options);
    ASSERT_FALSE(nine.fits.empty() || eight.fits.empty());
    EXPECT_LE(nine.fits.front().error.rms, 0.040782);
    EXPECT_LE(eight.fits.front().error.rms, 1.0573);
  }
}

TEST(PoseFit, ExactPosesArePassedToRounding) {
  const PoseTarget target = testing::pose_case("poses_tailgate8");
  PoseFitOptions options;
  options.max_link_ratio = 20;
  const PoseFits found = fit_poses(target, options);
  ASSERT_FALSE(found.fits.empty());
  EXPECT_LE(found.fits.front().error.rms, 1.9596);
  EXPECT_LE(found.fits.front().error.exact_residual, 1e-10 * target.scale());
}

// The nearest linkage keeps to one side of its dead points at the poses and passes two of them between; a hair off it
// turns fully. Random starts find that one, at 0.04431 of the scale; without it the nearest is at 0.0464.
TEST(PoseFit, IsLedAwayFromDeadPointsBetweenThePoses) {
  PoseTarget target;
  target.poses = {
      {{-1.869908, 3.677669}, -1.338268}, {{-1.848958, 3.735602}, -1.342215}, {{-1.854555, 3.755883}, -1.422959},
      {{-1.881372, 3.820472}, -1.429898}, {{-1.917493, 3.855075}, -1.427389}, {{-1.972463, 3.901796}, -1.524383},
      {{-2.058151, 3.947814}, -1.405915}, {{-2.178390, 3.981235}, -1.315020}, {{-2.269163, 4.031699}, -1.299499},
      {{-2.412729, 4.053813}, -1.231196}, {{-2.498372, 4.027832}, -1.254034}, {{-2.583062, 4.006484}, -1.093783}};
  target.turning_length = 0.285217;
  const PoseFits found = fit_poses(target);
  ASSERT_FALSE(found.fits.empty());
  EXPECT_LT(found.fits.front().error.rms, 0.0444 * target.scale());
  EXPECT_TRUE(found.fits.front().drive.no_defects(false));
}

TEST(PoseFit, MotionsOfLinkagesComeBack) {
  testing::RandomFourBars draw(14);
  PoseFitOptions options;
  options.effort = FitEffort::quick;
  int back = 0;
  constexpr int all = 20;
  for (int k = 0; k < all; ++k) {
    const PoseTarget target = drawn_target(draw, 8 + static_cast<std::size_t>(k) % 12);
    const PoseFits found = fit_poses(target, options);
    if (!found.fits.empty() && found.fits.front().error.rms < 1e-9 * target.scale()) ++back;
  }
  EXPECT_GE(back, all - 2);
}

TEST(PoseFit, ErrorsAreThoseThatTurningTheInputShows) {
  for (const PoseTarget& target : {hsieh(), tailgate()}) {
    PoseFitOptions options;
    options.effort = FitEffort::quick;
    const PoseFits found = fit_poses(target, options);
    ASSERT_FALSE(found.fits.empty());
    const PoseFit& best = found.fits.front();
    double square = 0;
    for (std::size_t j = 0; j < target.poses.size(); ++j) {
      const PoseState& state = best.states[j];
      const double told = std::hypot(state.position_error, target.turning_length * state.angle_error);
      const double shown = nearest_of_all(best.bars, best.states[0].body, target.poses[j], target.turning_length);
      EXPECT_NEAR(told, shown, 1e-3 * target.scale() * 1e-2 + 1e-2 * told);
      square += told * told;
    }
    EXPECT_NEAR(best.error.rms, std::sqrt(square / static_cast<double>(target.poses.size())), 1e-9);
    EXPECT_TRUE(best.drive.no_defects(false));
    const auto compared = compare_with_poses(best.bars, best.states[0].body, target, options);
    ASSERT_TRUE(compared);
    EXPECT_NEAR(compared->error.rms, best.error.rms, 1e-7 * target.scale());
  }
}

TEST(PoseFit, LimitsAreKept) {
  const PoseTarget target = tailgate();
  PoseFitOptions options;
  options.effort = FitEffort::quick;
  options.min_transmission_angle = radians(50);
  options.windows.ground = Box{0, 400, 100, 500};
  const PoseFits found = fit_poses(target, options);
  ASSERT_FALSE(found.fits.empty());
  for (const PoseFit& fit : found.fits) {
    EXPECT_TRUE(fit.within_limits);
    for (const PoseState& state : fit.states) {
      const double sine = transmission_sine(body_linkage(state.bars, body_pose(state.body)), body_pose(state.body));
      EXPECT_GE(std::abs(sine), std::sin(radians(50)) - 2e-6);
    }
    for (const Point pivot : {fit.bars.input_fixed, fit.bars.output_fixed})
      EXPECT_TRUE(pivot.real() > -1e-3 && pivot.imag() > 100 - 1e-3);
  }
}

TEST(PoseFit, LeastLargestIsSmallerAndSameOnAnyNumberOfThreads) {
  PoseFitOptions options;
  options.effort = FitEffort::quick;
  options.threads = 1;
  const auto largest = [](const PoseFits& found, const PoseTarget& target) {
    const PoseFit& best = found.fits.front();
    const PoseState& worst = best.states[best.error.max_at];
    return std::hypot(worst.position_error, target.turning_length * worst.angle_error);
  };
  const PoseTarget target = tailgate();
  const PoseFits squares = fit_poses(target, options);
  options.measure = FitMeasure::least_largest;
  const PoseFits least = fit_poses(target, options);
  ASSERT_FALSE(squares.fits.empty() || least.fits.empty());
  EXPECT_LT(largest(least, target), 0.95 * largest(squares, target));
  options.threads = 3;
  const PoseFits again = fit_poses(target, options);
  ASSERT_EQ(again.fits.size(), least.fits.size());
  EXPECT_EQ(again.fits.front().error.rms, least.fits.front().error.rms);
}

}  // namespace
}  // namespace linkwright::pose_fit_test
