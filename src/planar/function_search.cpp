#include "linkwright/planar/function_search.hpp"

#include <cmath>

#include "region/climb.hpp"

namespace linkwright {
namespace {

// Two linkages are alike when no pivot differs by more than this share of the ground link.
constexpr double alike = 0.02;

class PlanarGenerators : public GeneratorSource {
 public:
  PlanarGenerators(const FunctionFamily& family, const Requirements& requirements,
                   const std::optional<MapWindow>& window, const AddedMeasures& added)
      : family_(family), evaluator_(family, requirements, Objective::min_transmission_angle, window, added) {}

  [[nodiscard]] const LinkageFamily& family() const override { return family_; }

  [[nodiscard]] std::optional<RankedGenerator> at(MapPoint place, const ErrorSampling& sampling) const override {
    const auto candidate = evaluator_.candidate(place);
    if (!candidate) return std::nullopt;
    const FunctionError error = family_.error_of(four_bar_of(candidate->cell.pivots), place, sampling);
    if (!error.max_structural_error || !error.unreached.empty()) return std::nullopt;
    return RankedGenerator{place, candidate->cell.type, *error.max_structural_error};
  }

  [[nodiscard]] bool are_alike(MapPoint one, MapPoint other) const override {
    const auto a = bars_at(one), b = bars_at(other);
    if (!a || !b) return false;
    const double most = alike * a->lengths().ground;
    return std::abs(a->input_circle - b->input_circle) < most && std::abs(a->output_circle - b->output_circle) < most;
  }

 private:
  [[nodiscard]] std::optional<FourBar> bars_at(MapPoint place) const {
    const auto links = family_.dyad_pair(place);
    return links ? four_bar_of(*links) : std::nullopt;
  }

  const FunctionFamily& family_;
  Evaluator evaluator_;
};

}  // namespace

std::vector<RankedGenerator> best_generators(const FunctionFamily& family, const Requirements& requirements,
                                             const GeneratorSearchOptions& options, const Progress& progress) {
  if (!family.has_function()) return {};
  return best_generators(PlanarGenerators(family, requirements, options.window, options.added), options, progress);
}

std::optional<MapPoint> improved_generator(const FunctionFamily& family, const Requirements& requirements,
                                           MapPoint start, const AddedMeasures& added) {
  return improved_generator(PlanarGenerators(family, requirements, {}, added), start);
}

}  // namespace linkwright
