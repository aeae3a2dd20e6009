#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "linkwright/analysis/defects.hpp"
#include "linkwright/planar/four_bar_family.hpp"
#include "linkwright/region/best_cells.hpp"
#include "linkwright/region/hill_climb.hpp"
#include "linkwright/region/requirements.hpp"

namespace linkwright {

/// A linkage that meets the requirements. Working frame.
struct Candidate {
  MapPoint place;
  DyadPair links;
  FourBar bars;
  DefectReport report;
  double score = 0;  ///< as score_of
  bool local_optimum = false;
};

/// Judges any place of the map by the same rules as its cells. Refers to the family, which must outlive it.
class CellEvaluator {
 public:
  /// `requirements` with both lengths set. Places outside `window` are refused; nothing: none.
  CellEvaluator(const FourBarFamily& family, const Requirements& requirements, Objective objective,
                std::optional<MapWindow> window = {})
      : family_(family), requirements_(requirements), objective_(objective), window_(window) {}

  [[nodiscard]] const FourBarFamily& family() const { return family_; }
  [[nodiscard]] double largest_coordinate() const;

  /// The linkage at a place, or nothing where it does not meet the requirements or lies outside the window.
  [[nodiscard]] std::optional<Candidate> candidate(MapPoint place) const;
  /// The same; of grounded links known already those serve again whose coordinates are the place's.
  [[nodiscard]] std::optional<Candidate> candidate(MapPoint place, const DyadPair& known) const;

  /// The same bars driven from the better side that meets the requirements: no defects, score, transmission angle,
  /// smaller coordinate; as they are where the family names the input.
  [[nodiscard]] Candidate from_better_side(const Candidate& here) const;

 private:
  [[nodiscard]] std::optional<Candidate> evaluated(MapPoint place, const DyadPair& links) const;
  [[nodiscard]] bool inside(const std::optional<Box>& box, Point p, Point q) const;

  const FourBarFamily& family_;
  Requirements requirements_;
  Objective objective_;
  std::optional<MapWindow> window_;
};

/// A search stops where the type would depend on this share of the perimeter: near a change point the numbers look best
/// and a workshop's tolerances decide what the linkage does.
inline constexpr double buildable_margin = 1e-3;

/// The smallest excess, as a share of the perimeter.
[[nodiscard]] double change_point_margin(const FourBar& bars);

/// The two axes of a family, the one whose coordinate is dearer to change first, as a climb takes them.
class OrderedAxes {
 public:
  explicit OrderedAxes(const FourBarFamily& family)
      : family_(family), swapped_(family.costlier_side() == Side::output) {}

  [[nodiscard]] std::array<double, 2> both(double of_input, double of_output) const {
    return swapped_ ? std::array{of_output, of_input} : std::array{of_input, of_output};
  }
  [[nodiscard]] std::array<double, 2> coordinates(MapPoint place) const { return both(place.input, place.output); }
  [[nodiscard]] MapPoint place(std::array<double, 2> coordinates) const {
    return swapped_ ? MapPoint{coordinates[1], coordinates[0]} : MapPoint{coordinates[0], coordinates[1]};
  }
  /// Around a place, its scores by the ordered coordinates.
  [[nodiscard]] Hill hill(std::function<std::optional<double>(double, double)> score_at, MapPoint around) const;

 private:
  const FourBarFamily& family_;
  bool swapped_;
};

/// What a climb goes by.
struct Ascent {
  double first_step = 0;                              ///< in τ, along both coordinates
  double resolution = HillClimbOptions{}.resolution;  ///< shares of the first step
  /// Larger is better; nothing where a candidate is not allowed.
  std::function<std::optional<double>(const Candidate&)> score = [](const Candidate& c) { return c.score; };
  double across = HillClimbOptions{}.across;
};

/// Climbs from a linkage to the top of its hill (climb_hill), keeping branch, type and requirements.
[[nodiscard]] Candidate climbed(const CellEvaluator& evaluator, const Candidate& start, const Ascent& ascent,
                                const Progress& progress = {});

}  // namespace linkwright
