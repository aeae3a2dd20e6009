#pragma once

#include <array>
#include <vector>

#include "algebra/homotopy.hpp"
#include "linkwright/mechanism/four_bar.hpp"

namespace linkwright {

/// The four-bars with given ground pivots whose coupler point passes five places: of moving pivots in position 1, seen
/// from the point, and of their conjugates, which are unknowns of their own here, four equations (docs/theory/path.md).
/// Real four-bars are the solutions in which they are conjugate.
struct FivePointSystem {
  static constexpr std::size_t size = 4;
  static constexpr int solutions = 36;  ///< of a general one, counted numerically

  /// Of a way from one task to another.
  struct Task {
    Point input{}, input_conjugate{}, output{}, output_conjugate{};  ///< ground pivots, from the first place
    std::array<Point, size> place{}, place_conjugate{};              ///< the other places, likewise
  };

  Task from, to;

  /// Unknowns: input's moving pivot and its conjugate, output's moving pivot and its conjugate.
  [[nodiscard]] SystemAt<size> operator()(const ComplexVector<size>& unknowns, double t) const;
};

/// A task of no special kind with complex numbers, and its solutions: where the paths to those of any other begin.
struct FivePointStart {
  FivePointSystem::Task task;
  std::array<ComplexVector<FivePointSystem::size>, FivePointSystem::solutions> solutions;
};
[[nodiscard]] const FivePointStart& five_point_start();

/// A four-bar in position 1, and where its moving pivots stand.
struct FivePointFourBar {
  FourBar bars;                       ///< frame of the places
  std::array<Point, 5> input_moving;  ///< at each place
};

struct FivePointFourBars {
  std::vector<FivePointFourBar> real;  ///< by the place of the input's moving pivot
  int ends = 0;                        ///< solutions that were reached, real or not, of FivePointSystem::solutions
};

/// Places in order, none at a pivot. What is not reached in three tries by different ways lies at infinity, is
/// manifold, or is lost.
[[nodiscard]] FivePointFourBars five_point_four_bars(const std::array<Point, 5>& places, Point input, Point output);

}  // namespace linkwright
