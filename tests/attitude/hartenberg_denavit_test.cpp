#include "linkwright/attitude/hartenberg_denavit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <vector>

#include "linkwright/core/angle.hpp"
#include "support/attitude_case.hpp"

namespace linkwright::hartenberg_denavit_test {
namespace {

using testing::ulps_between;
using enum HartenbergDenavitForm;

double ulps(const Displacement& a, const Displacement& b) {
  return std::max(ulps_between(a.rotation, b.rotation), ulps_between(a.translation, b.translation));
}

HartenbergDenavit random_link(std::mt19937_64& random) {
  std::uniform_real_distribution<double> angle(-pi, pi), length(-1, 1);
  return {.theta = angle(random), .d = length(random), .a = length(random), .alpha = angle(random)};
}

Displacement about_z(double theta) { return {Rotation::about_z(theta), {}}; }
Displacement about_x(double alpha) { return {Rotation::about_x(alpha), {}}; }
Displacement along_z(double d) { return Displacement::translated({0, 0, d}); }
Displacement along_x(double a) { return Displacement::translated({a, 0, 0}); }

Displacement transform(const HartenbergDenavit& link, HartenbergDenavitForm form) {
  const Result<Displacement> result = hartenberg_denavit(link, form);
  EXPECT_TRUE(result.ok());
  return result ? *result : Displacement{};
}

TEST(HartenbergDenavit, IsTheProductOfItsFourSteps) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 1000; ++i) {
    const HartenbergDenavit l = random_link(random);
    EXPECT_LE(ulps(transform(l, classic), about_z(l.theta) * along_z(l.d) * along_x(l.a) * about_x(l.alpha)), 2);
    EXPECT_LE(ulps(transform(l, modified), about_x(l.alpha) * along_x(l.a) * about_z(l.theta) * along_z(l.d)), 2);
  }
}

TEST(HartenbergDenavit, ClassicHasItsPublishedMatrix) {
  const HartenbergDenavit l{.theta = 0.4, .d = 2, .a = 3, .alpha = -0.7};
  const double ct = std::cos(l.theta), st = std::sin(l.theta), ca = std::cos(l.alpha), sa = std::sin(l.alpha);
  const Matrix4x4 expected{
      {{ct, -st * ca, st * sa, l.a * ct}, {st, ct * ca, -ct * sa, l.a * st}, {0, sa, ca, l.d}, {0, 0, 0, 1}}};
  const Result<Displacement> matrix = Displacement::from_matrix(expected);
  EXPECT_LE(ulps(transform(l, classic), *matrix), 1);
}

TEST(HartenbergDenavit, ModifiedHasItsPublishedMatrix) {
  const HartenbergDenavit l{.theta = 0.4, .d = 2, .a = 3, .alpha = -0.7};
  const double ct = std::cos(l.theta), st = std::sin(l.theta), ca = std::cos(l.alpha), sa = std::sin(l.alpha);
  const Matrix4x4 expected{
      {{ct, -st, 0, l.a}, {st * ca, ct * ca, -sa, -sa * l.d}, {st * sa, ct * sa, ca, ca * l.d}, {0, 0, 0, 1}}};
  const Result<Displacement> matrix = Displacement::from_matrix(expected);
  EXPECT_LE(ulps(transform(l, modified), *matrix), 1);
}

TEST(HartenbergDenavit, OneFormInvertsTheOther) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 1000; ++i) {
    const HartenbergDenavit l = random_link(random), back{-l.theta, -l.d, -l.a, -l.alpha};
    EXPECT_LE(ulps(transform(l, modified).inverse(), transform(back, classic)), 4);
  }
}

TEST(HartenbergDenavit, ChainsOfTheTwoFormsDifferByWhereTheyAreCut) {
  std::mt19937_64 random(3);
  std::array<HartenbergDenavit, 6> links;
  for (auto& link : links) link = random_link(random);
  std::array<HartenbergDenavit, 7> shifted{};
  for (std::size_t i = 0; i < links.size(); ++i) {
    shifted[i].theta = links[i].theta, shifted[i].d = links[i].d;
    shifted[i + 1].a = links[i].a, shifted[i + 1].alpha = links[i].alpha;
  }
  EXPECT_LE(ulps(*hartenberg_denavit_chain(links, classic), *hartenberg_denavit_chain(shifted, modified)), 16);
}

