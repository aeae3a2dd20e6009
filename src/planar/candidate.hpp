#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "linkwright/planar/linkage_family.hpp"
#include "linkwright/planar/synthesis.hpp"

namespace linkwright {

/// A linkage that meets the requirements. Working frame.
struct Candidate {
  RegionPlace place;
  FourBar bars;
  DefectReport report;
  double score = 0;  ///< as score_of
  bool local_optimum = false;
};

/// Judges any place of the map by the same rules as its cells. Refers to the family, which must outlive it.
class Judge {
 public:
  /// `requirements` with max_length set. Places outside `window` are refused; nothing: none.
  Judge(const LinkageFamily& family, const Requirements& requirements, Objective objective,
        std::optional<RegionWindow> window = {})
      : family_(family), requirements_(requirements), objective_(objective), window_(window) {}

  [[nodiscard]] const LinkageFamily& family() const { return family_; }
  [[nodiscard]] double largest_coordinate() const;

  /// The linkage at a place, or nothing where it does not meet the requirements or lies outside the window.
  [[nodiscard]] std::optional<Candidate> candidate(RegionPlace place) const;

  /// The same bars driven from the better side that meets the requirements: no defects, score, transmission angle,
  /// smaller coordinate; as they are where the family names the input.
  [[nodiscard]] Candidate from_better_side(const Candidate& here) const;

 private:
  [[nodiscard]] std::optional<Candidate> judged(RegionPlace place, const FourBar& bars) const;
  [[nodiscard]] bool inside(const std::optional<Box>& box, Point p, Point q) const;

  const LinkageFamily& family_;
  Requirements requirements_;
  Objective objective_;
  std::optional<RegionWindow> window_;
};

/// A search stops where the type would hang on this share of the perimeter: near a change point the numbers look best
/// and a workshop's tolerances decide what the linkage does.
inline constexpr double buildable_margin = 1e-3;

/// The smallest excess, as a share of the perimeter.
[[nodiscard]] double change_point_margin(const FourBar& bars);

/// Climbs from a place to the top of its hill, keeping branch, type and requirements; steps begin at `first_step` in τ.
[[nodiscard]] Candidate climbed(const Judge& judge, const Candidate& start, double first_step);

}  // namespace linkwright
