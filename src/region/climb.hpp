#pragma once

#include <functional>
#include <optional>

#include "linkwright/core/progress.hpp"
#include "linkwright/region/added_measures.hpp"
#include "linkwright/region/cell_judge.hpp"
#include "linkwright/region/hill_climb.hpp"
#include "linkwright/region/objective.hpp"

namespace linkwright {

/// A linkage that meets the requirements.
struct Candidate {
  Cell cell;
  double score = 0;            ///< larger is better
  bool local_optimum = false;  ///< the top of its hill
};
/// Better first; ties by the place.
[[nodiscard]] bool is_better_candidate(const Candidate& a, const Candidate& b);

/// Two linkages count as different designs at this share of what designs of the task are long.
inline constexpr double different_design = 0.02;

/// Judges and ranks any place of a family's map by the same rules as its cells. Refers to the family, which must
/// outlive it.
class Evaluator {
 public:
  /// `requirements` with defaults filled in. Places outside `window` are refused; nothing: none.
  Evaluator(const LinkageFamily& family, const Requirements& requirements, Objective objective,
            std::optional<MapWindow> window = {}, AddedMeasures added = {});

  [[nodiscard]] const LinkageFamily& family() const { return family_; }

  /// The linkages at places, one after the other, as LinkageFamily::cells(). Nothing where one does not meet the
  /// requirements, or none is there. Of one thread; refers to this.
  using CandidateAt = std::function<std::optional<Candidate>(MapPoint place)>;
  [[nodiscard]] CandidateAt candidates() const;
  [[nodiscard]] std::optional<Candidate> candidate(MapPoint place) const { return candidates()(place); }

  /// The same bars driven from the better side that meets the requirements: no defects, score, transmission angle,
  /// smaller coordinate; as they are where the family names the input. Of cognates the better that meets the
  /// requirements, the smaller where they score alike.
  [[nodiscard]] Candidate from_better_side(const Candidate& here) const;

  /// Between two designs, and what that is measured by: the longest link, on the unit sphere 1.
  [[nodiscard]] double distance(const Candidate& a, const Candidate& b) const;
  [[nodiscard]] double size(const Candidate& of) const;
  /// Within which distance of it another is the same design, where designs of the task are `usual` long. Pairs of a few
  /// dyads are each a design, however alike they are beside the largest of them.
  [[nodiscard]] double same_within(const Candidate& candidate, double usual) const;

 private:
  [[nodiscard]] std::optional<Candidate> judged(const Cell& cell) const;

  const LinkageFamily& family_;
  Requirements requirements_;
  Objective objective_;
  std::optional<MapWindow> window_;
  AddedMeasures added_;
  CellJudge judge_;
  Rank rank_, by_transmission_;
};

/// A search stops where the type would depend on this share of the linkage's size: near a change point the numbers look
/// best and a workshop's tolerances decide what the linkage does.
inline constexpr double buildable_margin = 1e-3;

/// What a climb goes by.
struct Ascent {
  MapPoint first_step;                                ///< in the coordinates
  double resolution = HillClimbOptions{}.resolution;  ///< shares of the first step
  /// Larger is better; nothing where a candidate is not allowed.
  std::function<std::optional<double>(const Candidate&)> score = [](const Candidate& c) { return c.score; };
  double across = HillClimbOptions{}.across;
  int max_evaluations = HillClimbOptions{}.max_evaluations;
};

/// Of places that take long to judge: steps as given, a rougher top.
[[nodiscard]] Ascent long_ascent(MapPoint first_step);

/// Climbs from a linkage to the top of its hill (climb_hill), keeping branch, hill and requirements.
[[nodiscard]] Candidate climbed(const Evaluator& evaluator, const Candidate& start, const Ascent& ascent,
                                const Progress& progress = {});

}  // namespace linkwright
