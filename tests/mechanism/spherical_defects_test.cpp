#include "linkwright/mechanism/spherical_defects.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/spherical_position.hpp"
#include "linkwright/spherical/axis_curve.hpp"
#include "support/attitude_case.hpp"
#include "support/draws.hpp"
#include "support/spherical_case.hpp"

namespace linkwright::spherical_defects_test {
namespace {

using testing::random_orientations;

/// Pairs of dyads of random tasks: what the map is made of.
class RandomPairs {
 public:
  explicit RandomPairs(unsigned seed) : random_(seed) {}

  /// A new task after every 40 pairs, half of them of a body that turns on and on.
  SphericalFourBar next() {
    if (count_++ % 40 == 0) {
      orientations_ = count_ % 80 == 1 ? testing::random_sweep(random_, 4) : random_orientations(random_, 4);
      curve_.emplace(orientation_conditions(orientations_));
    }
    std::uniform_real_distribution<double> place(0, curve_->coordinate_length());
    const SphericalDyad a = curve_->dyad(place(random_)), b = curve_->dyad(place(random_));
    return {a.fixed_axis, a.moving_axis, b.moving_axis, b.fixed_axis};
  }
  [[nodiscard]] const std::vector<PrescribedOrientation>& orientations() const { return orientations_; }

