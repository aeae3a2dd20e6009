#pragma once

#include <optional>
#include <vector>

#include "linkwright/planar/motion_synthesis.hpp"

namespace linkwright {

/// A place on the map, as a continuous pair of curve coordinates.
struct Place {
  double input = 0, output = 0;
};

/// A linkage that meets the requirements. Working frame.
struct Candidate {
  Place place;
  FourBar bars;
  DefectReport report;
  double score = 0;  ///< as score_of
  bool local_optimum = false;
};

/// Judges any place of the map by the same rules as its cells.
class Judge {
 public:
  /// `solution` has its curve, requirements and options; it must outlive the judge.
  Judge(const MotionTask& task, const MotionSolution& solution);

  /// The linkage at a place, or nothing where it does not meet the requirements or lies outside the window.
  [[nodiscard]] std::optional<Candidate> candidate(Place place) const;

  /// The same bars driven from the better side that meets the requirements: no defects, score, transmission angle,
  /// smaller coordinate.
  [[nodiscard]] Candidate from_better_side(const Candidate& here) const;

 private:
  [[nodiscard]] std::optional<Candidate> judged(Place place, const FourBar& bars) const;
  [[nodiscard]] bool in_window(Place place) const;
  [[nodiscard]] bool inside(const std::optional<Box>& box, Point p, Point q) const;

  const MotionSolution* solution_;
  std::vector<PrescribedPose> poses_;
};

/// Climbs from a place to the top of its hill, keeping branch, type and requirements; steps begin at `first_step` in τ.
[[nodiscard]] Candidate climbed(const Judge& judge, const Candidate& start, double first_step);

}  // namespace linkwright
