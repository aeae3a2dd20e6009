#pragma once

#include "linkage_search.hpp"
#include "spherical/spherical_candidate.hpp"

namespace linkwright {

/// The spherical four-bars of a solved task, as a search for the best takes them. Refers to the answer.
class SearchedSphericalFourBars : public SphericalEvaluator {
 public:
  using Solution = SphericalSolution;

  explicit SearchedSphericalFourBars(const SphericalAnswer& answer)
      : SphericalEvaluator(*answer.given.family, answer.requirements, answer.options.objective, answer.options.window,
                           answer.added),
        answer_(answer) {}

  /// Largest distance on the unit sphere between two axes, which have no sense.
  [[nodiscard]] double distance(const Candidate& a, const Candidate& b) const;
  /// On the unit sphere no design is larger than another.
  [[nodiscard]] double size(const Candidate& /*of*/) const { return 1; }
  [[nodiscard]] std::optional<SphericalSolution> make(MapPoint place) const;
  [[nodiscard]] bool is_confirmed(const Candidate& candidate, const SphericalSolution& made) const;

 private:
  const SphericalAnswer& answer_;
};

}  // namespace linkwright
