#include "linkwright/spherical/spherical_function_search.hpp"

#include <cmath>

#include "linkwright/core/angle.hpp"
#include "region/climb.hpp"

namespace linkwright {
namespace {

class SphericalGenerators : public GeneratorSource {
 public:
  SphericalGenerators(const SphericalFunctionFamily& family, const Requirements& requirements,
                      const std::optional<MapWindow>& window, const AddedMeasures& added)
      : family_(family), evaluator_(family, requirements, Objective::min_transmission_angle, window, added) {}

  [[nodiscard]] const LinkageFamily& family() const override { return family_; }

  [[nodiscard]] std::optional<RankedGenerator> at(MapPoint place, const ErrorSampling& sampling) const override {
    const auto candidate = evaluator_.candidate(place);
    if (!candidate) return std::nullopt;
    const FunctionError error = family_.error_of(spherical_four_bar_of(candidate->cell.pivots), place, sampling);
    if (!error.max_structural_error || !error.unreached.empty()) return std::nullopt;
    return RankedGenerator{place, candidate->cell.type, *error.max_structural_error};
  }

  [[nodiscard]] bool are_alike(MapPoint one, MapPoint other) const override {
    const auto a = family_.dyad_pair(one), b = family_.dyad_pair(other);
    if (!a || !b) return false;
    return are_alike(a->input.moving_axis, b->input.moving_axis) &&
           are_alike(a->output.moving_axis, b->output.moving_axis);
  }

 private:
  [[nodiscard]] static bool are_alike(Vector3 a, Vector3 b) {
    constexpr double alike = pi / 180;
    return norm(cross(a, b)) < alike;
  }

  const SphericalFunctionFamily& family_;
  Evaluator evaluator_;
};

}  // namespace

std::vector<RankedGenerator> best_generators(const SphericalFunctionFamily& family, const Requirements& requirements,
                                             const GeneratorSearchOptions& options, const Progress& progress) {
  if (!family.has_function()) return {};
  return best_generators(SphericalGenerators(family, requirements, options.window, options.added), options, progress);
}

std::optional<MapPoint> improved_generator(const SphericalFunctionFamily& family, const Requirements& requirements,
                                           MapPoint start, const AddedMeasures& added) {
  return improved_generator(SphericalGenerators(family, requirements, {}, added), start);
}

}  // namespace linkwright
