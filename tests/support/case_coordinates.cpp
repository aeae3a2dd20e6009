#include "support/case_coordinates.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <map>

#include "linkwright/core/angle.hpp"

namespace linkwright::testing {
namespace {

struct BranchMap {
  double branch = 0, sense = 1, offset = 0;  // ours = branch + frac(sense · (theirs − floor(theirs)) + offset)
  [[nodiscard]] double operator()(double theirs) const {
    return branch + wrap_period(sense * (theirs - std::floor(theirs)) + offset, 1);
  }
};

Homogeneous circle_of(const nlohmann::json& sample) { return {sample["Z"][0], sample["Z"][1], sample["Z"][2]}; }

bool fits(const BranchMap& map, const BurmesterCurve& curve, const std::vector<nlohmann::json>& samples) {
  for (const auto& sample : samples)
    if (great_circle(curve.dyad(map(sample["tau"])).circle, circle_of(sample)) > 1e-7) return false;
  return true;
}

BranchMap fitted(const BurmesterCurve& curve, const std::vector<nlohmann::json>& samples) {
  // A sample away from where branches cross tells the branch; it fixes the offset for either sense.
  for (const auto& anchor : samples) {
    const double theirs = anchor["tau"], ours = curve.circle_curve().coordinate_of(circle_of(anchor)).value_or(0);
    for (const double sense : {1.0, -1.0}) {
      const double offset = ours - std::floor(ours) - sense * (theirs - std::floor(theirs));
      const BranchMap map{std::floor(ours), sense, offset};
      if (fits(map, curve, samples)) return map;
    }
  }
  ADD_FAILURE() << "the samples of a branch do not fit";
  return {};
}

}  // namespace

std::vector<double> our_coordinates(const PlanarCase& c, const BurmesterCurve& curve,
                                    const std::vector<double>& theirs) {
  if (curve.kappa()) return theirs;
  std::map<double, std::vector<nlohmann::json>> by_branch;
  for (const auto& sample : c.json["circle_point_curve"]["samples_homogeneous_working_frame"])
    by_branch[std::floor(sample["tau"].get<double>())].push_back(sample);
  std::map<double, BranchMap> maps;
  for (const auto& [branch, samples] : by_branch) maps[branch] = fitted(curve, samples);
  std::vector<double> ours;
  for (const double tau : theirs) ours.push_back(maps.at(std::floor(tau))(tau));
  return ours;
}

}  // namespace linkwright::testing