// Fu, Gonzalez and Lee, Robotics: control, sensing, vision, and intelligence, 1987: the PUMA 560 in millimetres.
TEST(HartenbergDenavit, PumaStandsWhereItsMakersTableSays) {
  const double q = pi / 2;
  const std::array<HartenbergDenavit, 6> arm{{{.theta = q, .alpha = -q},
                                              {.d = 149.09, .a = 431.8},
                                              {.theta = q, .a = -20.32, .alpha = q},
                                              {.d = 433.07, .alpha = -q},
                                              {.alpha = q},
                                              {.d = 56.25}}};
  const Result<Displacement> hand = hartenberg_denavit_chain(arm, classic);
  ASSERT_TRUE(hand.ok());
  EXPECT_LE(norm(hand->translation - Vector3{-149.09, 921.12, 20.32}), 1e-12);
  EXPECT_LE(ulps_between(hand->apply_to_direction({0, 0, 1}), {0, 1, 0}), 4) << "the hand points ahead";
}

// Craig, Introduction to robotics, section 3.7: the wrist of the PUMA 560 in closed form.
TEST(HartenbergDenavit, PumaWristFollowsItsClosedForm) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> angle(-pi, pi);
  const double a2 = 0.4318, a3 = 0.0203, d3 = 0.1245, d4 = 0.4318, q = pi / 2;
  for (int i = 0; i < 1000; ++i) {
    std::array<double, 6> t{};
    for (double& theta : t) theta = angle(random);
    const std::array<HartenbergDenavit, 6> arm{{{.theta = t[0]},
                                                {.theta = t[1], .alpha = -q},
                                                {.theta = t[2], .d = d3, .a = a2},
                                                {.theta = t[3], .d = d4, .a = a3, .alpha = -q},
                                                {.theta = t[4], .alpha = q},
                                                {.theta = t[5], .alpha = -q}}};
    const double reach = a2 * std::cos(t[1]) + a3 * std::cos(t[1] + t[2]) - d4 * std::sin(t[1] + t[2]);
    const Vector3 wrist{std::cos(t[0]) * reach - d3 * std::sin(t[0]), std::sin(t[0]) * reach + d3 * std::cos(t[0]),
                        -a3 * std::sin(t[1] + t[2]) - a2 * std::sin(t[1]) - d4 * std::cos(t[1] + t[2])};
    EXPECT_LE(ulps_between(hartenberg_denavit_chain(arm, modified)->translation, wrist), 8);
  }
}

TEST(HartenbergDenavit, ParametersComeBackFromTheTransform) {
  std::mt19937_64 random(5);
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    for (const auto form : {classic, modified}) {
      const HartenbergDenavit given = random_link(random);
      const Result<HartenbergDenavitFit> fit = hartenberg_denavit_of(transform(given, form), form);
      ASSERT_TRUE(fit.ok());
      worst = std::max({worst, testing::ulps_between_angles(fit->link.theta, given.theta),
                        testing::ulps_between_angles(fit->link.alpha, given.alpha), ulps_between(fit->link.a, given.a),
                        ulps_between(fit->link.d, given.d), fit->distance_defect / testing::ulp});
      EXPECT_EQ(fit->angle_defect, 0);
    }
  }
  EXPECT_LE(worst, 4);
  RecordProperty("worst_ulps", std::to_string(worst));
}

