#pragma once

#include <cmath>
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
  /// Of a value of each case that counts; nothing where one of them has none.
  template <class Of>
  [[nodiscard]] std::optional<double> worst_of(ReadOut read_out, const Of& of);
  [[nodiscard]] std::optional<double> hand_force_error();
  std::unique_ptr<Cases> cases_;  ///< null: it does not get through
};

/// How far a largest force of stations with parabola is from that over the travel: by that of the positions alone. Of
/// 2 865 tailgates with three steps from each position to the next 99 of 100 are within.
[[nodiscard]] inline double station_error(double at_positions, double at_stations) {
  return std::abs(at_stations - at_positions) / 4 + 0.01;
}

/// Steps from each position to the next: so many that there are at least `stations` of them.
[[nodiscard]] int steps_between(int stations, std::size_t positions);

/// The largest of some values over stations, with the parabola at an inner one; of several that are as large, as the
/// best strength of a spring makes them, that of any.
[[nodiscard]] double largest_with_parabola(const std::vector<double>& turns, const std::vector<double>& values);

}  // namespace linkwright