 private:
  std::mt19937_64 random_;
  int count_ = 0;
  std::vector<PrescribedOrientation> orientations_;
  std::optional<AxisCurve> curve_;
};

TEST(SphericalDefects, AreWhatDrivingShows) {
  RandomPairs pairs(1);
  int clean = 0, differ = 0;
  const int count = testing::draws(20'000);
  for (int i = 0; i < count; ++i) {
    const SphericalFourBar bars = pairs.next();
    const DefectReport report = find_defects(bars, pairs.orientations());
    const DriveThroughReport driven = drive_through(bars, pairs.orientations());
    if (!driven.completed) continue;
    clean += driven.defects.none();
    if (driven.defects == report.defects) continue;
    ++differ;
    // Only next to a dead point or a change point, which rounding puts on one side or the other.
    const LinkAngles l = bars.angles();
    const SphericalExcesses t = spherical_excesses(l);
    double margin = std::min({std::abs(t.t1), std::abs(t.t2), std::abs(t.t3), std::abs(t.t4)});
    for (const double arc : l.all()) margin = std::min({margin, arc, pi - arc});
    for (const auto& there : pairs.orientations()) {
      const auto at = [&](Vector3 v) { return turned(v, pairs.orientations()[0].orientation, there.orientation); };
      const SphericalFourBar moved{bars.input_fixed, at(bars.input_moving), at(bars.output_moving), bars.output_fixed};
      margin = std::min({margin, transmission_angle(moved), transmission_angle(moved.swapped())});
    }
    EXPECT_LT(margin, 2e-3) << i << " " << int{report.defects.bits} << " " << int{driven.defects.bits};
  }
  EXPECT_GT(clean, count / 100);
  EXPECT_LT(differ, count / 200);
}

TEST(SphericalDefects, TypeIsThatOfTheAngles) {
  RandomPairs pairs(2);
  for (int i = 0; i < 5000; ++i) {
    const SphericalFourBar bars = pairs.next();
    EXPECT_EQ(find_defects(bars, pairs.orientations()).type, linkage_type(bars.angles())) << i;
  }
}

TEST(SphericalDefects, SenseOfAnAxisDoesNotMatter) {
  RandomPairs pairs(3);
  for (int i = 0; i < 3000; ++i) {
    const SphericalFourBar bars = pairs.next();
    const DefectReport report = find_defects(bars, pairs.orientations());
    for (int sense = 1; sense < 16; ++sense) {
      const auto flipped = [&](Vector3 v, int bit) { return (sense >> bit & 1) != 0 ? -v : v; };
      const SphericalFourBar other{flipped(bars.input_fixed, 0), flipped(bars.input_moving, 1),
                                   flipped(bars.output_moving, 2), flipped(bars.output_fixed, 3)};
      const DefectReport there = find_defects(other, pairs.orientations());
      EXPECT_EQ(there.type, report.type);
      EXPECT_EQ(there.defects, report.defects);
      EXPECT_NEAR(there.min_transmission_angle, report.min_transmission_angle, 1e-7);
      EXPECT_NEAR(there.sweep, report.sweep, 1e-9);
    }
  }
}

// The last orientation first: the same linkages, driven back.
TEST(SphericalDefects, RunBackwardsTheyAreTheSame) {
  RandomPairs pairs(4);
  for (int i = 0; i < 3000; ++i) {
    const SphericalFourBar bars = pairs.next();
    std::vector<PrescribedOrientation> back(pairs.orientations().rbegin(), pairs.orientations().rend());
    const auto at_last = [&](Vector3 v) { return turned(v, back.back().orientation, back.front().orientation); };
    const SphericalFourBar last{bars.input_fixed, at_last(bars.input_moving), at_last(bars.output_moving),
                                bars.output_fixed};
    const DefectReport here = find_defects(bars, pairs.orientations()), there = find_defects(last, back);
    EXPECT_EQ(there.defects, here.defects);
    EXPECT_NEAR(there.min_transmission_angle, here.min_transmission_angle, 1e-7);
    EXPECT_NEAR(there.sweep, here.sweep, 1e-9);
  }
}

// Turned as a whole, on either side, the verdict stays.
TEST(SphericalDefects, TurnWithTheirFrame) {
  RandomPairs pairs(5);
  std::mt19937_64 random(6);
  for (int i = 0; i < 2000; ++i) {
    const SphericalFourBar bars = pairs.next();
    const UnitQuaternion left = testing::random_rotation(random), right = testing::random_rotation(random);
    std::vector<PrescribedOrientation> moved;
    for (const auto& there : pairs.orientations()) moved.push_back({left * there.orientation * right, {}});
    const SphericalFourBar other{left.apply(bars.input_fixed), left.apply(bars.input_moving),
                                 left.apply(bars.output_moving), left.apply(bars.output_fixed)};
    const DefectReport here = find_defects(bars, pairs.orientations()), there = find_defects(other, moved);
    EXPECT_EQ(there.type, here.type);
    EXPECT_EQ(there.defects, here.defects);
  }
}

// The least transmission angle over the travel, by looking at it in small steps.
TEST(SphericalDefects, LeastTransmissionAngleIsTheLeastOnTheWay) {
  RandomPairs pairs(7);
  int looked_at = 0;
  for (int i = 0; i < 6000; ++i) {
    const SphericalFourBar bars = pairs.next();
    const DefectReport report = find_defects(bars, pairs.orientations());
    if (!report.defects.none() || report.type == LinkageType::change_point) continue;
    ++looked_at;
    const double start = configuration_of(bars).input_angle, sense = report.sense == DriveSense::cw ? -1 : 1;
    double least = pi / 2;
    bool whole = true;
    for (int k = 0; k <= 400 && whole; ++k) {
      const auto there = assemble(bars.angles(), start + sense * report.sweep * k / 400, assembly_of(bars));
      whole = there.has_value();
      if (whole) least = std::min(least, transmission_angle(placed(bars, *there)));
    }
    EXPECT_TRUE(whole) << i;
    EXPECT_NEAR(least, report.min_transmission_angle, 2e-2) << i;
    EXPECT_GE(least, report.min_transmission_angle - 1e-6);
  }
  EXPECT_GT(looked_at, 100);
}

TEST(SphericalDefects, AVelocityIsPassedInItsSense) {
  std::mt19937_64 random(8);
  int against = 0;
  for (int i = 0; i < 200; ++i) {
    auto orientations = random_orientations(random, 3);
    orientations[1].derivatives = {testing::random_direction(random)};
    const AxisCurve curve(orientation_conditions(orientations));
    std::uniform_real_distribution<double> place(0, curve.coordinate_length());
    for (int k = 0; k < 30; ++k) {
      const SphericalDyad a = curve.dyad(place(random)), b = curve.dyad(place(random));
      const SphericalFourBar bars{a.fixed_axis, a.moving_axis, b.moving_axis, b.fixed_axis};
      const DefectReport with = find_defects(bars, orientations, true),
                         without = find_defects(bars, orientations, false);
      against += with.defects != without.defects;
      const auto driven = drive_through(bars, orientations, {.respect_direction = true});
      if (!driven.completed || with.min_transmission_angle < 0.01) continue;
      EXPECT_EQ(driven.defects, with.defects) << i << " " << k;
    }
  }
  EXPECT_GT(against, 10);
}

LinkAngles angles(double ground, double input, double coupler, double output) {
  return {ground, input, coupler, output};
}

// The sixteen sign patterns of Murray and Larochelle, with the names that they have there.
TEST(SphericalType, PublishedOnesAgree) {
  const auto c = testing::spherical_case("sph-types-16").content;
  const auto& published = c["published"]["types"];
  const auto& linkages = c["input"]["linkages"];
  const std::map<std::string, std::pair<LinkageType, TripleRockerKind>> meaning = {
      {"crank-rocker", {LinkageType::crank_rocker, TripleRockerKind::none}},
      {"rocker-crank", {LinkageType::rocker_crank, TripleRockerKind::none}},
      {"double-crank", {LinkageType::double_crank, TripleRockerKind::none}},
      {"Grashof double-rocker", {LinkageType::double_rocker, TripleRockerKind::none}},
      {"00 double-rocker", {LinkageType::triple_rocker, TripleRockerKind::zero_zero}},
      {"0pi double-rocker", {LinkageType::triple_rocker, TripleRockerKind::zero_pi}},
      {"pi0 double-rocker", {LinkageType::triple_rocker, TripleRockerKind::pi_zero}},
      {"pipi double-rocker", {LinkageType::triple_rocker, TripleRockerKind::pi_pi}}};
  ASSERT_EQ(published.size(), 16u);
  for (std::size_t i = 0; i < published.size(); ++i) {
    const LinkAngles l = angles(linkages[i]["gamma_ground"], linkages[i]["alpha_input"], linkages[i]["eta_coupler"],
                                linkages[i]["beta_output"]);
    const auto& [type, kind] = meaning.at(published[i]["name"]);
    EXPECT_EQ(linkage_type(l), type) << i;
    EXPECT_EQ(triple_rocker_kind(l), kind) << i;
  }
}

// An axis replaced by its antipode supplements the two links that meet in it.
TEST(SphericalType, DoesNotChangeWithTheSenseOfAnAxis) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> arc(0.05, pi - 0.05);
  for (int i = 0; i < 5000; ++i) {
    const LinkAngles l = angles(arc(random), arc(random), arc(random), arc(random));
    const LinkageType type = linkage_type(l);
    EXPECT_EQ(linkage_type(angles(pi - l.ground, pi - l.input, l.coupler, l.output)), type);
    EXPECT_EQ(linkage_type(angles(l.ground, pi - l.input, pi - l.coupler, l.output)), type);
    EXPECT_EQ(linkage_type(angles(l.ground, l.input, pi - l.coupler, pi - l.output)), type);
    EXPECT_EQ(linkage_type(angles(pi - l.ground, l.input, l.coupler, pi - l.output)), type);
    EXPECT_EQ(swapped(type), linkage_type(angles(l.ground, l.output, l.coupler, l.input)));
  }
}

// Shrunk, it is the planar four-bar of the same lengths.
TEST(SphericalType, OfSmallLinksIsThePlanarOne) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> length(0.1, 1);
  for (int i = 0; i < 5000; ++i) {
    const LinkLengths flat{length(random), length(random), length(random), length(random)};
    const GrashofExcesses t = grashof_excesses(flat);
    if (std::min({std::abs(t.t1), std::abs(t.t2), std::abs(t.t3)}) < 1e-6) continue;
    if (linkage_type(flat) == LinkageType::degenerate) continue;
    const double small = 1e-4;
    const LinkageType type =
        linkage_type(angles(small * flat.ground, small * flat.input, small * flat.coupler, small * flat.output));
    const bool triple = linkage_type(flat) >= LinkageType::triple_rocker_ground &&
                        linkage_type(flat) <= LinkageType::triple_rocker_output;
    EXPECT_EQ(type, triple ? LinkageType::triple_rocker : linkage_type(flat));
  }
}

TEST(SphericalType, ChangePointsAndZeroLinksAreNamed) {
  EXPECT_EQ(linkage_type(angles(1, 0.5, 1, 0.5)), LinkageType::change_point);
  EXPECT_EQ(linkage_type(angles(1, 0, 1, 0.5)), LinkageType::degenerate);
  EXPECT_EQ(linkage_type(angles(1, pi, 1, 0.5)), LinkageType::degenerate);
  EXPECT_EQ(name(TripleRockerKind::zero_pi), "0pi");
}

}  // namespace
}  // namespace linkwright::spherical_defects_test
