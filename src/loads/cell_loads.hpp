#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "linkwright/loads/loads.hpp"
#include "linkwright/mechanism/linkage_output.hpp"

namespace linkwright {

/// How closely a linkage is looked at.
enum class CellLook : unsigned char {
  map,    ///< the loads' stations, friction of pins to first order
  search  ///< more of them where forces have peaks, the top between them by parabolas, exact friction: as
          ///< reports have it
};

/// A linkage under its loads. A read-out is the worst of the cases that count, each at the positions and at equal steps
/// between them, and where the largest force stands between two stations at the top of the parabola through it and its
/// neighbours; what several read-outs share is worked out once. For one thread at a time. docs/theory/loads.md,
/// section 4.
class CellLoads {
 public:
  /// Refers to the loads.
  CellLoads(const Loads& loads, const PlanarOutput& output, CellLook look);
  CellLoads(const CellLoads&) = delete;
  CellLoads& operator=(const CellLoads&) = delete;
  ~CellLoads();

  /// Nothing where the linkage does not get through its positions in order without a dead point, or the read-out has no
  /// value.
  [[nodiscard]] std::optional<double> read_out(ReadOut read_out);

 private:
  struct Cases;
  std::unique_ptr<Cases> cases_;  ///< null: it does not get through
};

/// Steps from each position to the next: so many that there are at least `stations` of them.
[[nodiscard]] int steps_between(int stations, std::size_t positions);

/// The largest of some values over stations, with the parabola at an inner one.
[[nodiscard]] double largest_with_parabola(const std::vector<double>& turns, const std::vector<double>& values);

}  // namespace linkwright
