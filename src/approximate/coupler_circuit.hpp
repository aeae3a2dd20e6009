#pragma once

#include <array>
#include <span>
#include <vector>

#include "approximate/coupler_linkage.hpp"

namespace linkwright {

/// All states that a linkage can reach from one, by small steps: a closed curve. It knows nothing of dead points, which
/// are states like others to it.
class CouplerCircuit {
 public:
  /// `turning_length`: by it a turn of the coupler counts as travel of the point, which is at rest where the coupler
  /// turns about it.
  CouplerCircuit(const CouplerLinkage& linkage, const LoopState& start, double turning_length = 0);

  /// It came back to where it began; otherwise strands of the curve of states meet, or the loop opened.
  [[nodiscard]] bool closed() const { return closed_; }
  /// In turn; of a closed one the last is the first again. At least one.
  [[nodiscard]] const std::vector<LoopState>& states() const { return states_; }
  [[nodiscard]] const std::vector<Point>& points() const { return points_; }
  /// Lengths of the path of the coupler point up to each state, turns counted in.
  [[nodiscard]] const std::vector<double>& path() const { return path_; }

  /// Where a state lies, as an index with a fraction; below 0 where it is not on the circuit. Looked for first beside
  /// `near`.
  [[nodiscard]] double position_of(const LoopState& state, double near) const;
  /// The path's length up to a position.
  [[nodiscard]] double path_at(double position) const;

 private:
  void append(const LoopState& state);
  [[nodiscard]] double position_within(const LoopState& state, std::size_t from, std::size_t to) const;

  CouplerLinkage linkage_;
  double turning_length_;
  bool closed_ = false;
  std::vector<LoopState> states_;
  std::vector<Point> points_;
  std::vector<double> path_;
};

/// A direction of the linkage that can be driven: that of the input e, of the coupler u, or of the output g = B − B0.
/// Each is that of an input in two of the curve's six linkages (three realisations, either grounded link).
enum class CurveDriver : std::uint8_t { e, u, g };

/// What driving along the circuit showed.
struct CircuitDrive {
  bool one_circuit = false, in_order = false;
  struct OfDriver {
    bool no_dead_point = false;  ///< on the way; all the way round of a closed target
    bool full_turn = false;      ///< a whole round of the circuit turns it once
    double min_sine = 0;         ///< of the transmission angle on the way
    /// From the first target to each on the way, radians, to a step or two of the circuit. Empty: not in order.
    std::vector<double> turns;
  };
  std::array<OfDriver, 3> drivers;
  double excursion = 0;          ///< of the path on the way from the polygon through the targets
  double path_length_ratio = 0;  ///< of the way over the polygon

  [[nodiscard]] const OfDriver& of(CurveDriver driver) const { return drivers[static_cast<std::size_t>(driver)]; }
};

/// Goes along the circuit of the first state, and meets the others in turn. Going back along the path by no more than
/// `noise`, a length, is an error of the targets and no defect. `turning_length`: as of a CouplerCircuit.
[[nodiscard]] CircuitDrive drive_along_circuit(const CouplerLinkage& linkage, std::span<const LoopState> states,
                                               std::span<const Point> targets, bool closed, double noise,
                                               double turning_length = 0);

}  // namespace linkwright
