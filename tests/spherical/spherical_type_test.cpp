#include "linkwright/spherical/spherical_type.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "linkwright/core/angle.hpp"
#include "support/spherical_case.hpp"

namespace linkwright::spherical_type_test {
namespace {

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
}  // namespace linkwright::spherical_type_test