TEST(HartenbergDenavit, SaysHowFarATransformIsFromTheForm) {
  const HartenbergDenavit link{.theta = 0.5, .d = 2, .a = 3, .alpha = -1};
  // The defects are those of x of frame j and z of frame i: a turn of j about its y, a shift along it.
  const Displacement tilted = transform(link, classic) * Displacement{Rotation::about_y(0.01), {}};
  EXPECT_NEAR(hartenberg_denavit_of(tilted, classic)->angle_defect, 0.01 * std::cos(link.alpha), 1e-6);
  const Displacement shifted =
      Displacement{Rotation(), {-std::sin(0.5) * 0.25, std::cos(0.5) * 0.25, 0}} * transform(link, classic);
  EXPECT_NEAR(hartenberg_denavit_of(shifted, classic)->distance_defect, 0.25, 1e-15);
  EXPECT_NEAR(hartenberg_denavit_of(shifted, classic)->link.a, 3, 1e-15);
  const Displacement along_y =
      Displacement::translated({0, 0.25 * std::cos(1.0), -0.25 * std::sin(1.0)}) * transform(link, modified);
  EXPECT_NEAR(hartenberg_denavit_of(along_y, modified)->distance_defect, 0.25, 1e-15);
  EXPECT_EQ(hartenberg_denavit_of({Rotation::about_y(-pi / 2), {}}, classic)->angle_defect, 1);
}

TEST(HartenbergDenavit, GivesEveryFrameOfAChain) {
  const std::array<HartenbergDenavit, 3> links{
      {{.theta = 0.1, .a = 1}, {.theta = 0.2, .a = 1}, {.theta = 0.3, .a = 1}}};
  const auto frames = hartenberg_denavit_frames(links, classic);
  ASSERT_TRUE(frames.ok());
  ASSERT_EQ(frames->size(), 3U);
  EXPECT_LE(ulps((*frames)[2], *hartenberg_denavit_chain(links, classic)), 0);
  const Vector3 planar{std::cos(0.1) + std::cos(0.3) + std::cos(0.6), std::sin(0.1) + std::sin(0.3) + std::sin(0.6), 0};
  EXPECT_LE(ulps_between((*frames)[2].translation, planar), 4);
  EXPECT_EQ(*hartenberg_denavit_chain({}, classic), Displacement()) << "no links: the frame itself";
}

/// Every frame of the chain has its z in its line.
void expect_axes(const LinkChain& chain, const std::vector<Line>& axes, double largest) {
  const auto frames = hartenberg_denavit_frames(chain.links, modified);
  ASSERT_TRUE(frames.ok());
  ASSERT_EQ(frames->size(), axes.size());
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const Displacement frame = chain.base * (*frames)[k];
    const Vector3 direction = normalized(axes[k].direction);
    EXPECT_LE(norm(frame.apply_to_direction({0, 0, 1}) - direction), largest) << k;
    EXPECT_LE(norm(cross(frame.translation - axes[k].point, direction)), largest) << k;
  }
}

TEST(HartenbergDenavit, ParametersOfAxesPutTheAxesBack) {
  std::mt19937_64 random(6);
  for (int i = 0; i < 200; ++i) {
    std::vector<Line> axes(6);
    for (Line& line : axes) line = {testing::random_direction(random), testing::random_direction(random)};
    const Result<LinkChain> chain = hartenberg_denavit_of_axes(axes);
    ASSERT_TRUE(chain.ok());
    double min_sine = 1;
    for (const auto& link : chain->links)
      if (link.alpha != 0) min_sine = std::min(min_sine, std::fabs(std::sin(link.alpha)));
    expect_axes(*chain, axes, 1e-13 / (min_sine * min_sine));
  }
}

TEST(HartenbergDenavit, ParametersOfParallelMeetingAndCoincidingAxes) {
  const std::vector<Line> axes{{{0, 0, 0}, {0, 0, 1}}, {{1, 0, 9}, {0, 0, 2}}, {{1, 1, 0}, {0, 0, -1}},
                               {{1, 1, 4}, {0, 0, 1}}, {{1, 1, 2}, {1, 0, 0}}, {{5, 1, 2}, {1, 0, 0}},
                               {{2, 1, 2}, {0, 1, 1}}, {{2, 3, 0}, {0, 1, 1}}};
  const Result<LinkChain> chain = hartenberg_denavit_of_axes(axes);
  ASSERT_TRUE(chain.ok());
  expect_axes(*chain, axes, 1e-14);
  EXPECT_EQ(chain->links[1].d, 0) << "the normal of parallels that goes on from where the chain is";
  EXPECT_NEAR(chain->links[1].a, 1, 1e-15);
  EXPECT_NEAR(std::fabs(chain->links[2].alpha), pi, 1e-15);
  EXPECT_NEAR(std::fabs(chain->links[4].alpha), pi / 2, 1e-15);
}

TEST(HartenbergDenavit, ParametersOfThePumasAxesAreThoseOfThePuma) {
  const double a2 = 0.4318, a3 = 0.0203, d3 = 0.1245, d4 = 0.4318, q = pi / 2;
  const std::vector<HartenbergDenavit> arm{
      {}, {.alpha = -q}, {.d = d3, .a = a2}, {.d = d4, .a = a3, .alpha = -q}, {.alpha = q}, {.alpha = -q}};
  std::vector<Line> axes;
  const auto frames = hartenberg_denavit_frames(arm, modified);
  for (const Displacement& frame : *frames) axes.push_back({frame.translation, frame.apply_to_direction({0, 0, 1})});
  const Result<LinkChain> chain = hartenberg_denavit_of_axes(axes);
  ASSERT_TRUE(chain.ok());
  expect_axes(*chain, axes, 1e-14);
  EXPECT_NEAR(chain->links[2].a, a2, 1e-15);
  EXPECT_NEAR(chain->links[3].a, a3, 1e-15);
  EXPECT_NEAR(std::fabs(chain->links[3].d), d4, 1e-15);
  for (const std::size_t k : {1U, 3U, 4U, 5U}) EXPECT_NEAR(std::fabs(chain->links[k].alpha), q, 1e-15) << k;
}

TEST(HartenbergDenavit, ParametersOfAlmostParallelAxesLoseHalfOfTheDigitsAtMost) {
  for (int k = 1; k <= 16; ++k) {
    const double slope = std::pow(10, -k);
    const std::vector<Line> axes{{{0, 0, 0}, {0, 0, 1}}, {{1, 0, 0}, {0, slope, 1}}, {{1, 1, 0}, {slope, 0, 1}}};
    const Result<LinkChain> chain = hartenberg_denavit_of_axes(axes);
    ASSERT_TRUE(chain.ok());
    expect_axes(*chain, axes, 4e-8);
  }
}

TEST(HartenbergDenavit, OfOneAxisIsItsFrame) {
  const std::vector<Line> axes{{{1, 2, 3}, {0, -4, 0}}};
  const Result<LinkChain> chain = hartenberg_denavit_of_axes(axes);
  ASSERT_TRUE(chain.ok());
  expect_axes(*chain, axes, 0);
}

TEST(HartenbergDenavit, NamesTheAxisThatIsNone) {
  std::vector<Line> axes(3);
  axes[2].direction = {};
  EXPECT_EQ(hartenberg_denavit_of_axes(axes).errors().front().place, "axes[2]");
  EXPECT_EQ(hartenberg_denavit_of_axes({}).errors().front().code, "no_axes");
}

TEST(HartenbergDenavit, NamesTheParameterThatIsNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::array<HartenbergDenavit, 3> links{};
  links[2].alpha = nan;
  const Result<Displacement> chain = hartenberg_denavit_chain(links, modified);
  ASSERT_FALSE(chain.ok());
  EXPECT_EQ(chain.errors().front().code, "not_finite");
  EXPECT_EQ(chain.errors().front().place, "links[2].alpha");
  EXPECT_EQ(hartenberg_denavit(links[2], classic).errors().front().place, "alpha");
  EXPECT_FALSE(hartenberg_denavit_of(Displacement::translated({nan, 0, 0}), classic).ok());
  links[2] = {.a = 1e308};
  links[1] = {.a = 1e308};
  EXPECT_FALSE(hartenberg_denavit_chain(links, classic).ok()) << "overflow";
}

}  // namespace
}  // namespace linkwright::hartenberg_denavit_test
